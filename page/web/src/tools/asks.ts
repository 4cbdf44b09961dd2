// What may be asked of Rust, and what it answers. Made of page/bridge/src/ask/table.rs: do not edit it; the test of
// page/bridge/src/ask/contract.rs writes it where UPDATE=1 is set.

import type { Act, Adapted, As, BoardFacts, CardImage, Charted, Checked, Drawn, Fared, FlashStep, LadderDrawn, MachineFacts, MachineLook, Order, Outcome, Replayed, Searched, Sheet, Shelf, Speak, Step, Text } from "./answers";

export interface Asks {
  /** What a board has: each limit of its points and its memory, so that a page needs to know none. */
  board: { ask: { readonly board?: string | undefined }; answer: BoardFacts };
  /** The version of a text: all else that is asked of it names that. */
  text: { ask: { readonly name: string; readonly text: string; readonly board?: string | undefined }; answer: number };
  /** What there is to say of a text: its problems, or its program. */
  check: { ask: { readonly version: number }; answer: Checked };
  /** Its ladder, for a page that shows it live, in so many columns where that is enough. */
  ladder: { ask: { readonly version: number; readonly width: number; readonly speak?: Speak | undefined }; answer: LadderDrawn };
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
  /** Firmware for a board, as Intel hex; the answer is the rate of its boot loader. */
  flash: { ask: { readonly hex: string; readonly model: string }; answer: number };
  /** A step of that. */
  flashStep: { ask: { readonly now: number; readonly came: readonly number[] }; answer: FlashStep };
  /** The line is gone meanwhile, and why. */
  flashLose: { ask: { readonly why: string }; answer: null };
  /** The elements that can be drawn. */
  palette: { ask: object; answer: readonly Shelf[] };
  /** A drawing, of a text and what was done to it; `name`: what its file is called now. */
  draw: { ask: { readonly base: Text; readonly log: readonly Act[]; readonly name?: string | undefined; readonly board?: string | undefined; readonly width: number; readonly speak?: Speak | undefined }; answer: Drawn };
  /** Something done to it; what a page shows of it then. */
  edit: { ask: { readonly act: Act | null; readonly name?: string | undefined; readonly board?: string | undefined; readonly width: number; readonly speak?: Speak | undefined }; answer: Drawn };
  /** Its text in another form. */
  drawn: { ask: { readonly as: string }; answer: string };
  /** What of it has these words in it. */
  find: { ask: { readonly words: string }; answer: readonly number[] };
  /** Its charts, in the look of IEC 61131-3 or of GRAFCET; `what` is done `at` a part of one of them, and gives another text. */
  chart: { ask: { readonly version: number; readonly look?: string | undefined; readonly chart: number; readonly what?: string | undefined; readonly at?: string | undefined; readonly say?: string | undefined; readonly qualifier?: string | undefined; readonly time?: string | undefined }; answer: Charted };
}
