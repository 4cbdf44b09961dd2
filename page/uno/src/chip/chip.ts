// One life of the chip, from a reset to the next: avr8js' processor with peripherals around it. avr8js' own reset leaves
// peripherals and pending events as they were, so each reset makes a new chip, which takes over what a reset leaves.

import {
  AVRClock,
  AVREEPROM,
  AVRIOPort,
  AVRSPI,
  AVRWatchdog,
  CPU,
  spiConfig,
  watchdogConfig,
} from "avr8js";
import type { ResetCause } from "../messages";
import type { Setting } from "../serial";
import { converter } from "./converter";
import { type Eeprom, eepromRegisters } from "./eeprom";
import type { Fetches } from "./fetches";
import type { Model, Port } from "./model";
import { CLOCK_HZ, MCUSR, SPCR, WDCE, WDE, WDTCSR, WORKING_REGISTERS } from "./registers";
import { type Span, execute } from "./step";
import { Timer } from "./timer";
import { Usart } from "./usart";

/** Bytes that avr8js has for registers, in front of the RAM that it is asked for. */
const REGISTERS = 0x100;
/** Bits of MCUSR. */
const RECORD: Readonly<Record<ResetCause, number>> = { power: 1, button: 2, "brown-out": 4, watchdog: 8 };

/** What stands around the chip. */
export interface Around {
  readonly eeprom: Eeprom;
  /** The voltage at a channel of the converter. */
  millivolts(channel: number): number;
  /** A byte has been sent. */
  sent(byte: number, setting: Setting): void;
  /** A byte goes to the card, so many cycles long; gives the one that comes back. */
  exchange(byte: number, cycles: number): number;
  /** What a port does to its pins has changed. */
  portChanged(port: Port): void;
  /** SPI was switched on or off. */
  busSwitched(): void;
}

export class Chip {
  readonly cpu: CPU;
  readonly usart: Usart;
  readonly timers: readonly Timer[];
  readonly ports: Readonly<Partial<Record<Port, AVRIOPort>>>;
  /** The watchdog has bitten: this life is over. */
  bitten = false;
  /** No event of avr8js is due before its `due`. */
  private readonly span: Span = { until: 0, due: 0, fetches: null };

  /** A chip at its first instruction, at this cycle; `before` is the one whose RAM it takes over. */
  constructor(private readonly model: Model, flash: Uint16Array, around: Around, cause: ResetCause, cycle: number, before: Chip | null) {
    const { ram } = model;
    // Of registers, avr8js knows as many as those of the ATmega328P.
    const cpu = new CPU(flash, ram + model.ramLen - REGISTERS);
    this.cpu = cpu;
    cpu.cycles = cycle;
    if (before) {
      cpu.data.set(before.cpu.data.subarray(0, WORKING_REGISTERS));
      cpu.data.set(before.cpu.data.subarray(ram), ram);
    } else {
      scramble(cpu.data, ram);
    }
    const record = before ? (before.cpu.data[MCUSR] ?? 0) : 0;
    cpu.data[MCUSR] = record | RECORD[cause];

    const ports: Partial<Record<Port, AVRIOPort>> = {};
    for (const [name, config] of Object.entries(model.ports)) {
      const port = new AVRIOPort(cpu, config);
      port.addListener(() => around.portChanged(name as Port));
      ports[name as Port] = port;
    }
    this.ports = ports;
    this.timers = model.timers.map((config) => new Timer(cpu, config));
    this.usart = new Usart(cpu, model.received, around.sent.bind(around));
    converter(cpu, model.converted, around.millivolts.bind(around));
    new AVREEPROM(cpu, around.eeprom, { ...eepromRegisters(around.eeprom.writeCycles), eepromReadyInterrupt: model.eepromReady });
    this.watchEvents();
    this.connectBus(around);
    this.connectWatchdog(cause);
  }

  /** Runs to this cycle, or to the end of this life or of the instruction in which it is over. */
  run(until: number): void {
    this.go(-1, until);
  }

  /** The same, and to where the instruction at this byte address is the next, or the engine is to stop; says whether it is. */
  runTo(address: number, until: number): boolean {
    return this.go(address >> 1, until);
  }

  private go(stop: number, until: number): boolean {
    const { cpu, span, model } = this;
    span.until = until;
    while (cpu.cycles < span.until) {
      execute(cpu, span, stop, model.ram);
      if (cpu.cycles >= span.due || cpu.nextInterrupt >= 0) this.tick();
      if (cpu.pc === stop || span.fetches?.isThere) return true;
    }
    return false;
  }

  /** What is due behind an instruction: an event, an interrupt. */
  private tick(): void {
    this.cpu.tick();
    // Of an event that is added earlier, `watchEvents` knows.
    const { nextClockEvent } = this.cpu as unknown as { nextClockEvent: { cycles: number } | null };
    this.span.due = nextClockEvent?.cycles ?? Infinity;
  }

  private watchEvents(): void {
    const { cpu } = this;
    const add = cpu.addClockEvent.bind(cpu);
    cpu.addClockEvent = (callback, cycles) => {
      this.span.due = Math.min(this.span.due, cpu.cycles + Math.max(1, cycles));
      return add(callback, cycles);
    };
  }

  /** Who is told of what the engine fetches. */
  set fetches(fetches: Fetches | null) {
    this.span.fetches = fetches;
  }

  /** From within a run: it goes no further than to this cycle. */
  noLaterThan(cycle: number): void {
    this.span.until = Math.min(this.span.until, cycle);
  }

  register(address: number): number {
    return this.cpu.data[address] ?? 0;
  }

  private connectBus(around: Around): void {
    const { cpu } = this;
    const spi = new AVRSPI(cpu, { ...spiConfig, spiInterrupt: this.model.spi }, CLOCK_HZ);
    spi.onByte = (byte) => {
      const cycles = spi.transferCycles;
      const answer = around.exchange(byte, cycles);
      cpu.addClockEvent(() => spi.completeTransfer(answer), cycles);
    };
    cpu.writeHooks[SPCR] = (value, _, address) => {
      cpu.data[address] = value;
      around.busSwitched();
      return true;
    };
  }

  private connectWatchdog(cause: ResetCause): void {
    const { cpu } = this;
    new AVRWatchdog(cpu, { ...watchdogConfig, watchdogInterrupt: this.model.watchdog }, new AVRClock(cpu, CLOCK_HZ));
    // It calls this as it bites.
    cpu.reset = () => {
      this.bitten = true;
      this.noLaterThan(0);
    };
    if (cause === "watchdog") {
      // It goes on, at its shortest.
      cpu.writeData(WDTCSR, WDCE | WDE);
      cpu.writeData(WDTCSR, WDE);
    }
  }
}

/** Arbitrary bytes, the same each time: a chip promises nothing better after power-up. */
function scramble(data: Uint8Array, ram: number): void {
  let state = 0x9e37_79b9;
  for (let at = 0; at < data.length; at += 1) {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    if (at < WORKING_REGISTERS || at >= ram) data[at] = state >>> 24;
  }
}
