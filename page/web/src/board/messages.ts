// What the page asks of the machine beside its board, through the board's worker. Nothing here but types.

import type { Wrong } from "../tools/answers";

/** The module with everything, once, before the first request; then requests for the machine. */
export type ForMachine =
  | { readonly kind: "machine-module"; readonly module: WebAssembly.Module }
  | { readonly kind: "machine-ask"; readonly id: number; readonly what: string; readonly request: unknown };

/** What is answered; with neither `ok` nor `error`, the module has broken down, and there is no machine any more. */
export interface OfMachine {
  readonly kind: "machine-answer";
  readonly id: number;
  readonly ok?: unknown;
  readonly error?: Wrong;
}
