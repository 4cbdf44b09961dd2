// A filling station is drawn as a chart: by the keyboard alone, by mouse, by finger; then it runs.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding, mouse, touch } from "./hands.mjs";
import { Lab, keptText, lamp, run, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

const BARE = `PROGRAM filling
VAR start AT %IX1 : BOOL; full AT %IX2 : BOOL; valve AT %QX1 : BOOL; END_VAR
INITIAL_STEP Wait: END_STEP
TRANSITION FROM Wait TO Wait := FALSE; END_TRANSITION
END_PROGRAM
`;

/** A page with the chart of one step. @param {import("playwright-core").BrowserContextOptions} [options] */
async function begun(options) {
  const page = await lab.open(options);
  await page.click("#view-text");
  await type(page, BARE, "filling.st");
  await page.click("#view-draw");
  await page.locator('#chart-sheet [data-id="s0"]').waitFor();
  return page;
}

/** What runs is what was drawn. @param {Page} page */
async function fills(page, hand = mouse) {
  const text = await keptText(page);
  for (const part of ["STEP Fill: valve(N); END_STEP", "FROM Wait TO Fill := start;", "FROM Fill TO Wait := full;"]) assert.ok(text.includes(part), text);
  await run(page);
  await page.locator('#chart-sheet .active[data-id="s0"]').waitFor();
  await holding(page, 1, () => lamp(page, 1, true), hand);
  await page.locator('#chart-sheet .active[data-id="s1"]').waitFor();
  await holding(page, 2, () => lamp(page, 1, false), hand);
  await page.locator('#chart-sheet .active[data-id="s0"]').waitFor();
}

/** Waits until the text has this. @param {Page} page @param {string} part */
async function has(page, part) {
  await page.waitForFunction((part) => document.querySelector(".cm-content")?.textContent?.includes(part), part);
}

test("by the keyboard alone, and back again", async () => {
  const page = await begun();
  /** @param {string} field @param {string} text @param {string} part */
  const write = async (field, text, part) => {
    await page.keyboard.press("Enter");
    await page.locator(`${field}:focus`).waitFor();
    await page.keyboard.press("Control+A");
    await page.keyboard.insertText(text);
    await page.keyboard.press("Enter");
    await has(page, part);
  };
  await page.focus("#chart-sheet");
  await page.keyboard.press("a");
  await page.locator('#chart-sheet .selected[data-id="s1"]').waitFor();
  await write("#chart-name", "Fill", "STEP Fill:");
  await page.keyboard.press("q");
  await page.locator('#chart-sheet .selected[data-id="a1.0"]').waitFor();
  await write("#chart-action", "valve", "valve(N)");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowUp");
  await page.locator('#chart-sheet .selected[data-id="t0"]').waitFor();
  await write("#chart-condition", "start", ":= start");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await page.locator('#chart-sheet .selected[data-id="t1"]').waitFor();
  await write("#chart-condition", "full", ":= full");
  await fills(page);
  await page.focus("#chart-sheet");
  for (let left = 20; left > 0 && (await page.isEnabled("#chart-undo")); left--) {
    const before = await keptText(page);
    await page.keyboard.press("Control+z");
    await page.waitForFunction((before) => JSON.parse(localStorage.getItem(`program/${sessionStorage.getItem("place")}`) ?? "{}").text !== before, before);
  }
  assert.equal(await keptText(page), BARE);
  await page.context().close();
});

for (const hand of [mouse, touch]) {
  test(`by ${hand.name}`, async () => {
    const page = await begun(hand.options);
    /** @param {string} id */
    const take = async (id) => {
      await hand.press(page, `#chart-sheet [data-id="${id}"]`);
      await page.locator(`#chart-sheet .selected[data-id="${id}"]`).waitFor();
    };
    await take("s0");
    await hand.press(page, "#chart-after");
    await page.locator('#chart-sheet .selected[data-id="s1"]').waitFor();
    await hand.write(page, "#chart-name", "Fill");
    await has(page, "STEP Fill:");
    await hand.press(page, "#chart-act");
    await page.locator('#chart-sheet .selected[data-id="a1.0"]').waitFor();
    await hand.write(page, "#chart-action", "valve");
    await has(page, "valve(N)");
    await take("t0");
    await hand.write(page, "#chart-condition", "start");
    await has(page, ":= start");
    await take("t1");
    await hand.write(page, "#chart-condition", "full");
    await has(page, ":= full");
    await fills(page, hand);
    await page.context().close();
  });
}
