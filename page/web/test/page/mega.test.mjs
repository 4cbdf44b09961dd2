// The Mega in the page: chosen, simulated with its own firmware, seen with its points, and left again.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, clean, lamp, pick, pictures, run, select, state, tab, type } from "./harness.mjs";
import { connect, connected } from "./plugged.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

const FAR = "LD I24\nST Q16\nLD I9\nST Q5\nLD IW7\nGT 500\nST Q10\n";

for (const { locale, lacks } of [
  { locale: "en-US", lacks: /the Mega has this one/ },
  { locale: "pt-BR", lacks: /a placa Mega tem/ },
]) {
  test(`a program of a Mega runs on a simulated Mega, ${locale}`, async () => {
    const page = await lab.open({ locale });
    await type(page, FAR, "far.il");
    await page.locator("#problem-count.bad").waitFor();
    await select(page, "#for-board", "mega");
    await page.locator("#problem-count.good").waitFor();
    await run(page);
    assert.match((await page.locator("#status").textContent()) ?? "", /RUN/);
    for (const [input, output] of [[24, 16], [9, 5]]) {
      await page.hover(`[data-input="${input}"]`);
      await page.mouse.down();
      await lamp(page, output ?? 0, true);
      await page.mouse.up();
      await lamp(page, output ?? 0, false);
    }
    // A knob at its eighth analogue input.
    await lamp(page, 10, true);
    await page.locator('[data-analogue="7"]').fill("100");
    await lamp(page, 10, false);
    // Forced over the line, as on every board.
    await tab(page, "watch");
    await page.locator('tr[data-point="I24"] button', { hasText: /1$/ }).click();
    await lamp(page, 16, true);
    await page.click("#release");
    await lamp(page, 16, false);
    // Those of the program first, and all on request.
    assert.equal(await page.locator("[data-input]:visible").count(), 2);
    await pick(page, "#all-buttons");
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("[data-input]:visible").count(), 24);
    assert.equal(await page.locator("[data-output]").count(), 16);
    await clean(page, "a Mega");
    for (const [width, height] of /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]])) {
      await page.setViewportSize({ width, height });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
      await page.screenshot({ path: join(pictures, `mega-${locale}-${width}.png`) });
    }
    await page.setViewportSize({ width: 1440, height: 900 });
    // It keeps its program over a power cut, beside that of the UNO.
    await page.click("#plug");
    await state(page, "");
    await page.click("#plug");
    await state(page, "RUN");
    await page.locator('[data-input="24"]').hover();
    await page.mouse.down();
    await lamp(page, 16, true);
    await page.mouse.up();
    await select(page, "#for-board", "uno");
    await page.locator("#problem-count.bad").waitFor();
    await tab(page, "problems");
    await page.locator("#below", { hasText: lacks }).waitFor();
    await type(page, "LD I1\nST Q1\n", "one.il");
    await run(page);
    await page.hover('[data-input="1"]');
    await page.mouse.down();
    await lamp(page, 1, true);
    assert.equal(await page.locator("[data-output]").count(), 4);
    await page.context().close();
  });
}

test("a board at the port that lacks points keeps its program and says what it lacks; the larger one takes that of the smaller", async () => {
  const page = await connected(lab);
  await type(page, "LD I1\nST Q1\n");
  await run(page);
  await select(page, "#for-board", "mega");
  await type(page, "LD I1\nST Q2\nLD I24\nST Q16\n");
  await page.locator("#problem-count.good").waitFor();
  for (const [speak, words] of /** @type {const} */ ([
    ["en", /the UNO cannot run this program: line 3: .*I24.*nothing was sent/],
    ["pt", /o UNO não executa este programa: linha 3: .*I24.*nada foi enviado/],
  ])) {
    await select(page, "#speak", speak);
    await page.click("#run");
    const note = page.locator("#notes div", { hasText: words });
    await note.waitFor();
    await note.getByRole("button").last().click();
  }
  await state(page, "RUN");
  await holding(page, 1, () => lamp(page, 1, true));
  await page.context().close();

  const other = await connect(await lab.open(), null, "mega");
  await type(other, "LD I1\nST Q1\n");
  await run(other);
  await holding(other, 1, () => lamp(other, 1, true));
  await other.context().close();
});
