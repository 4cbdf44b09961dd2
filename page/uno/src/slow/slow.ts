// A scan in slow motion: the firmware as it is flashed, stopped where its engine fetches the next linked byte. It goes from
// seam to seam, tells what it has passed, and stands where somebody wants it to.

import type { Board } from "../board";
import { SREG, T } from "../chip/flags";
import { Fetches, SEAM, STOP } from "../chip/fetches";
import { SP, pair } from "../chip/operands";
import { type Places, type Seam, seamsOf } from "./linked";

/** The engine's registers: the images, the low byte of value. */
const [IMAGES, VALUE] = [18, 22] as const;
/** Inputs and outputs that the images have, each. */
const NEAR = 4;
/** What an output is in a byte of its own. */
const ON = 1 << 7;
/** Seams before a stop whose acc is known where the engine comes to it at full speed. */
const BEFORE = 5;
/** No instruction of the program stands there. */
const NOWHERE = -2;

/** How far it goes. */
export interface Go {
  /** It stops where one of these instructions comes next, from 0, or the next that can be told from the one before it;
   * `null`: where any does. */
  readonly to: readonly number[] | null;
  /** Whether it goes through the ends of scans, for as long as it takes; else it stops at the end of this one, whose outputs
   * have been written then. */
  readonly through: boolean;
}

/** What instructions in a row have left behind that were run at once; value and points are `null` where they went by at full
 * speed. */
export interface Left {
  /** The first of them, and the last. */
  readonly from: number;
  readonly to: number;
  readonly acc: boolean;
  readonly value: number | null;
  /** The inputs and the outputs as the scan has them, bit 0 point 01. */
  readonly inputs: number | null;
  readonly outputs: number | null;
}

/** How the engine stands. */
export interface Standing {
  /** The instruction that comes next, from 0; `null` at the end of a scan. */
  readonly step: number | null;
  /** Those from it to before this one are run by one handler, or side by side. */
  readonly until: number;
  readonly acc: boolean;
  readonly value: number;
  /** What is pushed, the last first. */
  readonly pushed: readonly number[];
  /** Bit n: input n + 1, as the images have it, and as it is at its pin; likewise the outputs. */
  readonly inputs: number;
  readonly closed: number;
  readonly outputs: number;
  readonly driven: number;
  /** The instructions of this scan that are done, each before a seam, in the order of the program. */
  readonly left: readonly Left[];
}

export class Slow {
  private readonly fetches: Fetches;
  private readonly byAddress: ReadonlyMap<number, number>;
  private readonly values = new Map<number, Pick<Left, "value" | "inputs" | "outputs">>();
  private order: Go | null = null;
  private wanted: ReadonlySet<Seam> = new Set();
  /** Where it is: at a seam, between two scans, or anywhere. */
  private at: "seam" | "between" | "anywhere" = "anywhere";
  /** The seam at which it stands, by its place in the list. */
  private seam = 0;

  /** Takes hold of a board, which costs nothing until it is to go; `null` where that keeps no program. */
  static of(board: Board, places: Places): Slow | null {
    const seams = seamsOf(board, places);
    return seams && seams.length > 0 && board.inside ? new Slow(board, places, seams) : null;
  }

  private constructor(
    private readonly board: Board,
    private readonly places: Places,
    readonly seams: readonly Seam[],
  ) {
    const length = board.inside?.cpu.data.length ?? 0;
    this.fetches = new Fetches(length, seams[0]?.at ?? 0, places.engine_end >> 9);
    if ((board.inside?.cpu.pc ?? 0) << 1 === places.scan_begin) this.at = "between";
    this.byAddress = new Map(seams.map(({ at }, index) => [at, index]));
  }

  /** Goes on with the next runs, up to where this says. */
  go(order: Go): void {
    this.order = order;
    const { fetches, seams } = this;
    this.wanted = new Set(order.to ? order.to.flatMap((wanted) => seams.find(({ step }) => step >= wanted) ?? []) : seams);
    const before = (index: number): boolean => seams.slice(index, index + BEFORE).some((seam) => this.wanted.has(seam));
    for (const [index, seam] of seams.entries()) {
      // One that stops within this scan goes from seam to seam: the value after each is told. One that goes at full speed knows
      // acc after what comes right before its stop.
      fetches.mark(seam.at, !order.through || this.wanted.has(seam) ? STOP : index === 0 || before(index) ? SEAM : 0);
    }
    this.board.fetches = fetches;
  }

