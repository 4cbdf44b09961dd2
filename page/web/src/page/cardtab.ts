// What stands on the card: PROGRAM.TXT and STATE.TXT.

import { say } from "../words/later";
import { speak, translate } from "../words/words";
import type { CardSlot } from "./cardslot";
import { h } from "./dom";
import { pick } from "./files";

const NAMES = ["PROGRAM.TXT", "STATE.TXT"];
/** What it means that one of them is not there. */
const LACKING = ["cardNoProgram", "cardNoState"] as const;

export class CardTab {
  private readonly files = h("div");
  private image: Uint8Array | null | undefined;

  constructor(
    private readonly slot: CardSlot,
    private readonly panel: HTMLElement,
  ) {
    const state = h("input", { type: "checkbox", checked: true });
    const make = h("button", { type: "button", id: "make-card", click: () => void slot.make(state.checked) }, h("span", { "data-say": "cardMake" }));
    const open = h("button", { type: "button", id: "open-card", click: () => pick(([file]) => file && void slot.load(file), ".img,.bin,.dd") }, h("span", { "data-say": "cardOpen" }));
    panel.append(h("div", { class: "row" }, make, open, h("label", { class: "row" }, state, h("span", { "data-say": "cardState" }))), this.files);
    translate(panel);
    slot.image.follow(() => void this.show());
    speak.follow(() => {
      this.image = undefined;
      void this.show();
    });
  }

  /** It is on the screen: a board writes to its card each minute, so it is read only then. */
  async show(): Promise<void> {
    const image = this.slot.image.value;
    if (this.panel.hidden || image === this.image) return;
    this.image = image;
    if (!image) return this.files.replaceChildren(h("p", { class: "empty" }, say("cardEmpty")));
    const texts = await Promise.all(NAMES.map((name) => this.slot.read(image, name)));
    if (this.image !== image) return;
    this.files.replaceChildren(...NAMES.flatMap((name, index) => {
      const text = texts[index];
      return typeof text === "string" ? [h("h3", {}, name), h("pre", {}, text)] : [h("h3", {}, name), h("p", { class: "note" }, say(LACKING[index] ?? "cardNoProgram"))];
    }));
  }
}
