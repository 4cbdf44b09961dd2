// The flags of a result, as SREG has them.

export const SREG = 95;
export const [C, Z, N, V, S, H, T, I] = [1, 2, 4, 8, 16, 32, 64, 128] as const;

/** Z, N, V and S of a result of 8 bits, from 256 on of one that overflows. */
const ZNVS = Uint8Array.from({ length: 512 }, (_, at) => {
  const [negative, overflows] = [(at & 0x80) !== 0, at > 0xff];
  const sign = (negative ? N : 0) | (overflows ? V : 0) | (negative !== overflows ? S : 0);
  return sign | ((at & 0xff) === 0 ? Z : 0);
});

/** After an addition of 8 bits: a + b and perhaps C gave this. */
export function added(data: Uint8Array, a: number, b: number, result: number): void {
  const carries = (a & b) | ((a | b) & ~result);
  const overflows = (a ^ result) & (b ^ result) & 0x80;
  data[SREG] = (data[SREG]! & (I | T)) | ZNVS[(overflows << 1) | result]! | ((carries >> 7) & C) | ((carries << 2) & H);
}

/** After a subtraction of 8 bits: a − b gave this. */
export function subtracted(data: Uint8Array, a: number, b: number, result: number): void {
  const borrows = (~a & b) | ((~a | b) & result);
  const overflows = (a ^ b) & (a ^ result) & 0x80;
  data[SREG] = (data[SREG]! & (I | T)) | ZNVS[(overflows << 1) | result]! | ((borrows >> 7) & C) | ((borrows << 2) & H);
}

/** The same where C was subtracted too: Z stays only where it was. */
export function subtractedOn(data: Uint8Array, a: number, b: number, result: number): void {
  const before = data[SREG]! | ~Z;
  subtracted(data, a, b, result);
  data[SREG] = data[SREG]! & before;
}

/** After a logic operation. */
export function combined(data: Uint8Array, result: number): void {
  data[SREG] = (data[SREG]! & (I | T | H | C)) | ZNVS[result]!;
}

/** After a step by one, which overflows or not. */
export function stepped(data: Uint8Array, result: number, overflows: boolean): void {
  data[SREG] = (data[SREG]! & (I | T | H | C)) | ZNVS[overflows ? 0x100 | result : result]!;
}

/** After a shift to the right of this value: V is N with C. */
export function shifted(data: Uint8Array, value: number, result: number): void {
  const carry = value & 1;
  const overflows = (result >> 7) ^ carry;
  data[SREG] = (data[SREG]! & (I | T | H)) | ZNVS[(overflows << 8) | result]! | carry;
}

/** After 16 bits have become this, with bit 15 set where they carry and where they overflow. */
export function widened(data: Uint8Array, result: number, carries: number, overflows: number): void {
  // Z of 16 bits, the others of the upper byte.
  const sign = ZNVS[((overflows & 0x8000) >> 7) | (result >> 8)]! & ~Z;
  data[SREG] = (data[SREG]! & (I | T | H)) | sign | (result === 0 ? Z : 0) | ((carries >> 15) & C);
}

/** After a product, which stands in the first two registers. */
export function multiplied(data: Uint8Array, result: number, carry: number): void {
  data[0] = result;
  data[1] = result >> 8;
  data[SREG] = (data[SREG]! & ~(Z | C)) | ((result & 0xffff) === 0 ? Z : 0) | ((carry >> 15) & C);
}
