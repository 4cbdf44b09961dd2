// The UNO on the desk: WebSerial, with the port replaced by a second simulated board. The chooser and DTR of a real port
// are not proven by it.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, run, still, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Runs in the page, before all else: a port with a board behind it. */
function plugIn() {
  class Port extends EventTarget {
    worker = new Worker("board.js", { type: "module" });
    /** @type {ReadableStreamDefaultController<Uint8Array> | null} */
    out = null;
    /** @type {ReadableStream<Uint8Array> | null} */
    readable = null;
    /** @type {WritableStream<Uint8Array> | null} */
    writable = null;

    /** What was asked of it, in order. @type {string[]} */
    did = [];

    constructor() {
      super();
      this.worker.addEventListener("message", ({ data }) => {
        if (data.kind === "serial") this.out?.enqueue(data.bytes);
      });
      void fetch("unoclp.bin").then(async (answer) => {
        this.worker.postMessage({ kind: "firmware", bytes: new Uint8Array(await answer.arrayBuffer()) });
        this.worker.postMessage({ kind: "plug", on: true });
        this.worker.postMessage({ kind: "run" });
      });
    }

    /** @param {{ baudRate: number }} options */
    async open({ baudRate }) {
      this.did.push("open");
      this.worker.postMessage({ kind: "line", format: { baud: baudRate, parity: "none" } });
      this.worker.postMessage({ kind: "reset" });
      this.readable = new ReadableStream({ start: (out) => void (this.out = out), cancel: () => void (this.out = null) });
      this.writable = new WritableStream({ write: (bytes) => this.worker.postMessage({ kind: "serial", bytes }) });
    }

    async setSignals() {
      this.did.push("reset");
      this.worker.postMessage({ kind: "reset" });
    }

    async close() {
      this.did.push("close");
      this.readable = this.writable = this.out = null;
    }

    /** Somebody pulls the plug. */
    pull() {
      this.worker.terminate();
      const { out } = this;
      this.readable = null;
      out?.error(new DOMException("The device has been lost.", "NetworkError"));
    }
  }
  const port = new Port();
  Object.assign(window, { port });
  Object.defineProperty(navigator, "serial", { value: { requestPort: async () => port }, configurable: true });
}

test("a board at a port is found, takes a program, is live, and is lost", async () => {
  const page = await lab.open();
  await page.context().addInitScript(plugIn);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  // The board at the port is another.
  await still(page);
  await page.click("#connect");
  await page.locator("#desk-about", { hasText: "Connected: unoclp UNO" }).waitFor();
  await run(page);
  // A button of the page forces the input of the board, and says so.
  await holding(page, 1, async () => {
    await page.locator('.place.is-forced [data-input="1"]').waitFor();
    await page.locator('[data-output="1"][data-on="true"]').waitFor();
  });
  await page.locator('.place:not(.is-forced) [data-input="1"]').waitFor();
  await page.locator('.ladder.live .element.on[data-point="Q1"]').first().waitFor();
  await page.evaluate("port.pull()");
  await page.locator("#notes", { hasText: "The line to the board is gone" }).waitFor();
  // The way back is the simulated board.
  await page.click("#connect");
  await page.locator("#hardware").waitFor();
  await page.context().close();
});

test("a program in a typed language goes to a board at a port without a reset, and the line stays open", async () => {
  const page = await lab.open();
  await page.context().addInitScript(plugIn);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  await still(page);
  await page.click("#connect");
  const about = page.locator("#desk-about", { hasText: "Connected: unoclp UNO" });
  await about.waitFor();
  await type(page, "PROGRAM p\nVAR on AT %IX1 : BOOL; lamp AT %QX2 : BOOL; END_VAR\nlamp := on;\nEND_PROGRAM\n", "lamp.st");
  await page.locator(".ladder .element[data-point=Q2]").waitFor();
  // The name of the board would vanish with the conversation, and come back with the next.
  await page.evaluate(() => {
    const about = document.querySelector("#desk-about");
    const names = Object.assign(window, { names: [about?.textContent] }).names;
    new MutationObserver(() => names.push(about?.textContent)).observe(about ?? document, { childList: true, characterData: true, subtree: true });
  });
  await run(page);
  await holding(page, 1, () => page.locator('[data-output="2"][data-on="true"]').waitFor());
  await page.locator(".ladder.live").waitFor();
  assert.deepEqual(await page.evaluate("port.did"), ["open"]);
  const names = new Set(/** @type {string[]} */ (await page.evaluate("names")));
  assert.equal(names.size, 1, [...names].join(" | "));
  await page.context().close();
});

test("a browser without WebSerial says which have it", async () => {
  const page = await lab.open();
  await page.evaluate(() => Object.defineProperty(navigator, "serial", { value: undefined, configurable: true }));
  await page.click("#connect");
  await page.locator("#notes", { hasText: "Chrome, Edge and Opera" }).waitFor();
  assert.ok(await page.isVisible("#hardware"));
  await page.context().close();
});
