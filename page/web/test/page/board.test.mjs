// The board that a program is for: one that only the core runs is called none, the page says which board holds the program,
// and nothing is sent to one that does not. The board is this test's own: Rust tells of it what is put into its answers.
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

/** Puts a board `wide` into what Rust answers; for it an input I9 is as good as I1. */
const WIDE = `{
  const make = WebAssembly.instantiate;
  WebAssembly.instantiate = async (module, imports) => {
    const instance = await make(module, imports);
    const { memory, unoclp_room, unoclp_call, unoclp_answer } = instance.exports;
    let room = 0, size = 0, own = null;
    const write = (text) => {
      const bytes = new TextEncoder().encode(text);
      new Uint8Array(memory.buffer, unoclp_room(bytes.length), bytes.length).set(bytes);
    };
    return { exports: {
      get memory() { return own ? { buffer: own.buffer } : memory; },
      unoclp_room: (bytes) => { own = null; size = bytes; return (room = unoclp_room(bytes)); },
      unoclp_call: () => {
        const asked = JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, room, size)));
        const isWide = asked.board === "wide";
        if (isWide) write(JSON.stringify({ ...asked, board: "uno", text: asked.text?.replaceAll("I9", "I1") }));
        const length = unoclp_call();
        if (asked.ask !== "board") return length;
        const { ok } = JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, unoclp_answer(), length)));
        const told = { ...ok, all: [...ok.all, "wide"], ...(isWide && { id: "wide", name: "PC", firmware: false, inputs: 99, outputs: 99, shared: [] }) };
        own = new TextEncoder().encode(JSON.stringify({ ok: told }));
        return own.length;
      },
      unoclp_answer: () => (own ? 0 : unoclp_answer()),
    } };
  };
}
`;

/** A page whose tools know that board. @param {import("playwright-core").BrowserContextOptions} options */
async function wide(options) {
  const page = await lab.still(options);
  await page.context().addInitScript(WIDE);
  await page.context().route("**/tools.js", async (route) => {
    const answer = await route.fetch();
    await route.fulfill({ response: answer, body: WIDE + (await answer.text()) });
  });
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  return page;
}

for (const { locale, none, fits, lacks, refused } of [
  { locale: "en-US", none: /PC is no UNO/, fits: /also fits on UNO, Nano/, lacks: /No board holds this program\. UNO: .*I9|09/, refused: /Nothing was sent: UNO/ },
  { locale: "pt-BR", none: /PC não é um UNO/, fits: /também cabe em UNO, Nano/, lacks: /Nenhuma placa comporta este programa\. UNO: .*I9|09/, refused: /Nada foi enviado: UNO/ },
]) {
  test(`a board that is none is called so, and sent to nobody, ${locale}`, async () => {
    const page = await wide({ locale });
    const note = page.locator("#board-note");
    await page.locator("#problem-count.good").waitFor();
    assert.ok(await note.isHidden());
    await page.selectOption("#for-board", "wide");
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

test("where all boards have the same points there is no choice", async () => {
  const page = await lab.still();
  assert.equal(await page.locator("#for-board:visible").count(), 0);
  await page.context().close();
});
