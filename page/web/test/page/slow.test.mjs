// A scan in slow motion, on the firmware of the simulated board and on this computer.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, clean, lamp, pick, run, select, turned, type } from "./harness.mjs";

/** Two rungs: line 1 and 2, line 4 to 6; line 3 makes no code. */
const PROGRAM = `LD I1
ST Q1
(* the second *)
LD I2
ANDN I3
ST Q2
`;

/** @type {Lab} */
let lab;
before(async () => (lab = await Lab.begin()));
after(() => lab.end());

/** Where it stands, in words. @param {import("playwright-core").Page} page @param {RegExp} says */
const stands = (page, says) => page.locator("#slow-state", { hasText: says }).waitFor();

/** Closes the contact of input 1, or opens it. @param {import("playwright-core").Page} page */
const latch = (page) => page.locator('[data-input="1"]').click({ modifiers: ["Shift"] });

/** A page whose board runs a program, in slow motion. @param {string} text @param {string} name
 * @param {import("playwright-core").BrowserContextOptions} options */
async function slow(text = PROGRAM, name = "slow.il", first = 1, options = {}) {
  const page = await lab.open(options);
  await type(page, text, name);
  await run(page);
  await page.locator("#ladder svg.live").waitFor();
  await pick(page, "#slow-motion");
  await stands(page, new RegExp(`Next: line ${first}\\.`));
  return page;
}

test("element by element, by the mouse: power moves as the engine goes, and images stand beside pins", async () => {
  const page = await slow();
  // The engine has fetched nothing yet: no wire behind the first contact has power.
  assert.equal(await page.locator("#ladder .element.slow-here").count() > 0, true);
  // Pressed in the middle of a scan: at the pin, and not in the image.
  await latch(page);
  await page.click("#slow-element");
  await stands(page, /Next: line 2\. The accumulator is 0/);
  assert.equal(await page.locator("#slow-acc").textContent(), "0");
  await page.click("#slow-end");
  await stands(page, /The scan is over/);
  // The next scan has it.
  await page.click("#slow-element");
  await stands(page, /Next: line 1/);
  assert.equal(await page.locator("#slow-I tbody tr").first().locator("td").allTextContents().then((cells) => cells.join()), "1,1");
  await page.click("#slow-element");
  await stands(page, /Next: line 2\. The accumulator is 1/);
  // The coil has been written to the image, and not to the pin.
  await page.click("#slow-rung");
  await stands(page, /Next: line 4/);
  assert.equal(await page.locator("#slow-Q tbody tr").first().locator("td").allTextContents().then((cells) => cells.join()), "1,0");
  await lamp(page, 1, false);
  await page.click("#slow-end");
  await stands(page, /The scan is over/);
  await lamp(page, 1, true);
  await clean(page, "slow motion");
  await page.click("#slow-close");
  await page.locator("#slow").waitFor({ state: "hidden" });
  // The board goes on.
  await latch(page);
  await lamp(page, 1, false);
  await page.context().close();
});

test("power has come as far as the engine, between contacts that it runs at once too", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nOR Q1\nANDN I2\nST Q1\n", "slow.il");
  await run(page);
  await page.locator("#ladder svg.live").waitFor();
  await latch(page);
  await lamp(page, 1, true);
  await pick(page, "#slow-motion");
  await stands(page, /Next: line 1/);
  const lit = async () => (await page.locator("#ladder .element.on").evaluateAll((all) => all.map((one) => one.getAttribute("data-point")))).join();
  await page.waitForFunction(() => document.querySelectorAll("#ladder .element.on").length === 0);
  await page.keyboard.press("F10");
  await stands(page, /Next: line 3/);
  assert.equal(await lit(), "I1,Q1");
  await page.keyboard.press("F10");
  await stands(page, /Next: line 4/);
  assert.equal(await lit(), "I1,I2,Q1");
  await page.context().close();
});

