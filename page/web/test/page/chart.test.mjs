// A filling station is drawn as a chart: by mouse, by finger, by the keyboard alone; then it runs. A chart controls its machine.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { fingers, holding, mouse } from "./hands.mjs";
import { Lab, choose, clean, has, keptText, lamp, pick, run, type } from "./harness.mjs";

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
  await part(page, "s0").waitFor();
  return page;
}

/** A part of the chart. @param {Page} page @param {string} id */
const part = (page, id, state = "") => page.locator(`#chart-sheet ${state}[data-id="${id}"]`);

/** What runs is what was drawn, and chart and ladder show it. @param {Page} page */
async function fills(page, hand = mouse) {
  const text = await keptText(page);
  for (const written of ["STEP Fill: valve(N); END_STEP", "FROM Wait TO Fill := start;", "FROM Fill TO Wait := full;"]) assert.ok(text.includes(written), text);
  await run(page);
  await part(page, "s0", ".active").waitFor();
  await part(page, "t0", ".ready").waitFor();
  await page.locator("#ladder svg.live").waitFor();
  await holding(page, 1, () => lamp(page, 1, true), hand);
  await part(page, "s1", ".active").waitFor();
  await part(page, "t1", ".ready").waitFor();
  await part(page, "s1").locator(".time", { hasText: /^\d+\.\d s$/ }).waitFor();
  await holding(page, 2, () => lamp(page, 1, false), hand);
  await part(page, "s0", ".active").waitFor();
}

