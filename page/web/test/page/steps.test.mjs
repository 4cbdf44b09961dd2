// What a step of the tutorial shows besides its words: listings that go into the editor, and pictures of ladders.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, findings, keptText, pick } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

const WORDS = {
  "en-US": { put: "Copy to the editor", next: "Next step", draw: "Start on an empty sheet", rung: "Start with a drawing" },
  "pt-BR": { put: "Colocar no editor", next: "Próximo passo", draw: "Começar em uma folha em branco", rung: "Comece pelo desenho" },
};

for (const locale of /** @type {const} */ (["en-US", "pt-BR"])) {
  test(`each step has its listings and ladders, begins with drawing, and asks for no command line, ${locale}`, async () => {
    const page = await lab.still({ locale });
    const words = WORDS[locale];
    const lesson = page.locator("#lesson");
    await pick(page, "#lessons");
    await lesson.locator(".words", { hasText: words.rung }).waitFor();
    assert.ok(await lesson.evaluate((it) => {
      const [picture, listing] = [".rungs", ".listing"].map((one) => it.querySelector(one));
      return picture && listing && (picture.compareDocumentPosition(listing) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0;
    }), "a ladder comes first");
    let pictures = 0;
    let listings = 0;
    for (;;) {
      const title = await lesson.locator("h3").textContent();
      assert.doesNotMatch((await lesson.locator(".words").textContent()) ?? "", /unoclp \w|cargo/, title ?? "");
      for (const figure of await lesson.locator(".rungs").all()) {
        const picture = figure.locator("svg.ladder");
        await picture.locator(".rung").first().waitFor();
        // It fits its column, and what is written in it is read.
        assert.ok(await picture.evaluate((svg) => {
          const text = /** @type {SVGTextElement} */ (svg.querySelector("text.point"));
          const height = parseFloat(getComputedStyle(text).fontSize) * (text.getScreenCTM()?.a ?? 0);
          const paper = /** @type {Element} */ (svg.parentElement);
          return height >= 12 && paper.scrollWidth <= paper.clientWidth;
        }), title ?? "");
        pictures += 1;
      }
      for (const listing of await lesson.locator(".listing").all()) {
        await listing.getByRole("button", { name: words.put }).click();
        assert.equal(await keptText(page), await listing.locator("pre").textContent());
        await page.locator("#problem-count.good").waitFor();
        listings += 1;
      }
      if ((await lesson.getByRole("button", { name: words.next }).count()) === 0) break;
      await lesson.getByRole("button", { name: words.next }).click();
      await lesson.locator("h3", { hasNotText: title ?? "" }).waitFor();
    }
    assert.deepEqual([pictures, listings], [11, 14]);
    await page.context().close();
  });
}

test("a step is drawn from an empty sheet, and axe-core finds nothing in it", async () => {
  const page = await lab.still();
  await pick(page, "#lessons");
  await page.locator("#lesson .rungs svg.ladder").first().waitFor();
  assert.deepEqual(await findings(page), []);
  await page.getByRole("button", { name: WORDS["en-US"].draw }).click();
  await page.locator("#sheet .rung").first().waitFor();
  assert.equal(await keptText(page), "");
  assert.equal(await page.inputValue("#name"), "01-lamp.il");
  await page.context().close();
});

test("each example stands once in the gallery, with its ladder, and opens in each of its languages", async () => {
  const page = await lab.still();
  await pick(page, "#examples");
  const cards = page.locator("#examples-list .gallery-card");
  await cards.first().waitFor();
  // Each by what it does, not by its file.
  const names = await cards.locator("h3").allTextContents();
  assert.ok(names.length > 20 && names.includes("OR"), names.join());
  assert.ok(names.every((name) => /^\p{Lu}|^\d/u.test(name)), names.join());
  await page.waitForFunction(() => [...document.querySelectorAll("#examples-list img")].filter((image) => /** @type {HTMLImageElement} */ (image).naturalWidth > 0).length > 20);
  assert.deepEqual(await findings(page), []);
  const tank = cards.filter({ has: page.getByRole("button", { name: "tank.st", exact: true }) });
  assert.deepEqual(await tank.getByRole("button").allTextContents(), ["tank.st", "tank.lce", "tank.iscl"]);
  await tank.getByRole("button", { name: "tank.iscl" }).click();
  await page.locator("#tongue", { hasText: "InterSCL" }).waitFor();
  assert.equal(await page.inputValue("#name"), "tank.iscl");
  assert.ok(await page.locator("#examples-list").count() === 0);
  await page.context().close();
});
