// The instructions that are executed by a table, against avr8js, opcode by opcode.

import { CPU, avrInstruction } from "avr8js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { RAM_LEN } from "../src/chip/registers";
import { KINDS, step } from "../src/chip/step";
import { FLASH_LEN } from "../src/hex";
import { Random } from "./random";

/** What may stand behind a skip: one word, and each of two. */
const NEXT = [0x0000, 0x9000, 0x91f0, 0x9200, 0x93f0, 0x940e, 0x95ff, 0x940c, 0x95fd, 0x9408, 0x9409, 0xffff];
const SREG = 95;
/** Half carry, in SREG. */
const H = 1 << 5;

/** `cp` and `cpi`. */
function isComparison(opcode: number): boolean {
  return (opcode & 0xfc00) === 0x1400 || (opcode & 0xf000) === 0x3000;
}

test("each opcode of the table does what avr8js does", () => {
  const random = new Random(0x0c19);
  const [ours, theirs] = [0, 0].map(() => new CPU(new Uint16Array(FLASH_LEN / 2), RAM_LEN));
  assert.ok(ours && theirs);
  let compared = 0;
  for (let opcode = 0; opcode <= 0xffff; opcode += 1) {
    if (KINDS[opcode] === 0) continue;
    for (let round = 0; round < 2; round += 1) {
      const pc = 4000 + random.below(4000);
      for (const cpu of [ours, theirs]) {
        cpu.pc = pc;
        cpu.cycles = 7;
        cpu.progMem[pc] = opcode;
      }
      const next = random.of(NEXT);
      ours.progMem[pc + 1] = theirs.progMem[pc + 1] = next;
      for (let register = 0; register < 32; register += 1) {
        // Pointers to RAM in every other round, to anywhere in the rest.
        const high = round === 0 && register > 25 && register % 2 === 1;
        ours.data[register] = theirs.data[register] = high ? 1 + random.below(7) : random.below(256);
      }
      ours.data[SREG] = theirs.data[SREG] = random.below(256);
      step(ours);
      avrInstruction(theirs);
      const text = `${opcode.toString(16)} before ${next.toString(16)}`;
      assert.equal(ours.pc, theirs.pc, text);
      assert.equal(ours.cycles, theirs.cycles, text);
      // A borrow from bit 3; avr8js has one from bit 0.
      if (isComparison(opcode)) theirs.data[SREG] = (theirs.data[SREG]! & ~H) | (ours.data[SREG]! & H);
      assert.equal(Buffer.compare(ours.data, theirs.data), 0, text);
      compared += 1;
    }
  }
  assert.ok(compared > 2 * 20_000, `${compared}`);
});

test("a comparison borrows from bit 3", () => {
  const cpu = new CPU(new Uint16Array(FLASH_LEN / 2), RAM_LEN);
  for (const [a, constant, half] of [[0x10, 0x01, H], [0x01, 0x10, 0], [0x18, 0x08, 0], [0x17, 0x08, H]] as const) {
    // cpi r16, constant
    cpu.pc = 0;
    cpu.progMem[0] = 0x3000 | ((constant & 0xf0) << 4) | (constant & 15);
    cpu.data[16] = a;
    step(cpu);
    assert.equal(cpu.data[SREG]! & H, half, `${a} and ${constant}`);
  }
});

test("any other opcode is avr8js' own", () => {
  const cpu = new CPU(new Uint16Array(FLASH_LEN / 2), RAM_LEN);
  // inc r16
  cpu.progMem[0] = 0x9503;
  cpu.data[16] = 0xff;
  step(cpu);
  assert.equal(cpu.data[16], 0);
  assert.deepEqual([cpu.pc, cpu.cycles], [1, 1]);
});

test("a jump from the first word goes to the last of the flash", () => {
  const cpu = new CPU(new Uint16Array(FLASH_LEN / 2), RAM_LEN);
  // rjmp .-4
  cpu.progMem[0] = 0xcffe;
  step(cpu);
  assert.equal(cpu.pc, FLASH_LEN / 2 - 1);
});
