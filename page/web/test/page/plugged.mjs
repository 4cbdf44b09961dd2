// A port of this computer with a second simulated board behind it. The chooser and DTR of a real port are not proven by it.
// @ts-check

import { pick, still } from "./harness.mjs";

/** A page that is connected to the board at the port; its own one stands. @param {import("./harness.mjs").Lab} lab */
export async function connected(lab) {
  return connect(await lab.open());
}

/** Connects a page to a board whose EEPROM may be kept as the browser keeps that of a simulated one.
 * @param {import("playwright-core").Page} page @param {string | null} eeprom @param {"uno" | "mega"} board */
export async function connect(page, eeprom = null, board = "uno") {
  await page.context().addInitScript(plugIn, /** @type {const} */ ([board, eeprom]));
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  await still(page);
  await pick(page, "#connect");
  await page.locator("#desk-about", { hasText: `Connected: unoclp ${board === "uno" ? "UNO" : "Mega"}` }).waitFor();
  return page;
}

/** Runs in the page, before all else: a port with a board behind it. @param {readonly ["uno" | "mega", string | null]} plugged */
function plugIn([board, eeprom]) {
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
      void fetch(board === "uno" ? "unoclp.bin" : `unoclp-${board}.bin`).then(async (answer) => {
        this.worker.postMessage({ kind: "firmware", board, bytes: new Uint8Array(await answer.arrayBuffer()) });
        if (eeprom) this.worker.postMessage({ kind: "eeprom", bytes: Uint8Array.from(atob(eeprom), (one) => one.charCodeAt(0)) });
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
