// What the page and the worker with the simulated board tell each other. Nothing here but types and constants.

import type { BoardId } from "./boards";
export type { BoardId };

/** Bytes of a block of a card. */
export const BLOCK_LEN = 512;

/** How bytes look on the serial line; 8 data bits and 1 stop bit always. */
export interface SerialFormat {
  readonly baud: number;
  readonly parity: "none" | "even" | "odd";
}

/** The format of a board whose settings nobody has changed. */
export const USUAL_FORMAT: SerialFormat = { baud: 115_200, parity: "none" };

/** What an analogue input is connected to. */
export type Analogue =
  /** Nothing: a pull-up decides, and without one the pin is at ground. */
  | "open"
  | { readonly millivolts: number }
  /** A potentiometer at the supply, turned to where the converter reads this, 0 to 1023. */
  | { readonly reading: number };

/** What the page asks of the worker. */
export type Command =
  /** A board and its firmware, as the flash holds it from 0 on. It stays without power until `plug`. Comes first. Of a board
   * of the same kind before it, EEPROM, card and line are kept. */
  | { readonly kind: "firmware"; readonly board: BoardId; readonly bytes: Uint8Array }
  /** The whole EEPROM as a browser has kept it; only while there is no power. */
  | { readonly kind: "eeprom"; readonly bytes: Uint8Array }
  /** The plug goes in, or is pulled: what stood in RAM is lost, what stands in the EEPROM and on the card stays. */
  | { readonly kind: "plug"; readonly on: boolean }
  /** The plug is pulled in the middle of the next byte that the board writes to its EEPROM; `false` calls it off. */
  | { readonly kind: "plug-at-write"; readonly armed: boolean }
  /** The button RESET, pressed and let go. */
  | { readonly kind: "reset" }
  /** Button of an input of the board (`input` 1 is point 01), closed to GND or open. */
  | { readonly kind: "button"; readonly input: number; readonly closed: boolean }
  /** From now on, contacts bounce for a few milliseconds, or no longer do. */
  | { readonly kind: "bouncing"; readonly on: boolean }
  /** An analogue input of the board (`input` 0 is A 00, pin A0). */
  | { readonly kind: "analogue"; readonly input: number; readonly to: Analogue }
  /** The switch STOP: closed is STOP. */
  | { readonly kind: "stop"; readonly closed: boolean }
  /** A card, as the bytes of its image, in whole blocks; `null` pulls it out. */
  | { readonly kind: "card"; readonly image: Uint8Array | null }
  /** Simulated time for each unit of real time: 1, 0.1, 0.01, or `Infinity` for as fast as it goes. */
  | { readonly kind: "speed"; readonly factor: number }
  /** Lets time go on, or stand. It stands at first, so `run` belongs behind the first `plug`. */
  | { readonly kind: "run" }
  | { readonly kind: "pause" }
  /** While time stands: so many simulated milliseconds, and no more. */
  | { readonly kind: "step"; readonly millis: number }
  /** How bytes come and go at the page's end of the line. A board that is set otherwise reads garbage, as a real one. */
  | { readonly kind: "line"; readonly format: SerialFormat }
  /** Bytes to the board, one after the other at the rate of the line. */
  | { readonly kind: "serial"; readonly bytes: Uint8Array }
  /** What time it is there: told behind all that has happened until then. */
  | { readonly kind: "time" };

/** Why the chip began again. */
export type ResetCause = "power" | "button" | "brown-out" | "watchdog";

/** What is seen at the board. */
export interface Pins {
  /** Outputs from point 01 on: 0 is dark, 1 is bright; between them the share of time that a pin was high since the last `pins`. */
  readonly outputs: readonly number[];
  /** LED L, likewise: it flickers while the card is read. */
  readonly led: number;
  /** Bit n: the pin of input n + 1 is low, as a button that bounces has it at this moment. */
  readonly closed: number;
}

/** A pin of an output that changed its level: `at` ms after the power came. Pulses of PWM are left out. */
export interface Edge {
  readonly at: number;
  /** Of output 01: 1. */
  readonly output: number;
  readonly high: boolean;
}

/** Why a command was not obeyed. */
export type Trouble =
  /** Not Intel hex, a checksum does not fit, or more than the flash. */
  | "bad-firmware"
  /** Not of the length of the EEPROM, or the board has power. */
  | "bad-eeprom"
  /** Not of whole blocks, or none. */
  | "bad-card"
  /** No such input, voltage, speed or rate. */
  | "bad-value"
  /** A plug without a firmware. */
  | "no-firmware"
  /** The program of the chip did what no program of a chip can: a mistake of the simulation. */
  | "broken";

/** What the worker tells the page. Times are simulated milliseconds since the power came, with a fraction. */
export type Event =
  /** The worker is up and takes commands. */
  | { readonly kind: "ready" }
  /** Some 60 times a second, if something has changed that can be seen; and after `plug`. */
  | { readonly kind: "pins"; readonly at: number; readonly pins: Pins; readonly edges: readonly Edge[] }
  /** Bytes from the board, in the format of the page's end of the line. */
  | { readonly kind: "serial"; readonly at: number; readonly bytes: Uint8Array }
  /** The chip begins again. */
  | { readonly kind: "reset"; readonly cause: ResetCause }
  /** The power came or went; it goes without a command after `plug-at-write`. */
  | { readonly kind: "power"; readonly on: boolean }
  /** What the EEPROM holds now, after bytes of it have changed: for the browser to keep. */
  | { readonly kind: "eeprom"; readonly bytes: Uint8Array }
  /** The board has written this block of the card. */
  | { readonly kind: "card"; readonly block: number; readonly bytes: Uint8Array }
  /** Four times a second while time goes on: `factor` of real time was reached over the last quarter, `asked` was asked for. */
  | { readonly kind: "pace"; readonly at: number; readonly factor: number; readonly asked: number }
  /** Time stands now: after `pause`, or at the end of a `step`. */
  | { readonly kind: "paused"; readonly at: number }
  | { readonly kind: "time"; readonly at: number }
  | { readonly kind: "trouble"; readonly trouble: Trouble };
