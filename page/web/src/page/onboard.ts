// Which program the board has: its checksum tells, after a reload, of another board, of a card. What is shown of the
// board goes by that program, and not by the one that somebody writes meanwhile.

import type { Made, Stored, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import type { Bench } from "./bench";
import type { ProgramDocument, Whole } from "./document";
import { keep, kept } from "./kept";
import { Signal } from "./signal";

const KEPT = "ran";
/** Programs that are known again. */
const MOST = 6;

/** A program that a board has had, and how it keeps it. */
interface Ran extends Text {
  readonly kept: Stored;
}

export class OnBoard {
  /** The program whose points and names are those of the board: the one that it has, or the one that it will have while
   * it has none. Null where there is none; without names where nobody knows what the board has. */
  readonly shown = new Signal<Made | null>(null);
  private known: Whole | null = null;
  private ran = ranBefore();
  private asked = "";

  constructor(
    private readonly bench: Bench,
    private readonly program: ProgramDocument,
    private readonly tools: RemoteTools,
  ) {
    for (const signal of [bench.seen, program.looked]) (signal as typeof bench.seen).follow(() => void this.look());
  }

  private async look(): Promise<void> {
    const { bench } = this;
    const { on: { value: on }, seen: { value: seen }, upload: { value: upload } } = bench;
    if (seen && upload === null && seen.same !== true) await this.recognise(seen.kept);
    if (seen?.same === true && on) await this.know(on, seen.kept);
    const looked = this.program.looked.value;
    const written = looked?.checked.program ?? null;
    // Until it is watched by the program that it keeps, names of another would be wrong.
    const hasOther = seen !== null && upload === null && seen.state !== "FAULT" && seen.same !== true && this.candidate(seen.kept) !== looked?.text;
    this.shown.value = hasOther ? written && nameless(written) : on && this.known ? this.known.made : (written ?? this.shown.value);
  }

  /** The program that a board keeps so: the one of the editor, or one of before. */
  candidate(stored: Stored): Text | null {
    const looked = this.program.looked.value;
    if (looked?.checked.program && isSame(looked.checked.program.kept, stored)) return looked.text;
    return this.ran.find(({ kept }) => isSame(kept, stored)) ?? null;
  }

  /** Has the board watched by the program that it keeps, where that is known. */
  private async recognise(stored: Stored): Promise<void> {
    const found = this.candidate(stored);
    const key = JSON.stringify([found, stored]);
    if (!found || key === this.asked) return;
    this.asked = key;
    try {
      await this.bench.watch({ name: found.name, text: found.text });
    } catch (error) {
      // An earlier version of the page took a program that this one does not.
      if (!(error instanceof Refusal)) throw error;
    }
  }

  /** The board has this program. */
  private async know(on: Text, stored: Stored): Promise<void> {
    this.asked = "";
    if (this.known?.text === on) return;
    const looked = this.program.looked.value;
    const isWritten = looked !== null && looked.text.text === on.text && looked.text.name === on.name;
    const made = isWritten ? looked.checked.program : (await this.tools.ask("check", { of: on })).program;
    if (!made || this.bench.on.value !== on) return;
    this.known = { text: on, made };
    this.ran = [{ ...on, kept: stored }, ...this.ran.filter(({ kept }) => !isSame(kept, stored))].slice(0, MOST);
    keep(KEPT, JSON.stringify(this.ran));
  }
}

/** Whether two programs are kept as the same bytes. */
export function isSame(one: Stored, other: Stored): boolean {
  return one.version === other.version && one.bytes === other.bytes && one.sum === other.sum;
}

/** The last that was written without names: made once for each, so that it counts as the same. */
let unnamed: { of: Made; made: Made } | null = null;
function nameless(of: Made): Made {
  if (unnamed?.of !== of) unnamed = { of, made: { ...of, symbols: {} } };
  return unnamed.made;
}

function ranBefore(): readonly Ran[] {
  try {
    const all = JSON.parse(kept(KEPT) ?? "[]") as readonly Partial<Ran>[];
    return all.filter((one): one is Ran => typeof one.name === "string" && typeof one.text === "string" && typeof one.kept?.sum === "number");
  } catch {
    return [];
  }
}
