// A lamp, as an eye sees it: the share of time that it was lit.

export class Lamp {
  private level = 0;
  /** Since when the level is what it is, and since when brightness is measured. */
  private since = 0;
  private from = 0;
  /** Lit cycles since `from`, up to `since`. */
  private lit = 0;

  /** How bright it is at this moment. */
  get now(): number {
    return this.level;
  }

  set(level: number, cycle: number): void {
    this.lit += (cycle - this.since) * this.level;
    this.since = cycle;
    this.level = level;
  }

  /** Flickers for so many cycles, lit for half of them. */
  flicker(cycles: number): void {
    this.lit += cycles / 2;
  }

  /** The brightness since the last call, 0 to 1. */
  take(cycle: number): number {
    this.set(this.level, cycle);
    const passed = cycle - this.from;
    const brightness = passed > 0 ? Math.min(1, this.lit / passed) : this.level;
    this.from = cycle;
    this.lit = 0;
    return brightness;
  }
}
