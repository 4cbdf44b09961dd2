// What the page looks like to everybody: languages, screen readers, small screens.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, clean, findings, lamp, lightAndDark, pick, pictures, run, select, still, tab } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

test("axe-core finds nothing, light and dark", async () => {
  const page = await lab.open();
  await clean(page, "no program");
  await run(page);
  // The board tells its settings while its time goes on.
  await tab(page, "settings");
  await page.locator("#settings-restart").waitFor();
  await still(page);
  for (const name of ["watch", "problems", "serial", "card", "settings", "trend"]) {
    await tab(page, name);
    await clean(page, name);
  }
  const shot = (/** @type {string} */ name) => lightAndDark(page, async (colorScheme) => {
    await page.screenshot({ path: join(pictures, `${name}-${colorScheme}.png`) });
  });
  await pick(page, "#lessons");
  await page.locator("#lesson h3").waitFor();
  await clean(page, "lesson");
  await shot("lesson");
  await pick(page, "#exercises");
  await page.click("#exercise-hint");
  await page.click("#exercise-check");
  await page.locator("#exercise .diagram svg").waitFor();
  await clean(page, "exercise");
  await shot("exercise");
  await page.context().close();
});

for (const [locale, name] of [
  ["en-US", "lab"],
  ["pt-BR", "lab.pt-BR"],
]) {
  test(`the picture that the READMEs begin with: ${name}.png`, async () => {
    const page = await lab.open({ locale, viewport: { width: 1280, height: 800 } });
    await run(page);
    // What the corner says is closed first: it would lie on the picture, and a click later would release the button.
    await page.locator("#notes", { hasText: /is stored and runs|está gravado e em/ }).waitFor();
    for (const notes = page.locator("#notes button"); (await notes.count()) > 0; ) await notes.last().click();
    await page.locator('[data-input="1"]').hover();
    await page.mouse.down();
    await lamp(page, 1, true);
    await page.locator('.ladder.live .element.on[data-point="Q1"]').first().waitFor();
    const picture = await page.screenshot({ path: join(pictures, `${name}.png`) });
    assert.ok(picture.length <= 200_000, `${picture.length} bytes`);
    await page.context().close();
  });
}

test("a browser in Portuguese gets Portuguese, and a switch changes it", async () => {
  const page = await lab.open({ locale: "pt-BR" });
  assert.equal(await page.getAttribute("html", "lang"), "pt-BR");
  assert.match((await page.textContent("#run")) ?? "", /^Executar$/);
  await run(page);
  assert.match((await page.textContent("#status")) ?? "", /varreduras/);
  await holding(page, 1, () => lamp(page, 1, true));
  await page.screenshot({ path: join(pictures, "portuguese.png") });
  assert.match((await page.textContent(".ladder .heading")) ?? "", /Degrau 1/);
  await select(page, "#speak", "en");
  assert.match((await page.textContent("#run")) ?? "", /^Run$/);
  await page.locator(".ladder .heading", { hasText: "Rung 1" }).waitFor();
  await page.context().close();
});

test("a note that stands speaks the other language after a switch, and so does what it offers", async () => {
  const page = await lab.still();
  await page.click("#menu-fileMenu");
  await page.locator(".menu button", { hasText: /^New$/ }).click();
  const note = page.locator("#notes > div");
  await note.filter({ hasText: "Your program was replaced" }).getByRole("button", { name: "Undo" }).waitFor();
  await select(page, "#speak", "pt");
  await note.filter({ hasText: "Seu programa foi substituído" }).getByRole("button", { name: "Desfazer" }).waitFor();
  assert.equal(await note.count(), 1);
  await page.context().close();
});

test("at 390 × 844 nothing lies beside the screen, and a finger runs a program", async () => {
  const page = await lab.open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
  await page.locator("#run").tap();
  await page.locator('#status[data-state="RUN"]').waitFor();
  const button = page.locator('[data-input="1"]');
  await button.scrollIntoViewIfNeeded();
  const box = await button.boundingBox();
  assert.ok(box && box.width >= 44 && box.height >= 44, "a finger's width");
  await button.dispatchEvent("pointerdown", { button: 0, pointerId: 1, pointerType: "touch", isPrimary: true });
  await lamp(page, 1, true);
  await button.dispatchEvent("pointerup", { button: 0, pointerId: 1, pointerType: "touch" });
  await page.screenshot({ path: join(pictures, "phone.png"), fullPage: true });
  assert.deepEqual(await findings(page), []);
  await page.context().close();
});

/** What is done, and what a screen reader hears of it.
 * @type {[(page: import("playwright-core").Page) => Promise<void>, en: RegExp, pt: RegExp][]} */
const HEARD = [
  [(page) => page.click("#run"), /RUN: the board is scanning/, /RUN: varreduras na placa/],
  [(page) => page.keyboard.press("Shift+1"), /Q1 on/, /Q1 ligada/],
  [(page) => page.keyboard.press("Shift+2"), /Q1 off/, /Q1 desligada/],
  [(page) => page.click('tr[data-point="Q1"] button'), /forced: Q1/, /forçado: Q1/],
  [(page) => page.click("#release"), /nothing is forced/, /nada está forçado/],
  [(page) => pick(page, "#pause"), /Time is stopped/, /O tempo está parado/],
  [(page) => pick(page, "#pause"), /Time is running/, /O tempo está correndo/],
  [(page) => page.click("#command-stop"), /STOP: the board is not scanning/, /STOP: sem varreduras/],
  [(page) => page.click("#plug"), /No power/, /Sem energia/],
  [(page) => page.click("#plug"), /RUN: the board is scanning/, /RUN: varreduras na placa/],
];

for (const [index, locale] of ["en-US", "pt-BR"].entries()) {
  test(`a screen reader hears what the board does, ${locale}`, async () => {
    const page = await lab.open({ locale });
    await page.locator("#problem-count.good").waitFor();
    await tab(page, "watch");
    for (const [act, ...words] of HEARD) {
      await page.evaluate(() => document.getElementById("live")?.replaceChildren());
      await act(page);
      await page.locator("#live[aria-live=polite]", { hasText: words[index] ?? /never/ }).waitFor({ state: "attached" });
    }
    // What the corner says is heard too.
    await tab(page, "card");
    await page.click("#make-card");
    await page.locator("#notes[aria-live=polite]", { hasText: /Reset|Reiniciar/ }).waitFor();
    await page.context().close();
  });
}