  /** Lets the board go: it runs as fast as without this. */
  release(): void {
    this.order = null;
    this.board.fetches = null;
    this.fetches.isThere = false;
    this.at = "anywhere";
  }

  /** Runs for so many cycles at most; gives how the engine stands where it has come to stop. */
  run(cycles: number): Standing | null {
    const { board, fetches, order } = this;
    const end = board.now + cycles;
    while (order && board.now < end) {
      const stop = order.through && this.at !== "anywhere" ? NOWHERE : this.places.scan_begin;
      if (!board.runTo(stop, end - board.now)) return null;
      if (fetches.isThere && this.at === "anywhere") {
        fetches.isThere = false;
        continue;
      }
      if (!fetches.isThere) {
        const begins = this.at === "anywhere";
        this.at = "between";
        if (begins) {
          fetches.forget();
          this.values.clear();
          continue;
        }
        return this.standing();
      }
      fetches.isThere = false;
      this.pass();
      const here = this.seams[this.seam];
      if (here && this.wanted.has(here)) return this.standing();
    }
    return null;
  }

  /** The engine is at a seam. */
  private pass(): void {
    const data = this.board.inside?.cpu.data;
    if (!data) return;
    const index = this.byAddress.get(this.fetches.at) ?? 0;
    // One that went at full speed has told none.
    if (index === 0 || this.order?.through) this.values.clear();
    else if (this.at === "seam") this.values.set(this.seam, { value: value(data), ...this.points(data) });
    this.at = "seam";
    this.seam = index;
  }

  private standing(): Standing {
    const { board, seams, at } = this;
    const data = board.inside?.cpu.data ?? new Uint8Array();
    const here = seams[this.seam];
    const isBetween = at === "between" || here === undefined;
    return {
      step: isBetween ? null : here.step,
      until: isBetween ? 0 : (seams[this.seam + 1]?.step ?? here.step),
      acc: ((data[SREG] ?? 0) & T) !== 0,
      value: value(data),
      pushed: isBetween ? [] : pushed(data, this.fetches.base),
      ...this.points(data),
      closed: board.surroundings.closed,
      driven: board.surroundings.outputs,
      left: this.left(),
    };
  }

  /** The inputs and outputs as the scan has them. */
  private points(data: Uint8Array): { readonly inputs: number; readonly outputs: number } {
    const { board, places } = this;
    const { inputs, outputs } = board.wiring;
    const images = data[IMAGES] ?? 0;
    const ports = Array.from({ length: Math.ceil(inputs.length / 8) }, (_, port) => (data[places.ENGINE_MORE_INPUTS + port] ?? 0) << (8 * port));
    const { OUTPUT_CELLS } = places;
    const cells = OUTPUT_CELLS === undefined ? [] : outputs.slice(NEAR).map((_, cell) => ((data[OUTPUT_CELLS + cell] ?? 0) & ON ? 1 << (NEAR + cell) : 0));
    const all = (bits: readonly number[]): number => bits.reduce((sum, one) => sum | one, 0);
    return { inputs: (images & 0x0f) | (all(ports) & ~0x0f), outputs: (images >> NEAR) | all(cells) };
  }

  /** What has been passed. */
  private left(): Left[] {
    return this.seams.flatMap(({ step, at }, index) => {
      const [acc, next] = [this.fetches.acc(at), this.seams[index + 1]];
      // Between two that are not both told of, there may have been others.
      if (!next || acc === null || !this.fetches.tells(at) || !this.fetches.tells(next.at)) return [];
      return [{ from: step, to: next.step - 1, acc, ...(this.values.get(index) ?? { value: null, inputs: null, outputs: null }) }];
    });
  }
}

function value(data: Uint8Array): number {
  return (data[VALUE] ?? 0) | ((data[VALUE + 1] ?? 0) << 8) | ((data[VALUE + 2] ?? 0) << 16) | ((data[VALUE + 3] ?? 0) << 24);
}

/** What stands on the stack, 4 bytes each, the low one first. */
function pushed(data: Uint8Array, base: number): number[] {
  const values: number[] = [];
  for (let at = pair(data, SP) + 1; at + 3 <= base; at += 4) {
    values.push((data[at] ?? 0) | ((data[at + 1] ?? 0) << 8) | ((data[at + 2] ?? 0) << 16) | ((data[at + 3] ?? 0) << 24));
  }
  return values;
}
