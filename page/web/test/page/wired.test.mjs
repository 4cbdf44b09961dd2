// A machine that is wired to a Mega: it says what the UNO lacks and offers the Mega, and its model solution moves it there.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, lamp, pick, pictures, run, select, type } from "./harness.mjs";

/** @param {string} name */
const file = (name) => readFileSync(new URL(`../../../../programs/plants/${name}`, import.meta.url), "utf8");

/** Each with what one presses, and the output that follows. @type {readonly [string, string, number][]} */
const MACHINES = [["three-cylinders", "start", 7], ["three-bins", "start", 5], ["four-floors", "cab1", 4], ["two-roads", "walk", 9]];

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

for (const { locale, lacks } of [
  { locale: "en-US", lacks: /wired to a Mega.*The UNO has 8 inputs and 4 outputs/ },
  { locale: "pt-BR", lacks: /ligada a um Mega.*O UNO tem 8 entradas e 4 saídas/ },
]) {
  test(`machines that are wired to a Mega move beside one, ${locale}`, async () => {
    const page = await lab.open({ locale });
    for (const [machine, part, output] of MACHINES) {
      await select(page, "#for-board", "uno");
      await pick(page, "#machines");
      await page.locator(`#gallery [data-machine="${machine}.toml"]`).click();
      await page.locator("#machine-other p", { hasText: lacks }).waitFor();
      await page.click("#machine-board");
      await page.locator("#machine-other").waitFor({ state: "hidden" });
      await type(page, file(`${machine}.st`), `${machine}.st`);
      await run(page);
      await page.locator(`#machine-picture [data-part="${part}"]`).press("Enter");
      await lamp(page, output, true);
      for (const [width, height] of /** @type {const} */ ([[1366, 768], [390, 844]])) {
        await page.setViewportSize({ width, height });
        if (width < 500) await page.click("#page-machine");
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${machine} scrolls sideways`);
        await page.screenshot({ path: join(pictures, `machine-${machine}-${locale}-${width}.png`) });
      }
      await page.setViewportSize({ width: 1440, height: 900 });
    }
    await page.context().close();
  });
}
