// What a chart was before, and was again: texts, from the first to the last.

import type { Text } from "../../tools/answers";
import type { ProgramDocument } from "../document";

export class Past {
  /** The text that is shown. */
  now: Text | null = null;
  private readonly texts = { undo: [] as Text[], redo: [] as Text[] };
  /** The program that it is of, as the document counts them. */
  private opened = -1;
  /** Whether a hand has written in the text last: all that it writes in a row is one step. */
  private isWriting = false;

  constructor(private readonly program: ProgramDocument) {}

  has(way: "undo" | "redo"): boolean {
    return this.texts[way].length > 0;
  }

  /** The program has this text: the same, one that a hand has written, or that of another program. */
  meet(text: Text): "same" | "written" | "another" {
    const { now } = this;
    this.now = text;
    if (this.opened !== this.program.opened || !now) {
      this.opened = this.program.opened;
      this.texts.undo = [];
      this.texts.redo = [];
      this.isWriting = false;
      return "another";
    }
    if (now.text === text.text) return "same";
    if (!this.isWriting) this.texts.undo.push(now);
    this.texts.redo = [];
    this.isWriting = true;
    return "written";
  }

  /** Something was done, which gave this text. */
  did(text: Text): void {
    if (this.now) this.texts.undo.push(this.now);
    this.texts.redo = [];
    this.now = text;
    this.isWriting = false;
  }

  /** The text before, or after; null where there is none, and where the program is another by now. */
  go(way: "undo" | "redo"): Text | null {
    if (!this.now || !this.program.isStill(this.now)) return null;
    const text = this.texts[way].pop();
    if (!text) return null;
    this.texts[way === "undo" ? "redo" : "undo"].push(this.now);
    this.now = text;
    this.isWriting = false;
    return text;
  }
}