for (const hand of [mouse, fingers]) {
  test(`a filling station by ${hand.name}`, async () => {
    const page = await begun(hand.options);
    /** @param {string} id */
    const take = async (id) => {
      await hand.press(page, part(page, id));
      await part(page, id, ".selected").waitFor();
    };
    await take("s0");
    await hand.press(page, "#chart-after");
    await part(page, "s1", ".selected").waitFor();
    await hand.write(page, "#chart-name", "Fill");
    await has(page, "STEP Fill:");
    await hand.press(page, "#chart-act");
    await part(page, "a1.0", ".selected").waitFor();
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

test("a filling station by the keyboard alone, and back to its beginning", async () => {
  const page = await begun();
  /** @param {string} field @param {string} text @param {string} written */
  const write = async (field, text, written) => {
    await page.keyboard.press("Enter");
    await page.locator(`${field}:focus`).waitFor();
    await page.keyboard.insertText(text);
    await page.keyboard.press("Enter");
    await has(page, written);
  };
  await page.focus("#chart-sheet");
  await page.keyboard.press("a");
  await part(page, "s1", ".selected").waitFor();
  await write("#chart-name", "Fill", "STEP Fill:");
  await page.keyboard.press("q");
  await part(page, "a1.0", ".selected").waitFor();
  await write("#chart-action", "valve", "valve(N)");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowUp");
  await part(page, "t0", ".selected").waitFor();
  await write("#chart-condition", "start", ":= start");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await part(page, "t1", ".selected").waitFor();
  await write("#chart-condition", "full", ":= full");
  await fills(page);
  await page.focus("#chart-sheet");
  const drawn = await keptText(page);
  for (let acts = 0; acts < 6; acts++) await page.keyboard.press("Control+z");
  await has(page, BARE);
  await page.locator("#chart-undo:disabled").waitFor();
  for (let acts = 0; acts < 6; acts++) await page.keyboard.press("Control+y");
  await has(page, drawn);
  await page.context().close();
});

test("selections, simultaneous sequences, jumps and qualifiers, in either look", async () => {
  const page = await begun();
  /** @param {string} what @param {string} id */
  const add = async (what, id) => {
    await page.click(`#chart-${what}`);
    await part(page, id, ".selected").waitFor();
  };
  await part(page, "s0").click();
  await add("after", "s1");
  await add("beside", "s2");
  await has(page, "TO (S1, S2)");
  await part(page, "t0").click();
  await add("branch", "s3");
  await has(page, "FROM Wait TO S3");
  // What the chart lacks is told, and nothing is lost.
  await part(page, "s0").click();
  await page.click("#chart-beside");
  await page.locator("#notes", { hasText: "select a step first" }).waitFor();
  await part(page, "s3").click();
  await page.selectOption("#chart-jump", "Wait");
  // Its sequence came back there already: this is a second transition.
  await has(page, "FROM S3 TO Wait := TRUE; END_TRANSITION\nTRANSITION FROM S3 TO Wait");
  await part(page, "s3").click();
  await add("act", "a3.0");
  await mouse.write(page, "#chart-action", "valve");
  await has(page, "valve(N)");
  await page.selectOption("#chart-qualifier", "L");
  await has(page, "valve(L, T#1s)");
  await mouse.write(page, "#chart-time", "T#2s");
  await has(page, "valve(L, T#2s)");
  // An action of several lines.
  await part(page, "s1").click();
  await add("act", "a1.0");
  await page.fill("#chart-body", "valve := start;\nvalve := valve OR full;");
  await page.press("#chart-body", "Control+Enter");
  await has(page, "valve := valve OR full;");
  const norm = await page.locator("#chart-sheet svg").innerHTML();
  await page.click("#chart-look");
  await page.waitForFunction((norm) => document.querySelector("#chart-sheet svg")?.innerHTML !== norm, norm);
  await clean(page, "chart");
  await page.reload();
  await part(page, "s3").waitFor();
  await page.locator('#chart-sheet [data-id="a3.0"]', { hasText: "2s" }).waitFor();
  // What is written in the text is a step of the chart too.
  await page.click("#view-text");
  await type(page, BARE);
  await page.click("#view-draw");
  await part(page, "s1").waitFor({ state: "detached" });
  await page.click("#chart-undo");
  await part(page, "s3").waitFor();
  // What is wrong stands at its part.
  await part(page, "t0").click();
  await mouse.write(page, "#chart-condition", "nobody");
  await part(page, "t0", ".wrong").waitFor();
  await page.locator("#chart-form .error", { hasText: "nobody" }).waitFor();
  await page.waitForFunction(() => document.querySelectorAll("#chart-sheet .wrong").length === 1);
  await page.focus("#chart-sheet");
  await page.keyboard.press("Control+z");
  await part(page, "t0", ":not(.wrong)").waitFor();
  await pick(page, "#new-chart");
  await has(page, "STEP Work: lamp(N)");
  await part(page, "t1").waitFor();
  await page.locator("#problem-count.good").waitFor();
  // A program without a chart shows none.
  await pick(page, "#new-file");
  await page.locator("#chart").waitFor({ state: "hidden" });
  await page.waitForFunction(() => document.querySelectorAll("#sheet .rung").length === 1);
  await page.context().close();
});

/** The switches close a little before the end: each way out or in has a step in which it settles. */
const CYLINDERS = `PROGRAM cylinders
VAR
  start AT %IX1 : BOOL;
  a_in AT %IX2 : BOOL; a_out AT %IX3 : BOOL; b_in AT %IX4 : BOOL; b_out AT %IX5 : BOOL;
  a_plus AT %QX1 : BOOL; a_minus AT %QX2 : BOOL; b_plus AT %QX3 : BOOL; b_minus AT %QX4 : BOOL;
END_VAR
INITIAL_STEP Rest: END_STEP
STEP Clamp: a_plus(N); END_STEP
STEP Clamped: a_plus(N); END_STEP
STEP Work: b_plus(N); END_STEP
STEP Worked: b_plus(N); END_STEP
STEP Pull: b_minus(N); END_STEP
STEP Pulled: b_minus(N); END_STEP
STEP Release: a_minus(N); END_STEP
TRANSITION FROM Rest TO Clamp := start AND a_in AND b_in; END_TRANSITION
TRANSITION FROM Clamp TO Clamped := a_out; END_TRANSITION
TRANSITION FROM Clamped TO Work := Clamped.T >= T#50ms; END_TRANSITION
TRANSITION FROM Work TO Worked := b_out; END_TRANSITION
TRANSITION FROM Worked TO Pull := Worked.T >= T#50ms; END_TRANSITION
TRANSITION FROM Pull TO Pulled := b_in; END_TRANSITION
TRANSITION FROM Pulled TO Release := Pulled.T >= T#50ms; END_TRANSITION
TRANSITION FROM Release TO Rest := a_in AND NOT start; END_TRANSITION
END_PROGRAM
`;

test("A+B+B-A- as a chart controls its cylinders", async () => {
  const page = await lab.open();
  await pick(page, "#machines");
  await page.locator("#gallery .gallery-card", { has: page.locator("h3", { hasText: "Cylinders A+ B+ B−" }) }).locator("[data-machine]").click();
  await page.locator("#machine").waitFor();
  await choose(page, "cylinders.st", Buffer.from(CYLINDERS));
  await page.click("#view-draw");
  await part(page, "s0").waitFor();
  await run(page);
  await part(page, "s0", ".active").waitFor();
  await page.locator('#machine-picture [data-part="start"]').hover();
  await page.mouse.down();
  // It waits at its end until the button is let go.
  await part(page, "s7", ".active").waitFor();
  await page.mouse.up();
  await part(page, "s0", ".active").waitFor();
  for (const goal of [/brings A out/, /B goes in/, /A goes in/]) await page.locator('#machine-rules li[data-state="met"]', { hasText: goal }).waitFor();
  assert.equal(await page.locator('#machine-rules li[data-state="broken"]').count(), 0);
  await page.context().close();
});
