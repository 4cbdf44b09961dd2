// How far simulated time is to go, and how fast it went, measured against a clock that it is told. All times are ms.

/** What is behind by more than this is given up: the simulation is then slower than asked, and says so. */
const PATIENCE = 100;
/** How often the speed is told. */
const WINDOW = 250;

export interface Measured {
  /** Simulated time for each unit of real time, over the last window. */
  readonly factor: number;
  readonly asked: number;
}

export class Pace {
  private asked = 1;
  /** Up to when real time has been turned into simulated time. */
  private paid = 0;
  /** The window: since when, and how much was simulated in it. */
  private since = 0;
  private simulated = 0;
  /** How far simulated time was ahead of real time as the window began. */
  private lead = 0;

  /** Time begins to go on, at this factor of real time. */
  start(now: number, asked: number): void {
    this.asked = asked;
    this.paid = now;
    this.since = now;
    this.simulated = 0;
    this.lead = 0;
  }

  /** How much is to be simulated now; less than nothing where it is ahead. */
  due(now: number): number {
    if (this.asked === Infinity) return Infinity;
    this.paid = Math.max(this.paid, now - PATIENCE);
    return (now - this.paid) * this.asked;
  }

  /** So much was simulated. */
  pay(simulated: number): void {
    this.simulated += simulated;
    if (this.asked !== Infinity) this.paid += simulated / this.asked;
  }

  /** The speed, once in each window. */
  measure(now: number): Measured | null {
    const passed = now - this.since;
    if (passed < WINDOW) return null;
    const lead = this.asked === Infinity ? 0 : Math.max(0, this.paid - now) * this.asked;
    const factor = (this.simulated - (lead - this.lead)) / passed;
    this.since = now;
    this.simulated = 0;
    this.lead = lead;
    return { factor, asked: this.asked };
  }
}
