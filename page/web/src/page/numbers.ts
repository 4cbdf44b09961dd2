// Numbers as a person reads them: with a decimal comma in Portuguese.

import { speak } from "../words/words";

const locale = (): string => (speak.value === "pt" ? "pt-BR" : "en-US");

/** A number with as many digits as a REAL has. */
export function decimal(value: number): string {
  const tiny = value !== 0 && (Math.abs(value) < 1e-4 || Math.abs(value) >= 1e15);
  if (!Number.isFinite(value)) return String(value);
  if (tiny) return String(Number(value.toPrecision(7))).replace(".", locale() === "pt-BR" ? "," : ".");
  return value.toLocaleString(locale(), { maximumSignificantDigits: Number.isInteger(value) ? 15 : 7, useGrouping: false });
}

/** A number with so many digits behind the comma. */
export function fixed(value: number, digits: number): string {
  return value.toLocaleString(locale(), { minimumFractionDigits: digits, maximumFractionDigits: digits, useGrouping: false });
}
