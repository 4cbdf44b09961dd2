// One instruction. avr8js looks for it in a row of a hundred cases; those that the firmware executes most, three quarters
// of all, are found here by a table. They do what avr8js does, but for flag H of a comparison, which it takes from the
// wrong bit: a test compares them, opcode by opcode.

import { type CPU, avrInstruction } from "avr8js";
import { RAM } from "./registers";

const Z = 30;
const Y = 28;
const X = 26;
const SREG = 95;
/** First address of what `in` and `out` reach. */
const IO = 32;
/** Flag T, in SREG. */
const T = 1 << 6;

/** What is done here, and the bits of an opcode that say so: mask and value. */
const PATTERNS = [
  [0xfe0f, 0x900d], // 1: ld r, X+
  [0xd208, 0x8000], // 2: ldd r, Z+q
  [0xd208, 0x8008], // 3: ldd r, Y+q
  [0xd208, 0x8200], // 4: std Z+q, r
  [0xd208, 0x8208], // 5: std Y+q, r
  [0xffff, 0x9409], // 6: ijmp
  [0xfc00, 0xf400], // 7: brbc
  [0xfc00, 0xf000], // 8: brbs
  [0xfe08, 0xf800], // 9: bld
  [0xfe08, 0xfa00], // 10: bst
  [0xff00, 0x0100], // 11: movw
  [0xfc00, 0x2c00], // 12: mov
  [0xf000, 0xe000], // 13: ldi
  [0xfe0f, 0x9000], // 14: lds
  [0xf000, 0xc000], // 15: rjmp
  [0xfe08, 0xfc00], // 16: sbrc
  [0xfe08, 0xfe00], // 17: sbrs
  [0xf800, 0xb000], // 18: in
  [0xf800, 0xb800], // 19: out
  [0xfc00, 0x2000], // 20: and
  [0xfc00, 0x2800], // 21: or
  [0xfc00, 0x2400], // 22: eor
  [0xf000, 0x7000], // 23: andi
  [0xfc00, 0x1400], // 24: cp
  [0xf000, 0x3000], // 25: cpi
] as const;

/** For each opcode its place in the patterns, from 1, or 0. */
export const KINDS = Uint8Array.from({ length: 1 << 16 }, (_, opcode) => {
  return 1 + PATTERNS.findIndex(([mask, value]) => (opcode & mask) === value);
});

/** Executes the next instruction. */
export function step(cpu: CPU): void {
  const { data, progMem } = cpu;
  const opcode = progMem[cpu.pc]!;
  const register = (opcode >> 4) & 31;
  switch (KINDS[opcode]) {
    case 1: {
      const at = pair(data, X);
      data[register] = load(cpu, at);
      data[X] = at + 1;
      data[X + 1] = (at + 1) >> 8;
      cpu.cycles += 1;
      break;
    }
    case 2:
      cpu.cycles += 1;
      data[register] = load(cpu, pair(data, Z) + displacement(opcode));
      break;
    case 3:
      cpu.cycles += 1;
      data[register] = load(cpu, pair(data, Y) + displacement(opcode));
      break;
    case 4:
      store(cpu, pair(data, Z) + displacement(opcode), data[register]!);
      cpu.cycles += 1;
      break;
    case 5:
      store(cpu, pair(data, Y) + displacement(opcode), data[register]!);
      cpu.cycles += 1;
      break;
    case 6:
      cpu.pc = pair(data, Z) - 1;
      cpu.cycles += 1;
      break;
    case 7:
      if (!((data[SREG]! >> (opcode & 7)) & 1)) branch(cpu, opcode);
      break;
    case 8:
      if ((data[SREG]! >> (opcode & 7)) & 1) branch(cpu, opcode);
      break;
    case 9: {
      const bit = 1 << (opcode & 7);
      data[register] = data[SREG]! & T ? data[register]! | bit : data[register]! & ~bit;
      break;
    }
    case 10:
      data[SREG] = (data[register]! >> (opcode & 7)) & 1 ? data[SREG]! | T : data[SREG]! & ~T;
      break;
    case 11: {
      const from = 2 * (opcode & 15);
      const to = 2 * ((opcode >> 4) & 15);
      data[to] = data[from]!;
      data[to + 1] = data[from + 1]!;
      break;
    }
    case 12:
      data[register] = data[other(opcode)]!;
      break;
    case 13:
      data[16 | (register & 15)] = constant(opcode);
      break;
    case 14:
      cpu.cycles += 1;
      data[register] = load(cpu, progMem[cpu.pc + 1]!);
      cpu.pc += 1;
      break;
    case 15:
      // 12 bits with a sign.
      cpu.pc += (opcode << 20) >> 20;
      cpu.cycles += 1;
      break;
    case 16:
      if (!((data[register]! >> (opcode & 7)) & 1)) skip(cpu);
      break;
    case 17:
      if ((data[register]! >> (opcode & 7)) & 1) skip(cpu);
      break;
    case 18:
      data[register] = cpu.readData(IO + ((opcode & 15) | ((opcode >> 5) & 0x30)));
      break;
    case 19:
      cpu.writeData(IO + ((opcode & 15) | ((opcode >> 5) & 0x30)), data[register]!);
      break;
    case 20:
      data[register] = logic(data, data[register]! & data[other(opcode)]!);
      break;
    case 21:
      data[register] = logic(data, data[register]! | data[other(opcode)]!);
      break;
    case 22:
      data[register] = logic(data, data[register]! ^ data[other(opcode)]!);
      break;
    case 23:
      data[16 | (register & 15)] = logic(data, data[16 | (register & 15)]! & constant(opcode));
      break;
    case 24:
      compare(data, data[register]!, data[other(opcode)]!);
      break;
    case 25:
      compare(data, data[16 | (register & 15)]!, constant(opcode));
      break;
    default:
      avrInstruction(cpu);
      return;
  }
  // The flash is a power of two words long.
  cpu.pc = (cpu.pc + 1) & (progMem.length - 1);
  cpu.cycles += 1;
}

