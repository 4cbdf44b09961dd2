// What the browser keeps: nobody's program is lost by another tab, a link, an undo, or a version before.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { Lab, clean, keptText, lamp, pick, run, state, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Another tab of the same browser. @param {Page} page @param {string} fragment */
async function tab(page, fragment = "") {
  const other = await page.context().newPage();
  await other.goto(lab.server.url + fragment);
  await other.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  return other;
}

/** @param {Page} page */
async function reload(page) {
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
}

/** @param {Page} page */
const text = async (page) => (await page.textContent(".cm-content")) ?? "";

/** A link to this program. @param {Page} page @param {string} program */
async function linkTo(page, program) {
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await type(page, program, "link.il");
  await pick(page, "#share");
  await page.locator("#notes", { hasText: "clipboard" }).waitFor();
  return new URL(await page.evaluate(() => navigator.clipboard.readText())).hash;
}

test("two tabs and a link keep a program each", async () => {
  const maker = await lab.still();
  const link = await linkTo(maker, "LD I4\nST Q4\n");
  await maker.context().close();

  const one = await lab.still();
  await type(one, "LD I1\nST Q3\n", "mine.il");
  const two = await tab(one);
  assert.match(await text(two), /LD I1/, "a new tab begins as the last one");
  await type(two, "LD I2\nST Q2\n");
  const three = await tab(one, link);
  await three.locator("#notes", { hasText: "comes from a link" }).waitFor();
  for (const page of [one, two, three]) await reload(page);
  assert.match(await text(one), /LD I1ST Q3/);
  assert.match(await text(two), /LD I2ST Q2/);
  assert.match(await text(three), /LD I4ST Q4/);
  // A link in a tab that has a program takes another place, and the menu has the one before.
  await one.evaluate((hash) => void (location.hash = hash), link);
  await one.locator("#notes", { hasText: "comes from a link" }).waitFor();
  await reload(one);
  assert.match(await text(one), /LD I4ST Q4/);
  await one.click("#menu-fileMenu");
  await one.locator("#menu-fileMenu + div button", { hasText: "mine.il" }).first().waitFor();
  await one.keyboard.press("Escape");
  await one.context().close();
});

test("a tab that was duplicated has a place of its own", async () => {
  const one = await lab.still();
  await type(one, "LD I1\nST Q3\n");
  const place = await one.evaluate(() => sessionStorage.getItem("place"));
  const other = await one.context().newPage();
  await other.addInitScript((place) => sessionStorage.setItem("place", place ?? ""), place);
  await other.goto(lab.server.url);
  await other.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  await one.waitForFunction((place) => sessionStorage.getItem("place") !== place, place);
  await type(other, "LD I2\nST Q2\n");
  assert.match(await keptText(one), /LD I1\nST Q3/);
  assert.match(await keptText(other), /LD I2\nST Q2/);
  await reload(one);
  assert.match(await text(one), /LD I1ST Q3/);
  await one.context().close();
});

test("a program that is open in one tab is opened in another, and each goes on by itself", async () => {
  const one = await lab.still();
  await type(one, "LD I1\nST Q3\n", "mine.il");
  const two = await tab(one);
  await type(two, "LD I2\nST Q2\n", "yours.il");
  await pick(two, "#programs");
  await two.locator('#programs-list [data-program="mine.il"]').getByRole("button", { name: "Open: mine.il" }).click();
  await two.locator(".cm-content", { hasText: "LD I1" }).waitFor();
  await type(two, "LD I4\nST Q4\n");
  await type(one, "LD I5\nST Q3\n");
  for (const page of [one, two]) await reload(page);
  assert.match(await text(one), /LD I5ST Q3/);
  assert.match(await text(two), /LD I4ST Q4/);
  await one.context().close();
});

test("the program and the board of version 0.2.0 are still there", async () => {
  const page = await lab.other({}, { program: JSON.stringify({ name: "old.il", text: "LD I3\nST Q3\n" }), view: "both", theme: "dark", speak: "pt" });
  assert.equal(await page.inputValue("#name"), "old.il");
  assert.match(await text(page), /LD I3ST Q3/);
  // With its settings, and a link of then.
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
  assert.equal(await page.getAttribute("html", "lang"), "pt-BR");
  const link = deflateRawSync(Buffer.from(JSON.stringify(["link.il", "LD I4\nST Q4\n"]))).toString("base64url");
  await page.evaluate((hash) => void (location.hash = hash), `#p=${link}`);
  await page.locator(".cm-content", { hasText: "LD I4" }).waitFor();
  await page.click("#menu-fileMenu");
  await page.locator("#menu-fileMenu + div button", { hasText: "old.il" }).first().waitFor();
  await page.context().close();
});

