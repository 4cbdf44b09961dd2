// Our timers against avr8js' own, count by count.

import { AVRTimer, type AVRTimerConfig, CPU, timer0Config, timer1Config, timer2Config } from "avr8js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { ATMEGA328P } from "../src/chip/model";
import { Timer } from "../src/chip/timer";
import { Random } from "./random";

const TIMERS = { timer0: timer0Config, timer1: timer1Config, timer2: timer2Config };
const TOV = 1;
const OCF = [2, 4];
/** A mode that is simulated: bits of TCCRA and TCCRB, and where the count ends. */
interface Mode {
  readonly a: number;
  readonly b: number;
  readonly top: "max" | "OCRA" | "ICR";
}
const MODES_8: readonly Mode[] = [
  { a: 0, b: 0, top: "max" },
  { a: 2, b: 0, top: "OCRA" },
  { a: 3, b: 0, top: "max" },
  { a: 3, b: 8, top: "OCRA" },
];
const MODES_16: readonly Mode[] = [
  { a: 0, b: 0, top: "max" },
  { a: 0, b: 8, top: "OCRA" },
  { a: 0, b: 0x18, top: "ICR" },
  { a: 2, b: 0x18, top: "ICR" },
  { a: 3, b: 0x18, top: "OCRA" },
];

/** A timer on a processor of its own, whose flags are noted and cleared in each cycle. */
class Run {
  readonly cpu = new CPU(new Uint16Array(64), ATMEGA328P.ramLen);
  /** Cycles at which flags rose, by flag. */
  readonly rose = new Map<number, number[]>();

  constructor(
    kind: typeof AVRTimer | typeof Timer,
    readonly config: AVRTimerConfig,
  ) {
    new kind(this.cpu, config);
    // So that each flag has its event; no interrupt is taken, since they are off.
    this.cpu.writeData(config.TIMSK, TOV | 2 | 4);
  }

  write(address: number, value: number): void {
    if (this.config.bits === 16) this.cpu.writeData(address + 1, value >> 8);
    this.cpu.writeData(address, value & 0xff);
  }

  count(): number {
    const low = this.cpu.readData(this.config.TCNT);
    return this.config.bits === 16 ? low | (this.cpu.readData(this.config.TCNT + 1) << 8) : low;
  }

  cycle(): void {
    this.cpu.cycles += 1;
    this.cpu.tick();
    const flags = this.cpu.data[this.config.TIFR] ?? 0;
    if (flags === 0) return;
    for (const flag of [TOV, ...OCF]) {
      if (flags & flag) this.rose.set(flag, [...(this.rose.get(flag) ?? []), this.cpu.cycles]);
    }
    this.cpu.data[this.config.TIFR] = 0;
  }

  at(flag: number): readonly number[] {
    return this.rose.get(flag) ?? [];
  }
}

for (const [name, config] of Object.entries(TIMERS)) {
  test(`${name} counts and overflows as avr8js' own, and compares one count later`, () => {
    const random = new Random(0x0c19);
    let compared = 0;
    let flags = 0;
    for (let round = 0; round < 120; round += 1) {
      const { a, b, top } = random.of(config.bits === 16 ? MODES_16 : MODES_8);
      const clock = random.of([1, 2, 3] as const);
      const divider = config.dividers[clock];
      const max = config.bits === 16 ? 0xffff : 0xff;
      const last = top === "max" ? max : 3 + random.below(200);
      const start = top === "max" ? max - random.below(100) : random.below(last);
      const [ocrA, ocrB] = [top === "OCRA" ? last : random.below(last + 1), random.below(last + 1)];
      const runs = [new Run(AVRTimer, config), new Run(Timer, config)] as const;
      for (const run of runs) {
        if (config.ICR) run.write(config.ICR, top === "ICR" ? last : 0);
        run.write(config.OCRA, ocrA);
        run.write(config.OCRB, ocrB);
        run.write(config.TCNT, start);
        run.cpu.writeData(config.TCCRA, a);
        run.cpu.writeData(config.TCCRB, b | clock);
      }
      const [theirs, ours] = runs;
      const cycles = Math.min(3 * (last + 2) * divider, 6000);
      const readAt = 1 + random.below(40);
      for (let cycle = 1; cycle <= cycles; cycle += 1) {
        theirs.cycle();
        ours.cycle();
        if (cycle % readAt !== 0) continue;
        assert.equal(ours.count(), theirs.count(), `round ${round}, cycle ${cycle}`);
        compared += 1;
      }
      const text = `round ${round}: mode ${a}/${b}, clock ${clock}, from ${start} to ${last}, A ${ocrA}, B ${ocrB}`;
      assert.deepEqual(ours.at(TOV), theirs.at(TOV), `overflows, ${text}`);
      for (const flag of OCF) {
        // On the chip the flag rises as the count goes on from the match (datasheet, figures 15-10 and 16-12).
        const later = theirs.at(flag).map((cycle) => cycle + divider);
        const expected = later.filter((cycle) => cycle <= cycles);
        assert.deepEqual(ours.at(flag), expected, `flag ${flag}, ${text}`);
        flags += expected.length;
      }
    }
    assert.ok(compared > 5000 && flags > 200, `${compared} counts, ${flags} flags`);
  });
}

test("without an interrupt or a pin that waits there is no event, and flags and count are right when they are read", () => {
  const cpu = new CPU(new Uint16Array(64), ATMEGA328P.ramLen);
  new Timer(cpu, timer2Config);
  cpu.writeData(timer2Config.OCRA, 27);
  cpu.writeData(timer2Config.OCRB, 200);
  cpu.writeData(timer2Config.TCCRB, 7);
  cpu.cycles += 1;
  cpu.tick();
  const began = cpu.cycles;
  cpu.cycles = began + 27 * 1024;
  assert.equal(cpu.readData(timer2Config.TIFR), 0);
  cpu.cycles = began + 28 * 1024;
  assert.equal(cpu.readData(timer2Config.TIFR), 2);
  // Hours later.
  cpu.cycles = began + 1024 * (1_000_000 * 256 + 5);
  assert.equal(cpu.readData(timer2Config.TCNT), 5);
  assert.equal(cpu.readData(timer2Config.TIFR), 1 | 2 | 4);
  // A written 1 clears a flag.
  cpu.writeData(timer2Config.TIFR, 2);
  assert.equal(cpu.readData(timer2Config.TIFR), 1 | 4);
});

test("a count that was written beyond the end goes on to the highest", () => {
  const cpu = new CPU(new Uint16Array(64), ATMEGA328P.ramLen);
  new Timer(cpu, timer0Config);
  cpu.writeData(timer0Config.TCCRA, 2);
  cpu.writeData(timer0Config.OCRA, 10);
  cpu.writeData(timer0Config.TCCRB, 1);
  cpu.cycles += 1;
  cpu.tick();
  cpu.writeData(timer0Config.TCNT, 200);
  cpu.cycles += 55;
  assert.equal(cpu.readData(timer0Config.TCNT), 255);
  cpu.cycles += 1;
  assert.equal(cpu.readData(timer0Config.TCNT), 0);
  cpu.cycles += 11;
  assert.equal(cpu.readData(timer0Config.TCNT), 0);
});

test("a mode that is not simulated is an error once it counts", () => {
  const cpu = new CPU(new Uint16Array(64), ATMEGA328P.ramLen);
  new Timer(cpu, timer0Config);
  cpu.writeData(timer0Config.TCCRA, 1);
  assert.throws(() => {
    cpu.writeData(timer0Config.TCCRB, 1);
    cpu.cycles += 1;
    cpu.tick();
  }, /not simulated/);
});
