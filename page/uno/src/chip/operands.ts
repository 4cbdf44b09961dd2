// What an instruction works on: fields of its opcode, pointers in registers, places in the data space.

import { Kind } from "./opcodes";

export const [X, Y, Z, SP] = [26, 28, 30, 93] as const;
/** First address of what `in` and `out` reach. */
const IO = 32;

/** The second register of an opcode. */
export function other(opcode: number): number {
  return (opcode & 15) | ((opcode >> 5) & 16);
}

/** The register from 16 on of an opcode with a constant. */
export function upper(opcode: number): number {
  return 16 | ((opcode >> 4) & 15);
}

/** The 8 bits of an opcode with a constant. */
export function constant(opcode: number): number {
  return (opcode & 15) | ((opcode >> 4) & 0xf0);
}

/** q of `ldd` and `std`. */
export function displacement(opcode: number): number {
  return (opcode & 7) | ((opcode >> 7) & 0x18) | ((opcode >> 8) & 0x20);
}

/** Where an instruction reads or writes; it moves the pointer. */
export function addressOf(data: Uint8Array, kind: Kind, opcode: number): number {
  switch (kind) {
    case Kind.IN:
    case Kind.OUT:
      return IO + ((opcode & 15) | ((opcode >> 5) & 0x30));
    case Kind.LDD_Z:
    case Kind.STD_Z:
      return pair(data, Z) + displacement(opcode);
    case Kind.LDD_Y:
    case Kind.STD_Y:
      return pair(data, Y) + displacement(opcode);
    case Kind.LD_X_INC:
    case Kind.ST_X_INC:
      return moved(data, X, 1);
    case Kind.LD_X_DEC:
    case Kind.ST_X_DEC:
      return moved(data, X, -1) - 1;
    case Kind.LD_Y_INC:
    case Kind.ST_Y_INC:
      return moved(data, Y, 1);
    case Kind.LD_Y_DEC:
    case Kind.ST_Y_DEC:
      return moved(data, Y, -1) - 1;
    case Kind.LD_Z_INC:
    case Kind.ST_Z_INC:
      return moved(data, Z, 1);
    case Kind.LD_Z_DEC:
    case Kind.ST_Z_DEC:
      return moved(data, Z, -1) - 1;
    default:
      return pair(data, X);
  }
}

/** Moves a pointer; gives where it was. */
export function moved(data: Uint8Array, low: number, by: number): number {
  const at = pair(data, low);
  setPair(data, low, at + by);
  return at;
}

export function pair(data: Uint8Array, low: number): number {
  return data[low]! | (data[low + 1]! << 8);
}

export function setPair(data: Uint8Array, low: number, value: number): void {
  data[low] = value;
  data[low + 1] = value >> 8;
}

export function signed(byte: number): number {
  return (byte << 24) >> 24;
}

/** The 6 bits of `adiw` and `sbiw`. */
export function wide(opcode: number): number {
  return (opcode & 15) | ((opcode >> 2) & 0x30);
}

/** The 12 bits of a jump, with a sign. */
export function near(opcode: number): number {
  return (opcode << 20) >> 20;
}

/** What `jmp` and `call` have above the 16 bits of their second word. */
export function above(opcode: number): number {
  return ((opcode & 1) << 16) | ((opcode & 0x1f0) << 13);
}

/** The register of `sbi`, `cbi`, `sbic` and `sbis`. */
export function port(opcode: number): number {
  return IO + ((opcode >> 3) & 31);
}
