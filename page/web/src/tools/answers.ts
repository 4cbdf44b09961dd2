// What Rust answers. Made of the types of page/bridge: do not edit it; the test of
// page/bridge/src/answer/contract.rs writes it where UPDATE=1 is set.

import type { LanguageName, Place, Rectangle } from "./said";

export type * from "./said";

/** A text with free points in the place of those that its board lacks. */
export interface Adapted {
  readonly text: string;
  /** Those for which the board has no place left, as the text writes them. */
  readonly left: readonly string[];
}

/** What is at the cursor. */
export interface At {
  readonly what: "rung" | "path" | "element" | "branch" | "run";
  /** What a person hears of it. */
  readonly say: Both;
  /** Its rung, from 1. */
  readonly rung: number;
  /** What its rung is about. */
  readonly comment: string;
  /** What of it can be changed. */
  readonly fields: readonly Field[];
}

/** What a board has. */
export interface BoardFacts {
  /** How a request names it. */
  readonly id: string;
  /** What people call it. */
  readonly name: string;
  /** How a request names each that there is. */
  readonly all: readonly [string, string, string, string];
  /** Whether a board can be flashed that has this; if not, its programs run on a PC alone. */
  readonly firmware: boolean;
  /** Whether it has the instructions of REAL numbers. */
  readonly real: boolean;
  /** Inputs 01 to this number. */
  readonly inputs: number;
  /** Outputs 01 to this number. */
  readonly outputs: number;
  /** Analogue inputs A 00 to below this number. */
  readonly analogue: number;
  /** The outputs that can be PWM. */
  readonly pwm: readonly number[];
  /** An input and the analogue input on the same pin: a program has the one or the other. */
  readonly shared: readonly (readonly [number, number])[];
  /** Markers M 01 to this number. */
  readonly markers: number;
  /** The first and the last marker that keeps its state over a power cut. */
  readonly retentive: readonly [number, number];
  /** Registers D 01 to this number. */
  readonly registers: number;
  /** Registers D 01 to this number take no memory of a program. */
  readonly nearRegisters: number;
  /** Counters C 01 to this number. */
  readonly counters: number;
  /** Timers of a program. */
  readonly timers: number;
  /** Labels 01 to this number. */
  readonly labels: number;
  /** Bytes of a program's stored form. */
  readonly stored: number;
  /** Bytes of its linked form and its data. */
  readonly linked: number;
}

/** A text in both languages. */
export interface Both {
  readonly en: string;
  readonly pt: string;
}

/** A card. */
export interface CardImage {
  /** Of the whole card. */
  readonly bytes: number;
  /** Those that are not empty: number, and hexadecimal digits of 512 bytes. */
  readonly blocks: readonly (readonly [number, string])[];
}

/** What a student learns of a case before its turn. */
export interface Case {
  readonly title: Both;
  readonly hidden: boolean;
}

/** A change of a text. */
export interface Change {
  readonly from: number;
  readonly to: number;
  readonly insert: string;
}

/** A chart. */
export interface ChartDrawn {
  /** The unit that it is the body of. */
  readonly unit: string;
  /** The element. */
  readonly svg: string;
  /** What is on it, from top to bottom along its lines. */
  readonly parts: readonly ChartPart[];
  /** The points of each step: whether it is active, and its time; none while the text is no program. */
  readonly points: readonly (readonly [string | null, string | null])[];
}

/** A part of a chart, and what can be changed of it. */
export interface ChartPart {
  readonly id: string;
  readonly kind: string;
  /** Its middle, in the units of the drawing. */
  readonly x: number;
  readonly y: number;
  /** The step, the action, the step that a jump leads to, or the name of a transition. */
  readonly name: string;
  /** A condition, or the body of an action. */
  readonly text: string;
  readonly qualifier: string;
  readonly time: string;
  readonly priority: string;
  readonly initial: boolean;
  /** The numbers of the steps that a transition leaves. */
  readonly from: readonly number[];
  /** Where it stands in the text, and where the statements of its action do: units of UTF-16, from and to. */
  readonly places: readonly (readonly [number, number])[];
  /** The instructions that it has become, from 0; none while the text is no program. */
  readonly steps: readonly number[];
}

/** The charts of a text. */
export interface Charted {
  readonly charts: readonly ChartDrawn[];
  /** The text after what was done. */
  readonly text: string | null;
  /** What is selected then. */
  readonly select: string | null;
}

