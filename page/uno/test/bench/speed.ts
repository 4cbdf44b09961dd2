// How fast the simulated UNO runs, against avr8js with its own timers in the same run: `npm run bench`.
//
// Both run the firmware with a program of some rungs, in turn, and the quickest turn of each counts, in time of the
// processor, so that other work on the machine changes little.

import {
  AVRADC,
  AVRClock,
  AVREEPROM,
  AVRIOPort,
  AVRSPI,
  AVRTimer,
  AVRUSART,
  AVRWatchdog,
  CPU,
  adcConfig,
  avrInstruction,
  portBConfig,
  portCConfig,
  portDConfig,
  spiConfig,
  timer0Config,
  timer1Config,
  timer2Config,
  usart0Config,
  watchdogConfig,
} from "avr8js";
import { ATMEGA328P } from "../../src/chip/model";
import { CLOCK_HZ } from "../../src/chip/registers";
import { Slow } from "../../src/slow";
import { firmware, places, runningBoard } from "../fixture";

/** Cycles of a turn, and how many turns each has. */
const TURN = CLOCK_HZ / 4;
const TURNS = 16;

/** avr8js as it comes, with the same firmware and the same EEPROM. */
function stock(eeprom: Uint8Array): (cycles: number) => void {
  const cpu = new CPU(firmware(), ATMEGA328P.ramLen);
  cpu.data[0x54] = 1;
  for (const config of [portBConfig, portCConfig, portDConfig]) new AVRIOPort(cpu, config);
  for (const config of [timer0Config, timer1Config, timer2Config]) new AVRTimer(cpu, config);
  new AVRUSART(cpu, usart0Config, CLOCK_HZ);
  new AVRSPI(cpu, spiConfig, CLOCK_HZ).onByte = function (this: AVRSPI) {
    cpu.addClockEvent(() => this.completeTransfer(0xff), this.transferCycles);
  };
  new AVRADC(cpu, adcConfig).channelValues.fill(0);
  new AVREEPROM(cpu, {
    readMemory: (address) => eeprom[address] ?? 0xff,
    writeMemory: () => {},
    eraseMemory: () => {},
  });
  new AVRWatchdog(cpu, watchdogConfig, new AVRClock(cpu, CLOCK_HZ));
  return (cycles) => {
    const end = cpu.cycles + cycles;
    while (cpu.cycles < end) {
      avrInstruction(cpu);
      cpu.tick();
    }
  };
}

/** Seconds of a processor that it takes. */
function time(work: () => void): number {
  const start = process.cpuUsage();
  work();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1e6;
}

const { board } = runningBoard("motor");
const runStock = stock(board.eeprom.bytes.slice());
// The start-up, and until the code has been compiled.
board.run(CLOCK_HZ);
runStock(CLOCK_HZ);

// A second one that waits for a stop it never comes to, beside the first: a rung that the program jumps over is as good.
const watched = runningBoard("motor").board;
const slow = Slow.of(watched, places());
slow?.go({ to: [], through: true });
const runWatched = (cycles: number): void => {
  for (const end = watched.now + cycles; watched.now < end; ) slow?.run(end - watched.now);
};

let ours = Infinity;
let waiting = Infinity;
let theirs = Infinity;
for (let turn = 0; turn < TURNS; turn += 1) {
  ours = Math.min(ours, time(() => board.run(TURN)));
  slow?.go({ to: [], through: true });
  waiting = Math.min(waiting, time(() => runWatched(TURN)));
  slow?.release();
  theirs = Math.min(theirs, time(() => runStock(TURN)));
}
const simulated = TURN / CLOCK_HZ;
console.log(`the simulated UNO: ${(simulated / ours).toFixed(2)} × real time`);
console.log(`avr8js as it comes: ${(simulated / theirs).toFixed(2)} × real time`);
console.log(`ratio: ${(theirs / ours).toFixed(2)}`);
console.log(`with a stop set: ${(100 * (waiting / ours - 1)).toFixed(1)} % more time`);
