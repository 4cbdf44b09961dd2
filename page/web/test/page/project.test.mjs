// A project with all five languages: its units, their variables and bodies are edited, mistakes stand at their element; it is
// saved, opened, run.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { holding, mouse } from "./hands.mjs";
import { Lab, choose, clean, has, keptText, lamp, pick, run } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

const FIVE = readFileSync(fileURLToPath(new URL("five.xml", import.meta.url)));

/** A page with the project. @param {import("playwright-core").BrowserContextOptions} [options] */
async function begun(options) {
  const page = await lab.open(options);
  await choose(page, "five.xml", FIVE);
  await page.click("#view-draw");
  await page.locator("#project-pane").waitFor();
  await page.locator('#project-body[data-unit="main"]').waitFor();
  return page;
}

/** Opens a unit. @param {Page} page @param {string} unit */
async function open(page, unit) {
  await page.click(`#project-tree [data-unit="${unit}"]`);
  await page.locator(`#project-body[data-unit="${unit}"]`).waitFor();
}

/** The field of a variable. @param {Page} page @param {string} variable @param {string} field */
const field = (page, variable, field) => page.locator(`tr[data-variable="${variable}"] [id$="-${field}"]`);

/** Waits until it shows this. @param {Page} page @param {string} variable @param {string} what @param {string} text */
const shows = (page, variable, what, text) => page.waitForFunction(
  ([variable, what, text]) => /** @type {HTMLInputElement | null} */ (document.querySelector(`tr[data-variable="${variable}"] [id$="-${what}"]`))?.value === text,
  /** @type {const} */ ([variable, what, text]));

/** Writes into it. @param {Page} page @param {string} variable @param {string} what @param {string} text */
async function write(page, variable, what, text) {
  await field(page, variable, what).fill(text);
  await field(page, variable, what).press("Enter");
}

test("the variables of a unit are edited in a table", async () => {
  const page = await begun();
  assert.equal(await field(page, "start", "comment").inputValue(), "the green button");
  await write(page, "halt", "comment", "the red button");
  await has(page, "the red button");
  await write(page, "lamp", "place", "%QX5");
  await has(page, 'name="lamp" address="%QX5"');
  await field(page, "hold", "retained").click();
  await has(page, 'retain="true"');
  await page.fill("#variable-new", "count");
  await page.press("#variable-new", "Enter");
  await has(page, '<variable name="count">');
  await page.waitForFunction(() => document.querySelector('tr[data-variable="count"]') && /** @type {HTMLInputElement | null} */ (document.querySelector("#variable-new"))?.value === "");
  await write(page, "count", "kind", "int");
  await has(page, "<INT/>");
  await shows(page, "count", "kind", "INT");
  await write(page, "count", "first", "7");
  await has(page, '<simpleValue value="7"/>');
  // A text that was begun goes on where the table is made anew.
  await field(page, "halt", "comment").fill("begun");
  const old = await field(page, "lamp", "comment").evaluateHandle((field) => {
    /** @type {HTMLInputElement} */ (field).value = "above the door";
    field.dispatchEvent(new Event("change"));
    return field;
  });
  await page.waitForFunction((field) => !field.isConnected, old);
  await field(page, "halt", "comment").press("Enter");
  await has(page, "begun");
  await has(page, "above the door");
  await clean(page, "project");
  await field(page, "count", "remove").click();
  await page.locator('tr[data-variable="count"]').waitFor({ state: "detached" });
  // A name that is none is told, and stands there no longer.
  await write(page, "halt", "name", "2 x");
  await page.locator("#notes", { hasText: "not a name" }).waitFor();
  await shows(page, "halt", "name", "halt");
  for (let acts = 0; acts < 9; acts++) await page.click("#project-undo");
  await page.locator("#project-undo:disabled").waitFor();
  assert.equal(await keptText(page), FIVE.toString());
  await page.context().close();
});

