// What the Rust of unoclp answers a page, as page/bridge has it. Nothing here but types; what may be asked is in `asks.ts`.

import type { Asks } from "./asks";

/** A text in both languages. */
export interface Both {
  readonly en: string;
  readonly pt: string;
}

/** What is wrong, where a field is with its key and what could stand in it instead. */
export interface Wrong extends Both {
  readonly field?: string;
  readonly offers?: readonly { readonly value: string; readonly say: Both; readonly sure: boolean }[];
}

export type LanguageName = "il" | "st" | "scl" | "iscl" | "lce" | "xml" | "numeric";

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

export interface Problem {
  readonly number: string;
  readonly severity: "error" | "warning";
  readonly line: number;
  readonly column: number;
  /** Units of UTF-16 from the beginning of the text. */
  readonly from: number;
  readonly to: number;
  readonly message: Both;
  readonly help: Both;
}

/** What a board has: how many there are of each kind of point, numbered from 1; analogue inputs from 0. */
export interface BoardFacts {
  /** How a request names it, and each that there is. */
  readonly id: string;
  readonly all: readonly string[];
  /** What people call it. */
  readonly name: string;
  /** Whether a board can be flashed that has this; if not, its programs run on a PC alone. */
  readonly firmware: boolean;
  /** Whether it has the instructions of REAL numbers. */
  readonly real: boolean;
  readonly inputs: number;
  readonly outputs: number;
  readonly analogue: number;
  /** The outputs that can be PWM. */
  readonly pwm: readonly number[];
  /** An input and the analogue input on the same pin: a program has the one or the other. */
  readonly shared: readonly (readonly [input: number, analogue: number])[];
  readonly markers: number;
  /** The first and the last marker that keeps its state over a power cut. */
  readonly retentive: readonly [number, number];
  readonly registers: number;
  /** Registers to this number take no memory of a program. */
  readonly nearRegisters: number;
  readonly counters: number;
  readonly timers: number;
  readonly labels: number;
  /** Bytes that a program may take as it is stored, and as it runs. */
  readonly stored: number;
  readonly linked: number;
}

export interface Uses {
  readonly inputs: readonly number[];
  readonly analogue: readonly number[];
  readonly outputs: readonly number[];
  readonly pwm: readonly number[];
  readonly markers: readonly number[];
  readonly registers: readonly number[];
  /** Those of the registers that hold REAL numbers. */
  readonly reals: readonly number[];
  readonly counters: readonly number[];
  readonly timers: readonly string[];
}

export interface Stored {
  readonly version: number;
  readonly bytes: number;
  readonly sum: number;
}

export interface Made {
  /** What stands in PROGRAM.TXT. */
  readonly code: string;
  readonly symbols: Readonly<Record<string, string>>;
  /** For each step: the line of the text, and the first and last line of PROGRAM.TXT. */
  readonly map: readonly (readonly [number, number, number])[];
  readonly size: {
    readonly codes: number;
    readonly stored: readonly [number, number];
    readonly linked: readonly [number, number];
    readonly text: Both;
  };
  readonly uses: Uses;
  readonly kept: Stored;
  /** Why it is sent to no board; null where it is written for one. */
  readonly unsent: Both | null;
  /** The boards that hold it. */
  readonly heldBy: readonly string[];
  /** What the first board lacks for it; null where one holds it. */
  readonly lacking: Both | null;
}

export interface Checked {
  readonly language: LanguageName;
  readonly problems: readonly Problem[];
  readonly more: number;
  /** The coloured parts of the text, three numbers each: units of UTF-16 since the end of the one before, its own units, and
   * 0 for a comment, 1 a text, 2 a point, 3 a number, 4 a word of the language. */
  readonly colours: readonly number[];
  readonly program: Made | null;
  /** Whether no instruction stands in it yet: one can draw the first. */
  readonly blank: boolean;
}

/** What a student learns of a case before its turn. */
export interface Case {
  readonly title: Both;
  readonly hidden: boolean;
}

/** What an exercise asks for: a program, the fault of a machine, the same program in another language. */
export type ExerciseKind = "program" | "find" | "write";

/** What an exercise says of itself. */
export interface Sheet {
  readonly kind: ExerciseKind;
  /** The program that is to be written in another language; both by the ends of the names of files. */
  readonly given: { readonly text: string; readonly language: string; readonly answerIn: string } | null;
  /** The name of its machine's file. */
  readonly plant: string | null;
  readonly title: Both;
  readonly task: Both | null;
  readonly hints: readonly Both[];
  /** What is connected to the points. */
  readonly names: Readonly<Record<string, Both>>;
  /** The inputs, from 1, whose buttons are normally closed. */
  readonly normallyClosed: readonly number[];
  /** A text in Instruction List that names what is connected, and has no instruction yet. */
  readonly begin: Both;
  readonly cases: readonly Case[];
}

