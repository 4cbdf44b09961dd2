// The program that somebody writes: its name and text, kept by the browser, and what Rust says of it.

import type { Both, Checked, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { keep, kept } from "./kept";
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
  /** Whether a reload would bring it back. */
  readonly isKept = new Signal(true);
  private busy = false;
  private stale = false;
  private waiting: (() => void)[] = [];

  constructor(private readonly tools: RemoteTools) {
    this.text = new Signal(lastText() ?? FIRST);
    this.text.follow((text) => {
      this.isKept.value = keep(KEPT, JSON.stringify(text));
      void this.look();
    });
  }

  /** Another text; what it replaces is given back. */
  replace(text: Text): Text {
    const before = this.text.value;
    this.text.value = text;
    return before;
  }

  /** What Rust says of the text as it is now, as soon as it has said it. */
  async now(): Promise<Looked> {
    for (;;) {
      const looked = this.looked.value;
      if (looked?.text === this.text.value) return looked;
      await new Promise<void>((wake) => this.waiting.push(wake));
    }
  }

  private async check(text: Text): Promise<Checked> {
    try {
      return await this.tools.ask("check", text);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return unseen(error.both);
    }
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
      this.looked.value = { text, checked: await this.check(text) };
    } while (this.stale);
    this.busy = false;
    for (const wake of this.waiting.splice(0)) wake();
  }
}

/** The program that the browser has kept. */
export function lastText(): Text | null {
  try {
    const text = JSON.parse(kept(KEPT) ?? "null") as Partial<Text> | null;
    return typeof text?.name === "string" && typeof text.text === "string" ? { name: text.name, text: text.text } : null;
  } catch {
    return null;
  }
}

/** What is shown of a text that Rust does not look at. */
function unseen(why: Both): Checked {
  const problem = { number: "", severity: "error", line: 1, column: 1, from: 0, to: 0, message: why, help: { en: "", pt: "" } } as const;
  return { language: "il", problems: [problem], more: 0, colours: [], program: null };
}
