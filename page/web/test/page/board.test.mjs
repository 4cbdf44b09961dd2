// The board that a program is for: one that only the core runs is called none, the page says which board holds the program,
// and nothing is sent to one that does not.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, clean, pictures, run, state, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

for (const { locale, none, fits, lacks, refused } of [
  { locale: "en-US", none: /PC is no UNO/, fits: /also fits on UNO, Nano/, lacks: /No board holds this program\. UNO: .*(?:I9|09)/, refused: /Nothing was sent: UNO/ },
  { locale: "pt-BR", none: /PC não é um UNO/, fits: /também cabe em UNO, Nano/, lacks: /Nenhuma placa comporta este programa\. UNO: .*(?:I9|09)/, refused: /Nada foi enviado: UNO/ },
]) {
  test(`a board that is none is called so, and sent to nobody, ${locale}`, async () => {
    const page = await lab.open({ locale });
    const note = page.locator("#board-note");
    await page.locator("#problem-count.good").waitFor();
    assert.ok(await note.isHidden());
    await page.selectOption("#for-board", "pc");
    await note.filter({ hasText: none }).filter({ hasText: fits }).waitFor();
    // What an UNO holds too may be sent to one.
    await run(page);
    await type(page, "LD I9\nST Q3\n", "nine.il");
    await note.filter({ hasText: lacks }).waitFor();
    await page.locator("#problem-count.good").waitFor();
    await page.click("#run");
    await page.locator("#notes", { hasText: refused }).waitFor();
    assert.equal(await page.locator("progress:visible").count(), 0);
    await state(page, "RUN");
    await clean(page, "a board that is none");
    for (const [width, height] of /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]])) {
      await page.setViewportSize({ width, height });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
      await page.screenshot({ path: join(pictures, `board-${locale}-${width}.png`) });
    }
    // It is so after a reload, and an UNO's errors are there again.
    await page.reload();
    await note.filter({ hasText: lacks }).waitFor();
    await page.selectOption("#for-board", "uno");
    await page.locator("#problem-count.bad").waitFor();
    await note.waitFor({ state: "hidden" });
    await page.context().close();
  });
}
