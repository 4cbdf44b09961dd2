// The ladder as professionals draw it: as wide as its area, with boxes whose pins show what they have come to.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, choose, lightAndDark, pictures, run } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

const PROGRAM = `VAR start AT I1 : BOOL; pump AT Q1 : BOOL; ready AT T1 : BOOL; END_VAR
(* The pump starts late *)
LD start
TON T1, 500
ST pump
LD start
CTU C1, 3
`;

/** Waits until the drawing fills its paper and does not scroll. A drawing for an older, wider window may still be there.
 * @param {Page} page @param {string} of */
const fills = (page, of) => page.waitForFunction((of) => {
  const svg = document.querySelector(`${of} svg.ladder`);
  const paper = svg?.parentElement;
  const isFull = paper && paper.clientWidth > 0 && svg.getBoundingClientRect().width > paper.clientWidth - 40;
  return isFull && paper.scrollWidth <= paper.clientWidth;
}, of);

for (const [width, height] of /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]])) {
  test(`at ${width} × ${height} the ladder fills its area, and its coils stand at the right rail`, async () => {
    const page = await lab.other({ viewport: { width, height } }, { view: "draw", palette: "folded" });
    await choose(page, "late.il", Buffer.from(PROGRAM));
    await page.locator('#sheet .element[data-point="T1"]').waitFor();
    await fills(page, "#sheet");
    // A box, a coil, and the rail of both rungs.
    const rails = await page.locator("#sheet .rail:not(.n0)").evaluateAll((all) => all.map((one) => one.getBoundingClientRect().left));
    assert.equal(new Set(rails).size, 1);
    for (const point of ["Q1", "C1"]) {
      const { right } = await page.locator(`#sheet .element[data-point="${point}"] .area`).evaluate((one) => one.getBoundingClientRect());
      assert.ok(Number(rails[0]) - right < 60, `${point}: ${right} of ${rails[0]}`);
    }
    await lightAndDark(page, async (scheme) => void (await page.screenshot({ path: join(pictures, `ladder-${width}-${scheme}.png`) })));
    await page.context().close();
  });
}

test("both ladders follow the width of the window", async () => {
  const page = await lab.other({ viewport: { width: 1366, height: 768 } });
  await choose(page, "late.il", Buffer.from(PROGRAM));
  for (const width of [1700, 1100]) {
    await page.setViewportSize({ width, height: 768 });
    await fills(page, "#ladder");
  }
  await page.click("#view-draw");
  for (const width of [1366, 1000]) {
    await page.setViewportSize({ width, height: 768 });
    await fills(page, "#sheet");
  }
  await page.context().close();
});

test("a timer and a counter are boxes with pins, and show live what they have come to", async () => {
  const page = await lab.open({}, "");
  await page.click("#view-draw");
  await choose(page, "late.il", Buffer.from(PROGRAM));
  const box = (/** @type {string} */ point) => page.locator(`#sheet .element[data-point="${point}"]`);
  await box("T1").waitFor();
  const texts = async (/** @type {string} */ point) => (await box(point).locator("text").allTextContents()).filter((text) => text !== "");
  assert.deepEqual(await texts("T1"), ["T1", "TON", "IN", "Q", "PT", "ET", "T#500ms"]);
  assert.deepEqual(await texts("C1"), ["C1", "CTU", "CU", "Q", "PV", "CV", "3"]);
  await page.locator("#sheet .name", { hasText: "start" }).first().waitFor();
  await run(page);
  await page.locator("#sheet .ladder.live .rail.n0.on").first().waitFor({ state: "attached" });
  assert.equal(await page.locator("#sheet .rail.on:not(.n0)").count(), 0, "power comes from the left");
  await box("T1").locator(".count", { hasText: "T#0ms" }).waitFor();
  await holding(page, 1, async () => {
    await box("T1").locator(".count", { hasText: "T#500ms" }).waitFor();
    await box("C1").locator(".count", { hasText: "1" }).waitFor();
    await page.locator('#sheet .element.on[data-point="Q1"]').waitFor();
    await page.screenshot({ path: join(pictures, "ladder-live.png") });
  });
  await page.context().close();
});

test("a comment that is longer than the drawing goes on in another line", async () => {
  const page = await lab.other({ viewport: { width: 390, height: 844 } }, { view: "draw", palette: "folded" });
  const words = Array.from({ length: 16 }, (_, at) => `longword${at}`).join(" ");
  await choose(page, "long.il", Buffer.from(`LD I1\nST Q1\n\n(* ${words} *)\nLD I2\nST Q2\n`));
  await page.locator('#sheet .element[data-point="Q2"]').waitFor();
  const out = await page.locator("#sheet svg.ladder").evaluate((svg) => {
    const { right } = svg.getBoundingClientRect();
    return [...svg.querySelectorAll(".heading, .remark")].filter((one) => one.getBoundingClientRect().right > right).map((one) => one.textContent);
  });
  assert.deepEqual(out, []);
  await page.locator("#sheet .remark", { hasText: "longword15" }).waitFor();
  await page.context().close();
});
