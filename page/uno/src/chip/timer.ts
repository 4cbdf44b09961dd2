// A timer of the chip with one event for each overflow or compare that something waits for, where avr8js has one for
// each count; what nobody waits for is worked out when it is read (ATmega328P datasheet, sections 15, 16 and 18).
//
// The modes that count upwards are here: normal, CTC and fast PWM. The rest, which the firmware does not use, is an
// error, and so are clocks from pins.

import type { AVRTimerConfig, CPU } from "avr8js";
import type { Interrupt } from "./interrupt";

const TOV = 1;
/** Flags OCFA, OCFB and OCFC; the bits that enable their interrupts stand in the same places. */
const OCF = [2, 4, 8] as const;

/** "other" stands only while the program sets a mode in two steps, with the timer stopped. */
type Mode = "normal" | "ctc" | "fast-pwm" | "other";
/** A count, or the register that holds it. */
type Top = number | "OCRA" | "ICR";

const MODES_8: Readonly<Record<number, readonly [Mode, Top]>> = {
  0: ["normal", 0xff],
  2: ["ctc", "OCRA"],
  3: ["fast-pwm", 0xff],
  7: ["fast-pwm", "OCRA"],
};

const MODES_16: Readonly<Record<number, readonly [Mode, Top]>> = {
  0: ["normal", 0xffff],
  4: ["ctc", "OCRA"],
  5: ["fast-pwm", 0xff],
  6: ["fast-pwm", 0x1ff],
  7: ["fast-pwm", 0x3ff],
  12: ["ctc", "ICR"],
  14: ["fast-pwm", "ICR"],
  15: ["fast-pwm", "OCRA"],
};

/** What a timer does to a pin (avr8js' PinOverrideMode, which it does not export): lets go, takes it as it stands. */
const RELEASE = 0;
const TAKE = 1;
const SET = 2;
const CLEAR = 3;
/** What a match does, by COM. */
const AT_MATCH = [RELEASE, 4, CLEAR, SET] as const;

/** One of the compare units: there are two, or three. */
interface Unit {
  readonly flag: number;
  readonly interrupt: Interrupt;
  /** What the count is compared with. */
  compare: number;
  /** What the program has written, which PWM takes over when the count begins again. */
  written: number;
  /** COM: 0 leaves the pin to its port, 1 toggles, 2 clears and 3 sets it at a match. */
  output: number;
  readonly port: number;
  readonly pin: number;
}

export class Timer {
  private readonly max: number;
  private readonly units: readonly [Unit, ...Unit[]];
  private readonly overflow: Interrupt;
  private mode: Mode = "normal";
  private top: Top;
  private icr = 0;
  /** Cycles of a count; 0 while it stands. */
  private divider = 0;
  /** The count, as it stood when the cycle counter read `since`, where a count began. */
  private count = 0;
  private since = 0;
  /** The count has been written since it last went on: it does not match as it does so. */
  private written = false;
  /** High byte of the next write to a register of 16 bits. */
  private high = 0;

  constructor(
    private readonly cpu: CPU,
    private readonly config: AVRTimerConfig,
  ) {
    this.max = config.bits === 16 ? 0xffff : 0xff;
    this.top = this.max;
    const interrupt = (address: number, mask: number): Interrupt => ({
      address,
      flagRegister: config.TIFR,
      flagMask: mask,
      enableRegister: config.TIMSK,
      enableMask: mask,
    });
    const unit = (flag: number, address: number, port: number, pin: number): Unit => {
      return { flag, interrupt: interrupt(address, flag), compare: 0, written: 0, output: 0, port, pin };
    };
    this.overflow = interrupt(config.ovfInterrupt, TOV);
    this.units = [
      unit(OCF[0], config.compAInterrupt, config.compPortA, config.compPinA),
      unit(OCF[1], config.compBInterrupt, config.compPortB, config.compPinB),
      ...(config.OCRC ? [unit(OCF[2], config.compCInterrupt, config.compPortC, config.compPinC)] : []),
    ];
    this.hook();
  }

  /** Whether this timer makes pulses on the pin of a unit, from 0 on. */
  drives(unit: number): boolean {
    return (this.units[unit]?.output ?? 0) !== 0;
  }

  private hook(): void {
    const { cpu, config } = this;
    const { data, readHooks, writeHooks } = cpu;

    readHooks[config.TCNT] = (address) => {
      this.catchUp();
      if (config.bits === 16) data[address + 1] = this.count >> 8;
      return (data[address] = this.count & 0xff);
    };
    readHooks[config.TIFR] = (address) => {
      this.catchUp();
      return data[address] ?? 0;
    };
    writeHooks[config.TIFR] = (value) => {
      this.catchUp();
      for (const interrupt of this.interrupts()) cpu.clearInterruptByFlag(interrupt, value);
      return true;
    };
    writeHooks[config.TIMSK] = (value, _, address) => {
      this.catchUp();
      data[address] = value;
      for (const interrupt of this.interrupts()) cpu.updateInterruptEnable(interrupt, value);
      this.schedule();
      return true;
    };

    this.hookNumber(config.TCNT, (value) => {
      this.count = value;
      this.written = true;
    });
    const compares = [config.OCRA, config.OCRB, config.OCRC];
    this.units.forEach((unit, n) => this.hookNumber(compares[n] ?? 0, (value) => this.setCompare(unit, value)));
    if (config.ICR) {
      this.hookNumber(config.ICR, (value) => {
        this.icr = value;
      });
    }
    writeHooks[config.TCCRA] = (value, _, address) => {
      this.catchUp();
      data[address] = value;
      this.setMode();
      this.schedule();
      return true;
    };
    writeHooks[config.TCCRB] = (value, _, address) => {
      this.catchUp();
      data[address] = value;
      this.setMode();
      // Counts begin with the end of this instruction.
      this.divider = 0;
      cpu.clearClockEvent(this.due);
      cpu.clearClockEvent(this.begin);
      cpu.addClockEvent(this.begin, 0);
      return true;
    };
  }