test("each unit opens in its editor, and mistakes stand at their element", async () => {
  const page = await begun();
  await open(page, "Latch");
  await page.click('#unit-sheet [data-id="4"]');
  assert.equal(await page.inputValue("#unit-written"), "stop");
  await page.click("#unit-negated");
  await has(page, '<contact localId="4" height');
  await page.click('#unit-sheet [data-id="2"]');
  await mouse.write(page, "#unit-written", "nobody");
  await page.locator('#unit-sheet .wrong[data-id="2"]').waitFor();
  await page.locator('#project-tree .wrong[data-unit="Latch"]').waitFor();
  await page.locator("#project-problems .error", { hasText: "nobody" }).waitFor();
  await page.click("#project-undo");
  await page.locator("#unit-sheet .wrong").first().waitFor({ state: "detached" });
  // By the keyboard alone.
  await page.focus("#unit-sheet");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  await page.locator("#unit-written:focus").waitFor();
  await page.click("#project-undo");
  await has(page, '<contact localId="4" negated="true"');
  await open(page, "Pair");
  assert.deepEqual(await page.locator("#unit-sheet .order").allTextContents(), ["1", "2"]);
  await open(page, "Any");
  assert.equal((await page.inputValue("#unit-text")).trim(), "LD x\nOR y\nST z");
  await page.fill("#unit-text", "LD x\nORN y\nST z\n");
  await page.press("#unit-text", "Control+Enter");
  await has(page, "ORN y");
  await open(page, "Ready");
  await page.fill("#unit-text", "Ready := a & NOT b;");
  await page.press("#unit-text", "Control+Enter");
  await has(page, "a &amp; NOT b");
  await open(page, "main");
  await page.click('#project-body [data-id="t1"]');
  await mouse.write(page, "#chart-condition", "halt AND NOT start");
  await has(page, "halt AND NOT start");
  await page.click('#project-body [data-id="s1"]');
  await page.click("#chart-after");
  await page.locator('#project-body .selected[data-id="s2"]').waitFor();
  await page.locator("#problem-count:not(.bad)").waitFor();
  // What unoclp does not use is where it was.
  const text = await keptText(page);
  for (const kept of ["a comment of the author's", "<!-- what unoclp does not use -->", '<position x="150" y="33"/>']) assert.ok(text.includes(kept), kept);
  await page.context().close();
});

test("it is saved, opened and run", async () => {
  const page = await begun();
  await write(page, "halt", "comment", "the red button");
  await has(page, "the red button");
  const saved = page.waitForEvent("download");
  await pick(page, "#save-file");
  const file = readFileSync(await (await saved).path());
  assert.equal(file.toString(), FIVE.toString().replace('address="%IX2"><type><BOOL/></type>', 'address="%IX2"><type><BOOL/></type><documentation><xhtml:p xmlns:xhtml="http://www.w3.org/1999/xhtml">the red button</xhtml:p></documentation>'));
  await pick(page, "#new-file");
  await page.locator("#project-pane").waitFor({ state: "hidden" });
  await choose(page, "again.xml", file);
  await page.locator("#project-pane").waitFor();
  await run(page);
  await page.locator('#project-body .active[data-id="s0"]').waitFor();
  await holding(page, 1, () => lamp(page, 1, true));
  await page.locator('#project-body .active[data-id="s1"]').waitFor();
  await lamp(page, 1, true);
  await lamp(page, 4, false);
  await holding(page, 2, () => lamp(page, 1, false));
  await page.locator('#project-body .active[data-id="s0"]').waitFor();
  await page.context().close();
});

test("it is stepped through: a scan goes from the step to its transition and its actions, and on to a breakpoint", async () => {
  const page = await begun();
  const part = (/** @type {string} */ id, says = "") => page.locator(`#project-body [data-id="${id}"]${says}`);
  const stands = (/** @type {RegExp} */ says) => page.locator("#slow-state", { hasText: says }).waitFor();
  await run(page);
  await part("s0", ".active").waitFor();
  await pick(page, "#slow-motion");
  await part("s0", ".slow-here").waitFor();
  await page.click("#slow-end");
  await stands(/The scan is over/);
  // It stands at a part for each of its codes: as many keys as that takes.
  for (const id of ["s0", "t0", "a0.0"]) {
    while (await part(id, ".slow-here").count() === 0) {
      await page.click("#slow-rung");
      await page.locator('#slow-state[aria-busy="false"]').waitFor();
    }
  }
  await part("t1").click();
  await page.keyboard.press("F9");
  await part("t1", ".slow-stop").waitFor();
  await page.keyboard.press("F4");
  await part("t1", ".slow-here").waitFor();
  await clean(page, "a project in slow motion");
  await page.click("#slow-close");
  await page.locator("#slow").waitFor({ state: "hidden" });
  await page.click('[data-input="1"]', { modifiers: ["Shift"] });
  await part("s1", ".active").waitFor();
  await page.context().close();
});

test("a plain file becomes a project", async () => {
  const page = await lab.open();
  await page.click("#view-draw");
  await pick(page, "#make-project");
  await page.locator("#project-pane").waitFor();
  await page.locator("#unit-sheet .coil").first().waitFor();
  assert.ok((await page.inputValue("#name")).endsWith(".xml"));
  await page.locator("#problem-count.good").waitFor();
  await page.context().close();
});

