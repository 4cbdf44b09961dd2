// A program as blocks: the switch, what is live, and that the same hands change it in both looks.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, clean, keptText, lamp, pick, pictures, run, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** A latch; and an OR of two inputs after a third, with a coil. */
const LATCH = [0, 827301, 40, 827901, 41, -827302, 877901, 787600, 827303, 6540, 827301, 40, 827302, 41, 41, 877902].join("\n");

/** A straight wire has no height: it is there, and counts as hidden. */
const drawn = /** @type {const} */ ({ state: "attached" });

/** The wires that carry power, beside those of the rails. @param {Page} page */
const lit = (page) => page.locator("#sheet .ladder.live .wire.on").count();

test("a latch is shown as blocks and back, runs live in both, and is changed as blocks", async () => {
  const page = await lab.open();
  await type(page, `${LATCH}\n`, "latch.txt");
  await page.click("#view-draw");
  await page.locator("#sheet .element").first().waitFor();
  const elements = await page.locator("#sheet .element").count();
  await pick(page, "#look-blocks");
  await page.locator("#sheet text.letter", { hasText: "≥1" }).first().waitFor();
  assert.equal(await page.locator("#sheet .element").count(), elements);
  assert.equal(await page.locator("#sheet text.letter", { hasText: "&" }).count(), 2);
  await page.screenshot({ path: join(pictures, "blocks.png") });

  await run(page);
  await holding(page, 1, () => lamp(page, 1, true));
  // I1 is off again: Q1 keeps the OR, and I2, which is off, is negated.
  await page.locator('#sheet .ladder.live .wire.on[data-says="Q1"]').waitFor(drawn);
  await page.locator('#sheet .ladder.live .wire:not(.on)[data-says="I1"]').first().waitFor(drawn);
  await page.locator('#sheet .ladder.live .element.on[data-point="Q1"]').first().waitFor();
  assert.ok((await lit(page)) >= 3);
  // The OR of the second rung says what its inputs say, though I3 before it is off.
  await holding(page, 2, () => page.locator('#sheet .ladder.live .wire.on[data-says="|2 I1 I2"]').waitFor(drawn));

  // The selected block is deleted and put back, as in the ladder.
  const before = await keptText(page);
  await page.locator('#sheet .element[data-point="I2"]').first().click();
  await page.locator("#sheet .element.selected").waitFor();
  await page.keyboard.press("Delete");
  await page.waitForFunction((count) => document.querySelectorAll("#sheet .element").length === count, elements - 1);
  assert.notEqual(await keptText(page), before);
  await page.keyboard.press("Control+z");
  await page.waitForFunction((count) => document.querySelectorAll("#sheet .element").length === count, elements);

  // The look is kept, and goes back.
  await page.reload();
  await page.locator("#sheet text.letter", { hasText: "≥1" }).first().waitFor();
  await pick(page, "#look-ladder");
  await page.waitForFunction(() => ![...document.querySelectorAll("#sheet text.letter")].some((text) => text.textContent === "≥1"));
  await clean(page, "blocks");
});

/** A counter whose result is taken twice: fan-out by the name of a marker. */
const COUNTS = "LD I1\nCTU C1, I2, 2\nST M1\nLD M1\nST Q1\nLD M1\nANDN I3\nST Q2\n";

test("an FBD with a counter and fan-out", async () => {
  const page = await lab.open();
  await type(page, COUNTS, "counts.il");
  await page.click("#view-draw");
  await page.locator("#sheet .element").first().waitFor();
  await pick(page, "#look-blocks");
  await page.locator("#sheet text", { hasText: "CTU" }).first().waitFor();
  // The name stands where it is written, and where it is taken.
  await page.waitForFunction(() => document.querySelectorAll('#sheet .element[data-point="M1"]').length === 3);
  // So is when a block runs.
  await page.locator("#sheet text.order").first().waitFor();
  await run(page);
  const contact = (state = "") => page.locator(`#sheet .ladder.live .element${state}[data-point="I1"]`).first();
  for (let count = 0; count < 2; count++) {
    await holding(page, 1, () => contact(".on").waitFor());
    await contact(":not(.on)").waitFor();
  }
  await lamp(page, 1, true);
  await lamp(page, 2, true);
  await page.locator('#sheet .ladder.live .element.on[data-point="M1"]').nth(2).waitFor();
  await holding(page, 3, () => lamp(page, 2, false));
  await lamp(page, 1, true);
  // One more place takes it, by the keyboard; and back.
  await page.locator('#sheet .element[data-point="Q2"]').first().click();
  await page.locator('#sheet .element.selected[data-point="Q2"]').waitFor();
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => document.querySelectorAll('#sheet .element[data-point="Q2"]').length === 0);
  await page.keyboard.press("Control+z");
  await page.locator('#sheet .element[data-point="Q2"]').first().waitFor();
  await page.context().close();
});
