// Finding words in the drawing: addresses, names, comments.

import type { RemoteTools } from "../../tools/remote";
import { say } from "../../words/draw";
import { h } from "../dom";
import { announce } from "../notes";

export class Finder {
  readonly bar: HTMLElement;
  private readonly input = h("input", { type: "search", id: "find-words", "data-say-label": "find" });
  private readonly count = h("span", { class: "note", id: "find-count" });
  private words = "";
  private found: readonly number[] = [];
  private at = -1;

  constructor(
    private readonly tools: RemoteTools,
    private readonly go: (id: number) => void,
  ) {
    this.bar = h("form", { class: "row finder", role: "search", hidden: true }, this.input, this.count);
    this.bar.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.next();
    });
    this.bar.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.bar.hidden = true;
    });
  }

  open(): void {
    this.bar.hidden = false;
    this.input.focus();
    this.input.select();
  }

  private async next(): Promise<void> {
    const words = this.input.value;
    this.found = await this.tools.ask("find", { words });
    this.at = words === this.words ? (this.at + 1) % Math.max(this.found.length, 1) : 0;
    this.words = words;
    const id = this.found[this.at];
    this.count.textContent = id === undefined ? say("findNone", { words }) : say("findOf", { n: this.at + 1, all: this.found.length });
    announce(this.count.textContent);
    if (id !== undefined) this.go(id);
  }
}
