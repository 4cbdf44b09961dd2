// Instructions, one after the other. avr8js looks for each in a row of a hundred cases, and keeps its place and its time
// in the heap; here a table says what an opcode asks for, and both stay in registers of the computer until something
// around the chip may look. A test compares every opcode with avr8js, and names what it does otherwise than the chip.

import { type CPU, avrInstruction } from "avr8js";
import {
  I,
  SREG,
  T,
  added,
  combined,
  multiplied,
  shifted,
  stepped,
  subtracted,
  subtractedOn,
  widened,
} from "./flags";
import { KINDS, Kind, wordsOf } from "./opcodes";
import { SP, X, Y, Z, above, addressOf, constant, near, other, pair, port, setPair, signed, upper, wide } from "./operands";
import type { Fetches } from "./fetches";

/** No place is marked. */
const NONE = new Uint8Array(0);
/** Cycles that are counted without a look at the clock: as many fit an integer. */
const FAR = 1 << 29;

/** How far instructions are executed. What stands around the chip may shorten it while they are. */
export interface Span {
  /** To this cycle. */
  until: number;
  /** And no further than to this one, at which something is due. */
  due: number;
  /** Who is told of what the engine fetches, as long as its jumps tell of it. */
  fetches?: Fetches | null;
}

/**
 * Executes instructions of a chip whose RAM begins at `ram` to the end of the span, or until one at this address, in words, is the next; at least one.
 * While an interrupt waits, it executes one alone.
 */