test("each program has its place: listed, renamed, duplicated, deleted and brought back, and as it was before", async () => {
  const page = await lab.still();
  await type(page, "LD I1\nST Q3\n", "mine.il");
  await pick(page, "#new-file");
  await type(page, "LD I2\nST Q2\n", "yours.il");
  const programs = page.locator("#programs-list");
  const row = (/** @type {string} */ name) => programs.locator(`[data-program="${name}"]`);
  await pick(page, "#programs");
  await row("yours.il").filter({ hasText: "open here" }).waitFor();
  // Each has its first rungs beside it.
  for (const name of ["yours.il", "mine.il"]) await row(name).locator('.program-picture img[src^="data:image/svg"]').waitFor();
  // What was written before is there, and nothing took its place.
  await row("mine.il").getByRole("button", { name: "Duplicate: mine.il" }).click();
  await row("mine-2.il").locator("input").fill("third.il");
  await row("mine-2.il").locator("input").press("Tab");
  await row("third.il").getByRole("button", { name: "Delete: third.il" }).click();
  await row("third.il").waitFor({ state: "detached" });
  await page.click("#program-back");
  await row("third.il").getByRole("button", { name: "Open: third.il" }).click();
  await programs.waitFor({ state: "detached" });
  assert.equal(await page.inputValue("#name"), "third.il");
  assert.match(await text(page), /LD I1ST Q3/);
  await reload(page);
  assert.equal(await page.inputValue("#name"), "third.il");
  // What it was before is one of its versions, and opens as a program of its own.
  await type(page, "LD I4\nST Q4\n");
  await pick(page, "#programs");
  await row("third.il").locator("summary").click();
  await row("third.il").locator("[data-version]").first().click();
  await page.locator(".cm-content", { hasText: "LD I1" }).waitFor();
  await pick(page, "#programs");
  await row("mine.il").waitFor();
  await row("yours.il").waitFor();
  await clean(page, "programs");
  await page.context().close();
});

test("an undo by a note can be done again, with the drawing that it took", async () => {
  const page = await lab.still();
  const entry = async (/** @type {string} */ name) => {
    await page.click("#menu-fileMenu");
    await page.getByRole("button", { name, exact: true }).click();
  };
  const offer = (/** @type {string} */ name) => page.locator("#notes").getByRole("button", { name, exact: true }).last().click();
  await entry("New");
  await page.click("#view-draw");
  await page.locator("#sheet .rung").first().waitFor();
  await page.click('.palette [data-what="contact"]');
  await page.fill("#field-point", "I3 go");
  await page.keyboard.press("Enter");
  await page.locator('#sheet .element[data-point="I3"]').waitFor();
  // The coil is not complete, so that the text has nothing of it.
  await page.click('.palette [data-what="coil"]');
  await page.locator(".at-element").waitFor();
  await page.keyboard.press("Escape");
  await page.locator("#mistakes .error").first().waitFor();
  await offer("Undo");
  await page.locator('#sheet .element[data-point="I1"]').first().waitFor();
  await offer("Redo");
  await page.locator('#sheet .element[data-point="I3"]').waitFor();
  await page.locator("#mistakes .error").first().waitFor();
  assert.equal(await page.locator("#sheet .element").count(), 2);
  await page.context().close();
});

test("a note ends, whatever it offers", async () => {
  const page = await lab.still();
  // The page's time stands but for what the test lets pass, however long the machine takes.
  await page.clock.install({ time: 0 });
  await page.clock.pauseAt(60_000);
  // The second takes the place of the first, which says the same.
  for (let time = 0; time < 2; time += 1) {
    await page.evaluate(() => document.querySelector("#menu-fileMenu")?.dispatchEvent(new MouseEvent("click")));
    await page.getByRole("button", { name: "New", exact: true }).click();
    await page.locator("#notes").getByRole("button", { name: "Undo" }).waitFor();
  }
  // Each step by keyboard gives it its time again.
  await page.clock.runFor(7_900);
  await page.keyboard.press("Tab");
  await page.clock.runFor(7_900);
  assert.equal(await page.locator("#notes > div").count(), 1);
  await page.clock.runFor(200);
  await page.locator("#notes > div").waitFor({ state: "detached" });
  await page.context().close();
});

test("what a note offered is in the menu once the note is gone", async () => {
  const page = await lab.still();
  await type(page, "LD I3\nST Q3\n", "mine.il");
  await pick(page, "#new-file");
  await page.locator("#notes").getByRole("button", { name: "Undo" }).waitFor();
  await page.locator("#notes").getByRole("button", { name: "Close" }).click();
  await page.locator("#notes > div").waitFor({ state: "detached" });
  await page.click("#menu-fileMenu");
  await page.locator("#menu-fileMenu + div button", { hasText: "mine.il" }).first().click();
  assert.match(await text(page), /LD I3ST Q3/);
  assert.equal(await page.inputValue("#name"), "mine.il");
  await page.context().close();
});

test("after a reload the ladder, the values and the names of what runs are live", async () => {
  const page = await lab.open();
  await run(page);
  await reload(page);
  await state(page, "RUN");
  await page.locator("#ladder .ladder.live").waitFor();
  await page.locator(".place", { hasText: "motor" }).first().waitFor();
  await page.keyboard.press("Escape");
  // Another program in the editor: the names are those of the board, and the ladder is not live.
  await type(page, "VAR\n  go AT %I1 : BOOL;\n  horn AT %Q1 : BOOL;\nEND_VAR\nLD go\nST horn\n", "other.il");
  await page.locator("#ladder .ladder:not(.live)").waitFor();
  await page.locator("#about-program", { hasText: "changed" }).waitFor();
  assert.equal(await page.locator(".place .name", { hasText: "motor" }).count(), 1);
  assert.equal(await page.locator(".place .name", { hasText: "horn" }).count(), 0);
  await reload(page);
  await state(page, "RUN");
  await page.locator("#about-program", { hasText: "changed" }).waitFor();
  assert.equal(await page.locator(".place .name", { hasText: "horn" }).count(), 0);
  await lamp(page, 1, false);
  await page.context().close();
});
