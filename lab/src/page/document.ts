// The program that somebody writes: its name and text, kept by the browser, and what Rust says of it.

import type { Checked, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Signal } from "./signal";

const KEPT = "program";
const FIRST: Text = {
  name: "seal-in.il",
  text: `(* Seal-in - Selo: I1 starts, I2 stops - I1 liga, I2 desliga *)
VAR
    start AT %I1 : BOOL;
    stop  AT %I2 : BOOL;
    motor AT %Q1 : BOOL;
END_VAR

LD   start
OR   motor
ANDN stop
ST   motor
`,
};

/** What Rust says of a text. */
export interface Looked {
  readonly text: Text;
  readonly checked: Checked;
}

export class ProgramDocument {
  readonly text: Signal<Text>;
  /** What was found in the last text that was looked at; null before that. */
  readonly looked = new Signal<Looked | null>(null);
  private busy = false;
  private stale = false;

  constructor(private readonly tools: RemoteTools) {
    this.text = new Signal(kept() ?? FIRST);
    this.text.follow((text) => {
      keep(text);
      void this.look();
    });
  }

  /** Another text; what it replaces is given back. */
  replace(text: Text): Text {
    const before = this.text.value;
    this.text.value = text;
    return before;
  }

  /** The text is checked; while that lasts, the newest of those that come is next. */
  private async look(): Promise<void> {
    if (this.busy) {
      this.stale = true;
      return;
    }
    this.busy = true;
    do {
      this.stale = false;
      const text = this.text.value;
      this.looked.value = { text, checked: await this.tools.ask("check", text) };
    } while (this.stale);
    this.busy = false;
  }
}

function kept(): Text | null {
  try {
    const text = JSON.parse(localStorage.getItem(KEPT) ?? "null") as Partial<Text> | null;
    return typeof text?.name === "string" && typeof text.text === "string" ? { name: text.name, text: text.text } : null;
  } catch {
    return null;
  }
}

function keep(text: Text): void {
  try {
    localStorage.setItem(KEPT, JSON.stringify(text));
  } catch {
    // A browser that keeps nothing still runs programs.
  }
}
