// The machine as Rust moves it, as the simulated UNO is wired to it.

import type { Gives, Machine } from "unoclp-uno";
import { bitsOf } from "../tools/bits";
import type { Tools } from "../tools/tools";

export class Wired implements Machine {
  private last: Gives = { closed: 0, analogue: [] };

  constructor(
    private readonly rust: Tools,
    readonly inputs: number,
    /** It has broken down, and stands still; who asks for it next is told. */
    private readonly lost: () => void,
  ) {}

  step(levels: number, shares: readonly number[]): Gives {
    try {
      const { inputs, analogue } = this.rust.ask("machineStep", { levels, shares, ms: 1 });
      this.last = { closed: bitsOf(inputs), analogue };
    } catch {
      this.lost();
    }
    return this.last;
  }
}