/** What there is to say of a text. */
export interface Checked {
  /** `il`, `st`, `scl`, `iscl`, `lce`, `numeric`; empty for a text in none of them. */
  readonly language: LanguageName;
  readonly problems: readonly Problem[];
  /** How many more there are. */
  readonly more: number;
  /** The coloured parts of the text, each by three numbers: units of UTF-16 since the end of the one before, its own units, and what it is (`tell::colours`). */
  readonly colours: readonly number[];
  /** None where the text has errors. */
  readonly program: Made | null;
  /** Whether no instruction stands in it yet: one can draw the first. */
  readonly blank: boolean;
}

/** What a page shows. */
export interface Drawn {
  /** Left out where it is as it was. */
  readonly sheet: DrawnSheet | null;
  readonly cursor: readonly [number, number];
  /** All that is selected. */
  readonly selected: readonly number[];
  readonly at: At;
  /** How many changes can be undone, and done again. */
  readonly undo: number;
  readonly redo: number;
  readonly mistakes: readonly Mistake[];
  /** Whether the drawing is a program. */
  readonly isProgram: boolean;
  /** The version of its text, and that; none where it is not a program. */
  readonly version: number | null;
  readonly text: string | null;
  /** What a change loses of the text that a person has written; none: nothing. */
  readonly loses: Both | null;
  readonly title: string;
  readonly table: readonly Named[];
  /** Whether there is something to paste. */
  readonly copied: boolean;
}

/** The drawing. */
export interface DrawnSheet {
  readonly width: number;
  readonly height: number;
  readonly rungs: readonly RungDrawn[];
}

/** An element of the palette. */
export interface Entry {
  /** What `insert` and `put` take. */
  readonly id: string;
  readonly name: Both;
  /** The key that inserts it; empty without one. */
  readonly key: string;
  /** What is on its button. */
  readonly face: string;
}

/** What an exercise asks for. */
export type ExerciseKind =
  | "program"
  | "find"
  | "write";

/** The first case that was not passed. */
export interface Failing {
  /** Its place among the cases, from 0. */
  readonly case: number;
  /** None of a hidden case. */
  readonly shown: Shown | null;
}

/** How a machine fared with a program. */
export interface Fared {
  readonly passed: boolean;
  /** What went wrong first: when, and which rule. */
  readonly why: Both | null;
  /** When, ms after the first scan; none where the program did not run at all. */
  readonly at: number | null;
}

/** A field with what is in it. */
export interface Field {
  readonly key: string;
  readonly name: Both;
  readonly value: string;
  /** `point`: an address or a name; `value`: that or a number. */
  readonly kind: "point" | "value" | "number" | "name";
}

/** A program that is to be written in another language. */
export interface GivenProgram {
  readonly text: string;
  /** Its language, and the one to write it in, by the ends of the names of files. */
  readonly language: LanguageName;
  readonly answerIn: LanguageName;
}

/** What a person there can change of a part. */
export interface Hand {
  readonly part: number;
  readonly value: number;
  /** The part's name, by which its symbol is found. */
  readonly name: string;
  readonly label: Both;
  /** What it is: `pressed`, `turned`. */
  readonly what: string;
  /** Whether it goes back as soon as nobody holds it. */
  readonly isHeld: boolean;
  readonly low: number;
  readonly high: number;
}

/** A drawing of a page. */
export interface LadderDrawn {
  /** The element. */
  readonly svg: string;
  /** Whether it is the code of a compiler, which no person would draw. */
  readonly code: boolean;
}

/** What is shown live. */
export interface Live {
  /** The nets that carry power. */
  readonly nets: readonly number[];
  /** Steps of timers and counters, their presets and what they have come to. */
  readonly boxes: readonly (readonly [number, string, string])[];
  /** Steps, and the value after them. */
  readonly values: readonly (readonly [number, number])[];
  /** For each line of the text: null, whether it has power, a number, or the literal of another type: `T#1s`. */
  readonly lines: readonly (boolean | number | string | null)[];
}

