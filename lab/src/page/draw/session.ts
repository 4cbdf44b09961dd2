// The drawing that is open: what is done to it goes to Rust, its text into the program, and its log into the browser.

import { type Act, type Drawn, type Text } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { Refusal } from "../../tools/tools";
import { speak, told } from "../../words/words";
import type { Looked, ProgramDocument } from "../document";
import { keep, kept } from "../kept";
import { note } from "../notes";
import { Signal } from "../signal";

const KEPT = "drawing";
/** What moves the cursor and no more: of several in a row the last is enough. */
const MOVES = new Set(["move", "select", "extend", "out"]);

/** Why nothing can be drawn. */
export type Closed = "faulty" | "readOnly" | null;

interface Kept {
  readonly name: string;
  readonly base: Text;
  readonly log: Act[];
  /** The program's text as the drawing has left it. */
  readonly text: string;
}

export class Session {
  readonly drawn = new Signal<Drawn | null>(null);
  readonly closed = new Signal<Closed>(null);
  private kept: Kept | null = null;
  private queue: Promise<unknown> = Promise.resolve();
  private begins = false;
  private visible = false;

  constructor(
    private readonly program: ProgramDocument,
    private readonly tools: RemoteTools,
    private readonly width: () => number,
    /** Shows a text in the editor too. */
    private readonly write: (text: Text) => void,
  ) {
    program.looked.follow(() => this.follow());
    tools.begun.add(() => this.begin());
    speak.follow(() => {
      if (this.visible && this.drawn.value) void this.again();
    });
  }

  /** It is on the screen, or no longer. */
  show(visible: boolean): void {
    this.visible = visible;
    this.follow();
  }

  /** Settled when all that was asked for is done. */
  async settled(): Promise<void> {
    await this.queue;
  }

  /** Does something; what is wrong with it is told to the person, and given back. */
  act(act: Act): Promise<boolean> {
    return this.next(async () => {
      if (this.closed.value || !this.kept) return false;
      const drawn = await this.tools.ask("edit", { act, width: this.width(), speak: speak.value });
      const { log } = this.kept;
      if (MOVES.has(act.do)) {
        if (MOVES.has(log.at(-1)?.do ?? "")) log.pop();
        log.push({ do: "select", from: drawn.cursor[0], to: drawn.cursor[1] });
      } else log.push(act);
      this.take(drawn);
      return true;
    });
  }

  /** Draws it anew, in another width or language. */
  again(): Promise<boolean> {
    return this.next(async () => {
      this.drawn.value = await this.tools.ask("edit", { act: null, width: this.width(), speak: speak.value });
      return true;
    });
  }

  /** The tools know no drawing any more: it is opened again, with all that can be undone. */
  private begin(): void {
    if (this.begins) return;
    this.begins = true;
    void this.next(async () => {
      if (this.kept) await this.open(this.kept, this.program.text.value);
      return true;
    }).finally(() => {
      this.begins = false;
    });
  }

  private next(job: () => Promise<boolean>): Promise<boolean> {
    const done = this.queue.then(job).catch((error: unknown) => {
      if (!(error instanceof Refusal)) throw error;
      note(told(error.both));
      return false;
    });
    this.queue = done;
    return done;
  }

  /** The program has another text than the drawing: a hand has written in it, or opened another. */
  private follow(): void {
    const looked = this.program.looked.value;
    if (!this.visible || !looked || looked.text !== this.program.text.value) return;
    void this.next(() => this.meet(looked));
  }

  private async meet({ text, checked }: Looked): Promise<boolean> {
    if (text !== this.program.text.value) return true;
    const isBlank = text.text.trim() === "";
    const isDrawn = checked.language === "il" || checked.language === "numeric" || isBlank;
    this.closed.value = !checked.program && !isBlank ? "faulty" : isDrawn ? null : "readOnly";
    if (this.closed.value === "faulty") return false;
    const { kept } = this;
    if (kept?.text === text.text && endOf(kept.name) === endOf(text.name)) {
      // It has another name at most.
      this.kept = { ...kept, name: text.name };
      this.keep();
      return true;
    }
    const old = this.drawn.value === null ? remembered() : null;
    if (old && old.name === text.name && old.text === text.text) await this.open(old, text);
    else if (kept && kept.name === text.name) {
      // A step of its own, which undo takes back.
      const act: Act = { do: "text", ...text };
      const drawn = await this.tools.ask("edit", { act, width: this.width(), speak: speak.value });
      this.kept = { ...kept, log: [...kept.log, act], text: text.text };
      this.take(drawn);
    } else await this.open({ name: text.name, base: text, log: [], text: text.text }, text);
    return true;
  }

  private async open(kept: Kept, text: Text): Promise<void> {
    const ask = { width: this.width(), speak: speak.value };
    let drawn: Drawn;
    try {
      drawn = await this.tools.ask("draw", { base: kept.base, log: kept.log, ...ask });
      this.kept = kept;
    } catch (error) {
      if (!(error instanceof Refusal) || kept.log.length === 0) throw error;
      // What was kept fits no longer; the text does.
      this.kept = { name: text.name, base: text, log: [], text: text.text };
      drawn = await this.tools.ask("draw", { base: text, log: [], ...ask });
    }
    // Nothing but its text is the program's.
    this.drawn.value = drawn;
    this.keep();
  }

  private take(drawn: Drawn): void {
    if (this.kept && drawn.text !== null && drawn.text !== this.kept.text) {
      this.kept = { ...this.kept, text: drawn.text };
      this.write({ name: this.kept.name, text: drawn.text });
    }
    this.drawn.value = drawn;
    this.keep();
  }

  private keep(): void {
    keep(KEPT, JSON.stringify(this.kept));
  }
}

/** The end of a file's name, which says its language. */
function endOf(name: string): string {
  return /\.\w+$/.exec(name)?.[0].toLowerCase() ?? "";
}

function remembered(): Kept | null {
  try {
    const found = JSON.parse(kept(KEPT) ?? "null") as Partial<Kept> | null;
    const is = typeof found?.name === "string" && typeof found.text === "string" && Array.isArray(found.log) && typeof found.base?.text === "string";
    return is ? (found as Kept) : null;
  } catch {
    return null;
  }
}
