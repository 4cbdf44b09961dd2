// What the page says to Rust, and names of what it is answered. Nothing here but types; which asks there are is in `asks.ts`.

import type { Both, Seen, Settings } from "./answers";
import type { Asks } from "./asks";

/** What is wrong, where a field is with its key and what could stand in it instead. */
export interface Wrong extends Both {
  readonly field?: string;
  readonly offers?: readonly { readonly value: string; readonly say: Both; readonly sure: boolean }[];
}

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

export type Order =
  | { readonly do: "run" | "stop" | "scan" | "restart" | "release" | "settings" | "fetch" }
  | { readonly do: "force"; readonly output: boolean; readonly number: number; readonly to: boolean | null }
  | { readonly do: "set"; readonly point: string; readonly value: number }
  /** Of what this computer runs alone: a board has contacts and knobs of its own. */
  | { readonly do: "press"; readonly input: number; readonly closed: boolean }
  | { readonly do: "turn"; readonly input: number; readonly reading: number }
  | ({ readonly do: "upload"; readonly stay?: boolean } & Of)
  | ({ readonly do: "watch" } & Of)
  | { readonly do: "settle"; readonly settings: Settings };

export type Speak = "en" | "pt";

/** Where something is inserted. */
export type Place = "before" | "behind" | "beside";
type Along = "back" | "forth";
export type Rectangle = readonly [x: number, y: number, width: number, height: number];

/** What may be done to a drawing. */
export type Act =
  | { readonly do: "undo" | "redo" | "out" | "branch" | "delete" | "copy" | "cut" | "toggle" | "split" | "join" }
  | { readonly do: "move"; readonly to: "left" | "right" | "up" | "down" }
  | { readonly do: "select"; readonly from: number; readonly to: number }
  | { readonly do: "extend" | "insertRung" | "moveRung"; readonly along: Along }
  | { readonly do: "stretch"; readonly along: Along; readonly out: boolean }
  | { readonly do: "insert"; readonly what: string; readonly place: Place }
  | { readonly do: "put"; readonly what: string; readonly at: number; readonly place: Place }
  | { readonly do: "carry"; readonly at: number; readonly place: Place }
  | { readonly do: "paste"; readonly place: Place }
  | { readonly do: "coil"; readonly coil: "normal" | "negated" | "set" | "reset" | "load" }
  | { readonly do: "edit"; readonly fields: readonly { readonly key: string; readonly value: string }[]; readonly sure?: boolean }
  | { readonly do: "name"; readonly point: string; readonly name: string; readonly comment: string; readonly sure?: boolean }
  | { readonly do: "comment" | "title"; readonly text: string }
  | ({ readonly do: "text" } & Text);

/** What a program is listed as. */
export type As = "ladder" | "il" | "st" | "numeric" | "svg" | "xml";

/** What the page asks, with a text in place of its version: the tools know which that is. */
export type Ask<K extends keyof Asks> = WithText<Asks[K]["ask"]>;
type WithText<A> = A extends { readonly version: number } ? Omit<A, "version"> & Of
  : A extends { readonly version: number | null } ? Omit<A, "version"> & { readonly of: Text | null } : A;