/** A machine as a page gets to know it. */
export interface MachineFacts {
  readonly title: Both;
  readonly about: Both;
  /** The board that it is wired to. */
  readonly board: string;
  readonly svg: string;
  /** What a person there can change. */
  readonly hands: readonly Hand[];
  /** What people call its parts, and how the file names them. */
  readonly parts: readonly Both[];
  readonly names: readonly string[];
  /** How they can fail: the part, the fault, and what to call it. */
  readonly faults: readonly (readonly [number, string, Both])[];
  /** What must never be, and what must come to be. */
  readonly rules: readonly Both[];
  /** The inputs that it switches, the analogue inputs that it sets, the outputs that drive it. */
  readonly uses: readonly [readonly number[], readonly number[], readonly number[]];
  /** Whether it is driven by PWM. */
  readonly dims: boolean;
}

/** What has changed of it. */
export interface MachineLook {
  /** ms since it began. */
  readonly at: number;
  readonly changes: readonly (readonly [string, string | null, string])[];
  /** The rules that broke, by number, and when. */
  readonly broken: readonly (readonly [number, number])[];
  /** How often each goal was met. */
  readonly met: readonly number[];
  /** What can be changed by hand, as it stands. */
  readonly hands: readonly number[];
  /** How far somebody is who looks for its fault, where that is the task. */
  readonly search: Searched | null;
}

/** What has become of a text. */
export interface Made {
  /** What stands in PROGRAM.TXT. */
  readonly code: string;
  /** What the text calls its points. */
  readonly symbols: Readonly<Record<string, string>>;
  /** For each step: the line of the text, from 1, and the first and last line of PROGRAM.TXT. */
  readonly map: readonly (readonly [number, number, number])[];
  readonly size: Size;
  readonly uses: Uses;
  /** How a board keeps it. */
  readonly kept: Stored;
  /** Why it is sent to no board; none where it is written for one. */
  readonly unsent: Both | null;
  /** The boards that hold it. */
  readonly heldBy: readonly string[];
  /** What the first board lacks for it; none where one holds it. */
  readonly lacking: Both | null;
}

/** What a word stands for. */
export interface Meant {
  readonly from: number;
  readonly to: number;
  readonly head: string;
  readonly lines: readonly string[];
  /** The variable or point whose live value it is. */
  readonly value: string | null;
}

/** A way to mend a mistake. */
export interface Mended {
  readonly title: string;
  readonly changes: readonly Change[];
}

/** A mistake. */
export interface Mistake {
  readonly at: number | null;
  /** Its rung, from 1. */
  readonly rung: number;
  readonly error: boolean;
  readonly message: Both;
}

/** A row of the symbol table. */
export interface Named {
  readonly point: string;
  readonly name: string;
  readonly comment: string;
}

/** What a page is told. */
export type News =
  /** A board has answered; and which it is, as a request names it, where that is known. */
  | { readonly news: "found"; readonly identity: string; readonly board: string | null }
  /** There is no board, or no longer one. It is sought on. */
  | { readonly news: "lost"; readonly why: Both }
  /** All that there is to show. */
  | ({ readonly news: "seen" } & Seen)
  /** So many bytes of an upload have been sent. */
  | { readonly news: "sent"; readonly order: number; readonly bytes: number; readonly of: number }
  /** The board stores what was uploaded. */
  | { readonly news: "storing"; readonly order: number }
  /** So many requests of so many have been answered on the way of a firmware. */
  | { readonly news: "flashing"; readonly order: number; readonly done: number; readonly of: number }
  /** What the board keeps since an upload. */
  | ({ readonly news: "stored" } & Stored)
  /** The program that the board keeps, as numeric code. */
  | { readonly news: "fetched"; readonly order: number; readonly code: string }
  /** What the board keeps for its next start. */
  | ({ readonly news: "settings" } & Settings)
  /** Something ordered was done, and what there is to say of it. */
  | { readonly news: "done"; readonly order: number; readonly said: Both | null }
  /** Something ordered was not done, and why. */
  | { readonly news: "undone"; readonly order: number; readonly why: Both };

/** Something that may stand there. */
export interface Offer {
  readonly label: string;
  readonly kind: "variable" | "property" | "function" | "type" | "enum" | "constant" | "keyword";
  /** Its type, or what it takes. */
  readonly detail: string;
  /** What is written, where that is not the label. */
  readonly insert: string | null;
}

/** What may stand at a place. */
export interface Offers {
  /** Where the word begins that is written there, units of UTF-16 from the beginning of the text. */
  readonly from: number;
  readonly offers: readonly Offer[];
}

/** What came of a check. */
export interface Outcome {
  readonly passed: boolean;
  /** The cases in order, and whether each was passed. */
  readonly cases: readonly (readonly [Case, boolean])[];
  readonly failing: Failing | null;
  /** How the machine of the exercise fared, where it has one. */
  readonly machine: Fared | null;
}

