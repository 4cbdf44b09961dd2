// What may be asked of Rust, and what it answers. Made of page/bridge/src/ask/table.rs: do not edit it; the test of
// page/bridge/src/ask/contract.rs writes it where UPDATE=1 is set.

import type { Adapted, BoardFacts, CardImage, Change, Charted, Checked, Drawn, Fared, LadderDrawn, Live, MachineFacts, MachineLook, Meant, Mended, Offers, Order, Outcome, Project, Replayed, Searched, Settings, Sheet, Shelf, Step, Stood, Text, UnitShown, UsedAt } from "./answers";

export type Place = "before" | "behind" | "beside";

export type Along = "back" | "forth";

export type Direction = "left" | "right" | "up" | "down";

export type Coil = "normal" | "negated" | "set" | "reset" | "load";

export type Edge = "rising" | "falling";

export type As = "ladder" | "il" | "st" | "numeric" | "svg" | "picture" | "svg-fbd" | "xml" | "xml-fbd";

export type DrawnAs = "numeric" | "il";

export type Speak = "en" | "pt";

/** What may be done to a drawing. */
export type Act =
  | { readonly do: "undo" }
  | { readonly do: "redo" }
  /** Selects what stands around the cursor. */
  | { readonly do: "out" }
  | { readonly do: "move"; readonly to: Direction }
  | { readonly do: "select"; readonly from: number; readonly to: number }
  | { readonly do: "extend"; readonly along: Along }
  /** Inserts an element of the palette at the cursor. */
  | { readonly do: "insert"; readonly what: string; readonly place: Place }
  /** Inserts it at something else. */
  | { readonly do: "put"; readonly what: string; readonly at: number; readonly place: Place }
  | { readonly do: "branch" }
  | { readonly do: "stretch"; readonly along: Along; readonly out: boolean }
  | { readonly do: "delete" }
  | { readonly do: "copy" }
  | { readonly do: "cut" }
  | { readonly do: "paste"; readonly place: Place }
  | { readonly do: "carry"; readonly at: number; readonly place: Place }
  | { readonly do: "toggle" }
  | { readonly do: "edge"; readonly edge: Edge | null }
  | { readonly do: "coil"; readonly coil: Coil }
  | { readonly do: "insertRung"; readonly along: Along }
  | { readonly do: "moveRung"; readonly along: Along }
  | { readonly do: "split" }
  | { readonly do: "join" }
  /** Changes the fields of the element at the cursor; a person who is sure is not asked. */
  | { readonly do: "edit"; readonly fields: readonly { readonly key: string; readonly value: string }[]; readonly sure?: boolean | undefined }
  /** Says what a point is called and what it is for; likewise. */
  | { readonly do: "name"; readonly point: string; readonly name: string; readonly comment: string; readonly sure?: boolean | undefined }
  | { readonly do: "comment"; readonly text: string }
  | { readonly do: "title"; readonly text: string }
  /** Another text in place of this one. */
  | { readonly do: "text"; readonly name: string; readonly text: string };

/** What may be ordered of a board. */
export type OrderGiven =
  /** RUN, from the beginning. */
  | { readonly do: "run" }
  | { readonly do: "stop" }
  /** One single scan; a board in RUN stops for it. */
  | { readonly do: "scan" }
  /** The whole start-up again. */
  | { readonly do: "restart" }
  /** Lets all points go. */
  | { readonly do: "release" }
  /** Tells the program that the board keeps, as numeric code. */
  | { readonly do: "fetch" }
  /** Tells the settings. */
  | { readonly do: "settings" }
  /** Forces an input or output, from 1, or lets it go. */
  | { readonly do: "force"; readonly output: boolean; readonly number: number; readonly to: boolean | null }
  /** Of what this computer runs alone: a board has contacts and knobs of its own. */
  | { readonly do: "press"; readonly input: number; readonly closed: boolean }
  | { readonly do: "turn"; readonly input: number; readonly reading: number }
  /** Sets an output, a marker, a register or a preset once. */
  | { readonly do: "set"; readonly point: string; readonly value: number }
  /** Puts this program on the board, and watches it from then on. It runs then, unless it stays in STOP. */
  | { readonly do: "upload"; readonly version: number; readonly stay?: boolean | undefined }
  /** Watches this program from now on; it is said to be on the board. */
  | { readonly do: "watch"; readonly version: number }
  /** Changes the settings: the lock holds at once, all else from the next start on. */
  | { readonly do: "settle"; readonly settings: Settings }
  /** Writes a firmware, as Intel hex, by the boot loader of this kind of board. */
  | { readonly do: "flash"; readonly hex: string; readonly model: string };