test("a variable that is renamed in the table is so in the whole project", async () => {
  const page = await begun();
  await write(page, "halt", "name", "stop_now");
  await has(page, "Ready(start, stop_now)");
  await has(page, "stop := stop_now, on");
  await page.locator("#problem-count:not(.bad)").waitFor();
  // The input of a block, by a call in another unit.
  await open(page, "Latch");
  await write(page, "go", "name", "begin_it");
  await has(page, "hold(begin_it := start");
  await has(page, "<variable>begin_it</variable>");
  // A name that another has and a keyword are told, and stand there no longer.
  for (const [name, told] of /** @type {const} */ ([["stop", /already used/], ["END_IF", /not a name|cannot be a name/]])) {
    await write(page, "begin_it", "name", name);
    await page.locator("#notes", { hasText: told }).waitFor();
    await shows(page, "begin_it", "name", "begin_it");
  }
  await page.click("#project-undo");
  await page.click("#project-undo");
  await page.locator("#project-undo:disabled").waitFor();
  assert.equal(await keptText(page), FIVE.toString());
  await page.context().close();
});

/** Waits for so many elements of a kind. @param {Page} page @param {string} kind @param {number} count */
const counted = (page, kind, count) => page.waitForFunction(([kind, count]) => document.querySelectorAll(`#unit-sheet .${kind}`).length === count, /** @type {const} */ ([kind, count]));

test("new elements are drawn in a ladder and in a block diagram of the project, by mouse and by keyboard", async () => {
  const page = await begun();
  await open(page, "Latch");
  await page.click('#unit-sheet [data-id="4"]');
  await page.click('#unit-palette [data-what="contact"]');
  await counted(page, "contact", 4);
  await page.locator('#unit-sheet .selected[data-id="7"]').waitFor();
  // By keys: in parallel, its variable, then away again and back.
  await page.keyboard.press("Shift+C");
  await counted(page, "contact", 5);
  await page.locator('#unit-sheet .selected[data-id="8"]').waitFor();
  await page.keyboard.press("Enter");
  await page.keyboard.press("Control+A");
  await page.keyboard.type("on");
  await page.keyboard.press("Enter");
  await page.locator("#unit-sheet:focus").waitFor();
  await page.keyboard.press("Delete");
  await counted(page, "contact", 4);
  await page.keyboard.press("Control+Z");
  await counted(page, "contact", 5);
  await page.keyboard.press("Control+Y");
  await counted(page, "contact", 4);
  await page.selectOption("#unit-others", "SR");
  await has(page, '<variable name="SR_1"><type><derived name="SR"/></type></variable>');
  await page.click("#project-undo");
  await page.click("#unit-below");
  await counted(page, "coil", 2);
  await page.click("#project-undo");
  // A block diagram: the lamp is on with either button, negated.
  await open(page, "Pair");
  await page.click('#unit-sheet [data-id="3"]');
  await page.focus("#unit-sheet");
  await page.keyboard.press("!");
  await counted(page, "block", 2);
  await page.click('#unit-sheet [data-id="3"]');
  await page.selectOption("#unit-where", "before");
  await page.click('#unit-palette [data-what="value"]');
  await has(page, 'formalParameter="IN3"');
  await page.locator("#problem-count:not(.bad)").waitFor();
  const saved = page.waitForEvent("download");
  await pick(page, "#save-file");
  const file = readFileSync(await (await saved).path());
  assert.ok(file.toString().includes("a comment of the author's"));
  await pick(page, "#new-file");
  await choose(page, "again.xml", file);
  await page.locator("#project-pane").waitFor();
  await run(page);
  // Not both buttons: the third lamp, which showed the AND, is on now.
  await holding(page, 1, () => lamp(page, 3, true));
  await page.context().close();
});

test("a mistake of a chart stands at its part", async () => {
  const page = await begun();
  await page.click('#project-body [data-id="t1"]');
  await mouse.write(page, "#chart-condition", "nobody");
  await page.locator('#project-body .wrong[data-id="t1"]').waitFor();
  await page.locator("#chart-form .error").waitFor();
  // Where it jumps to is a part of it; no step is wrong.
  assert.equal(await page.locator('#project-body [data-id^="s"].wrong').count(), 0);
  await page.click("#project-undo");
  await page.locator("#project-body .wrong").first().waitFor({ state: "detached" });
  await page.context().close();
});