  /** A register of the timer's width: of two bytes, the high one waits for the low one. */
  private hookNumber(address: number, set: (value: number) => void): void {
    const { writeHooks, data } = this.cpu;
    writeHooks[address] = (value) => {
      this.catchUp();
      set((this.high << 8) | value);
      data[address] = value;
      this.schedule();
      return true;
    };
    if (this.config.bits === 16) {
      writeHooks[address + 1] = (value) => {
        this.high = value;
        data[address + 1] = value;
        return true;
      };
    }
  }

  private interrupts(): readonly Interrupt[] {
    return [this.overflow, ...this.units.map((unit) => unit.interrupt)];
  }

  private readonly begin = (): void => {
    const clock = (this.register(this.config.TCCRB) & 7) as keyof AVRTimerConfig["dividers"];
    this.divider = this.config.dividers[clock];
    if (this.divider === 0 && clock > 5) throw new Error("a timer's clock from a pin is not simulated");
    this.checkMode();
    this.since = this.cpu.cycles;
    this.schedule();
  };

  private checkMode(): void {
    if (this.mode === "other" && this.divider > 0) throw new Error("a timer's mode is not simulated");
  }

  private setMode(): void {
    const a = this.register(this.config.TCCRA);
    const b = this.register(this.config.TCCRB);
    const wide = this.config.bits === 16;
    const number = (a & 3) | ((b >> 1) & (wide ? 0x0c : 0x04));
    [this.mode, this.top] = (wide ? MODES_16 : MODES_8)[number] ?? ["other", this.max];
    this.checkMode();
    this.units.forEach((unit, index) => {
      const output = (a >> (6 - 2 * index)) & 3;
      const changed = (unit.output !== 0) !== (output !== 0);
      unit.output = output;
      if (this.mode !== "fast-pwm") unit.compare = unit.written;
      if (changed) this.drive(unit, output ? TAKE : RELEASE);
    });
  }

  private setCompare(unit: Unit, value: number): void {
    unit.written = value;
    if (this.mode !== "fast-pwm") unit.compare = value;
  }

  /** The count behind which 0 comes: a count that was written above it goes on to the highest. */
  private last(): number {
    const top = this.top === "OCRA" ? this.units[0].compare : this.top === "ICR" ? this.icr : this.top;
    return this.count <= top ? top : this.max;
  }

  /** Brings count and flags up to this cycle. */
  private catchUp(): void {
    if (this.divider === 0) return;
    let counts = Math.floor((this.cpu.cycles - this.since) / this.divider);
    this.since += counts * this.divider;
    let rounds = 0;
    while (counts > 0) {
      const last = this.last();
      const rest = last - this.count + 1;
      const taken = Math.min(counts, rest);
      for (const unit of this.units) {
        // A match shows as the count goes on from it.
        const from = this.written ? this.count + 1 : this.count;
        if (unit.compare >= from && unit.compare < this.count + taken) this.match(unit);
      }
      this.written = false;
      this.count += taken;
      counts -= taken;
      if (this.count > last) {
        this.beginAnew(last);
        rounds += 1;
        // Each round is like the one before from the third on.
        if (rounds > 2) counts %= this.last() + 1;
      }
    }
  }

  private match(unit: Unit): void {
    this.cpu.setInterruptFlag(unit.interrupt);
    if (unit.output) this.drive(unit, AT_MATCH[unit.output] ?? RELEASE);
  }

  private beginAnew(last: number): void {
    this.count = 0;
    if (this.mode === "fast-pwm" || last === this.max) this.cpu.setInterruptFlag(this.overflow);
    if (this.mode !== "fast-pwm") return;
    for (const unit of this.units) {
      unit.compare = unit.written;
      if (unit.output === 2) this.drive(unit, SET);
      if (unit.output === 3) this.drive(unit, CLEAR);
    }
  }

  private drive(unit: Unit, mode: number): void {
    this.cpu.gpioByPort[unit.port]?.timerOverridePin(unit.pin, mode);
  }

  private readonly due = (): void => {
    this.catchUp();
    this.await();
  };

  private schedule(): void {
    this.cpu.clearClockEvent(this.due);
    this.await();
  }

  /** One event at the next count that somebody waits for: an interrupt, or a pin. There must be none yet. */
  private await(): void {
    const { cpu, divider } = this;
    if (divider === 0) return;
    const enabled = this.register(this.config.TIMSK);
    const last = this.last();
    const pulses = this.units.some((unit) => unit.output !== 0);
    let waited = pulses || enabled & (TOV | OCF[0] | OCF[1] | OCF[2]) ? last + 1 : Infinity;
    for (const unit of this.units) {
      const wanted = unit.output !== 0 || enabled & unit.flag;
      if (wanted && unit.compare >= this.count) waited = Math.min(waited, unit.compare + 1);
    }
    if (waited === Infinity) return;
    const at = this.since + (waited - this.count) * divider;
    cpu.addClockEvent(this.due, at - cpu.cycles);
  }

  private register(address: number): number {
    return this.cpu.data[address] ?? 0;
  }
}
