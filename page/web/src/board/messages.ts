// What the page asks of the board's worker beside its commands: of the machine, and of slow motion. Nothing here but types.

import type { Go, Places, Standing } from "unoclp-uno/slow";
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

/** Slow motion of the board: it is held, goes on to where this says, is let go. Its time runs and stands by the board's own commands. */
export type ForSlow =
  | { readonly kind: "slow-hold"; readonly places: Places }
  | { readonly kind: "slow-go"; readonly go: Go }
  | { readonly kind: "slow-end" };

/** Whether it is held: it keeps a program then; and where it stands. */
export type OfSlow = { readonly kind: "slow-held"; readonly is: boolean } | { readonly kind: "slow-stood"; readonly standing: Standing };
