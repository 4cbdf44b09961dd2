// Instructions as they are executed here, against avr8js, opcode by opcode, and against the datasheet where avr8js does
// otherwise than the chip.

import { CPU, avrInstruction } from "avr8js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { H, S, SREG, V, Z } from "../src/chip/flags";
import { KINDS, Kind } from "../src/chip/opcodes";
import { SP, constant, other, upper } from "../src/chip/operands";
import { type Span, execute } from "../src/chip/step";
import { ATMEGA328P } from "../src/chip/model";
import { Random } from "./random";

const { ram: RAM, ramLen: RAM_LEN } = ATMEGA328P;
const WORDS = ATMEGA328P.flash / 2;
/** What may stand after a skip: one word, and each of two. */
const NEXT = [0x0000, 0x9000, 0x91f0, 0x9200, 0x93f0, 0x940e, 0x95ff, 0x940c, 0x95fd, 0x9408, 0x9409, 0xffff];
/** Pointers that an instruction moves; what becomes of one that it reads or writes too, the manual leaves open. */
const MOVED: Partial<Record<Kind, number>> = {
  [Kind.LD_X_INC]: 26,
  [Kind.LD_X_DEC]: 26,
  [Kind.ST_X_INC]: 26,
  [Kind.ST_X_DEC]: 26,
  [Kind.LD_Y_INC]: 28,
  [Kind.LD_Y_DEC]: 28,
  [Kind.ST_Y_INC]: 28,
  [Kind.ST_Y_DEC]: 28,
  [Kind.LD_Z_INC]: 30,
  [Kind.LD_Z_DEC]: 30,
  [Kind.ST_Z_INC]: 30,
  [Kind.ST_Z_DEC]: 30,
};

/** A chip without anything around it but hooks that note who reads and writes, when; a look takes two cycles. */
function hooked(): { cpu: CPU; seen: number[] } {
  const cpu = new CPU(new Uint16Array(WORDS), RAM_LEN);
  const seen: number[] = [];
  for (let address = 32; address < RAM; address += 3) {
    if (address === SP || address === SREG) continue;
    cpu.readHooks[address] = (at) => {
      seen.push(at, cpu.cycles);
      cpu.cycles += 2;
      return (cpu.data[at]! + 1) & 0xff;
    };
    cpu.writeHooks[address] = (value, before, at, mask) => {
      seen.push(at, cpu.cycles, value & 0xff, before, mask);
      return at % 2 === 0;
    };
  }
  return { cpu, seen };
}

function one(cpu: CPU): void {
  execute(cpu, { until: cpu.cycles + 1, due: Infinity }, -1, RAM);
}

/** The operands of an opcode that adds or subtracts 8 bits, or nothing. */
function operands(opcode: number, data: Uint8Array): { a: number; b: number; sum: boolean; carry: number } | null {
  const carry = data[SREG]! & 1;
  const d = data[(opcode >> 4) & 31]!;
  const r = data[other(opcode)]!;
  switch (KINDS[opcode]) {
    case Kind.ADD:
      return { a: d, b: r, sum: true, carry: 0 };
    case Kind.ADC:
      return { a: d, b: r, sum: true, carry };
    case Kind.SUB:
    case Kind.CP:
      return { a: d, b: r, sum: false, carry: 0 };
    case Kind.SBC:
    case Kind.CPC:
      return { a: d, b: r, sum: false, carry };
    case Kind.SUBI:
    case Kind.CPI:
      return { a: data[upper(opcode)]!, b: constant(opcode), sum: false, carry: 0 };
    case Kind.SBCI:
      return { a: data[upper(opcode)]!, b: constant(opcode), sum: false, carry };
    case Kind.NEG:
      return { a: 0, b: d, sum: false, carry: 0 };
    default:
      return null;
  }
}

/** Makes of what avr8js did what the chip does: of the registers before, and the cycles and registers since. */
function mend(opcode: number, before: Uint8Array, cpu: CPU): void {
  const { data } = cpu;
  const put = (flag: number, on: boolean): void => {
    data[SREG] = on ? data[SREG]! | flag : data[SREG]! & ~flag;
  };
  const sum = operands(opcode, before);
  if (sum) {
    // A carry between the digits; avr8js has that of bit 0.
    const [a, b] = [sum.a & 15, (sum.b & 15) + sum.carry];
    put(H, sum.sum ? a + b > 15 : b > a);
    // 0 - 255 - 1 leaves 0.
    if (sum.a === 0 && sum.b === 255 && sum.carry === 1 && !sum.sum) put(Z, (before[SREG]! & Z) !== 0);
  }
  switch (KINDS[opcode]) {
    case Kind.NEG: {
      // 128 has no opposite.
      const overflows = data[(opcode >> 4) & 31] === 0x80;
      put(V, overflows);
      if (overflows) put(S, false);
      break;
    }
    case Kind.SBIW:
      put(H, (before[SREG]! & H) !== 0);
      break;
    case Kind.FMULSU:
      put(Z, data[0] === 0 && data[1] === 0);
      break;
    case Kind.CBI:
      cpu.cycles += 1;
      break;
  }
}

