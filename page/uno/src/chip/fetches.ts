// What the firmware's engine fetches: linked bytes in a row, each through a jump to its handler. A fetch may be a stop; the
// chip stands then before the handler, and all that came before it is done.

import { SREG, T } from "./flags";
import { SP, X, Z, pair } from "./operands";

/** What is at an address: a place that counts, and one at which the engine stops. */
export const SEAM = 1;
export const STOP = 3;
/** Scans are told apart by what stands above a byte. */
const SCAN = 1 << 8;
const SCANS = 1 << 29;

export class Fetches {
  /** By the address after a linked byte: `SEAM`, `STOP`, or 0 where a fetch is of no interest. */
  readonly marks: Uint8Array;
  /** By the address of one: SREG behind what begins there, with the scan that has done it last above it. */
  private readonly passed: Int32Array;
  private scan = SCAN;
  /** The stack pointer as the scan's first byte was fetched: what is pushed stands below. */
  base = 0;
  /** The last mark that was fetched. */
  at: number;
  /** The engine stands at a stop. */
  isThere = false;

  /** Of linked code that begins at this address of the data space, whose handlers begin in words with this high byte. */
  constructor(
    length: number,
    private readonly first: number,
    private readonly page: number,
  ) {
    this.marks = new Uint8Array(length);
    this.passed = new Int32Array(length);
    this.at = first;
  }

  /** Marks the byte at this address. */
  mark(at: number, as: typeof SEAM | typeof STOP | 0): void {
    this.marks[at + 1] = as;
  }

  /** A jump through Z is done, to what is marked; says whether the engine stops. */
  note(data: Uint8Array): boolean {
    const at = pair(data, X) - 1;
    if (at === this.first) this.begin(data);
    else this.passed[this.at] = this.scan | data[SREG]!;
    this.at = at;
    // Other code jumps through Z too, with anything in X.
    if (this.marks[at + 1] !== STOP || data[Z + 1] !== this.page) return false;
    this.isThere = true;
    return true;
  }

  /** Whether the byte at this address is marked. */
  tells(at: number): boolean {
    return this.marks[at + 1] !== 0;
  }

  /** acc behind what begins at this address; `null` where this scan has not done it. */
  acc(at: number): boolean | null {
    const passed = this.passed[at] ?? 0;
    return (passed & ~0xff) === this.scan ? (passed & T) !== 0 : null;
  }

  /** Nothing of a scan has been done. */
  forget(): void {
    this.scan = (this.scan % SCANS) + SCAN;
  }

  private begin(data: Uint8Array): void {
    this.forget();
    this.base = pair(data, SP);
  }
}
