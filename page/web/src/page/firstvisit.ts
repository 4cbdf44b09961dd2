// The first visit: a machine that moves, its program running. Who has been here finds what they left, and a link what it holds.

import type { Text } from "../tools/answers";
import type { Bench } from "./bench";
import { keep, kept } from "./kept";
import type { ListedMachine } from "./listed";
import type { MachineArea } from "./machine";
import { keptHere } from "./place";
import { sharedToken } from "./shared";

/** What is shown: it moves without being touched. */
const SHOWN = "crossing.toml";
const KEY = "greeted";

/** Whether nobody has been here before; to be asked before anything is kept. */
export function isFirstVisit(): boolean {
  return kept(KEY) !== "yes" && keptHere("program") === null && location.hash === "" && sharedToken() === null;
}

interface Shown {
  readonly bench: Bench;
  readonly machine: MachineArea;
  readonly machines: Promise<readonly ListedMachine[]>;
  /** Whether the program is still the one that the page began with. */
  isUntouched(): boolean;
  put(text: Text): void;
  run(): Promise<void>;
}

export async function greet({ bench, machine, machines, isUntouched, put, run }: Shown): Promise<void> {
  const listed = (await machines).find(({ name }) => name === SHOWN);
  if (!listed?.solution || !isUntouched()) return;
  keep(KEY, "yes");
  put(listed.solution);
  await machine.open(listed);
  await new Promise<void>((found) => bench.identity.follow((identity) => identity !== null && found()));
  await run();
}
