// The machine as Rust moves it, as the simulated UNO is wired to it.

import type { Gives, Machine } from "unoclp-uno";
import type { MachineFacts } from "../tools/answers";
import { bitsOf } from "../tools/bits";
import type { Tools } from "../tools/tools";

export class Wired implements Machine {
  readonly inputs: number;
  private readonly analogue: readonly number[];
  private last: Gives = { closed: 0, analogue: [] };

  constructor(
    private readonly rust: Tools,
    { uses: [inputs, analogue] }: MachineFacts,
    /** It has broken down, and stands still; who asks for it next is told. */
    private readonly lost: () => void,
  ) {
    this.inputs = bitsOf(inputs);
    this.analogue = analogue;
  }

  step(levels: number, shares: readonly number[]): Gives {
    try {
      const closed = this.rust.step(levels, shares, 1);
      if (closed === null) this.lost();
      else this.last = { closed, analogue: this.analogue.length > 0 ? this.read() : [] };
    } catch {
      this.lost();
    }
    return this.last;
  }

  private read(): Gives["analogue"] {
    const readings = this.rust.readings();
    return this.analogue.map((input) => [input, readings[input] ?? 0]);
  }
}
