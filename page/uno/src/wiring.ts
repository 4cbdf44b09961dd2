// Where the points of each board stand: the standard wiring (docs/numeric-code.md, "Pins").

import type { BoardId } from "./boards";
import { ATMEGA2560, ATMEGA328P, type Model, type Port } from "./chip/model";

export type Pin = readonly [port: Port, bit: number];

export interface Wiring {
  readonly chip: Model;
  /** From point 01 on. */
  readonly inputs: readonly Pin[];
  readonly outputs: readonly Pin[];
  /** From analogue input 00 on, in the order of the converter's channels. */
  readonly analogue: readonly Pin[];
  /** Closed to ground is STOP. */
  readonly stop: Pin;
  readonly led: Pin;
  /** The LED is on the clock of the card too. */
  readonly ledIsClock: boolean;
  /** Low selects the card. */
  readonly select: Pin;
  /** What makes pulses on which output, 0 is point 01: number of the timer, and its unit. */
  readonly pulses: ReadonlyMap<number, readonly [timer: number, unit: number]>;
}

const row = (port: Port, from: number, to: number): Pin[] => Array.from({ length: to - from + 1 }, (_, n) => [port, from + n] as const);

export const WIRINGS: Readonly<Record<BoardId, Wiring>> = {
  uno: {
    chip: ATMEGA328P,
    inputs: [...row("D", 2, 5), ...row("C", 0, 3)],
    outputs: [["D", 6], ["D", 7], ["B", 0], ["B", 1]],
    analogue: row("C", 0, 4),
    stop: ["C", 5],
    led: ["B", 5],
    ledIsClock: true,
    select: ["B", 2],
    pulses: new Map([[0, [0, 0]], [3, [1, 0]]]),
  },
  mega: {
    chip: ATMEGA2560,
    inputs: [...row("A", 0, 7), ...row("K", 0, 7), ...row("C", 0, 7)],
    outputs: [["E", 4], ["E", 5], ["G", 5], ["E", 3], ...row("H", 3, 6), ...row("L", 0, 7)],
    analogue: row("F", 0, 7),
    stop: ["D", 0],
    led: ["B", 7],
    ledIsClock: false,
    select: ["B", 0],
    pulses: new Map([
      [3, [3, 0]], [0, [3, 1]], [1, [3, 2]],
      [4, [4, 0]], [5, [4, 1]], [6, [4, 2]],
      [11, [5, 0]], [12, [5, 1]], [13, [5, 2]],
    ]),
  },
};
