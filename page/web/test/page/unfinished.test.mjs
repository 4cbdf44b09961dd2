// What cannot run is not run, and everything says so; forms keep what was typed; exercises are drawn and pressed.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, choose, keptText, lamp, pick, pictures, run, state, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** @param {Page} page @param {string} what @param {Record<string, string>} fields */
async function place(page, what, fields) {
  await page.click(`.palette [data-what="${what}"]`);
  for (const [key, value] of Object.entries(fields)) await page.fill(`#field-${key}`, value);
  await page.click(".at-element button[type=submit]");
}

/** @param {Page} page */
const closed = (page) => page.locator(".at-element").waitFor({ state: "detached" });

test("an unfinished drawing does not run, and header, sheet, problems and Run agree", async () => {
  const page = await lab.open();
  await run(page);
  await page.click("#view-draw");
  await page.locator('#sheet .element[data-point="Q1"]').first().waitFor();
  await page.locator("#sheet .rung").first().click({ position: { x: 5, y: 5 } });
  await page.click('.palette [data-what="contact"]');
  await page.keyboard.press("Escape");
  await page.locator("#draw-state", { hasText: "problems: 1" }).waitFor();
  await page.locator("#problem-count.bad", { hasText: "Problems in the drawing: 1" }).waitFor();
  await page.click("#problem-count");
  await page.locator("#panel-problems", { hasText: "problems: 1" }).waitFor();
  await page.click("#view-text");
  await page.click("#run");
  await page.locator("#notes", { hasText: "problems: 1" }).waitFor();
  assert.equal(await page.getAttribute("#views", "data-view"), "draw");
  assert.equal(await page.locator("progress:visible").count(), 0, "nothing is uploaded");
  await page.screenshot({ path: join(pictures, "unfinished.png") });
  // So it is after a reload, whatever is shown.
  await page.click("#view-text");
  await page.reload();
  await page.locator("#problem-count.bad", { hasText: "Problems in the drawing: 1" }).waitFor();
  await page.click("#view-draw");
  await page.click("#draw-undo");
  await page.locator("#problem-count.good").waitFor();
  await run(page);
  await page.context().close();
});

test("a link to an unfinished drawing opens that drawing, with all that can be undone", async () => {
  const page = await lab.emptySheet();
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await place(page, "contact", { point: "I1 start" });
  await closed(page);
  await place(page, "coil", { point: "Q1 motor" });
  await closed(page);
  await page.click('#sheet .element[data-point="I1"] .area');
  await page.click('.palette [data-what="ton"]');
  await page.keyboard.press("Escape");
  await page.locator("#draw-state", { hasText: "problems: 1" }).waitFor();
  await pick(page, "#share");
  await page.locator("#notes", { hasText: "clipboard" }).waitFor();
  const link = new URL(await page.evaluate(() => navigator.clipboard.readText())).hash;
  await page.context().close();
  const other = await lab.other({}, {}, lab.server.url + link);
  await other.click("#view-draw");
  await other.locator("#draw-state", { hasText: "problems: 1" }).waitFor();
  await other.locator("#problem-count.bad").waitFor();
  await other.locator('#sheet .element[data-point="T1"] .preset', { hasText: "?" }).waitFor();
  await other.locator("#sheet", { hasText: "start" }).waitFor();
  await other.click("#draw-undo");
  await other.locator("#problem-count.good").waitFor();
  assert.match(await keptText(other), /LD +start\nST +motor/);
  await other.context().close();
});

test("an empty program is no mistake, and Run says that there is none", async () => {
  for (const [locale, empty, none] of /** @type {const} */ ([["en-US", "Empty program", "There is no program yet"], ["pt-BR", "Programa vazio", "Ainda não há programa"]])) {
    const page = await lab.emptySheet({ locale });
    await page.locator("#problem-count:not(.bad):not(.good)", { hasText: empty }).waitFor();
    await page.click("#run");
    await page.locator("#notes", { hasText: none }).waitFor();
    assert.equal(await page.locator("progress:visible").count(), 0, "nothing is uploaded");
    await page.context().close();
  }
});

