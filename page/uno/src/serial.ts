// Characters on a serial line, and how they are read by a receiver that is set otherwise.

import type { SerialFormat } from "./messages";
import { CLOCK_HZ } from "./chip/registers";

/** How one end of the line sends and reads: 8 data bits, 1 stop bit. */
export interface Setting {
  /** Cycles of a bit; a fraction where the rate is not a divider of the clock. */
  readonly bit: number;
  readonly parity: SerialFormat["parity"];
}

/** The setting of an end that counts in baud. */
export function settingOf(format: SerialFormat): Setting {
  return { bit: CLOCK_HZ / format.baud, parity: format.parity };
}

/** Bits of a character, from its start bit to its stop bit. */
export function bitsOf(setting: Setting): number {
  return setting.parity === "none" ? 10 : 11;
}

/** Cycles of a character. */
export function lengthOf(setting: Setting): number {
  return bitsOf(setting) * setting.bit;
}

/** A character as it was read. */
export interface Read {
  readonly byte: number;
  /** The stop bit was low. */
  readonly framing: boolean;
  /** The parity bit was the other one. */
  readonly parity: boolean;
}

/** What a receiver with the setting `by` makes of a byte sent as `sent`: each bit is what the line has in its middle. */
export function read(byte: number, sent: Setting, by: Setting): Read {
  const middle = (bit: number): boolean => level(byte, sent, (bit + 0.5) * by.bit);
  let value = 0;
  for (let bit = 0; bit < 8; bit += 1) value |= middle(bit + 1) ? 1 << bit : 0;
  const stop = bitsOf(by) - 1;
  return {
    byte: value,
    framing: !middle(stop),
    parity: by.parity !== "none" && middle(9) !== parityBit(value, by.parity),
  };
}

/** The line so many cycles after the beginning of a character; behind it, and with nothing else, it is high. */
function level(byte: number, sent: Setting, at: number): boolean {
  const bit = Math.floor(at / sent.bit);
  if (bit === 0) return false;
  if (bit <= 8) return ((byte >> (bit - 1)) & 1) === 1;
  if (bit === 9 && sent.parity !== "none") return parityBit(byte, sent.parity);
  return true;
}

function parityBit(byte: number, parity: "even" | "odd"): boolean {
  let odd = parity === "odd";
  for (let rest = byte; rest > 0; rest &= rest - 1) odd = !odd;
  return odd;
}