export function execute(cpu: CPU, span: Span, stop: number, ram: number): void {
  const { data, progMem, progBytes, pc22Bits: far } = cpu;
  // An address on the stack has two bytes, or three.
  const pushed = far ? 3 : 2;
  const marks = span.fetches?.marks ?? NONE;
  // The flash is a power of two words long.
  const last = progMem.length - 1;
  const start = cpu.cycles;
  let { pc } = cpu;
  let spent = 0;
  let end = room(cpu, span, start);
  do {
    const opcode = progMem[pc]!;
    const kind = KINDS[opcode]!;
    const d = (opcode >> 4) & 31;
    if (kind >= Kind.LD_X) {
      let at: number;
      if (kind === Kind.LDS || kind === Kind.STS) {
        pc += 1;
        at = progMem[pc & last]!;
      } else at = addressOf(data, kind, opcode);
      if (kind < Kind.ST_X) {
        if (kind !== Kind.IN) spent += 1;
        if (at >= ram) data[d] = data[at]!;
        else {
          cpu.cycles = start + spent;
          data[d] = cpu.readData(at);
          spent = cpu.cycles - start;
          end = room(cpu, span, start);
        }
      } else {
        if (at >= ram) data[at] = data[d]!;
        else {
          cpu.cycles = start + spent;
          cpu.writeData(at, data[d]!);
          spent = cpu.cycles - start;
          end = room(cpu, span, start);
        }
        if (kind !== Kind.OUT) spent += 1;
      }
    } else {
      switch (kind) {
        case Kind.NOP:
          break;
        case Kind.LDI:
          data[upper(opcode)] = constant(opcode);
          break;
        case Kind.MOV:
          data[d] = data[other(opcode)]!;
          break;
        case Kind.MOVW: {
          const from = 2 * (opcode & 15);
          const to = 2 * (d & 15);
          data[to] = data[from]!;
          data[to + 1] = data[from + 1]!;
          break;
        }
        case Kind.SWAP:
          data[d] = (data[d]! << 4) | (data[d]! >> 4);
          break;

        case Kind.ADD:
        case Kind.ADC: {
          const a = data[d]!;
          const b = data[other(opcode)]!;
          const result = (a + b + (kind === Kind.ADC ? data[SREG]! & 1 : 0)) & 0xff;
          data[d] = result;
          added(data, a, b, result);
          break;
        }
        case Kind.SUB:
        case Kind.CP: {
          const a = data[d]!;
          const b = data[other(opcode)]!;
          const result = (a - b) & 0xff;
          if (kind === Kind.SUB) data[d] = result;
          subtracted(data, a, b, result);
          break;
        }
        case Kind.SBC:
        case Kind.CPC: {
          const a = data[d]!;
          const b = data[other(opcode)]!;
          const result = (a - b - (data[SREG]! & 1)) & 0xff;
          if (kind === Kind.SBC) data[d] = result;
          subtractedOn(data, a, b, result);
          break;
        }
        case Kind.SUBI:
        case Kind.CPI: {
          const a = data[upper(opcode)]!;
          const b = constant(opcode);
          const result = (a - b) & 0xff;
          if (kind === Kind.SUBI) data[upper(opcode)] = result;
          subtracted(data, a, b, result);
          break;
        }
        case Kind.SBCI: {
          const a = data[upper(opcode)]!;
          const b = constant(opcode);
          const result = (a - b - (data[SREG]! & 1)) & 0xff;
          data[upper(opcode)] = result;
          subtractedOn(data, a, b, result);
          break;
        }
        case Kind.NEG: {
          const b = data[d]!;
          const result = -b & 0xff;
          data[d] = result;
          subtracted(data, 0, b, result);
          break;
        }
        case Kind.INC: {
          const result = (data[d]! + 1) & 0xff;
          data[d] = result;
          stepped(data, result, result === 0x80);
          break;
        }
        case Kind.DEC: {
          const result = (data[d]! - 1) & 0xff;
          data[d] = result;
          stepped(data, result, result === 0x7f);
          break;
        }
        case Kind.ADIW: {
          const low = Y - 4 + 2 * (d & 3);
          const before = pair(data, low);
          const result = (before + wide(opcode)) & 0xffff;
          setPair(data, low, result);
          widened(data, result, before & ~result, ~before & result);
          spent += 1;
          break;
        }
        case Kind.SBIW: {
          const low = Y - 4 + 2 * (d & 3);
          const before = pair(data, low);
          const result = (before - wide(opcode)) & 0xffff;
          setPair(data, low, result);
          widened(data, result, ~before & result, before & ~result);
          spent += 1;
          break;
        }

        case Kind.AND:
          combined(data, (data[d] = data[d]! & data[other(opcode)]!));
          break;
        case Kind.OR:
          combined(data, (data[d] = data[d]! | data[other(opcode)]!));
          break;
        case Kind.EOR:
          combined(data, (data[d] = data[d]! ^ data[other(opcode)]!));
          break;
        case Kind.ANDI:
          combined(data, (data[upper(opcode)] = data[upper(opcode)]! & constant(opcode)));
          break;
        case Kind.ORI:
          combined(data, (data[upper(opcode)] = data[upper(opcode)]! | constant(opcode)));
          break;
        case Kind.COM:
          combined(data, (data[d] = data[d]! ^ 0xff));
          data[SREG] = data[SREG]! | 1;
          break;
        case Kind.LSR: {
          const value = data[d]!;
          shifted(data, value, (data[d] = value >> 1));
          break;
        }
        case Kind.ASR: {
          const value = data[d]!;
          shifted(data, value, (data[d] = (value & 0x80) | (value >> 1)));
          break;
        }
        case Kind.ROR: {
          const value = data[d]!;
          shifted(data, value, (data[d] = ((data[SREG]! & 1) << 7) | (value >> 1)));
          break;
        }
        case Kind.BLD: {
          const bit = 1 << (opcode & 7);
          data[d] = data[SREG]! & T ? data[d]! | bit : data[d]! & ~bit;
          break;
        }
        case Kind.BST:
          data[SREG] = (data[d]! >> (opcode & 7)) & 1 ? data[SREG]! | T : data[SREG]! & ~T;
          break;
        case Kind.BSET:
          data[SREG] = data[SREG]! | (1 << (d & 7));
          break;
        case Kind.BCLR:
          data[SREG] = data[SREG]! & ~(1 << (d & 7));
          break;

        case Kind.MUL: {
          const result = data[d]! * data[other(opcode)]!;
          multiplied(data, result, result);
          spent += 1;
          break;
        }
        case Kind.MULS: {
          const result = signed(data[upper(opcode)]!) * signed(data[16 | (opcode & 15)]!);
          multiplied(data, result, result);
          spent += 1;
          break;
        }
        case Kind.MULSU:
        case Kind.FMUL:
        case Kind.FMULS:
        case Kind.FMULSU: {
          const a = data[16 | (d & 7)]!;
          const b = data[16 | (opcode & 7)]!;
          const result = (kind === Kind.FMUL ? a : signed(a)) * (kind === Kind.FMULS ? signed(b) : b);
          multiplied(data, kind === Kind.MULSU ? result : result << 1, result);
          spent += 1;
          break;
        }

        case Kind.RJMP:
          pc += near(opcode);
          spent += 1;
          break;
        case Kind.IJMP:
          pc = pair(data, Z) - 1;
          spent += 1;
          break;
        case Kind.FETCH:
          pc = pair(data, Z) - 1;
          spent += 1;
          if (marks[pair(data, X)] && span.fetches?.note(data)) end = 0;
          break;
        case Kind.FIRST_FETCH:
          push(data, pc + 1, far);
          pc = pair(data, Z) - 1;
          spent += pushed;
          if (marks[pair(data, X)] && span.fetches?.note(data)) end = 0;
          break;
        case Kind.JMP:
          pc = (above(opcode) | progMem[(pc + 1) & last]!) - 1;
          spent += 2;
          break;
        case Kind.RCALL:
          push(data, pc + 1, far);
          pc += near(opcode);
          spent += pushed;
          break;
        case Kind.ICALL:
          push(data, pc + 1, far);
          pc = pair(data, Z) - 1;
          spent += pushed;
          break;
        case Kind.CALL:
          push(data, pc + 2, far);
          pc = (above(opcode) | progMem[(pc + 1) & last]!) - 1;
          spent += pushed + 1;
          break;
        case Kind.RETI:
        case Kind.RET: {
          const sp = pair(data, SP) + pushed;
          setPair(data, SP, sp);
          pc = (((far ? data[sp - 2]! : 0) << 16) | (data[sp - 1]! << 8) | data[sp]!) - 1;
          spent += pushed + 1;
          if (kind === Kind.RETI) data[SREG] = data[SREG]! | I;
          break;
        }
        case Kind.PUSH: {
          const sp = pair(data, SP);
          data[sp] = data[d]!;
          setPair(data, SP, sp - 1);
          spent += 1;
          break;
        }
        case Kind.POP: {
          const sp = pair(data, SP) + 1;
          setPair(data, SP, sp);
          data[d] = data[sp]!;
          spent += 1;
          break;
        }

        case Kind.BRBC:
          if (!((data[SREG]! >> (opcode & 7)) & 1)) {
            // 7 bits with a sign.
            pc += (opcode << 22) >> 25;
            spent += 1;
          }
          break;
        case Kind.BRBS:
          if ((data[SREG]! >> (opcode & 7)) & 1) {
            pc += (opcode << 22) >> 25;
            spent += 1;
          }
          break;
        case Kind.SBRC:
        case Kind.SBRS:
          if (((data[d]! >> (opcode & 7)) & 1) === (kind === Kind.SBRS ? 1 : 0)) {
            const words = wordsOf(progMem[(pc + 1) & last]!);
            pc += words;
            spent += words;
          }
          break;
        case Kind.CPSE:
          if (data[d] === data[other(opcode)]) {
            const words = wordsOf(progMem[(pc + 1) & last]!);
            pc += words;
            spent += words;
          }
          break;
        case Kind.SBIC:
        case Kind.SBIS:
          cpu.cycles = start + spent;
          if (((cpu.readData(port(opcode)) >> (opcode & 7)) & 1) === (kind === Kind.SBIS ? 1 : 0)) {
            const words = wordsOf(progMem[(pc + 1) & last]!);
            pc += words;
            cpu.cycles += words;
          }
          spent = cpu.cycles - start;
          end = room(cpu, span, start);
          break;
        case Kind.SBI:
        case Kind.CBI: {
          cpu.cycles = start + spent;
          const bit = 1 << (opcode & 7);
          const value = cpu.readData(port(opcode));
          cpu.writeData(port(opcode), kind === Kind.SBI ? value | bit : value & ~bit, bit);
          spent = cpu.cycles - start + 1;
          end = room(cpu, span, start);
          break;
        }

        case Kind.LPM:
          data[0] = progBytes[pair(data, Z)]!;
          spent += 2;
          break;
        case Kind.LPM_Z:
        case Kind.LPM_Z_INC: {
          const at = pair(data, Z);
          data[d] = progBytes[at]!;
          if (kind === Kind.LPM_Z_INC) setPair(data, Z, at + 1);
          spent += 2;
          break;
        }
        default:
          cpu.pc = pc;
          cpu.cycles = start + spent;
          avrInstruction(cpu);
          // It counts its own word and cycle, as the end of this does.
          pc = cpu.pc - 1;
          spent = cpu.cycles - start - 1;
          end = room(cpu, span, start);
      }
    }
    pc = (pc + 1) & last;
    spent += 1;
  } while (spent < end && pc !== stop);
  cpu.pc = pc;
  cpu.cycles = start + spent;
}

/** Cycles from the start to where execution ends. */
function room(cpu: CPU, span: Span, start: number): number {
  if (cpu.nextInterrupt >= 0) return 0;
  return Math.min(span.until - start, span.due - start, FAR) | 0;
}

function push(data: Uint8Array, address: number, far: boolean): void {
  const sp = pair(data, SP);
  data[sp] = address;
  data[sp - 1] = address >> 8;
  if (far) data[sp - 2] = address >> 16;
  setPair(data, SP, sp - (far ? 3 : 2));
}
