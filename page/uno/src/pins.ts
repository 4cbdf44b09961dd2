// The pins of the board: what drives those that are read, and what is seen of those that are driven.

import { PinState } from "avr8js";
import type { Chip } from "./chip/chip";
import { SPCR, SPE } from "./chip/registers";
import { Lamp } from "./lamp";
import type { Analogue, Pins } from "./messages";
import type { Pin, Wiring } from "./wiring";

/** The supply, mV. */
export const SUPPLY = 5000;
const READINGS = 1024;

/** A pin that something outside may drive. */
interface Driven {
  readonly pin: Pin;
  /** What it puts there, mV; `null` leaves the pin open. */
  readonly outside: () => number | null;
}

export class Surroundings {
  readonly analogue: Analogue[];
  /** Bit n: the contact of input n + 1 is closed. */
  closed = 0;
  stop = false;

  private readonly driven: readonly Driven[];
  /** Those of them that the converter reads, by its channels. */
  private readonly channels: readonly (Driven | undefined)[];
  private readonly lamps: readonly Lamp[];
  /** The same for a machine, which looks more often than a person. */
  private readonly drives: readonly Lamp[];
  private readonly led = new Lamp();

  /** `output` is told of each output whose level changes, but for pulses. */
  constructor(
    private readonly wiring: Wiring,
    private readonly output: (output: number, high: boolean) => void,
  ) {
    this.analogue = wiring.analogue.map(() => "open");
    this.lamps = wiring.outputs.map(() => new Lamp());
    this.drives = wiring.outputs.map(() => new Lamp());
    const pins = [...wiring.inputs, ...wiring.analogue.filter((pin) => !wiring.inputs.some((other) => isSame(pin, other)))];
    this.driven = [...pins.map((pin) => ({ pin, outside: this.outside(pin) })), { pin: wiring.stop, outside: () => (this.stop ? 0 : null) }];
    this.channels = wiring.analogue.map((pin) => this.driven.find((driven) => isSame(driven.pin, pin)));
  }

  /** Puts the levels from outside on the pins that are inputs. */
  drive(chip: Chip): void {
    for (const { pin: [name, bit], outside } of this.driven) {
      const port = chip.ports[name];
      const millivolts = outside();
      if (millivolts !== null) port?.setPin(bit, 2 * millivolts >= SUPPLY);
      // An open pin without pull-up keeps its level.
      else if (port?.pinState(bit) === PinState.InputPullUp) port.setPin(bit, true);
    }
  }

  /** The voltage that is measured at a channel of the converter. */
  millivolts(channel: number, chip: Chip): number {
    const driven = this.channels[channel];
    if (!driven) return 0;
    const open = stateOf(chip, driven.pin) === PinState.InputPullUp ? SUPPLY : 0;
    return driven.outside() ?? open;
  }

  /** What the outside puts on a pin of an input, an analogue input or both, mV. */
  private outside(pin: Pin): () => number | null {
    const input = this.wiring.inputs.findIndex((other) => isSame(pin, other));
    const analogue = this.wiring.analogue.findIndex((other) => isSame(pin, other));
    return () => {
      if (input >= 0 && (this.closed >> input) & 1) return 0;
      const to = this.analogue[analogue] ?? "open";
      if (to === "open") return null;
      // In the middle of the step.
      return "millivolts" in to ? to.millivolts : ((to.reading + 0.5) * SUPPLY) / READINGS;
    };
  }

  /** Looks at what the chip does to its pins; without one there is no power. */
  look(chip: Chip | null, cycle: number): void {
    this.wiring.outputs.forEach((pin, n) => {
      const lamp = this.lamps[n];
      const high = isHigh(chip, pin);
      if (!lamp || (lamp.now === 1) === high) return;
      lamp.set(high ? 1 : 0, cycle);
      this.drives[n]?.set(high ? 1 : 0, cycle);
      const [timer, unit] = this.wiring.pulses.get(n) ?? [];
      const pulses = timer !== undefined && unit !== undefined && chip?.timers[timer]?.drives(unit);
      if (!pulses) this.output(n + 1, high);
    });
    const clock = this.wiring.ledIsClock && chip && chip.register(SPCR) & SPE;
    const lit = !clock && isHigh(chip, this.wiring.led) ? 1 : 0;
    if (lit !== this.led.now) this.led.set(lit, cycle);
  }

  /** The clock of the card goes for so many cycles, and where LED L is on it, it flickers. */
  clockCard(cycles: number): void {
    if (this.wiring.ledIsClock) this.led.flicker(cycles);
  }

  /** Whether the card is selected. */
  selectsCard(chip: Chip): boolean {
    return stateOf(chip, this.wiring.select) === PinState.Low;
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
    return { outputs: this.lamps.map((lamp) => lamp.take(cycle)), led: this.led.take(cycle), closed: this.closed };
  }
}

const isSame = ([port, bit]: Pin, [other, otherBit]: Pin): boolean => port === other && bit === otherBit;

const stateOf = (chip: Chip, [port, bit]: Pin): PinState | undefined => chip.ports[port]?.pinState(bit);

function isHigh(chip: Chip | null, pin: Pin): boolean {
  return chip !== null && stateOf(chip, pin) === PinState.High;
}
