// What Rust answers after the user has gone on: it is not done to another program, nor to another text, and takes no keyboard away.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Lab, choose, keptText, pick, run, still, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => (lab = await Lab.begin()));
after(() => lab.end());

/** Has the answers of the worker with the tools wait for as long as `held` is a list. */
function holdAnswers() {
  /** @type {any} */
  const page = window;
  page.held = null;
  window.Worker = class extends Worker {
    /** @param {string | URL} script @param {WorkerOptions} [options] */
    constructor(script, options) {
      super(script, options);
      if (!String(script).includes("tools")) return;
      /** @param {string} kind @param {any} hear */
      this.addEventListener = (kind, hear) => super.addEventListener(kind, (event) => (page.held ? page.held.push(() => hear(event)) : hear(event)));
    }
  };
}

/** A page whose answers can be held. */
async function begun() {
  const page = await lab.other();
  await page.addInitScript(holdAnswers);
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  await still(page);
  return page;
}

/** Does something while no answer comes; then all of them come. @param {Page} page @param {() => Promise<unknown>} act */
async function unanswered(page, act) {
  await page.evaluate("held = []");
  await act();
  await page.evaluate("for (const come of [held, held = null][0]) come()");
}

/** The sheet is empty: one rung, and the program has no text. @param {Page} page */
async function isNew(page) {
  await page.waitForFunction(() => document.querySelectorAll("#sheet .rung").length === 1);
  assert.equal(await keptText(page), "");
}

/** An empty sheet, which took the place of a program, with a contact. @param {Page} page */
async function drawn(page) {
  await pick(page, "#new-file");
  await page.click("#view-draw");
  await isNew(page);
  await page.click('.palette [data-what="contact"]');
  await page.fill("#field-point", "I3");
  await page.keyboard.press("Enter");
  await page.locator('#sheet .element[data-point="I3"]').waitFor();
  await page.locator(".at-element").waitFor({ state: "detached" });
}

/** Brings the program back that was there before. @param {Page} page */
const undo = (page) => page.locator("#notes button", { hasText: "Undo" }).last().click();

test("what was drawn in one program is not written into the next", async () => {
  const page = await begun();
  const before = await keptText(page);
  await drawn(page);
  await unanswered(page, async () => {
    await page.click('.palette [data-what="coil"]');
    await undo(page);
  });
  await page.locator('#sheet .element[data-point="I1"]').first().waitFor();
  assert.equal(await keptText(page), before);
  assert.equal(await page.locator(".at-element").count(), 0);
  await page.context().close();
});

test("a form at an element is closed with its program", async () => {
  const page = await begun();
  const before = await keptText(page);
  await drawn(page);
  await page.click('.palette [data-what="coil"]');
  await page.locator(".at-element").waitFor();
  await undo(page);
  await page.locator(".at-element").waitFor({ state: "detached" });
  await page.locator('#sheet .element[data-point="I1"]').first().waitFor();
  assert.equal(await keptText(page), before);
  await page.context().close();
});

test("a late answer leaves the keyboard where the user has it", async () => {
  const page = await begun();
  await drawn(page);
  await unanswered(page, async () => {
    await page.focus("#sheet");
    await page.keyboard.press("Delete");
    await page.click("#menu-fileMenu");
  });
  await page.locator("#sheet .element").waitFor({ state: "detached" });
  await page.keyboard.press("Escape");
  await page.locator("#new-file").waitFor({ state: "hidden" });
  await page.context().close();
});

test("a chart is not changed once another program is open, and undo does not bring it", async () => {
  const page = await begun();
  await pick(page, "#new-chart");
  await page.click("#view-draw");
  await page.locator('#chart-sheet [data-id="t1"]').waitFor();
  await page.click("#chart-after");
  await page.locator("#chart-undo:enabled").waitFor();
  await unanswered(page, async () => {
    await page.click("#chart-after");
    await page.click("#chart-undo");
    await pick(page, "#new-file");
  });
  await page.locator("#chart").waitFor({ state: "hidden" });
  await isNew(page);
  await page.context().close();
});

test("a project is not changed once another program is open", async () => {
  const page = await begun();
  await choose(page, "five.xml", readFileSync(fileURLToPath(new URL("five.xml", import.meta.url))));
  await page.click("#view-draw");
  await page.locator('#project-body[data-unit="main"]').waitFor();
  await unanswered(page, async () => {
    await page.locator('tr[data-variable="halt"] [id$="-comment"]').fill("the red button");
    await page.keyboard.press("Enter");
    await pick(page, "#new-file");
  });
  await page.locator("#project-pane").waitFor({ state: "hidden" });
  await isNew(page);
  await page.context().close();
});

test("a text that has changed since is not formatted", async () => {
  const page = await begun();
  const written = "PROGRAM p\nVAR a AT %QX1:BOOL; END_VAR\na:=TRUE;\nEND_PROGRAM\n";
  await type(page, written, "p.st");
  await page.locator("#problem-count.good").waitFor();
  await page.locator(".text-menu button").first().waitFor();
  await page.keyboard.press("Control+Home");
  await unanswered(page, async () => {
    await page.keyboard.press("Shift+Alt+f");
    await page.keyboard.type("(* mine *) ");
  });
  await page.locator("#notes", { hasText: "The text was changed in the meantime" }).waitFor();
  assert.equal(await keptText(page), `(* mine *) ${written}`);
  await page.context().close();
});

test("slow motion does not begin in a program that has changed since", async () => {
  const page = await begun();
  await type(page, "LD I1\nST Q1\n", "p.il");
  await run(page);
  await page.locator("#ladder svg.live").waitFor();
  await unanswered(page, async () => {
    await pick(page, "#slow-motion");
    // Its styles are loaded first.
    await page.waitForFunction("held.length > 0");
    await page.click(".cm-content");
    await page.keyboard.press("Control+End");
    await page.keyboard.type("LD I2\nST Q2\n");
  });
  await page.locator("#notes", { hasText: "The program has changed" }).waitFor();
  assert.ok(await page.locator("#slow").isHidden());
  assert.equal(await keptText(page), "LD I1\nST Q1\nLD I2\nST Q2\n");
  await page.context().close();
});
