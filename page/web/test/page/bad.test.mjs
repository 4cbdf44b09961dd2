// Bad input: each gets words, in both languages, and a way on; nothing that was typed is lost, by a reload neither.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { Lab, choose, give, pick, state, tab, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page @typedef {readonly [en: RegExp, pt: RegExp]} Said */

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** A link with this in it. @param {Buffer} bytes */
const fragment = (bytes) => `#p=${deflateRawSync(bytes).toString("base64url")}`;
/** @param {string} hash */
const link = (hash) => (/** @type {Page} */ page) => page.evaluate((hash) => void (location.hash = hash), hash);
/** @param {string} name @param {Buffer} bytes */
const file = (name, bytes) => (/** @type {Page} */ page) => choose(page, name, bytes);
/** @param {Buffer} bytes */
const image = (bytes) => async (/** @type {Page} */ page) => {
  await tab(page, "card");
  await give(page, () => page.click("#open-card"), "card.img", bytes);
};

/** A card as the page makes one, with no entry of its FAT free: FAT16, in a partition. @param {Page} page */
async function full(page) {
  const download = page.waitForEvent("download");
  await page.click("#menu-fileMenu");
  await page.locator("#menu-fileMenu + div button").last().click();
  const card = readFileSync(await (await download).path());
  const volume = card.readUInt32LE(454) * 512;
  const fat = volume + card.readUInt16LE(volume + 14) * 512;
  const end = fat + card.readUInt16LE(volume + 22) * 512;
  for (let entry = fat; entry < end; entry += 2) if (card.readUInt16LE(entry) === 0) card.writeUInt16LE(0xffff, entry);
  await image(card)(page);
  await page.locator("#panel-card pre", { hasText: "827303" }).waitFor();
}

/** Puts in a text so many times, as from a clipboard. @param {Page} page @param {string} text @param {number} times */
const paste = (page, text, times) => page.locator(".cm-content").evaluate((content, [text, times]) => {
  const clipboardData = new DataTransfer();
  clipboardData.setData("text/plain", text.repeat(times));
  content.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
}, /** @type {const} */ ([text, times]));

const NO_PROGRAM = /** @type {Said} */ ([/contains no program. Your program is still here/, /não contém nenhum programa. O seu programa continua aqui/]);
const NO_CARD = /** @type {Said} */ ([/not a card image with FAT16 or FAT32. Make one here/, /não é a imagem de um cartão com FAT16 ou FAT32. Crie um aqui/]);

/** @type {[string, (page: Page) => Promise<unknown>, Said][]} */
const BAD = [
  ["a file that is no text", file("no.il", Buffer.from([0x7f, 0x45, 0x4c, 0x46, 0, 0, 0])), [/is not text. Your program is still here/, /não é um texto. O seu programa continua aqui/]],
  ["a file of 5 MB", file("large.il", Buffer.alloc(5 << 20, "LD I1\n")), [/larger than 1 MB; .* still here/, /mais de 1 MB; .* continua aqui/]],
  ["5 MB of text put in", (page) => paste(page, "LD I1\n", 900_000), [/larger than 1 MB; .* Nothing was inserted/, /passaria de 1 MB; .* Nada foi inserido/]],
  ["a link of garbage", link("#p=%%%"), NO_PROGRAM],
  ["a link whose data break off", link(fragment(Buffer.from('["a.il","LD I1"]')).slice(0, -4)), NO_PROGRAM],
  ["a link that holds no text", link(fragment(Buffer.from('{"name":1}'))), NO_PROGRAM],
  ["a link that inflates to 64 MB", link(fragment(Buffer.alloc(64 << 20))), NO_PROGRAM],
  ["an image that is no card", image(Buffer.alloc(1 << 20, 7)), NO_CARD],
  ["an image of half a block", image(Buffer.alloc(700)), NO_CARD],
  ["an image of 9 MB", image(Buffer.alloc(9 << 20)), [/larger than 8 MB.* Make a card here/, /passa de 8 MB.* Crie um cartão aqui/]],
  ["a card that is full", full, [/This card is full. The board can read it/, /Este cartão está cheio. A placa consegue lê-lo/]],
];

for (const [index, locale] of ["en-US", "pt-BR"].entries()) {
  test(`bad files, links and cards are named, and lose nothing, ${locale}`, async (t) => {
    const page = await lab.still({ locale });
    await type(page, "LD I3\nST Q3 (* mine *)\n", "mine.il");
    for (const [name, bad, said] of BAD) {
      await t.test(name, async () => {
        await page.evaluate(() => document.getElementById("notes")?.replaceChildren());
        await bad(page);
        await page.locator("#notes", { hasText: said[index] ?? /never/ }).waitFor();
        assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
      });
    }
    await page.reload();
    await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
    assert.equal(await page.inputValue("#name"), "mine.il");
    assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
    await page.context().close();
  });
}

test("a text that Rust does not look at is a problem, and the next one is looked at again", async () => {
  const page = await lab.still();
  // Characters that take three bytes each.
  await type(page, "");
  await paste(page, "…\n", 300_000);
  await page.click("#problem-count.bad");
  await page.locator(".problems", { hasText: "longer than" }).waitFor();
  await type(page, "LD I1\nST Q1\n");
  await page.locator("#problem-count.good").waitFor();
  await page.context().close();
});

test("a browser that keeps nothing says so, and offers the file", async () => {
  const page = await lab.still();
  await page.context().addInitScript(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
  page.on("dialog", (dialog) => void dialog.accept());
  await page.reload();
  const note = page.locator("#notes", { hasText: "cannot store your program" });
  await note.waitFor();
  const download = page.waitForEvent("download");
  await note.getByRole("button", { name: "Save" }).click();
  assert.equal((await download).suggestedFilename(), "seal-in.il");
  await page.context().close();
});

test("a browser whose store is forbidden to the page says so, and runs the program", async () => {
  for (const [locale, said] of /** @type {const} */ ([["en-US", "cannot store your program"], ["pt-BR", "não consegue guardar o seu programa"]])) {
    const context = await lab.browser.newContext({ locale, serviceWorkers: "block" });
    await context.addInitScript(() => {
      for (const name of ["localStorage", "sessionStorage", "indexedDB"]) {
        Object.defineProperty(window, name, { get: () => { throw new DOMException("denied", "SecurityError"); } });
      }
    });
    const page = await context.newPage();
    page.on("pageerror", (error) => lab.errors.push(String(error.stack)));
    page.on("dialog", (dialog) => void dialog.accept());
    await page.goto(lab.server.url);
    await page.locator("#notes", { hasText: said }).waitFor();
    await state(page, "RUN");
    await pick(page, "#programs");
    await page.locator("#programs-list [data-program]").waitFor();
    await context.close();
  }
});

test("a browser without WebAssembly says so in plain HTML, and gives the program back", async () => {
  const page = await lab.still();
  await type(page, "LD I3\nST Q3\n", "mine.il");
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  await page.context().addInitScript("delete window.WebAssembly");
  await page.reload();
  await page.locator("#stuck", { hasText: /Firefox, Chrome, Edge or Safari[^]*continuam guardados/ }).waitFor();
  const download = page.waitForEvent("download");
  await page.click("#save-kept");
  assert.equal((await download).suggestedFilename(), "mine.il");
  await page.context().close();
});

test("a browser without scripts shows the same in its HTML", async () => {
  const context = await lab.browser.newContext({ javaScriptEnabled: false });
  const page = await context.newPage();
  await page.goto(lab.server.url);
  await page.locator("#stuck", { hasText: "needs JavaScript and WebAssembly" }).waitFor();
  await context.close();
});
