// The simulated board as a class sees it: its card; and the page without a network. What every hand does is in hands.test.mjs.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, lamp, run, state, tab, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("a card runs its program after a reset, and shows its files", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nST Q2\n", "card.il");
  await page.locator('.ladder .element[data-point="Q2"]').waitFor();
  await tab(page, "card");
  await page.click("#make-card");
  await page.locator("#panel-card pre").first().waitFor();
  assert.match((await page.textContent("#panel-card")) ?? "", /PROGRAM\.TXT[^]*877902[^]*STATE\.TXT/);
  await page.click("#reset");
  await state(page, "RUN");
  await tab(page, "serial");
  await page.locator("#panel-serial", { hasText: "RUN" }).waitFor();
  await holding(page, 1, () => lamp(page, 2, true));
  await page.context().close();
});

test("the page works without its server, once it was there", async () => {
  const page = await lab.open({ serviceWorkers: "allow" });
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.context().setOffline(true);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  await run(page);
  await page.context().close();
});