for (const view of /** @type {const} */ (["draw", "text"])) {
  test(`on a phone no stop turns the page, ${view}`, async () => {
    const page = await slow(PROGRAM, "slow.il", 1, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
    await page.tap(`#view-${view}`);
    await page.tap("#page-machine");
    await turned(page, "#board");
    const left = () => page.locator("#board").evaluate((board) => Math.round(board.getBoundingClientRect().left));
    for (const line of [2, 4]) {
      // What comes late, after the page was turned.
      await page.dispatchEvent(line === 2 ? "#slow-element" : "#slow-rung", "click");
      await page.locator("#slow-state", { hasText: `Next: line ${line}` }).waitFor({ state: "attached" });
      // It is marked at once, and comes into view with the next frame.
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
      assert.equal(await left(), 0);
    }
    await page.context().close();
  });
}

test("by the keyboard: by lines, a breakpoint on a line without code, to here, and on", async () => {
  const page = await slow();
  await page.keyboard.press("Alt+F10");
  await stands(page, /Next: line 2/);
  await page.keyboard.press("Alt+F10");
  await stands(page, /Next: line 4/);
  // The comment makes no code: the next line that does is told.
  await page.locator(".cm-line").nth(2).click();
  await page.keyboard.press("F9");
  await page.locator("#notes", { hasText: "Line 3 generates no code. The breakpoint is on line 4." }).waitFor();
  assert.equal(await page.locator(".slow-breaks button").count(), 1);
  await page.keyboard.press("F4");
  await stands(page, /Next: line 4/);
  // To where the cursor is: once round through the end of the scan.
  await page.locator(".cm-line").nth(1).click();
  await page.keyboard.press("Control+F9");
  await stands(page, /Next: line 2/);
  await page.keyboard.press("Control+F8");
  await stands(page, /The scan is over/);
  await page.click(".slow-breaks button");
  assert.equal(await page.locator(".slow-breaks button").count(), 0);
  await page.context().close();
});

test("a program that is changed while it stands is let go, and what was written stays", async () => {
  const page = await slow();
  await page.locator(".cm-line").nth(4).click();
  await page.keyboard.press("End");
  await page.keyboard.type(" (* more *)");
  await page.locator("#notes", { hasText: "The program has changed" }).waitFor();
  assert.match(await page.locator(".cm-content").innerText(), /ANDN I3 \(\* more \*\)/);
  // The board runs on.
  await latch(page);
  await lamp(page, 1, true);
  await page.context().close();
});

test("Structured Text goes statement by statement, with the values", async () => {
  const page = await slow("PROGRAM p\nVAR a AT %MD1 : DINT; END_VAR\na := 3;\na := a * 7;\n%QX0.0 := a > 20;\nEND_PROGRAM\n", "slow.st", 3);
  await page.keyboard.press("Alt+F10");
  await stands(page, /Next: line 4/);
  assert.equal(await page.locator("#slow-value").textContent(), "3");
  await page.keyboard.press("Alt+F10");
  await stands(page, /Next: line 5/);
  assert.equal(await page.locator("#slow-value").textContent(), "21");
  // The values stand beside the statements that have been run, and beside no other.
  assert.deepEqual(await page.locator(".cm-state .cm-gutterElement span").allTextContents(), ["= 3", "= 21"]);
  await page.keyboard.press("Control+F8");
  await stands(page, /The scan is over/);
  await lamp(page, 1, true);
  await page.context().close();
});

/** A chart: its step without actions makes no code of its own. */
const CHART = `PROGRAM filling
VAR start AT %IX1 : BOOL; full AT %IX2 : BOOL; valve AT %QX1 : BOOL; END_VAR
INITIAL_STEP Wait: END_STEP
STEP Fill: valve(N); END_STEP
TRANSITION FROM Wait TO Fill := start; END_TRANSITION
TRANSITION FROM Fill TO Wait := full; END_TRANSITION
END_PROGRAM
`;

for (const board of ["uno", "pc"]) {
  test(`a chart stops at its transitions, steps and actions, ${board}`, async () => {
    const page = await lab.open();
    await type(page, CHART, "chart.st");
    await select(page, "#for-board", board);
    await run(page);
    await page.click("#view-draw");
    /** @param {string} id @param {string} [state] */
    const part = (id, state = "") => page.locator(`#chart-sheet ${state}[data-id="${id}"]`);
    await part("s0", ".active").waitFor();
    await pick(page, "#slow-motion");
    await stands(page, /Next: line/);
    // To a transition, and from there to an action.
    await part("t1").click();
    await page.keyboard.press("Control+F9");
    await stands(page, /Next: line 6/);
    await part("t1", ".slow-here").waitFor();
    // Its jump is of it.
    const here = await page.locator("#chart-sheet .slow-here").evaluateAll((all) => all.map((one) => one.getAttribute("data-id")));
    assert.deepEqual(here.sort(), ["j1.0", "t1"]);
    await part("a1.0").click();
    await page.keyboard.press("F9");
    await part("a1.0", ".slow-stop").waitFor();
    assert.match((await page.locator(".slow-breaks button").textContent()) ?? "", /Action valve/);
    await page.keyboard.press("F4");
    await stands(page, /Next: line 4/);
    await part("a1.0", ".slow-here").waitFor();
    // It makes no code of its own: that is told, and nothing else changes.
    await part("s1").click();
    await page.keyboard.press("F9");
    await page.locator("#notes", { hasText: "Step Fill: this part of the chart generates no code of its own." }).waitFor();
    assert.equal(await page.locator(".slow-breaks button").count(), 1);
    // The marks outlast another look of the same chart.
    await page.click("#chart-look");
    await part("a1.0", ".slow-here.slow-stop").waitFor();
    await clean(page, "a chart in slow motion");
    await page.click(".slow-breaks button");
    assert.equal(await page.locator(".slow-breaks button").count(), 0);
    // A step more is another program: it is let go, and the step stays.
    await part("s1").click();
    await page.click("#chart-after");
    await page.locator("#notes", { hasText: "The program has changed" }).waitFor();
    await part("s2").waitFor();
    assert.equal(await page.locator("#chart-sheet .slow-here").count(), 0);
    await page.context().close();
  });
}

test("a Mega goes slowly too, by the map of its own firmware", async () => {
  const page = await lab.open();
  await type(page, "LD I24\nAND I5\nANDN I6\nST Q16\nLD Q16\nST Q1\n", "far.il");
  await select(page, "#for-board", "mega");
  await run(page);
  await page.locator("#ladder svg.live").waitFor();
  for (const input of [24, 5]) await page.locator(`[data-input="${input}"]`).click({ modifiers: ["Shift"] });
  await lamp(page, 16, true);
  await pick(page, "#slow-motion");
  await stands(page, /Next: line 1/);
  await page.keyboard.press("Control+F10");
  await stands(page, /Next: line 5/);
  // Power has come through contacts that the engine runs at once, at inputs that have bytes of their own.
  const lit = async () => (await page.locator("#ladder .element.on").evaluateAll((all) => all.map((one) => one.getAttribute("data-point")))).join();
  assert.equal(await lit(), "I24,I5,I6,Q16");
  /** @param {string} table */
  const rows = (table) => page.locator(`#slow-${table} tbody tr`).evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent).join(" ")));
  assert.deepEqual(await rows("I"), ["I5 1 1", "I6 0 0", "I24 1 1"]);
  assert.deepEqual(await rows("Q"), ["Q1 1 1", "Q16 1 1"]);
  await page.locator('[data-input="5"]').click({ modifiers: ["Shift"] });
  await page.keyboard.press("Control+F8");
  await stands(page, /The scan is over/);
  await page.keyboard.press("Control+F10");
  await stands(page, /Next: line 1/);
  await page.keyboard.press("Control+F10");
  await stands(page, /Next: line 5/);
  // The output is written at the end of the scan.
  assert.deepEqual(await rows("Q"), ["Q1 1 1", "Q16 0 1"]);
  assert.deepEqual(await rows("I"), ["I5 0 0", "I6 0 0", "I24 1 1"]);
  await page.click("#slow-close");
  await lamp(page, 16, false);
  await page.context().close();
});

test("this computer goes slowly too", async () => {
  const page = await lab.open();
  await type(page, PROGRAM, "slow.il");
  await select(page, "#for-board", "pc");
  await run(page);
  await pick(page, "#slow-motion");
  await stands(page, /Next: line 1/);
  await latch(page);
  await page.keyboard.press("Control+F8");
  await stands(page, /The scan is over/);
  await page.keyboard.press("F10");
  await page.keyboard.press("F10");
  await stands(page, /The accumulator is 1/);
  await page.keyboard.press("F4");
  await stands(page, /is running/);
  await page.click("#slow-close");
  await lamp(page, 1, true);
  await page.context().close();
});
