// The program that an exercise gives, to be written in another language: a list as its ladder, any other as its text.

import type { Sheet } from "../tools/answers";
import { LANGUAGES } from "../tools/languages";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say } from "../words/learn";
import { speak } from "../words/words";
import { h } from "./dom";

type Given = NonNullable<Sheet["given"]>;

/** Columns of the ladder, which scrolls. */
const WIDTH = 64;

export class GivenView {
  readonly element = h("div", { class: "given", id: "given" });
  private shown = "";

  constructor(private readonly tools: RemoteTools) {}

  /** Shows this one in the language of now. */
  show(given: Given): void {
    const is = JSON.stringify([given, speak.value]);
    if (is === this.shown) return;
    this.shown = is;
    const language = LANGUAGES[given.answerIn][speak.value];
    const asked = h("p", { class: "note" }, say("givenIn", { language }));
    const text = h("pre", { tabindex: 0, "aria-label": say("givenText") }, given.text);
    if (given.language !== "il") {
      this.element.replaceChildren(text, asked);
      return;
    }
    const paper = h("div", { class: "diagram", tabindex: 0, role: "group", "aria-label": say("givenLadder") });
    this.element.replaceChildren(paper, h("details", {}, h("summary", {}, say("givenAsText")), text), asked);
    void this.draw(given, paper, is);
  }

  private async draw(given: Given, paper: HTMLElement, is: string): Promise<void> {
    try {
      const { svg } = await this.tools.ask("ladder", { of: { name: "given.il", text: given.text }, width: WIDTH, speak: speak.value });
      // Drawn by our own Rust, which escapes every text in it.
      if (this.shown === is) paper.innerHTML = svg;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      // Its text stands beneath.
      paper.remove();
      this.element.querySelector("details")?.setAttribute("open", "");
    }
  }
}
