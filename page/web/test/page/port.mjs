// A port of this computer, as the page has it from WebSerial, and behind it a device that a test brings along. The chooser
// and what DTR does at a real board are not proven by it: opening the port resets the device, as does a pulse of DTR.
// @ts-check

/** A device at the other end of the cable.
 * @typedef {{ open(baud: number): void, send(bytes: number[]): void, reset(): void, hear: (bytes: number[]) => void }} Device */

/** What becomes of a byte on its way: another one, or nothing.
 * @typedef {(way: "to the board" | "to the page", byte: number) => number | null} Fate */

/** @type {Fate} */
const CARRIED = (_, byte) => byte;

/** Runs in the page, before all else: `navigator.serial`, with one port. */
function serial() {
  /** @type {any} */
  const ends = globalThis;
  class Port extends EventTarget {
    /** @type {ReadableStreamDefaultController<Uint8Array> | null} */
    out = null;
    /** @type {ReadableStream<Uint8Array> | null} */
    readable = null;
    /** @type {WritableStream<Uint8Array> | null} */
    writable = null;

    /** @param {{ baudRate: number }} options */
    async open({ baudRate }) {
      const refused = await ends.cableOpen(baudRate);
      if (refused) throw new DOMException(refused, "NetworkError");
      this.readable = new ReadableStream({ start: (out) => void (this.out = out), cancel: () => void (this.out = null) });
      this.writable = new WritableStream({ write: (bytes) => ends.cableSend([...bytes]) });
    }

    /** @param {{ dataTerminalReady: boolean }} signals */
    async setSignals({ dataTerminalReady }) {
      if (dataTerminalReady) await ends.cableReset();
    }

    async close() {
      this.readable = this.writable = this.out = null;
      await ends.cableClose();
    }
  }
  const port = new Port();
  ends.cableHeard = (/** @type {number[]} */ bytes) => port.out?.enqueue(Uint8Array.from(bytes));
  ends.cableLost = () => {
    const { out } = port;
    port.readable = null;
    out?.error(new DOMException("The device has been lost.", "NetworkError"));
  };
  Object.defineProperty(navigator, "serial", { value: { requestPort: async () => port }, configurable: true });
}

/** The cable between a page and a device. */
export class Cable {
  /** Another program has the port. */
  isBusy = false;
  /** @type {Fate} */
  fate = CARRIED;
  isOpen = false;
  isIn = true;
  /** Frames that the page has sent, by their first two bytes: address and function. @type {number[]} */
  asked = [];
  /** @type {Promise<unknown>} */
  told = Promise.resolve();

  /** @param {import("playwright-core").Page} page @param {Device} device */
  constructor(page, device) {
    this.page = page;
    this.device = device;
    device.hear = (bytes) => this.tell(this.pass("to the page", bytes));
  }

  /** Puts one in, and loads the page again. @param {import("playwright-core").Page} page @param {Device} device */
  static async between(page, device) {
    const cable = new Cable(page, device);
    await page.exposeFunction("cableOpen", (/** @type {number} */ baud) => cable.open(baud));
    await page.exposeFunction("cableSend", (/** @type {number[]} */ bytes) => cable.send(bytes));
    await page.exposeFunction("cableReset", () => cable.isIn && device.reset());
    await page.exposeFunction("cableClose", () => void (cable.isOpen = false));
    await page.addInitScript(serial);
    await page.reload();
    await page.locator("#run:enabled").waitFor();
    return cable;
  }

  /** Somebody pulls it out. */
  async pull() {
    if (!this.isIn) return;
    this.isIn = this.isOpen = false;
    await this.page.evaluate("cableLost()");
  }

  /** And puts it in again; nothing happens to its bytes then. */
  plugIn() {
    this.isIn = true;
    this.fate = CARRIED;
  }

  /** @param {number} baud */
  open(baud) {
    if (!this.isIn) return "The device has been lost.";
    if (this.isBusy) return "Failed to open serial port.";
    this.isOpen = true;
    this.device.open(baud);
    return "";
  }

  /** @param {number[]} bytes */
  send(bytes) {
    if (bytes[1] !== undefined) this.asked.push(bytes[1]);
    const passed = this.pass("to the board", bytes);
    if (this.isOpen && passed.length > 0) this.device.send(passed);
  }

  /** @param {number[]} bytes */
  tell(bytes) {
    if (!this.isOpen || bytes.length === 0) return;
    this.told = this.told.then(() => this.page.evaluate(`cableHeard([${bytes.join()}])`)).catch(() => undefined);
  }

  /** @param {"to the board" | "to the page"} way @param {number[]} bytes */
  pass(way, bytes) {
    return bytes.flatMap((byte) => this.fate(way, byte) ?? []);
  }
}
