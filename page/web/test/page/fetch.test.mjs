// The program of a board, read back: as it was written where the browser knows it, else as numeric code; it opens as a program
// of its own. And scans that go on from where the program is.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, keptHere, keptText, lamp, pick, run, select, state, tab, type } from "./harness.mjs";
import { connect } from "./plugged.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Output 03 follows input 01. */
const HORN = "VAR\n  press AT %I1 : BOOL;\n  horn AT %Q3 : BOOL;\nEND_VAR\nLD press\nST horn\n";

/** The browser forgets which programs boards have had, and those of other places. @param {Page} page */
const forget = (page) => page.evaluate(() => {
  const here = sessionStorage.getItem("place");
  for (const key of Object.keys(localStorage)) if (key === "ran" || (/^(program|versions)\//.test(key) && !key.endsWith(`/${here}`))) localStorage.removeItem(key);
});

/** @param {Page} page */
async function reload(page) {
  await page.reload();
  await state(page, "RUN");
}

for (const [locale, known, unknown, none] of /** @type {const} */ ([
  ["en-US", "which this browser stores", "as numeric code", "has no program"],
  ["pt-BR", "que este navegador guarda", "em código numérico", "não tem programa"],
])) {
  test(`the simulated board gives its program back, and nothing is overwritten, ${locale}`, async () => {
    const page = await lab.open({ locale });
    const said = (/** @type {string} */ text) => page.locator("#notes", { hasText: text }).waitFor();
    await state(page, "EMPTY");
    await pick(page, "#fetch");
    await said(none);
    await type(page, HORN, "horn.il");
    await run(page);
    await pick(page, "#new-file");
    await type(page, "LD I2\nST Q2 (* mine *)\n", "mine.il");
    await pick(page, "#fetch");
    await said(known);
    assert.equal(await page.inputValue("#name"), "horn.il");
    assert.equal(await keptText(page), HORN);
    await pick(page, "#programs");
    await page.locator('#programs-list [data-program="mine.il"]').getByRole("button").first().click();
    assert.match(await keptText(page), /mine/);
    // Nobody knows it any more: its codes are read.
    await forget(page);
    await reload(page);
    await pick(page, "#fetch");
    await said(unknown);
    assert.equal(await page.inputValue("#name"), "PROGRAM.TXT");
    const code = await keptText(page);
    assert.match(code, /^0\n[^]*827301[^]*7903/);
    await page.locator("#tongue", { hasText: /Numeric code|Código numérico/ }).waitFor();
    // It is the program that runs: names come of none, and the ladder is live.
    await page.locator(".ladder.live").waitFor();
    await page.click("#menu-fileMenu");
    await page.locator("#menu-fileMenu + div button", { hasText: "mine.il" }).first().waitFor();
    await page.context().close();
  });
}

test("a board at the port gives its program back; where the browser knows it, it is live as soon as it is connected", async () => {
  const page = await lab.open();
  await type(page, HORN, "horn.il");
  await run(page);
  const eeprom = await keptHere(page, "eeprom");
  assert.ok(eeprom);
  await connect(page, eeprom);
  await page.locator(".ladder.live").waitFor();
  await holding(page, 1, () => lamp(page, 3, true));
  await page.context().close();

  const other = await connect(await lab.open(), eeprom);
  await type(other, "LD I2\nST Q2 (* mine *)\n", "mine.il");
  await pick(other, "#fetch");
  await other.locator("#notes", { hasText: "as numeric code" }).waitFor();
  assert.match(await keptText(other), /^0\n[^]*827301[^]*7903/);
  await other.locator(".ladder.live").waitFor();
  await holding(other, 1, () => lamp(other, 3, true));
  await other.context().close();
});

test("a single scan in RUN stops the board, and goes on from where the program is", async () => {
  for (const board of ["uno", "pc"]) {
    const page = await lab.open();
    if (board === "pc") await select(page, "#for-board", board);
    await type(page, "LD I1\nS M1\nLD D1\nADD 1\nST D1\nLD M1\nST Q1\n", "holds.il");
    await run(page);
    await tab(page, "watch");
    const value = (/** @type {string} */ point) => page.locator(`tr[data-point="${point}"] .value`).first();
    await holding(page, 1, () => lamp(page, 1, true));
    await page.waitForFunction(() => Number(document.querySelector('tr[data-point="D1"] .value')?.textContent) > 3);
    await pick(page, "#scan");
    await state(page, "STOP");
    await value("M1").filter({ hasText: "1" }).waitFor();
    const first = Number(await value("D1").textContent());
    assert.ok(first > 3, `${board}: ${first}`);
    await pick(page, "#scan");
    await page.waitForFunction((first) => Number(document.querySelector('tr[data-point="D1"] .value')?.textContent) > first, first);
    assert.ok(Number(await value("D1").textContent()) <= first + 2, board);
    await value("M1").filter({ hasText: "1" }).waitFor();
    await page.context().close();
  }
});
