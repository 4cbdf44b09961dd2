// When what a reading tells has happened. Pins are known to the microsecond, all else of the simulated board only from
// reading to reading; what has changed between two of them is put where it has its cause before it and its effect after it.

/** A pin that has changed, at a time in ms. */
interface Turn {
  readonly at: number;
  readonly drives: boolean;
  /** How many readings had come when it was told. */
  readonly told: number;
}

/** So many pins that have changed are looked through: more than two readings lie no further back. */
const KEPT = 500;

export class Moments {
  private turns: Turn[] = [];
  /** The times of the last two readings: a part of a reading is as old as the one before it at most. */
  private before: readonly [number, number] = [0, 0];
  private readings = 0;

  /** An input or an output has changed. */
  turned(at: number, what: "input" | "output"): void {
    this.turns.push({ at, drives: what === "input", told: this.readings });
    if (this.turns.length > KEPT) this.turns.shift();
  }

  /** A reading has come at this time: gives when that has happened which is new in it. */
  read(at: number): number {
    const [from] = this.before;
    this.before = [this.before[1], at];
    // What was told only after the last reading is new as well.
    const isNew = (turn: Turn): boolean => turn.at > from || turn.told === this.readings;
    const turns = this.turns.filter((turn) => isNew(turn) && turn.at <= at).sort((one, other) => one.at - other.at);
    this.readings += 1;
    const driven = (since: number): boolean => turns.some((turn) => !turn.drives && turn.at >= since);
    const inputs = turns.filter((turn) => turn.drives);
    // What an input has brought about, and what has brought about an output.
    const cause = inputs.findLast((turn) => driven(turn.at)) ?? inputs.at(-1) ?? turns[0];
    return cause?.at ?? at;
  }

  clear(): void {
    this.turns = [];
    this.before = [0, 0];
  }
}
