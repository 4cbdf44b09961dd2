// The time of a program that this computer runs: it may stand, or go slower than that of the room.

import type { Clock } from "./conversation";

export class OwnTime implements Clock {
  readonly turned = new Set<() => void>();
  /** ms, and when that was. */
  private at = 0;
  private known = performance.now();
  private pace = 1;
  private stands = false;

  now(): number {
    return this.at + (performance.now() - this.known) * this.factor();
  }

  factor(): number {
    return this.stands ? 0 : this.pace;
  }

  /** So much of it passes in a unit of real time. */
  speed(pace: number): void {
    this.turn(() => (this.pace = pace));
  }

  stand(stands: boolean): void {
    this.turn(() => (this.stands = stands));
  }

  private turn(change: () => void): void {
    this.at = this.now();
    this.known = performance.now();
    change();
    for (const hear of [...this.turned]) hear();
  }
}