export interface Outcome {
  readonly passed: boolean;
  /** The cases in order, and whether each was passed. */
  readonly cases: readonly (readonly [Case, boolean])[];
  /** The first that was not passed; of a hidden one nothing is shown. */
  readonly failing: { readonly case: number; readonly shown: Shown | null } | null;
  /** How the machine fared, where the exercise has one. */
  readonly machine: Fared | null;
}

/** How a machine fared with a program: what went wrong first, and when, in ms. */
export interface Fared {
  readonly passed: boolean;
  readonly why: Both | null;
  readonly at: number | null;
}

/** What a machine did about the time at which something went wrong. */
export interface Replayed {
  readonly from: number;
  readonly until: number;
  readonly at: number;
  /** From one picture to the next, ms. */
  readonly every: number;
  /** The first picture, and what changes with each of the others. */
  readonly svg: string;
  readonly frames: readonly MachineLook["changes"][];
  readonly diagram: string;
  /** Where its times are in the diagram: the place of the first, and how far it is to the last. */
  readonly plot: readonly [number, number];
}

/** What is shown of a case that was not passed. */
export interface Shown {
  readonly unmet: {
    readonly place: string;
    readonly expected: number;
    readonly came: number;
    readonly from: number;
    readonly to: number;
  } | null;
  readonly why: Both;
  /** The timing diagram: what was pressed, expected and came. */
  readonly svg: Both;
}

export interface CardImage {
  readonly bytes: number;
  /** Blocks that are not empty: number, and hexadecimal digits of 512 bytes. */
  readonly blocks: readonly (readonly [number, string])[];
}

/** What is shown of a running program. */
export interface Live {
  /** The nets that carry power. */
  readonly nets: readonly number[];
  readonly boxes: readonly (readonly [number, string])[];
  readonly values: readonly (readonly [number, number | null])[];
  /** For each line of the text: whether it has power, a number, or nothing. */
  readonly lines: readonly (boolean | number | string | null)[];
}

/** A point that is forced, by its number, and to what. */
export type Forced = readonly [number: number, to: boolean];

export interface Seen {
  readonly at: number;
  /** `EMPTY`: nobody has given the board a program yet. */
  readonly state: "RUN" | "STOP" | "FAULT" | "EMPTY" | "?";
  readonly switchedOff: boolean;
  readonly cardFailed: boolean;
  readonly fault: { readonly number: number; readonly line: number | null; readonly text: Both } | null;
  readonly cause: string;
  readonly scanTimes: readonly [number, number, number];
  readonly freeStack: number;
  readonly supply: number;
  readonly restarts: number;
  readonly faults: number;
  readonly kept: Stored;
  readonly same: boolean | null;
  /** The numbers of those that are 1. */
  readonly inputs: readonly number[];
  readonly outputs: readonly number[];
  /** Outputs with PWM, and what of 255; of a board nobody knows. */
  readonly dimmed: readonly (readonly [number, number])[];
  /** The numbers of those that are forced, and to what. */
  readonly forcedInputs: readonly Forced[];
  readonly forcedOutputs: readonly Forced[];
  readonly forcingEnds: number | null;
  readonly markers: readonly number[];
  readonly analogue: readonly number[];
  readonly registers: readonly number[];
  readonly timers: readonly (readonly [number, number])[];
  readonly counters: readonly (readonly [number, number])[];
  readonly live: Live | null;
}

export type News =
  | { readonly news: "found"; readonly identity: string }
  | { readonly news: "lost"; readonly why: Both }
  | ({ readonly news: "seen" } & Seen)
  | { readonly news: "sent"; readonly order: number; readonly bytes: number; readonly of: number }
  | { readonly news: "storing"; readonly order: number }
  | ({ readonly news: "stored" } & Stored)
  | ({ readonly news: "settings" } & Settings)
  | { readonly news: "done"; readonly order: number; readonly said: Both | null }
  | { readonly news: "undone"; readonly order: number; readonly why: Both };

export interface Settings {
  readonly address: number;
  readonly rate: number;
  /** 0 none, 1 even, 2 odd. */
  readonly parity: number;
  readonly direction: boolean;
  readonly lock: number | null;
}

export type Order =
  | { readonly do: "run" | "stop" | "scan" | "restart" | "release" | "settings" }
  | { readonly do: "force"; readonly output: boolean; readonly number: number; readonly to: boolean | null }
  | { readonly do: "set"; readonly point: string; readonly value: number }
  /** Of what this computer runs alone: a board has contacts and knobs of its own. */
  | { readonly do: "press"; readonly input: number; readonly closed: boolean }
  | { readonly do: "turn"; readonly input: number; readonly reading: number }
  | ({ readonly do: "upload"; readonly stay?: boolean } & Of)
  | ({ readonly do: "watch" } & Of)
  | { readonly do: "settle"; readonly settings: Settings };

