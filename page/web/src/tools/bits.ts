// Points as bits.

/** Bit n: the point n + 1 is one of these. */
export function bitsOf(numbers: readonly number[]): number {
  return numbers.reduce((all, number) => all | (1 << (number - 1)), 0);
}

/** Whether the point with this number is among these. */
export function hasBit(bits: number, number: number): boolean {
  return ((bits >> (number - 1)) & 1) === 1;
}
