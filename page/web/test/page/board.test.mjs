// The board that a program is for: one that only the core runs is called none, the page says which board holds the program,
// this computer runs it, and nothing is sent to a board.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, clean, lamp, pick, pictures, run, select, state, tab, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** A program that no board holds: I 09 lights Q 40, and Q 41 comes after a moment. */
const NINE = "LD I9\nST Q40\nLDN S1\nTON T1, 20\nST Q41\n";

for (const { locale, none, fits, lacks, runs, card } of [
  { locale: "en-US", none: /PC is not a board/, fits: /also fits on UNO, Nano/, lacks: /No board can run this program: the UNO lacks inputs 09; outputs 40, 41\./, runs: /RUN: this computer/, card: /the UNO lacks inputs 09/ },
  { locale: "pt-BR", none: /PC não é uma placa/, fits: /também cabe em UNO, Nano/, lacks: /Nenhuma placa consegue executar este programa: faltam ao UNO as entradas 09; as saídas 40, 41\./, runs: /RUN: varreduras neste computador/, card: /faltam ao UNO as entradas 09/ },
]) {
  test(`a board that is none is called so, and sent to nobody, ${locale}`, async () => {
    const page = await lab.open({ locale });
    const note = page.locator("#board-note");
    await page.locator("#problem-count.good").waitFor();
    assert.ok(await note.isHidden());
    await select(page, "#for-board", "pc");
    await note.filter({ hasText: none }).filter({ hasText: fits }).waitFor();
    await run(page);
    await page.locator("#status", { hasText: runs }).waitFor();
    // Points that no board has are pressed, seen and forced here.
    await type(page, NINE, "nine.il");
    await note.filter({ hasText: lacks }).waitFor();
    await run(page);
    await lamp(page, 40, false);
    await page.hover('[data-input="9"]');
    await page.mouse.down();
    await lamp(page, 40, true);
    await page.mouse.up();
    await lamp(page, 40, false);
    await page.locator('[data-output="41"][data-on="true"]').waitFor();
    await tab(page, "watch");
    await page.locator('tr[data-point="I9"] button', { hasText: /1$/ }).click();
    await lamp(page, 40, true);
    await page.click("#release");
    await lamp(page, 40, false);
    // It stops, makes a single scan, and goes on.
    await page.click("#command-stop");
    await state(page, "STOP");
    await lamp(page, 41, false);
    await pick(page, "#command-run");
    await state(page, "RUN");
    await lamp(page, 41, true);
    // No card is made of it.
    await pick(page, "#save-card");
    await page.locator("#notes", { hasText: card }).waitFor();
    assert.equal(await page.locator("progress:visible").count(), 0);
    await clean(page, "a board that is none");
    for (const [width, height] of /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]])) {
      await page.setViewportSize({ width, height });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
      await page.screenshot({ path: join(pictures, `board-${locale}-${width}.png`) });
    }
    // It is so after a reload, and an UNO's errors are there again.
    await page.reload();
    await note.filter({ hasText: lacks }).waitFor();
    await run(page);
    await lamp(page, 41, true);
    await select(page, "#for-board", "uno");
    await page.locator("#problem-count.bad").waitFor();
    await note.waitFor({ state: "hidden" });
    // The simulated UNO takes over again, with its own buttons and lamps.
    await type(page, "LD I1\nST Q1\n", "one.il");
    await page.locator("#problem-count.good").waitFor();
    await run(page);
    await page.hover('[data-input="1"]');
    await page.mouse.down();
    await lamp(page, 1, true);
    assert.equal(await page.locator("[data-output]").count(), 4);
    await page.context().close();
  });
}
