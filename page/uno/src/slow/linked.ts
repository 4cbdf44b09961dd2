// Which byte of the linked code begins which instruction of the program. Nobody but the firmware is asked: another board with
// the same flash and the same EEPROM starts, and is watched while it links.

import type { Board, Witness } from "../board";
import { Y, SP, displacement, pair } from "../chip/operands";
import { CYCLES_PER_MS } from "../chip/registers";

/** Byte addresses of the firmware, by the symbols of its map. */
export interface Places {
  /** The linker, and its parts: an instruction, what is pending is put, a byte is put. */
  readonly engine_link: number;
  readonly link_one: number;
  readonly link_flush: number;
  readonly link_put: number;
  /** The handler of the end. */
  readonly engine_end: number;
  readonly scan_begin: number;
  /** Where inputs from 05 on stand again, 8 in a byte. */
  readonly ENGINE_MORE_INPUTS: number;
  /** Where outputs from 05 on stand, each in bit 7 of a byte, if the board has such. */
  readonly OUTPUT_CELLS?: number;
}

const NAMES: readonly (keyof Places)[] = ["engine_link", "link_one", "link_flush", "link_put", "engine_end", "scan_begin", "ENGINE_MORE_INPUTS"];

/** Those of a map, as `avr-nm` writes it. Data stand from 0x800000 on there. */
export function placesOf(map: string): Places {
  const lines = map.split("\n").map((line) => line.split(" "));
  const found = [...NAMES, "OUTPUT_CELLS"].flatMap((name) => {
    const address = lines.find((words) => words.at(-1) === name)?.[0];
    if (address !== undefined) return [[name, Number.parseInt(address, 16) & 0xffff]];
    if (name === "OUTPUT_CELLS") return [];
    throw new Error(`the firmware has no symbol ${name}`);
  });
  return Object.fromEntries(found) as Places;
}

/** A place between two instructions at which nothing is half done. */
export interface Seam {
  /** The instruction that comes next, from 0; at the end as many as there are. */
  readonly step: number;
  /** The address of its first linked byte. */
  readonly at: number;
}

/** What is pending while the linker goes on: nothing, or the beginning of a rung, which takes no byte. */
const SETTLED = 1;
/** A start-up waits for a card that is not there. */
const START_UP = 2000 * CYCLES_PER_MS;
/** Cycles of a passage of the linker, at most. */
const PASSAGE = 200 * CYCLES_PER_MS;

const NOBODY: Witness = { serial() {}, output() {}, reset() {}, power() {}, eeprom() {}, card() {} };

/** The seams of the program that a board keeps, in order; the last is the end. `null` where it keeps none. */
export function seamsOf(board: Board, places: Places): Seam[] | null {
  const other = board.copy(NOBODY);
  other.plug(true);
  if (!other.runTo(places.engine_link, START_UP)) return null;
  const chip = other.inside;
  if (!chip) return null;
  const { cpu } = chip;
  const { data } = cpu;
  const home = pair(data, SP);
  // The linker's own instructions say where its job has what they load: pending, and where the next byte is put.
  const loaded = (address: number): number => displacement(cpu.progMem[address >> 1] ?? 0);
  const [pendingAt, putAt] = [loaded(places.link_flush), loaded(places.link_put)];
  const job = (at: number): number => pair(data, Y) + at;
  const pending = (): number => data[job(pendingAt)] ?? 0;
  const put = (): number => pair(data, job(putAt));

  const seams: Seam[] = [];
  const seam = (step: number, at: number): void => {
    // What takes no byte is passed over.
    if (seams.at(-1)?.at === at) seams.pop();
    seams.push({ step, at });
  };
  /** What the instruction found pending, until it has been put or has become something else. */
  let found: number | null = null;
  let step = -1;
  /** Where the linker goes on after what is pending has been put; where the last byte went. */
  let back = -1;
  let last = -1;
  for (const end = other.now + PASSAGE; other.now < end; ) {
    const at = cpu.pc << 1;
    if (at === places.link_one) {
      step += 1;
      found = pending();
      if (found <= SETTLED) {
        seam(step, put());
        found = null;
      }
    } else if (at === places.link_flush && found !== null && pending() === found) {
      // A chip with more flash has pushed a byte above them.
      const sp = pair(data, SP) + (cpu.pc22Bits ? 1 : 0);
      back = ((data[sp + 1] ?? 0) << 9) | ((data[sp + 2] ?? 0) << 1);
      found = null;
    } else if (at === back) {
      seam(step, put());
      back = -1;
    } else if (at === places.link_put) last = put();
    other.run(1);
    if (pair(data, SP) > home) break;
  }
  seam(step + 1, last);
  return seams;
}
