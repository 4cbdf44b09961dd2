// The first ten seconds, and the room that a program has: at three sizes, in both languages.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { HANDS, holding } from "./hands.mjs";
import { Lab, clean, lamp, pick, pictures, select, state, tab, turned, type } from "./harness.mjs";
import { CONTROLS, SIZES, inView, newcomer, stands } from "./newcomer.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** @typedef {import("playwright-core").Page} Page */

/** The sheet is as high as this in every state, px. */
const SHEET = 350;

for (const [width, height] of SIZES) {
  for (const [locale, sentence] of /** @type {const} */ ([["en-US", /turns an Arduino UNO into a PLC/], ["pt-BR", /transforma um Arduino UNO em um CLP/]])) {
    test(`a newcomer sees a sentence, a program that runs, and three doors, ${locale}, ${width} × ${height}`, async () => {
      const phone = width < 760;
      const { page, said } = await newcomer(lab, { locale, viewport: { width, height }, hasTouch: phone, isMobile: phone });
      await page.locator("#welcome p", { hasText: sentence }).waitFor();
      for (const door of ["draw", "exercises", "examples"]) await page.locator(`#door-${door}`).waitFor();
      // No fault is shown of a board that holds no program, and then it runs by itself.
      await state(page, "RUN");
      assert.equal(await page.locator('[data-state="FAULT"]').count(), 0);
      await page.locator('#sheet .ladder.live .element[data-point="Q1"]').first().waitFor();
      await page.locator("#notes > div").last().waitFor();
      const seen = await inView(page);
      const notes = await page.locator("#notes button").count();
      assert.ok(seen.length - notes <= CONTROLS, `${seen.length - notes} controls: ${seen.join(", ")}`);
      await page.screenshot({ path: join(pictures, `first-${locale}-${width}.png`) });
      await stands(page);
      // There is something to press.
      const hand = HANDS[phone ? 1 : 0];
      await holding(page, 1, () => lamp(page, 1, true), hand);
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
      await clean(page, "the opening");
      assert.deepEqual(said, []);
      await page.context().close();
    });
  }
}

test("the door Draw leads to an empty sheet with the palette, and is not there the next time", async () => {
  const { page } = await newcomer(lab, { locale: "en-US", viewport: { width: 1366, height: 768 } });
  await page.click("#door-draw");
  await page.locator("#sheet .rung").first().waitFor();
  await page.locator('.palette [data-what="contact"]').waitFor();
  assert.ok(await page.locator("#welcome").isHidden());
  await page.reload();
  await page.locator("#sheet .rung").first().waitFor();
  assert.ok(await page.locator("#welcome").isHidden());
  await page.context().close();
});

test("who comes by a link sees that program, and is told nothing of one that never was", async () => {
  const maker = await lab.still({ permissions: ["clipboard-read", "clipboard-write"] });
  await type(maker, "LD I4\nST Q4\n", "link.il");
  await pick(maker, "#share");
  await maker.locator("#notes", { hasText: "clipboard" }).waitFor();
  const link = await maker.evaluate(() => navigator.clipboard.readText());
  await maker.context().close();
  const context = await lab.browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  await page.goto(link);
  await page.locator('#sheet .element[data-point="Q4"]').waitFor();
  assert.equal(await page.inputValue("#name"), "link.il");
  assert.equal(await page.locator("#notes > div").count(), 0);
  assert.ok(await page.locator("#welcome").isHidden());
  await context.close();
});

test("the sheet keeps its height in every state at 1366 × 768", async () => {
  const page = await lab.other({ viewport: { width: 1366, height: 768 } }, { view: "draw", drawer: "" });
  const high = async (/** @type {string} */ where) => {
    await page.locator("#sheet .rung").first().waitFor();
    const box = await page.locator("#sheet").boundingBox();
    assert.ok(box && box.height >= SHEET, `${where}: ${box?.height}`);
    assert.ok(await page.evaluate(() => document.documentElement.scrollHeight <= innerHeight), `${where}: the page scrolls`);
  };
  await high("alone");
  await pick(page, "#exercises");
  await page.locator("#exercise-check").waitFor();
  await high("exercise");
  for (const name of ["trend", "watch", "problems"]) {
    await tab(page, name);
    await high(`exercise and ${name}`);
  }
  // However high somebody wants the drawer.
  await page.focus("#split-drawer");
  for (let step = 0; step < 30; step++) await page.keyboard.press("ArrowUp");
  await high("a high drawer");
  await page.screenshot({ path: join(pictures, "sheet-1366.png") });
  await page.click("#view-both");
  await type(page, "PROGRAM p\nVAR a AT %IX1 : BOOL; b AT %QX1 : BOOL; END_VAR\nb := a;\nEND_PROGRAM\n", "other.st");
  await page.locator("#problem-count.good").waitFor();
  await page.click("#view-draw");
  await page.locator("#draw-banner", { hasText: "another language" }).waitFor();
  await high("a banner");
  await page.context().close();
});

