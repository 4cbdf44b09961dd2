// The boards that a page knows. Where the points of one that is simulated stand is `wiring.ts`, what its chip has
// `chip/model.ts`.

/** Those that a firmware is for, the usual one first; a file tells them apart by these places in the list. */
export const BOARDS = ["uno", "mega"] as const;

/** A board that can be simulated. */
export type BoardId = (typeof BOARDS)[number];

/** What the files of its firmware are called, without their ends. */
export const firmwareName = (id: BoardId): string => (id === BOARDS[0] ? "unoclp" : `unoclp-${id}`);

/** The boards that firmware is for: as Rust names them, and the file of each. */
export const MODELS = [
  { name: "uno", title: "Arduino UNO", file: "unoclp.hex" },
  { name: "nano", title: "Arduino Nano", file: "unoclp-nano.hex" },
  { name: "nano-old", title: "Arduino Nano (old boot loader)", file: "unoclp-nano.hex" },
  { name: "mega", title: "Arduino Mega 2560", file: "unoclp-mega.hex" },
] as const;