function pair(data: Uint8Array, low: number): number {
  return data[low]! | (data[low + 1]! << 8);
}

/** The second register of an opcode. */
function other(opcode: number): number {
  return (opcode & 15) | ((opcode >> 5) & 16);
}

/** The 8 bits of an opcode with a constant. */
function constant(opcode: number): number {
  return (opcode & 15) | ((opcode >> 4) & 0xf0);
}

/** Flags I and T, and those with H and C. */
const [IT, ITHC] = [0xc0, 0xe1];
const [C, ZERO, N, V, S, H] = [1, 2, 4, 8, 16, 32];

/** The flags of a logic result, which it gives back. */
function logic(data: Uint8Array, result: number): number {
  const sign = result & 0x80 ? N | S : 0;
  data[SREG] = (data[SREG]! & ITHC) | sign | (result === 0 ? ZERO : 0);
  return result;
}

/** The flags of a − b. */
function compare(data: Uint8Array, a: number, b: number): void {
  const result = (a - b) & 0xff;
  const negative = (result & 0x80) !== 0;
  const overflow = ((a ^ b) & (a ^ result) & 0x80) !== 0;
  data[SREG] =
    (data[SREG]! & IT) |
    (b > a ? C : 0) |
    (result === 0 ? ZERO : 0) |
    (negative ? N : 0) |
    (overflow ? V : 0) |
    (negative !== overflow ? S : 0) |
    ((b & 15) > (a & 15) ? H : 0);
}

/** q of `ldd` and `std`. */
function displacement(opcode: number): number {
  return (opcode & 7) | ((opcode >> 7) & 0x18) | ((opcode >> 8) & 0x20);
}

/** Nothing is hooked to RAM. */
function load(cpu: CPU, address: number): number {
  return address >= RAM ? cpu.data[address]! : cpu.readData(address);
}

function store(cpu: CPU, address: number, value: number): void {
  if (address >= RAM) cpu.data[address] = value;
  else cpu.writeData(address, value);
}

/** 7 bits with a sign. */
function branch(cpu: CPU, opcode: number): void {
  cpu.pc += (opcode << 22) >> 25;
  cpu.cycles += 1;
}

/** Skips an instruction, which may be two words long. */
function skip(cpu: CPU): void {
  const next = cpu.progMem[cpu.pc + 1]!;
  const long = (next & 0xfc0f) === 0x9000 || (next & 0xfe0c) === 0x940c;
  cpu.pc += long ? 2 : 1;
  cpu.cycles += long ? 2 : 1;
}
