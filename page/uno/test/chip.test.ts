// The chip through resets and power cuts, with small programs of its own.

import { assemble } from "avr8js/dist/esm/utils/assembler";
import assert from "node:assert/strict";
import { test } from "node:test";
import { WRITE_CYCLES } from "../src/chip/eeprom";
import { ATMEGA328P } from "../src/chip/model";
import { type Fixture, ms, newBoard } from "./fixture";

/** A board with this program in assembly, powered. */
function board(program: string): Fixture {
  const { bytes, errors } = assemble(program);
  assert.deepEqual(errors, []);
  const flash = new Uint8Array(ATMEGA328P.flash).fill(0xff);
  flash.set(bytes);
  const fixture = newBoard(new Uint16Array(flash.buffer));
  fixture.board.plug(true);
  return fixture;
}

/** Counts in RAM at 0x200 how often it has begun, and keeps MCUSR, which it clears, at 0x201. */
const COUNTER = `
  lds r16, 0x200
  inc r16
  sts 0x200, r16
  in r17, 0x34
  sts 0x201, r17
  ldi r18, 0
  out 0x34, r18
`;
const WAIT = `
wait:
  rjmp wait
`;
/** The watchdog resets after 16 ms. */
const WATCHDOG = `
  ldi r20, 0x18
  sts 0x60, r20
  ldi r20, 0x08
  sts 0x60, r20
`;

function ram({ board }: Fixture, address: number): number {
  return board.inside?.cpu.data[address] ?? -1;
}

test("a reset keeps RAM, and says in MCUSR what it was", () => {
  const fixture = board(COUNTER + WAIT);
  fixture.board.run(ms(1));
  const first = ram(fixture, 0x200);
  assert.equal(ram(fixture, 0x201), 1);
  fixture.board.reset();
  fixture.board.run(ms(1));
  assert.equal(ram(fixture, 0x200), (first + 1) & 0xff);
  assert.equal(ram(fixture, 0x201), 2);
  assert.deepEqual(fixture.notes.resets, ["power", "button"]);
});

test("a power cut loses RAM, and is told by MCUSR", () => {
  const fixture = board(COUNTER + WAIT);
  fixture.board.run(ms(1));
  const first = ram(fixture, 0x200);
  fixture.board.plug(false);
  fixture.board.run(ms(100));
  assert.equal(ram(fixture, 0x200), -1);
  fixture.board.plug(true);
  fixture.board.run(ms(1));
  assert.equal(ram(fixture, 0x200), first);
  assert.equal(ram(fixture, 0x201), 1);
  assert.deepEqual(fixture.notes.powers, [true, false, true]);
});

test("the watchdog resets the chip after 16 ms, and goes on until it is stopped", () => {
  const fixture = board(COUNTER + WATCHDOG + WAIT);
  fixture.board.run(ms(15));
  assert.deepEqual(fixture.notes.resets, ["power"]);
  fixture.board.run(ms(2));
  assert.deepEqual(fixture.notes.resets, ["power", "watchdog"]);
  assert.equal(ram(fixture, 0x201), 8);

  // A program that does not touch it is reset again and again.
  const restless = board("  lds r16, 0x200\n  cpi r16, 7\n  breq wait\n  ldi r16, 7\n  sts 0x200, r16" + WATCHDOG + WAIT);
  restless.board.run(ms(60));
  assert.deepEqual(restless.notes.resets, ["power", "watchdog", "watchdog", "watchdog"]);
});

test("pins are let go at a reset", () => {
  const fixture = board(`
  lds r16, 0x200
  cpi r16, 7
  breq wait
  ldi r16, 7
  sts 0x200, r16
  sbi 0x0a, 7
  sbi 0x0b, 7
${WAIT}`);
  fixture.board.run(ms(1));
  assert.equal(fixture.board.surroundings.outputs, 2);
  fixture.board.reset();
  fixture.board.run(ms(1));
  assert.equal(fixture.board.surroundings.outputs, 0);
  assert.deepEqual(fixture.notes.outputs, [{ output: 2, high: true }, { output: 2, high: false }]);
});

/** Writes 0x5a to byte 5 of the EEPROM. */
const WRITES = `
  ldi r16, 5
  out 0x21, r16
  ldi r16, 0
  out 0x22, r16
  ldi r16, 0x5a
  out 0x20, r16
  sbi 0x1f, 2
  sbi 0x1f, 1
`;

test("a write to the EEPROM takes 3.4 ms, in which the chip says so", () => {
  const fixture = board(`${WRITES}
  sts 0x200, r0
busy:
  sbic 0x1f, 1
  rjmp busy
  ldi r16, 1
  sts 0x200, r16
${WAIT}`);
  const { board: uno } = fixture;
  uno.run(ms(3.3));
  assert.notEqual(ram(fixture, 0x200), 1);
  uno.run(ms(0.2));
  assert.equal(ram(fixture, 0x200), 1);
  assert.equal(uno.eeprom.bytes[5], 0x5a);
  assert.equal(WRITE_CYCLES, ms(3.4));
});

test("a power cut in the middle of a write leaves the byte erased, one behind it leaves it whole", () => {
  for (const [after, expected] of [[1, 0xff], [3.3, 0xff], [3.5, 0x5a]] as const) {
    const { board: uno } = board(WRITES + WAIT);
    uno.eeprom.bytes[4] = 0x11;
    uno.run(ms(after));
    uno.plug(false);
    assert.equal(uno.eeprom.bytes[5], expected, `${after} ms`);
    assert.equal(uno.eeprom.bytes[4], 0x11);
  }
});

test("the plug is pulled in the middle of the next write, if it was asked for", () => {
  const { board: uno, notes } = board(COUNTER + WRITES + WAIT);
  uno.pullPlugAtWrite(true);
  uno.run(ms(10));
  assert.deepEqual(notes.powers, [true, false]);
  assert.equal(uno.hasPower, false);
  assert.equal(uno.eeprom.bytes[5], 0xff);

  uno.plug(true);
  uno.run(ms(10));
  assert.equal(uno.hasPower, true);
  assert.equal(uno.eeprom.bytes[5], 0x5a);
});

test("a reset lets a write come to its end", () => {
  const { board: uno } = board(WRITES + WAIT);
  uno.run(ms(1));
  uno.reset();
  uno.run(ms(0.01));
  assert.equal(uno.eeprom.bytes[5], 0x5a);
});
