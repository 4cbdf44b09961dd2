// Times as people of either language write them.

import { speak } from "../words/words";

/** Seconds with so many digits behind the point, or the comma. */
export function seconds(ms: number, digits = 1): string {
  const form = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return (ms / 1000).toLocaleString(speak.value === "pt" ? "pt-BR" : "en-US", form);
}
