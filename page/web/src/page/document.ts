// The program that somebody writes: its name and text, its drawing, and what Rust says of it. The browser keeps it.

import seal from "../../../bridge/start/seal-in.il";
import type { Act, Both, Checked, Made, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { keepHere, keptHere, programOf, whenMoved } from "./place";
import { Signal } from "./signal";

/** The one text in Instruction List that the first module knows: it asks no one for more. */
const FIRST: Text = {
  name: "seal-in.il",
  text: seal,
};

/** What Rust says of a text. */
export interface Looked {
  readonly text: Text;
  readonly checked: Checked;
}

/** A program that can run. */
export interface Whole {
  readonly text: Text;
  readonly made: Made;
}

/** A drawing: what it began with, and all that was done to it. */
export interface Drawing {
  readonly name: string;
  readonly base: Text;
  readonly log: Act[];
  /** The program's text as the drawing has left it. */
  readonly text: string;
  /** How much of it is to be completed before it is a program again; the text is that of the last one. */
  readonly lacks?: number;
}

/** What another program replaces, and what brings it back. */
export interface Work extends Text {
  readonly drawing: Drawing | null;
}

export class ProgramDocument {
  readonly text: Signal<Text>;
  /** The drawing that the text came from last, or null. */
  readonly drawing = new Signal<Drawing | null>(lastDrawing());
  /** The board that it is written for, as a request names it; empty: the usual one. */
  readonly board = new Signal(keptHere("board") ?? "");
  /** How many elements of the drawing are to be completed before all of it is the program. */
  readonly lacks = new Signal(0);
  /** Counts the programs that were opened: each begins a drawing of its own. */
  opened = 0;
  /** What was found in the last text that was looked at; null before that. */
  readonly looked = new Signal<Looked | null>(null);
  /** Whether a reload would bring it back. */
  readonly isKept = new Signal(true);
  private busy = false;
  private stale = false;
  private waiting: (() => void)[] = [];

  constructor(private readonly tools: RemoteTools) {
    this.text = new Signal(lastText() ?? FIRST);
    this.board.follow((board) => {
      tools.board = board || undefined;
      keepHere("board", board);
      // The same text is another program there.
      this.text.value = { ...this.text.value };
    });
    this.text.follow(() => {
      this.keep();
      this.weigh();
      void this.look();
    });
    this.drawing.follow((drawing) => {
      keepHere("drawing", JSON.stringify(drawing));
      this.weigh();
    });
    whenMoved(() => this.keep());
    addEventListener("pagehide", () => this.keep());
  }

  /** Another program; what it replaces is given back. */
  replace({ name, text, drawing }: Text & Partial<Work>): Work {
    const before = this.work;
    this.opened += 1;
    this.drawing.value = drawing ?? null;
    this.text.value = { name, text };
    return before;
  }

  /** The program, where all that is written and drawn is one. */
  get whole(): Whole | null {
    const looked = this.looked.value;
    const made = looked?.text === this.text.value ? looked.checked.program : null;
    return made && this.lacks.value === 0 ? { text: this.text.value, made } : null;
  }

  /** Whether this is still the program: what was asked of another one is not written into it. */
  isStill({ name, text }: Text): boolean {
    const now = this.text.value;
    return now.name === name && now.text === text;
  }

  /** The program and its drawing as they are. */
  get work(): Work {
    return { ...this.text.value, drawing: this.drawing.value };
  }

  private keep(): void {
    this.isKept.value = keepHere("program", JSON.stringify({ ...this.text.value, at: Date.now() }));
  }

  private weigh(): void {
    const drawing = this.drawing.value;
    this.lacks.value = drawing && isOf(drawing, this.text.value) ? (drawing.lacks ?? 0) : 0;
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
      return await this.tools.ask("check", { of: text });
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

/** The program that the browser has kept for this tab. */
export function lastText(): Text | null {
  const program = programOf(keptHere("program"));
  return program && { name: program.name, text: program.text };
}

/** Whether a text is what a drawing has made; the name may be another. */
export function isOf(drawing: Drawing, text: Text): boolean {
  return drawing.text === text.text && endOf(drawing.name) === endOf(text.name);
}

/** The end of a file's name, which says its language. */
export function endOf(name: string): string {
  return /\.\w+$/.exec(name)?.[0].toLowerCase() ?? "";
}

/** A file's name without its end. */
export function stemOf(name: string): string {
  return name.replace(/\.\w+$/, "");
}

/** Whether what was kept, or came in a file, is a drawing. */
export function isDrawing(found: unknown): found is Drawing {
  const drawing = found as Partial<Drawing> | null | undefined;
  return typeof drawing?.name === "string" && typeof drawing.text === "string" && Array.isArray(drawing.log) && typeof drawing.base?.text === "string" &&
    (drawing.lacks === undefined || typeof drawing.lacks === "number");
}

function lastDrawing(): Drawing | null {
  return drawingOf(keptHere("drawing"));
}

/** A drawing as it was kept; null for anything else. */
export function drawingOf(text: string | null): Drawing | null {
  try {
    const found = JSON.parse(text ?? "null") as unknown;
    return isDrawing(found) ? found : null;
  } catch {
    return null;
  }
}

/** What is shown of a text that Rust does not look at. */
function unseen(why: Both): Checked {
  const problem = { number: "", severity: "error", line: 1, column: 1, from: 0, to: 0, message: why, help: { en: "", pt: "" } } as const;
  return { language: "il", problems: [problem], more: 0, colours: [], program: null, blank: false };
}
