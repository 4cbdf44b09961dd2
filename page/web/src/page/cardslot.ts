// The card in its slot: PROGRAM.TXT made from the program in the editor, and what the board has written to it.

import type { RemoteTools } from "../tools/remote";
import { say, speak } from "../words/words";
import type { Bench } from "./bench";
import { h } from "./dom";
import { icon } from "./icons";
import { note } from "./notes";
import { Signal } from "./signal";

const BLOCK = 512;
/** Bytes of a card that is put in from a file: it lives in memory. */
const LARGEST = 8 << 20;
const DIGITS = Array.from({ length: 256 }, (_, byte) => byte.toString(16).padStart(2, "0"));

export class CardSlot {
  /** The image that is in the slot; null: it is empty. */
  readonly image = new Signal<Uint8Array | null>(null);
  readonly control: HTMLElement;
  readonly pull: HTMLElement;
  private aside: Uint8Array | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly tools: RemoteTools,
    /** What would stand in PROGRAM.TXT; null where the text has problems. */
    private readonly code: () => string | null,
    /** Tells why there is none. */
    private readonly tellWhy: () => void,
  ) {
    const box = h("input", { type: "checkbox", role: "switch", id: "card-in", change: () => void (box.checked ? this.insert() : this.remove()) });
    this.control = h("label", { class: "switch" }, box, h("span", { "data-say": "cardSlot" }));
    this.pull = h("button", { type: "button", id: "pull-card", click: () => void (this.image.value ? this.remove() : this.insert()) });
    this.image.follow((image) => {
      box.checked = image !== null;
    });
    const label = (): void => {
      const key = this.image.value ? "faultPull" : "faultInsert";
      this.pull.replaceChildren(icon("bolt"), h("span", { "data-say": key }, say(key)));
    };
    this.image.follow(label);
    speak.follow(label);
    bench.events.add((event) => {
      if (event.kind !== "card" || !this.image.value) return;
      // A copy: others hold the image that was.
      const image = this.image.value.slice();
      image.set(event.bytes, event.block * BLOCK);
      this.image.value = image;
    });
  }

  /** Puts the card in that was pulled out, or a new one. */
  async insert(): Promise<void> {
    if (this.aside) this.put(this.aside);
    else await this.make(true);
  }

  /** Puts a new card in, with the program of the editor. */
  async make(state: boolean): Promise<void> {
    const image = await this.build(state);
    if (!image) {
      this.image.value = null;
      return;
    }
    this.put(image);
    note(() => say("cardReset"));
  }

  /** The bytes of a card with the program of the editor. */
  async build(state: boolean): Promise<Uint8Array | null> {
    const code = this.code();
    if (code === null) {
      this.tellWhy();
      return null;
    }
    const made = await this.tools.ask("card", { program: code, state });
    const image = new Uint8Array(made.bytes);
    for (const [block, digits] of made.blocks) {
      for (let at = 0; at < BLOCK; at++) image[block * BLOCK + at] = Number.parseInt(digits.slice(2 * at, 2 * at + 2), 16);
    }
    return image;
  }

  /** Puts in a card that somebody has read with a tool of their own; says how much room is left on it. */
  async load(file: File): Promise<void> {
    if (file.size > LARGEST) return note(() => say("cardTooLarge"));
    const image = new Uint8Array(await file.arrayBuffer());
    const free = image.length > 0 && image.length % BLOCK === 0 ? await this.tools.ask("free", { blocks: blocksOf(image) }) : null;
    if (free === null) return note(() => say("cardNone"));
    this.put(image);
    note(() => say(free === 0 ? "cardFull" : "cardReset"));
  }

  remove(): void {
    this.aside = this.image.value;
    this.image.value = null;
    this.bench.simulated.tell({ kind: "card", image: null });
  }

  private put(image: Uint8Array): void {
    this.aside = image;
    this.image.value = image;
    this.bench.simulated.tell({ kind: "card", image });
  }

  /** A file of the root folder, by its name in capitals: `PROGRAM.TXT`. */
  async read(image: Uint8Array, name: string): Promise<string | null> {
    return this.tools.ask("read", { blocks: blocksOf(image), name });
  }
}

/** The blocks that are not empty, as Rust takes them. */
function blocksOf(image: Uint8Array): [number, string][] {
  const blocks: [number, string][] = [];
  for (let at = 0; at < image.length; at += BLOCK) {
    const bytes = image.subarray(at, at + BLOCK);
    if (bytes.some((byte) => byte !== 0)) blocks.push([at / BLOCK, Array.from(bytes, (byte) => DIGITS[byte]).join("")]);
  }
  return blocks;
}
