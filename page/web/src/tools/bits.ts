// Points as bits.

/** Bit n: the point n + 1 is one of these. */
export function bitsOf(numbers: readonly number[]): number {
  return numbers.reduce((all, number) => all | (1 << (number - 1)), 0);
}