/** What is wrong with a text, or worth a second look. */
export interface Problem {
  /** `IL-11`, `ST-101`, or the number of a fault. */
  readonly number: string;
  /** `error` or `warning`. */
  readonly severity: "error" | "warning";
  /** From 1; a column is a character. */
  readonly line: number;
  readonly column: number;
  /** Units of UTF-16 from the beginning of the text. */
  readonly from: number;
  readonly to: number;
  readonly message: Both;
  /** What to do; empty where there is nothing to say. */
  readonly help: Both;
}

/** A project. */
export interface Project {
  readonly name: string;
  readonly types: readonly string[];
  readonly globals: readonly ProjectRow[];
  readonly units: readonly ProjectUnit[];
}

/** A variable. */
export interface ProjectRow {
  readonly name: string;
  /** The element that declares it and others: `localVars`. */
  readonly section: string;
  readonly kind: string;
  readonly first: string | null;
  readonly place: string | null;
  readonly retained: boolean;
  readonly constant: boolean;
  readonly comment: string;
  /** Where it stands in the file, units of UTF-16. */
  readonly from: number;
  readonly to: number;
}

/** A program, a function block or a function. */
export interface ProjectUnit {
  readonly name: string;
  /** `program`, `functionBlock`, `function`. */
  readonly kind: string;
  /** `LD`; empty where it has no body. */
  readonly language: string;
  /** What a function gives. */
  readonly gives: string | null;
  readonly comment: string;
  readonly variables: readonly ProjectRow[];
  /** Where it begins in the file, units of UTF-16. */
  readonly from: number;
}

/** A moment of a machine. */
export interface Replayed {
  /** The first of its times and the last, ms after the first scan, and when it went wrong. */
  readonly from: number;
  readonly until: number;
  readonly at: number;
  /** From one picture to the next, ms. */
  readonly every: number;
  /** The first picture. */
  readonly svg: string;
  /** What changes with each of the others. */
  readonly frames: readonly (readonly (readonly [string, string | null, string])[])[];
  /** The timing diagram, and where its times are in it: the place of the first, and how far it is to the last. */
  readonly diagram: string;
  readonly plot: readonly [number, number];
}

/** A rung wherever it stands. */
export interface RungDrawing {
  readonly svg: string;
  readonly places: readonly (readonly [number, Place, Rectangle])[];
}

/** A rung where it stands: its upper edge, and how many nets and steps there are before its own. */
export interface RungDrawn {
  readonly id: number;
  readonly top: number;
  readonly nets: number;
  readonly first: number;
  /** Left out where it is as it was. */
  readonly drawn: RungDrawing | null;
}

/** How far somebody is who looks for its fault. */
export interface Searched {
  readonly steps: number;
  readonly tries: number;
  readonly found: boolean;
}

/** A reading. */
export interface Seen {
  /** ms since the board's start. */
  readonly at: number;
  /** `RUN`, `STOP`, `FAULT`; `EMPTY`: nobody has given it a program yet. */
  readonly state: "RUN" | "STOP" | "FAULT" | "EMPTY" | "?";
  readonly switchedOff: boolean;
  readonly cardFailed: boolean;
  readonly fault: Trouble | null;
  readonly cause: string;
  /** µs: last, least, most. */
  readonly scanTimes: readonly [number, number, number];
  readonly freeStack: number;
  readonly supply: number;
  readonly restarts: number;
  readonly faults: number;
  readonly kept: Stored;
  /** Whether the board keeps the program that is watched; none: none is. */
  readonly same: boolean | null;
  /** The numbers of those that are 1. */
  readonly inputs: readonly number[];
  readonly outputs: readonly number[];
  /** Outputs with PWM, and what of 255; those of the core alone, since a line tells none. */
  readonly dimmed: readonly (readonly [number, number])[];
  /** The numbers of those that are forced, and to what. */
  readonly forcedInputs: readonly (readonly [number, boolean])[];
  readonly forcedOutputs: readonly (readonly [number, boolean])[];
  /** Seconds without a request that end it; 0, 255: none do. */
  readonly forcingEnds: number | null;
  /** The numbers of those that are 1. */
  readonly markers: readonly number[];
  readonly analogue: readonly number[];
  /** From 01 on. */
  readonly registers: readonly number[];
  /** Elapsed and preset, from 01 on. */
  readonly timers: readonly (readonly [number, number])[];
  readonly counters: readonly (readonly [number, number])[];
  /** None where another program runs than the one that is watched, or none does. */
  readonly live: Live | null;
}