export interface Step {
  readonly send: readonly number[];
  readonly until: number;
  readonly news: readonly News[];
}

/** A step of firmware on its way to a board. */
export interface FlashStep {
  readonly reset: boolean;
  readonly send: readonly number[];
  readonly until: number;
  readonly stage: "meeting" | "writing" | "comparing" | "finishing";
  readonly progress: readonly [number, number];
  readonly over: boolean;
  readonly failure: Both | null;
}

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

export interface Field {
  readonly key: string;
  readonly name: Both;
  readonly value: string;
  readonly kind: "point" | "value" | "number" | "name";
}

/** A rung of a drawing where it stands: its upper edge, and how many nets and steps there are before its own. */
export interface RungDrawn {
  readonly id: number;
  readonly top: number;
  readonly nets: number;
  readonly first: number;
  /** Null where it is as it was. Places count from its upper edge. */
  readonly drawn: { readonly svg: string; readonly places: readonly (readonly [number, Place, Rectangle])[] } | null;
}

/** What a page shows of a drawing. */
export interface Drawn {
  /** Null where it is as it was. */
  readonly sheet: {
    readonly width: number;
    readonly height: number;
    readonly rungs: readonly RungDrawn[];
  } | null;
  readonly cursor: readonly [number, number];
  readonly selected: readonly number[];
  readonly at: {
    readonly what: "rung" | "path" | "element" | "branch" | "run";
    readonly say: Both;
    readonly rung: number;
    readonly comment: string;
    readonly fields: readonly Field[];
  };
  readonly undo: number;
  readonly redo: number;
  readonly mistakes: readonly { readonly at: number | null; readonly rung: number; readonly error: boolean; readonly message: Both }[];
  readonly isProgram: boolean;
  /** The version of its text, and that; null where the drawing is not a program yet. */
  readonly version: number | null;
  readonly text: string | null;
  /** What a change loses of the text that a person has written; null: nothing. */
  readonly loses: Both | null;
  readonly title: string;
  readonly table: readonly { readonly point: string; readonly name: string; readonly comment: string }[];
  readonly copied: boolean;
}

export interface Shelf {
  readonly name: Both;
  readonly items: readonly { readonly id: string; readonly name: Both; readonly key: string; readonly face: string }[];
}

/** What a person can change of a machine's part. */
export interface Hand {
  readonly part: number;
  readonly value: number;
  /** The part's name, by which its symbol is found. */
  readonly name: string;
  readonly label: Both;
  readonly what: string;
  /** It goes back as soon as nobody holds it. */
  readonly isHeld: boolean;
  readonly low: number;
  readonly high: number;
}

/** A machine to control. */
export interface MachineFacts {
  readonly title: Both;
  readonly about: Both;
  readonly svg: string;
  readonly hands: readonly Hand[];
  /** What people call its parts, and how the file names them. */
  readonly parts: readonly Both[];
  readonly names: readonly string[];
  /** How they can fail: the part, the fault, and what to call it. */
  readonly faults: readonly (readonly [number, string, Both])[];
  /** What must never be, and what must come to be. */
  readonly rules: readonly Both[];
  /** Inputs, analogue inputs and outputs that it is wired to. */
  readonly uses: readonly [readonly number[], readonly number[], readonly number[]];
  /** Whether it is driven by PWM. */
  readonly dims: boolean;
}

/** What has changed of a machine. */
export interface MachineLook {
  readonly at: number;
  /** The element, its attribute or null for its text, and what that is now. */
  readonly changes: readonly (readonly [string, string | null, string])[];
  /** The rules that broke, and when. */
  readonly broken: readonly (readonly [number, number])[];
  readonly met: readonly number[];
  /** What can be changed by hand, as it stands. */
  readonly hands: readonly number[];
  readonly search: Searched | null;
}

/** How far somebody is who looks for the fault of a machine. */
export interface Searched {
  readonly steps: number;
  readonly tries: number;
  readonly found: boolean;
}

/** What a program is listed as. */
export type As = "ladder" | "il" | "st" | "numeric" | "svg" | "xml";

/** What the page asks, with a text in place of its version: the tools know which that is. */
export type Ask<K extends keyof Asks> = WithText<Asks[K]["ask"]>;
type WithText<A> = A extends { readonly version: number } ? Omit<A, "version"> & Of
  : A extends { readonly version: number | null } ? Omit<A, "version"> & { readonly of: Text | null } : A;