export interface Asks {
  /** What a board has: each limit of its points and its memory, so that a page needs to know none. */
  board: { ask: { readonly board?: string | undefined }; answer: BoardFacts };
  /** The version of a text: all else that is asked of it names that. */
  text: { ask: { readonly name: string; readonly text: string; readonly board?: string | undefined }; answer: number };
  /** What there is to say of a text: its problems, or its program. */
  check: { ask: { readonly version: number }; answer: Checked };
  /** Its ladder, for a page that shows it live, in so many columns where that is enough; or the same as a block diagram. */
  ladder: { ask: { readonly version: number; readonly width: number; readonly isBlocks?: boolean | undefined; readonly speak?: Speak | undefined }; answer: LadderDrawn };
  /** A conversation with a board, which is said to run this text; `core`: this computer runs its programs, and there is no line. */
  open: { ask: { readonly version: number | null; readonly reset: boolean; readonly core?: boolean | undefined; readonly board?: string | undefined; readonly address?: number | undefined; readonly rate?: number | undefined; readonly parity?: number | undefined }; answer: number };
  /** A step of it: what has come since the last one, at this time in ms since any moment. */
  step: { ask: { readonly board: number; readonly now: number; readonly came: readonly number[] }; answer: Step };
  /** Something to be done by the board. */
  order: { ask: { readonly board: number; readonly order: Order }; answer: number };
  /** The line is gone, and why. */
  lose: { ask: { readonly board: number; readonly why: string }; answer: null };
  /** The end of a conversation. */
  close: { ask: { readonly board: number }; answer: null };
  /** Its program in another form. Instruction List that is made is compiled again, by all that there is. */
  list: { ask: { readonly version: number; readonly as: As; readonly width: number; readonly speak?: Speak | undefined }; answer: string };
  /** A text of another PLC with free points in the place of those that its board lacks, and those that found none; null in a language whose points are names of its own. */
  adapt: { ask: { readonly version: number }; answer: Adapted | null };
  /** The ladder on pages of paper. */
  pages: { ask: { readonly version: number; readonly letter: boolean; readonly width: number; readonly speak?: Speak | undefined }; answer: readonly string[] };
  /** What an exercise asks. */
  sheet: { ask: { readonly title: string; readonly scenario: string; readonly board?: string | undefined }; answer: Sheet };
  /** Whether its program does what the cases of a scenario file expect, and its machine too. */
  exercise: { ask: { readonly version: number; readonly title: string; readonly scenario: string; readonly plant?: string | undefined; readonly plantText?: string | undefined }; answer: Outcome };
  /** Whether its program does what a machine asks, through the script of that. */
  trial: { ask: { readonly version: number; readonly plant: string; readonly plantText: string }; answer: Fared };
  /** A number for all that a machine is with it in each of so many ms. */
  trace: { ask: { readonly version: number; readonly plant: string; readonly plantText: string; readonly ms: number }; answer: string };
  /** What a machine did with it about a time at which something went wrong. */
  replay: { ask: { readonly version: number; readonly plant: string; readonly plantText: string; readonly scenario?: string | undefined; readonly at: number; readonly why: string; readonly speak?: Speak | undefined }; answer: Replayed };
  /** The picture of a machine that stands. */
  picture: { ask: { readonly name: string; readonly text: string; readonly board?: string | undefined; readonly speak?: Speak | undefined }; answer: string };
  /** The image of a card with this PROGRAM.TXT. */
  card: { ask: { readonly program: string; readonly state: boolean; readonly board?: string | undefined }; answer: CardImage };
  /** A file of a card, by its name, from the blocks that are not empty; null where there is none. */
  read: { ask: { readonly blocks: CardImage["blocks"]; readonly name: string }; answer: string | null };
  /** Bytes that are free on a card; null where it has no FAT16 or FAT32. */
  free: { ask: { readonly blocks: CardImage["blocks"] }; answer: number | null };
  /** A machine to control, from its file; it stands until it is stepped. `keep`: the one that is open goes on, and is told in this language; `find`: a scenario that hides a fault in it. */
  machine: { ask: { readonly name: string; readonly text: string; readonly speak?: Speak | undefined; readonly keep?: boolean | undefined; readonly find?: string | undefined; readonly board?: string | undefined }; answer: MachineFacts };
  /** What has changed of its picture. */
  machineLook: { ask: object; answer: MachineLook };
  /** A person there changes something. */
  machineHand: { ask: { readonly part: number; readonly value: number; readonly to: number }; answer: null };
  /** A part of it fails, or is mended. */
  machineFault: { ask: { readonly part: number; readonly fault: string; readonly is: boolean }; answer: null };
  /** A person forces a point of the board: a step of a search. */
  machineForced: { ask: object; answer: null };
  /** A person names the fault that is hidden in it; how far they are. */
  machineName: { ask: { readonly part: number; readonly fault: string }; answer: Searched | null };
  /** As it was at first. */
  machineReset: { ask: object; answer: null };
  /** There is none any longer. */
  machineClose: { ask: object; answer: null };
  /** The elements that can be drawn. */
  palette: { ask: object; answer: readonly Shelf[] };
  /** A drawing, of a text and what was done to it; `name`: what its file is called now; `isBlocks`: as a block diagram. */
  draw: { ask: { readonly base: Text; readonly log: readonly Act[]; readonly name?: string | undefined; readonly board?: string | undefined; readonly width: number; readonly isBlocks?: boolean | undefined; readonly speak?: Speak | undefined }; answer: Drawn };
  /** Something done to it; what a page shows of it then. */
  edit: { ask: { readonly act: Act | null; readonly name?: string | undefined; readonly board?: string | undefined; readonly width: number; readonly isBlocks?: boolean | undefined; readonly speak?: Speak | undefined }; answer: Drawn };
  /** Its text in another form. */
  drawn: { ask: { readonly as: DrawnAs }; answer: string };
  /** What of it has these words in it. */
  find: { ask: { readonly words: string }; answer: readonly number[] };
  /** What may stand at a place of a text, in units of UTF-16 from its beginning. */
  complete: { ask: { readonly version: number; readonly at: number; readonly speak?: Speak | undefined }; answer: Offers };
  /** What stands there; null where nothing is known of it. */
  meant: { ask: { readonly version: number; readonly at: number; readonly speak?: Speak | undefined }; answer: Meant | null };
  /** Where that is used, its declaration among them. */
  uses: { ask: { readonly version: number; readonly at: number }; answer: readonly UsedAt[] };
  /** What gives the name there another. */
  rename: { ask: { readonly version: number; readonly at: number; readonly to: string }; answer: readonly Change[] };
  /** What places the words of a text well. */
  form: { ask: { readonly version: number }; answer: readonly Change[] };
  /** What can be done about the mistakes between two places. */
  remedies: { ask: { readonly version: number; readonly from: number; readonly to: number; readonly speak?: Speak | undefined }; answer: readonly Mended[] };
  /** Its charts, in the look of IEC 61131-3 or of GRAFCET; `what` is done `at` a part of one of them, and gives another text. */
  chart: { ask: { readonly version: number; readonly look?: string | undefined; readonly chart: number; readonly what?: string | undefined; readonly at?: string | undefined; readonly say?: string | undefined; readonly qualifier?: string | undefined; readonly time?: string | undefined }; answer: Charted };
  /** What there is to show of it while a board stands in the middle of a scan, which has left this so far. */
  slow: { ask: { readonly version: number; readonly left: readonly (readonly [from: number, to: number, acc: boolean, value: number | null, inputs: number | null, outputs: number | null])[] }; answer: Live };
  /** The scan that this computer makes goes on, to where one of these instructions comes next, or any; `through` the ends of scans, or else to the end of this one. Null where it has not come there yet. */
  slowly: { ask: { readonly board: number; readonly to: readonly number[] | null; readonly through: boolean }; answer: Stood | null };
  /** The units of a project, and their variables. */
  project: { ask: { readonly version: number }; answer: Project };
  /** The body of a unit of a project; null where it has none. */
  unit: { ask: { readonly version: number; readonly unit: string }; answer: UnitShown | null };
  /** A project in which something is another: of a variable of a unit, or a global one, `name`, `kind`, `first`, `place`, `comment`, `retained`, or all of it by `add` and `remove`; of an element of a drawn body `written`, `negated`, `edge`, `storage`; the `body` of a unit in text. */
  alter: { ask: { readonly version: number; readonly unit?: string | undefined; readonly what: string; readonly at: string; readonly to: string }; answer: string };
}