/** The settings as a page has them. */
export interface Settings {
  readonly address: number;
  readonly rate: number;
  /** 0 none, 1 even, 2 odd. */
  readonly parity: number;
  readonly direction: boolean;
  readonly lock: number | null;
}

/** What an exercise says of itself. */
export interface Sheet {
  readonly kind: ExerciseKind;
  /** The program that is to be written in another language. */
  readonly given: GivenProgram | null;
  /** The name of its machine's file, where it has one. */
  readonly plant: string | null;
  /** The board that it is for, where it names one. */
  readonly board: string | null;
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

/** A group of the palette. */
export interface Shelf {
  readonly name: Both;
  readonly items: readonly Entry[];
}

/** What is shown of a case that was not passed. */
export interface Shown {
  /** What was not as expected first, if it was a place. */
  readonly unmet: Unmet | null;
  /** Why it was not passed, in a line. */
  readonly why: Both;
  /** Its timing diagram. */
  readonly svg: Both;
}

/** How much of the board it takes: bytes. */
export interface Size {
  readonly stored: number;
  /** How many there are. */
  readonly all: number;
}

/** A step of a conversation. */
export interface Step {
  /** How bytes are sent from now on, bits per second, */
  readonly rate: number;
  /** and 0 without parity, 1 even, 2 odd. */
  readonly parity: number;
  /** First reset the board, and throw away what has come before. */
  readonly reset: boolean;
  /** Then send this. */
  readonly send: readonly number[];
  /** The next step comes at this time, in whole ms, or as soon as bytes have come or something is ordered. */
  readonly until: number;
  readonly news: readonly News[];
}

/** How the core stands in the middle of a scan. */
export interface Stood {
  /** The instruction that comes next, from 0; none at the end of a scan. */
  readonly step: number | null;
  /** Those from it to before this one are run at once. */
  readonly until: number;
  readonly acc: boolean;
  readonly value: number;
  /** What is pushed, the last first. */
  readonly pushed: readonly number[];
  /** Bit n: input n + 1, as the scan has it, and as it is at its contact; likewise the outputs. */
  readonly inputs: number;
  readonly closed: number;
  readonly outputs: number;
  readonly driven: number;
  readonly live: Live | null;
}

/** How a board keeps a program. */
export interface Stored {
  readonly version: number;
  readonly bytes: number;
  readonly sum: number;
}

/** A fault. */
export interface Trouble {
  readonly number: number;
  /** Of the text of the program that is watched. */
  readonly line: number | null;
  readonly text: Both;
}

/** An element of a drawn body. */
export interface UnitElement {
  /** Its number in the file. */
  readonly id: string;
  /** The name of its element: `contact`. */
  readonly kind: string;
  readonly written: string;
  readonly negated: boolean;
  /** `rising`, `falling`; else empty. */
  readonly edge: string;
  /** `set`, `reset`; else empty. */
  readonly storage: string;
  /** Where it stands in the file, units of UTF-16. */
  readonly from: number;
  readonly to: number;
}

/** The body of a unit. */
export interface UnitShown {
  readonly language: string;
  /** Of ST and IL. */
  readonly text: string;
  /** Of LD and FBD. */
  readonly svg: string;
  readonly elements: readonly UnitElement[];
}

/** A place that was not as expected for a while. */
export interface Unmet {
  readonly place: string;
  readonly expected: number;
  readonly came: number;
  /** ms after the first scan. */
  readonly from: number;
  readonly to: number;
}

/** A place at which a name is used. */
export interface UsedAt {
  /** From 1. */
  readonly line: number;
  readonly from: number;
  readonly to: number;
  readonly declares: boolean;
  readonly writes: boolean;
}

/** The numbers that it names. */
export interface Uses {
  readonly inputs: readonly number[];
  readonly analogue: readonly number[];
  readonly outputs: readonly number[];
  readonly pwm: readonly number[];
  readonly markers: readonly number[];
  readonly registers: readonly number[];
  readonly reals: readonly number[];
  readonly counters: readonly number[];
  /** What each timer does, from T 01 on: `TON`, `TOF`, `TP` … */
  readonly timers: readonly string[];
}
