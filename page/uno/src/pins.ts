// The pins of the board: what drives those that are read, and what is seen of those that are driven.

import { PinState } from "avr8js";
import type { Chip, Port } from "./chip/chip";
import { SPCR, SPE } from "./chip/registers";
import { Lamp } from "./lamp";
import { ANALOGUE_INPUTS, type Analogue, OUTPUTS, type Pins } from "./messages";

/** The supply, mV. */
export const SUPPLY = 5000;
const READINGS = 1024;

/** Pins of port D with inputs 01 to 04, from D2 on; inputs 05 to 08 are A0 to A3. */
const FIRST_D = 2;
const INPUTS_D = 4;
/** A5, the switch STOP. */
const STOP = 5;
const PINS_C = 6;

/** Outputs 01 to 04: D6 to D9. */
const OUTPUT_PINS = [["D", 6], ["D", 7], ["B", 0], ["B", 1]] as const;
/** D13: clock of the card, and LED L. */
const LED = 5;
/** D10: select line of the card, low to select. */
const SELECT = 2;

export class Surroundings {
  readonly analogue: Analogue[] = new Array<Analogue>(ANALOGUE_INPUTS).fill("open");
  /** Bit n: the contact of input n + 1 is closed. */
  closed = 0;
  stop = false;

  private readonly lamps = Array.from({ length: OUTPUTS }, () => new Lamp());
  /** The same for a machine, which looks more often than a person. */
  private readonly drives = Array.from({ length: OUTPUTS }, () => new Lamp());
  private readonly led = new Lamp();

  /** `output` is told of each output whose level changes, but for pulses. */
  constructor(private readonly output: (output: number, high: boolean) => void) {}

  /** Puts the levels from outside on the pins that are inputs. */
  drive(chip: Chip): void {
    for (let n = 0; n < INPUTS_D; n += 1) {
      this.drivePin(chip, "D", FIRST_D + n, (this.closed >> n) & 1 ? 0 : null);
    }
    for (let pin = 0; pin < PINS_C; pin += 1) this.drivePin(chip, "C", pin, this.outside(pin));
  }

  /** An open pin without pull-up keeps its level. */
  private drivePin(chip: Chip, name: Port, pin: number, millivolts: number | null): void {
    const port = chip.ports[name];
    if (millivolts !== null) port.setPin(pin, 2 * millivolts >= SUPPLY);
    else if (port.pinState(pin) === PinState.InputPullUp) port.setPin(pin, true);
  }

  /** The voltage that is measured at a pin of port C. */
  millivolts(pin: number, chip: Chip): number {
    const open = chip.ports.C.pinState(pin) === PinState.InputPullUp ? SUPPLY : 0;
    return this.outside(pin) ?? open;
  }

  /** What the outside puts on a pin of port C, mV. */
  private outside(pin: number): number | null {
    if (pin === STOP) return this.stop ? 0 : null;
    if ((this.closed >> (INPUTS_D + pin)) & 1) return 0;
    const to = this.analogue[pin] ?? "open";
    if (to === "open") return null;
    // In the middle of the step.
    return "millivolts" in to ? to.millivolts : ((to.reading + 0.5) * SUPPLY) / READINGS;
  }

  /** Looks at what the chip does to its pins; without one there is no power. */
  look(chip: Chip | null, cycle: number): void {
    OUTPUT_PINS.forEach(([port, pin], n) => {
      const lamp = this.lamps[n];
      const high = isHigh(chip, port, pin);
      if (!lamp || (lamp.now === 1) === high) return;
      lamp.set(high ? 1 : 0, cycle);
      this.drives[n]?.set(high ? 1 : 0, cycle);
      const pulses = n === 0 ? chip?.timer0.drivesA : n === OUTPUTS - 1 ? chip?.timer1.drivesA : false;
      if (!pulses) this.output(n + 1, high);
    });
    const clock = chip && chip.register(SPCR) & SPE;
    const lit = !clock && isHigh(chip, "B", LED) ? 1 : 0;
    if (lit !== this.led.now) this.led.set(lit, cycle);
  }

  /** LED L is on the clock of the card, which goes for so many cycles. */
  clockCard(cycles: number): void {
    this.led.flicker(cycles);
  }

  /** Whether the card is selected. */
  selectsCard(chip: Chip): boolean {
    return chip.ports.B.pinState(SELECT) === PinState.Low;
  }

  /** Bit n: output n + 1 is high. */
  get outputs(): number {
    return this.lamps.reduce((levels, lamp, n) => levels | (lamp.now << n), 0);
  }

  /** The share of 255 that each output was high since the last call. */
  takeShares(cycle: number): number[] {
    return this.drives.map((drive) => Math.round(255 * drive.take(cycle)));
  }

  /** What is seen since the last call. */
  take(cycle: number): Pins {
    const [a = 0, b = 0, c = 0, d = 0] = this.lamps.map((lamp) => lamp.take(cycle));
    return { outputs: [a, b, c, d], led: this.led.take(cycle), closed: this.closed };
  }
}

function isHigh(chip: Chip | null, port: Port, pin: number): boolean {
  return chip?.ports[port].pinState(pin) === PinState.High;
}