test("a splitter is dragged, moved by keys, and remembered", async () => {
  const page = await lab.other({ viewport: { width: 1366, height: 768 } });
  const wide = () => page.locator("#board").evaluate((board) => Math.round(board.getBoundingClientRect().width));
  const before = await wide();
  const box = await page.locator("#split-machine").boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + 3, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x - 97, box.y + 200, { steps: 4 });
  await page.mouse.up();
  assert.equal(await wide(), before + 100);
  await page.focus("#split-machine");
  await page.keyboard.press("ArrowRight");
  assert.equal(await wide(), before + 84);
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  assert.equal(await wide(), before + 84);
  await page.context().close();
});

test("what is told lies over no control, and the status keeps its height", async () => {
  const page = await lab.other({ viewport: { width: 1366, height: 768 } }, { view: "draw" });
  const height = () => page.locator("#status").evaluate((status) => status.getBoundingClientRect().height);
  await page.locator("#run:enabled").waitFor();
  const first = await height();
  await tab(page, "watch");
  await pick(page, "#new-file");
  await page.locator("#notes > div").first().waitFor();
  const under = await page.evaluate(() => {
    const notes = [...document.querySelectorAll("#notes > div")].map((note) => note.getBoundingClientRect());
    return [...document.querySelectorAll("button, select, input, [role=separator]")].filter((one) => {
      const box = one.getBoundingClientRect();
      const isSeen = one.checkVisibility({ visibilityProperty: true }) && !one.closest("#notes");
      return isSeen && notes.some((note) => box.left < note.right && box.right > note.left && box.top < note.bottom && box.bottom > note.top);
    }).map((one) => one.id || one.outerHTML.slice(0, 80));
  });
  assert.deepEqual(under, []);
  for (const act of ["#plug", "#plug", "#run"]) {
    await page.click(act);
    assert.equal(await height(), first, act);
  }
  await page.context().close();
});

test("on a phone program, machine and drawer are three pages, with buttons and lamps under the program", async () => {
  const page = await lab.other({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, { view: "draw", palette: "folded", drawer: "" });
  await page.locator("#dock [data-input='1']").waitFor();
  await page.locator("#dock [data-output='1']").waitFor();
  await turned(page, "#program");
  await page.tap("#page-machine");
  await turned(page, "#board");
  await page.tap("#page-drawer");
  await turned(page, "#below");
  await page.tap("#tab-watch");
  await page.tap("#page-program");
  await turned(page, "#program");
  // What is drawn anew turns no page.
  await page.tap("#page-machine");
  await turned(page, "#board");
  await page.locator("#sheet .selected").first().waitFor({ state: "attached" });
  await select(page, "#speak", "pt");
  await page.locator("#run", { hasText: "Executar" }).waitFor();
  await page.locator("#rung-add", { hasText: "Degrau" }).waitFor({ state: "attached" });
  await turned(page, "#board");
  await page.context().close();
});

test("on a phone a problem leads to its line, from the drawing too", async () => {
  const page = await lab.other({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, { view: "text" });
  await type(page, "LD I1\nSTT Q1\n");
  await page.locator("#problem-count.bad").waitFor({ state: "attached" });
  for (const view of ["text", "draw"]) {
    await page.tap("#page-program");
    await turned(page, "#program");
    await page.tap(`#view-${view}`);
    await page.tap("#page-drawer");
    await turned(page, "#below");
    await tab(page, "problems");
    await page.tap(".problems button");
    await turned(page, "#program");
    await page.locator(".cm-content:focus").waitFor();
  }
  await page.context().close();
});
