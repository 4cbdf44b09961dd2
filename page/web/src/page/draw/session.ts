// The drawing that is open: what is done to it goes to Rust, its text into the program, which keeps its log too.

import { type Act, type Drawn, type Text } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { Refusal } from "../../tools/tools";
import { speak, told } from "../../words/words";
import { type Drawing, type Looked, type ProgramDocument, isOf } from "../document";
import { blocks } from "../look";
import { note } from "../notes";
import { Signal } from "../signal";

/** What moves the cursor and no more: of several in a row the last is enough. */
const MOVES = new Set(["move", "select", "extend", "out"]);

/** Why nothing can be drawn. */
export type Closed = "faulty" | "readOnly" | "loses" | null;

export class Session {
  readonly drawn = new Signal<Drawn | null>(null);
  readonly closed = new Signal<Closed>(null);
  /** The drawing that Rust has open. */
  private drawing: Drawing | null = null;
  /** The program that it is of, as the document counts them. */
  private opened = -1;
  private begins = false;
  /** The text that a person lets the drawing write anew. */
  private agreed: string | null = null;
  private queue: Promise<unknown> = Promise.resolve();
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
    const again = (): void => {
      if (this.visible && this.drawn.value) void this.again();
    };
    speak.follow(again);
    blocks.follow(again);
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

  /** Does something; says whether it is done. What is wrong with it is told to the person. */
  async act(act: Act): Promise<boolean> {
    const refused = await this.attempt(act);
    if (refused) note(() => told(refused.both));
    return refused === null;
  }

  /** Does something; gives why it is not done. */
  async attempt(act: Act): Promise<Refusal | null> {
    let refused: Refusal | null = null;
    await this.next(async () => {
      const looksOn = this.closed.value === "loses" && MOVES.has(act.do);
      if ((this.closed.value && !looksOn) || !this.drawing || this.isOther) return;
      try {
        const drawn = await this.tools.ask("edit", { act, ...this.shown });
        this.take(act, drawn);
      } catch (error) {
        if (!(error instanceof Refusal)) throw error;
        refused = error;
      }
    });
    return refused;
  }

  /** A person wants the text as the drawing writes it: from now on it can be changed. */
  agree(): void {
    this.agreed = this.program.text.value.text;
    this.closed.value = null;
  }

  /** Draws it again, in another width, look or language. */
  again(): Promise<void> {
    return this.next(async () => {
      this.drawn.value = await this.tools.ask("edit", { act: null, ...this.shown });
    });
  }

  /** Another program is open than the one that is drawn: what was asked of that one comes too late. */
  get isOther(): boolean {
    return this.program.opened !== this.opened;
  }

  private get shown(): { name: string; width: number; isBlocks: boolean; speak: typeof speak.value } {
    const { name } = this.program.text.value;
    return { name, width: this.width(), isBlocks: blocks.value, speak: speak.value };
  }

  /** The tools know no drawing any more: it is opened again, with all that can be undone. */
  private begin(): void {
    if (this.begins) return;
    this.begins = true;
    void this.next(async () => {
      if (this.drawing) await this.open(this.drawing, this.program.text.value);
    }).finally(() => {
      this.begins = false;
    });
  }

  private next(job: () => Promise<void>): Promise<void> {
    const done = this.queue.then(job).catch((error: unknown) => {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
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

  private async meet({ text, checked }: Looked): Promise<void> {
    const { program } = this;
    if (text !== program.text.value) return;
    const kept = program.drawing.value;
    const isDrawn = kept !== null && isOf(kept, text);
    const canDraw = checked.language === "il" || checked.language === "numeric" || checked.blank;
    const isAnother = this.isOther;
    const loses = this.closed.value === "loses" && !isAnother ? "loses" : null;
    this.closed.value = isDrawn || (canDraw && (checked.program || checked.blank)) ? loses : !checked.program && !checked.blank ? "faulty" : "readOnly";
    if (this.closed.value === "faulty") {
      // Of another program nothing is shown that it is not.
      if (isAnother) this.drawing = this.drawn.value = null;
      return;
    }
    this.opened = program.opened;
    if (isAnother) return this.open(isDrawn ? kept : null, text);
    const { drawing } = this;
    if (drawing && isOf(drawing, text)) {
      // It has another name at most.
      if (drawing.name !== text.name) this.keep({ ...drawing, name: text.name });
    } else if (drawing && drawing.name === text.name) {
      // A step of its own, which undo takes back.
      const act: Act = { do: "text", ...text };
      const drawn = await this.tools.ask("edit", { act, ...this.shown });
      // A hand that has written on meanwhile is not undone.
      this.take(act, drawn, text === program.text.value);
    } else await this.open(null, text);
  }

  /** Opens a drawing, or a text that was never drawn in. */
  private async open(kept: Drawing | null, text: Text): Promise<void> {
    const anew: Drawing = { name: text.name, base: text, log: [], text: text.text };
    let drawing = kept ?? anew;
    let drawn: Drawn | null = null;
    try {
      drawn = await this.tools.ask("draw", { base: drawing.base, log: drawing.log, ...this.shown });
    } catch (error) {
      if (!(error instanceof Refusal) || kept === null) throw error;
    }
    // A file may say of a drawing what it is not.
    const isOther = drawn !== null && drawn.text !== null && drawn.text !== text.text && drawing.base.text !== text.text;
    if (drawn === null || isOther) {
      // What was kept fits no longer; the text does.
      drawing = anew;
      drawn = await this.tools.ask("draw", { base: text, log: [], ...this.shown });
    }
    if (this.isOther) return;
    // Nothing but its text is the program's.
    this.keep({ ...drawing, name: text.name, lacks: lacks(drawn) });
    this.drawn.value = drawn;
    this.weigh(drawn);
  }

  /** This was done, and this is how it is drawn then; the program has its text, if it may. */
  private take(act: Act, drawn: Drawn, mayWrite = true): void {
    const { drawing } = this;
    if (!drawing || this.isOther) return;
    const log = [...drawing.log];
    if (MOVES.has(act.do)) {
      if (MOVES.has(log.at(-1)?.do ?? "")) log.pop();
      log.push({ do: "select", from: drawn.cursor[0], to: drawn.cursor[1] });
    } else log.push(act);
    const text = drawn.text ?? (act.do === "text" ? act.text : drawing.text);
    this.keep({ ...drawing, log, text, lacks: lacks(drawn) });
    if (mayWrite && text !== this.program.text.value.text) this.write({ name: drawing.name, text });
    this.drawn.value = drawn;
    this.weigh(drawn);
  }

  /** A text that would lose something is not changed before a person agrees, or has changed it before. */
  private weigh(drawn: Drawn): void {
    if (this.closed.value === "readOnly" || this.closed.value === "faulty") return;
    const log = this.drawing?.log ?? [];
    const own = log.slice(log.findLastIndex((act) => act.do === "text") + 1);
    const isAgreed = this.agreed === drawn.text || own.some((act) => !MOVES.has(act.do));
    this.closed.value = drawn.loses && !isAgreed ? "loses" : null;
  }

  private keep(drawing: Drawing): void {
    this.drawing = drawing;
    this.program.drawing.value = drawing;
  }
}

/** How much is to be completed before it is a program; nothing, where the sheet is still empty. */
function lacks(drawn: Drawn): number {
  return drawn.text === null ? Math.max(1, drawn.mistakes.filter((mistake) => mistake.error).length) : 0;
}
