// What the page says to Rust, and names of what it is answered. Nothing here but types; which asks there are is in `asks.ts`.

import type { Both, Seen } from "./answers";
import type { Asks, OrderGiven } from "./asks";

/** What is wrong, where a field is with its key and what could stand in it instead. */
export interface Wrong extends Both {
  readonly field?: string;
  readonly offers?: readonly { readonly value: string; readonly say: Both; readonly sure: boolean }[];
}

export type { Act, Along, As, Coil, Direction, DrawnAs, Edge, Place, Speak } from "./asks";
export type { LanguageName } from "./languages";

/** A program as somebody writes it: the end of the name says its language. */
export interface Text {
  readonly name: string;
  readonly text: string;
}

/** A text that something is asked about: the tools ask Rust by its version. */
export interface Of {
  readonly of: Text;
  /** The board that it is for, where it is not the usual one. */
  readonly board?: string | undefined;
}

/** A point that is forced, by its number, and to what. */
export type Forced = Seen["forcedInputs"][number];

/** What may be ordered of a board, with a text in place of its version. */
export type Order = WithText<OrderGiven>;

export type Rectangle = readonly [x: number, y: number, width: number, height: number];

/** What the page asks, with a text in place of its version: the tools know which that is. */
export type Ask<K extends keyof Asks> = WithText<Asks[K]["ask"]>;
type WithText<A> = A extends { readonly version: number } ? Omit<A, "version"> & Of
  : A extends { readonly version: number | null } ? Omit<A, "version"> & { readonly of: Text | null } : A;
