// What is wired to the board beside its buttons: a machine that moves with the board's time.

/** What a machine gives to the board. */
export interface Gives {
  /** Bit n: the contact at input n + 1 is closed. */
  readonly closed: number;
  /** Analogue inputs, and their readings, 0 to 1023. */
  readonly analogue: readonly (readonly [input: number, reading: number])[];
}

export interface Machine {
  /** Bit n: it is wired to input n + 1, whose button it takes the place of. */
  readonly inputs: number;
  /** The next simulated millisecond, with these outputs: bit n is output n + 1; of each, what share of 255 it was high. */
  step(levels: number, shares: readonly number[]): Gives;
}