test("each opcode does what avr8js does, and what the chip does where that is another thing", () => {
  const random = new Random(0x0c19);
  const ours = hooked();
  const theirs = hooked();
  let compared = 0;
  for (let opcode = 0; opcode <= 0xffff; opcode += 1) {
    const register = (opcode >> 4) & 31;
    const pointer = MOVED[KINDS[opcode] as Kind];
    if (pointer !== undefined && (register & ~1) === pointer) continue;
    for (let round = 0; round < 4; round += 1) {
      const pc = 4000 + random.below(4000);
      const next = random.of(NEXT);
      const data = ours.cpu.data;
      for (let at = 0; at < 32; at += 1) {
        // Pointers to RAM in one round, to what has hooks in another, to anywhere in the rest.
        const high = at > 25 && at % 2 === 1;
        data[at] = high && round === 0 ? 1 + random.below(7) : high && round === 1 ? 0 : random.below(256);
      }
      // Numbers that carry, and that overflow.
      if (round === 3) for (let at = 0; at < 26; at += 1) data[at] = random.of([0, 1, 0x7f, 0x80, 0xff]);
      data[SREG] = random.below(256);
      data[SP] = random.below(256);
      data[SP + 1] = 1 + random.below(7);
      theirs.cpu.data.set(data);
      const before = data.slice();
      for (const { cpu, seen } of [ours, theirs]) {
        cpu.pc = pc;
        cpu.cycles = 7;
        cpu.progMem[pc] = opcode;
        cpu.progMem[pc + 1] = next;
        seen.length = 0;
      }
      one(ours.cpu);
      avrInstruction(theirs.cpu);
      mend(opcode, before, theirs.cpu);
      const text = `${opcode.toString(16)} before ${next.toString(16)}, round ${round}`;
      assert.equal(ours.cpu.pc, theirs.cpu.pc, text);
      assert.equal(ours.cpu.cycles, theirs.cpu.cycles, text);
      if (Buffer.compare(data, theirs.cpu.data) !== 0) assert.deepEqual(data, theirs.cpu.data, text);
      assert.deepEqual(ours.seen, theirs.seen, text);
      compared += 1;
    }
  }
  assert.ok(compared > 4 * 65_000, `${compared}`);
});

test("many instructions at once are the same as one by one", () => {
  const random = new Random(0x51ab);
  for (let round = 0; round < 40; round += 1) {
    const [many, single] = [hooked(), hooked()];
    for (let at = 0; at < WORDS; at += 1) many.cpu.progMem[at] = random.below(1 << 16);
    for (let at = 0; at < many.cpu.data.length; at += 1) many.cpu.data[at] = random.below(256);
    single.cpu.progMem.set(many.cpu.progMem);
    single.cpu.data.set(many.cpu.data);
    // Past what fits a small integer.
    const start = round * 2 ** 28;
    for (const { cpu } of [many, single]) cpu.cycles = start;
    for (const until of [start + 1, start + 200, start + 20_000]) {
      execute(many.cpu, { until, due: Infinity }, -1, RAM);
      while (single.cpu.cycles < until) one(single.cpu);
      assert.deepEqual([many.cpu.pc, many.cpu.cycles], [single.cpu.pc, single.cpu.cycles], `round ${round}`);
      assert.equal(Buffer.compare(many.cpu.data, single.cpu.data), 0, `round ${round}`);
    }
    assert.deepEqual(many.seen, single.seen);
  }
});

/** A chip that counts forever: `inc r16`, `out 0x1e, r16`, `rjmp` to the first; four cycles. */
function counting(): CPU {
  const cpu = new CPU(new Uint16Array(WORDS), RAM_LEN);
  cpu.progMem.set([0x9503, 0xbb0e, 0xcffd]);
  return cpu;
}

test("it ends at the word that is named", () => {
  const cpu = counting();
  execute(cpu, { until: 1000, due: Infinity }, 2, RAM);
  assert.deepEqual([cpu.pc, cpu.cycles], [2, 2]);
  execute(cpu, { until: 1000, due: Infinity }, 2, RAM);
  assert.deepEqual([cpu.pc, cpu.cycles, cpu.data[16]], [2, 6, 2]);
});

test("it ends where something is due, also where that comes about meanwhile", () => {
  const cpu = counting();
  const span: Span = { until: 1000, due: 90 };
  cpu.writeHooks[0x3e] = (value) => {
    if (value === 7) span.due = cpu.cycles + 5;
    if (value === 12) span.until = 0;
    return false;
  };
  execute(cpu, span, -1, RAM);
  // The seventh `out` begins at 25.
  assert.deepEqual([cpu.data[16], cpu.cycles], [8, 30]);
  span.due = Infinity;
  execute(cpu, span, -1, RAM);
  assert.deepEqual([cpu.data[16], cpu.cycles], [12, 46]);
});

test("while an interrupt waits, each instruction ends it", () => {
  const cpu = counting();
  cpu.writeHooks[0x3e] = (value) => {
    if (value === 3) cpu.nextInterrupt = 9;
    return false;
  };
  const span: Span = { until: 1000, due: Infinity };
  execute(cpu, span, -1, RAM);
  assert.deepEqual([cpu.data[16], cpu.pc], [3, 2]);
  execute(cpu, span, -1, RAM);
  assert.equal(cpu.pc, 0);
});

test("a jump from the first word goes to the last of the flash", () => {
  const cpu = new CPU(new Uint16Array(WORDS), RAM_LEN);
  // rjmp .-4
  cpu.progMem[0] = 0xcffe;
  one(cpu);
  assert.equal(cpu.pc, WORDS - 1);
});