test("a form keeps its fields at a mistake, and tells it beside the field", async () => {
  const page = await lab.emptySheet({ locale: "pt-BR", viewport: { width: 1366, height: 768 } });
  await place(page, "contact", { point: "liga", name: "" });
  const wrong = page.locator(".at-element .field-wrong");
  await wrong.filter({ hasText: "liga" }).waitFor();
  assert.equal(await page.inputValue("#field-point"), "liga");
  assert.equal(await page.getAttribute("#field-point", "aria-invalid"), "true");
  await page.screenshot({ path: join(pictures, "form-wrong.png") });
  await page.click('[data-offer="I1 liga"]');
  await closed(page);
  await page.locator('#sheet .element[data-point="I1"]').waitFor();
  // The first button of many is called S1, as a system marker is.
  await place(page, "contact", { point: "S1" });
  await wrong.filter({ hasText: "memória de sistema" }).waitFor();
  await page.click('[data-offer="I2 S_1"]');
  await closed(page);
  await page.locator('#sheet .element[data-point="I2"]').waitFor();
  await place(page, "ton", { point: "T1", line0: "4s" });
  await wrong.filter({ hasText: "T1" }).waitFor();
  assert.equal(await page.inputValue("#field-line0"), "4s");
  await page.fill("#field-point", "Q1");
  await page.keyboard.press("Enter");
  await closed(page);
  assert.match(await keptText(page), /TON +T1, 4000/);
  // The names of all points: what is wrong stands there too, and nothing is cleared.
  await pick(page, "#draw-symbols");
  await page.fill("#symbol-point", "X9");
  await page.fill("#symbol-name", "bomba");
  await page.keyboard.press("Enter");
  await page.locator("#symbols .field-wrong", { hasText: "X9" }).waitFor();
  assert.equal(await page.inputValue("#symbol-name"), "bomba");
  await page.context().close();
});

test("a contact after a coil keeps its drawing and names, and is told", async () => {
  const page = await lab.emptySheet();
  await place(page, "contact", { point: "I1 start" });
  await closed(page);
  await place(page, "coil", { point: "Q1 motor" });
  await closed(page);
  await place(page, "contact", { point: "I2 stop" });
  await closed(page);
  await page.locator("#mistakes .warning", { hasText: "no coil comes after this element" }).waitFor();
  assert.match(await keptText(page), /LD {4}start\nST {4}motor\nCODE 827302/);
  await page.locator("#problem-count.good").waitFor();
  await page.reload();
  await page.locator('#sheet .element[data-point="I2"]').waitFor();
  await page.locator("#sheet", { hasText: "stop" }).waitFor();
  // Its text alone has the names too.
  const text = await keptText(page);
  await pick(page, "#new-file");
  await choose(page, "again.il", Buffer.from(text));
  await page.locator('#sheet .element[data-point="I2"]').waitFor();
  for (const name of ["start", "motor", "stop"]) await page.locator("#sheet .name", { hasText: name }).waitFor();
  await page.context().close();
});

test("exercise 5 begins as a drawing with its names, and its right solution runs with a stop that is normally closed", async () => {
  const page = await lab.open({ viewport: { width: 1366, height: 768 } });
  await page.click("#view-draw");
  await page.locator('#sheet .element[data-point="Q1"]').first().waitFor();
  await pick(page, "#exercises");
  await page.selectOption("#exercise-list", { index: 4 });
  await page.locator("#exercise .names", { hasText: "normally closed" }).waitFor();
  // Its machine has buttons of its own; without it those of the board are as the exercise says.
  await page.click("#machine-close");
  await page.locator('.kind[data-kind="nc"]', { hasText: "NC" }).waitFor();
  await page.click("#exercise-begin");
  await page.locator("#sheet .element").first().waitFor({ state: "detached" });
  await page.locator("#draw-banner").waitFor({ state: "hidden" });
  assert.equal(await page.inputValue("#name"), "05-motor.il");
  await place(page, "contact", { point: "start" });
  await closed(page);
  await place(page, "coil", { point: "motor" });
  await closed(page);
  assert.match(await keptText(page), /LD {4}start\nST {4}motor/);
  await page.screenshot({ path: join(pictures, "exercise-drawn.png") });
  await page.click("#view-both");
  await type(page, readFileSync(new URL("../../../../programs/exercises/05-motor.il", import.meta.url), "utf8"));
  await page.locator('#ladder .element[data-point="Q2"]').waitFor();
  await run(page);
  await lamp(page, 2, true);
  await holding(page, 1, () => lamp(page, 1, true));
  await lamp(page, 2, false);
  await holding(page, 2, () => lamp(page, 1, false));
  // It is so after a reload.
  await page.reload();
  await state(page, "RUN");
  await holding(page, 1, () => lamp(page, 1, true));
  await page.setViewportSize({ width: 390, height: 844 });
  await page.locator('[data-input="2"]').scrollIntoViewIfNeeded();
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await page.screenshot({ path: join(pictures, "contacts-phone.png") });
  await page.context().close();
});

test("an empty drawing in place of a text with errors keeps the name, and can be undone", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nSTT Q1\n", "mine.il");
  await page.locator("#problem-count.bad").waitFor();
  await page.click("#view-draw");
  await page.click("#draw-empty");
  await page.locator("#sheet .rung").first().waitFor();
  assert.equal(await page.inputValue("#name"), "mine.il");
  await page.locator("#notes").getByRole("button", { name: "Undo", exact: true }).click();
  assert.match(await keptText(page), /STT Q1/);
  await page.context().close();
});
