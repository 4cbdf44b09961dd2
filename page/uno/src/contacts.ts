// Buttons that close a pin to ground, and that bounce if they are asked to.

import type { Agenda } from "./agenda";
import { CYCLES_PER_MS } from "./chip/registers";

/** How long a contact bounces at most, in cycles. */
const BOUNCE = 5 * CYCLES_PER_MS;
/** The longest time between two bounces. */
const GAP = CYCLES_PER_MS;

export class Contacts {
  bouncing = false;
  /** Bit n: contact n is closed at this moment. */
  closed = 0;
  /** Bit n: it is pressed. */
  private pressed = 0;
  /** Counts up for a contact as it is moved, so that bounces of an earlier move end. */
  private readonly moves: number[] = [];
  private random = 1;

  /** `changed` is called as a contact has closed or opened. */
  constructor(
    private readonly agenda: Agenda,
    private readonly changed: () => void,
  ) {}

  press(contact: number, pressed: boolean, now: number): void {
    const bit = 1 << contact;
    if (((this.pressed & bit) !== 0) === pressed) return;
    this.pressed ^= bit;
    const move = (this.moves[contact] ?? 0) + 1;
    this.moves[contact] = move;
    const set = (closed: boolean): void => {
      if (this.moves[contact] !== move) return;
      this.closed = closed ? this.closed | bit : this.closed & ~bit;
      this.changed();
    };
    set(pressed);
    if (!this.bouncing) return;
    let at = now + this.below(GAP);
    for (let closed = !pressed; at < now + BOUNCE; closed = !closed, at += this.below(GAP)) {
      const level = closed;
      this.agenda.add(at, () => set(level));
    }
    this.agenda.add(at, () => set(pressed));
  }

  /** From 1 to `limit`: arbitrary, and the same in each run. */
  private below(limit: number): number {
    this.random = (Math.imul(this.random, 1_103_515_245) + 12_345) & 0x7fff_ffff;
    return 1 + ((this.random >>> 8) % limit);
  }
}
