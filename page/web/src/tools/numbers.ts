// Numbers of Rust that are no answers. Made like `asks.ts`: do not edit it.

/** Points of a kind whose numbers a machine is told by: number 0 of outputs is none. */
export const NUMBERS = 100;

/** The most ms that a machine goes on at once. */
export const MOST_MS = 250;

/** How a board is spoken to whose settings nobody has changed; parity: 0 none, 1 even, 2 odd. */
export const USUAL = { address: 1, rate: 115200, parity: 0 };

/** The rates that a board meets well, bits per second. */
export const RATES = [2400, 4800, 9600, 19200, 28800, 38400, 57600, 115200];

/** Addresses that a board may have, the least and the greatest. */
export const ADDRESSES = [1, 247] as const;
