// A machine of this page beside a board on the desk: the board's outputs are read, its inputs are forced, by as much time as
// passes from one reading to the next. It knows nothing of how a machine is drawn.

import type { Ask, Both, MachineFacts, Order, Seen } from "../tools/answers";
import type { Asks } from "../tools/asks";
import { bitsOf, hasBit } from "../tools/bits";
import { MOST_MS } from "../tools/numbers";
import { Refusal, type Tools } from "../tools/tools";
import { both } from "../words/words";
import type { MachineAsk, Machines } from "./machines";
import { forcedTo } from "./points";
import { Signal } from "./signal";

/** As long as one step of Rust may be, ms. */
const STEP = MOST_MS;
/** A board that has not been read for so long, ms, was away: the machine stood. */
const AWAY = 1000;
/** A board that has refused for so long, ms, refuses always. One that starts again refuses for a moment. */
const PATIENCE = 5000;
/** Readings of which the interval is the mean. */
const READINGS = 8;

/** What a board on the desk is asked for. */
export interface DeskBoard {
  readonly seen: Signal<Seen | null>;
  /** How far an upload is; null: there is none. */
  readonly upload: { readonly value: unknown };
  order(order: Order): Promise<unknown>;
}

export class DeskMachine implements Machines {
  /** How long it takes from one reading to the next, ms. */
  readonly interval = new Signal<number | null>(null);
  private inputs: readonly number[] = [];
  private last: number | null = null;
  private readonly ordered = new Set<number>();
  private refused: Both | null = null;
  /** When the board began to refuse; null: it takes what it is told. */
  private refusing: number | null = null;

  constructor(
    private readonly board: DeskBoard,
    private readonly tools: () => Tools,
    /** Tools that know machines. */
    private readonly whole: () => Promise<Tools>,
  ) {
    board.seen.follow((seen) => this.step(seen));
  }

  async ask<K extends MachineAsk>(what: K, request: Ask<K>): Promise<Asks[K]["answer"]> {
    const { refused } = this;
    if (refused) {
      this.refused = null;
      this.tools().ask("machineClose", {});
      throw new Refusal(refused);
    }
    const answer = (await this.whole()).ask(what, request);
    if (what === "machine") this.wire(answer as MachineFacts);
    if (what === "machineClose") this.leave();
    return answer;
  }

  private wire({ uses: [inputs, analogue], dims }: MachineFacts): void {
    if (analogue.length > 0 || dims) {
      this.tools().ask("machineClose", {});
      throw new Refusal(both("machineDesk"));
    }
    this.inputs = inputs;
    this.last = null;
    this.refusing = null;
  }

  /** Lets go of the board's inputs. */
  leave(): void {
    const { seen } = this.board;
    for (const number of this.inputs) {
      if (seen.value && forcedTo(seen.value, `I${number}`) !== null) void this.force(number, null);
    }
    this.inputs = [];
    this.interval.value = null;
  }

  private step(seen: Seen | null): void {
    if (!seen || this.inputs.length === 0) {
      this.last = null;
      return;
    }
    // Who begins to watch another program counts its time anew.
    const passed = Math.max(0, seen.at - (this.last ?? seen.at));
    this.last = seen.at;
    if (passed > 0) this.interval.value = Math.round(((this.interval.value ?? passed) * (READINGS - 1) + passed) / READINGS);
    const levels = bitsOf(seen.outputs);
    let closed: number | null = null;
    try {
      for (let left = passed > AWAY ? 0 : passed, first = true; first || left > 0; left -= STEP, first = false) {
        closed = this.tools().step(levels, [], Math.round(Math.min(left, STEP)));
      }
    } catch {
      // It is told as one that is gone.
      closed = null;
    }
    if (closed === null) return this.fail(both("machineDied"));
    // A board without a program that runs takes no forcing, nor does one that is given a program.
    if ((seen.state !== "RUN" && seen.state !== "STOP") || this.board.upload.value !== null) return;
    for (const number of this.inputs) {
      const is = hasBit(closed, number);
      if (forcedTo(seen, `I${number}`) !== is && !this.ordered.has(number)) void this.force(number, is);
    }
  }

  private async force(number: number, to: boolean | null): Promise<void> {
    this.ordered.add(number);
    try {
      await this.board.order({ do: "force", output: false, number, to });
      this.refusing = null;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      const seen = this.board.seen.value;
      // A board that is away is told of elsewhere, and its machine waits.
      if (!seen) return;
      if (this.refusing === null || this.refusing > seen.at) this.refusing = seen.at;
      if (seen.at - this.refusing >= PATIENCE) this.fail(error.both);
    } finally {
      this.ordered.delete(number);
    }
  }

  private fail(why: Both): void {
    this.inputs = [];
    this.interval.value = null;
    this.refused = why;
  }
}
