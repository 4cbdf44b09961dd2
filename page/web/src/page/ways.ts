// How the page speaks to a board: a board may be set otherwise than usual, and keeps for its next start what it does not
// do yet.

import type { SerialFormat } from "unoclp-uno";
import { USUAL } from "../tools/numbers";
import { keep, kept } from "./kept";
import { keepHere, keptHere } from "./place";

/** What a board is spoken to by: its address, the rate in baud, the parity: 0 none, 1 even, 2 odd. */
export interface Way {
  readonly address: number;
  readonly rate: number;
  readonly parity: number;
}

const PARITIES = ["none", "even", "odd"] as const;

/** How bytes look on the line then. */
export function formatOf({ rate, parity }: Pick<Way, "rate" | "parity">): SerialFormat {
  return { baud: rate, parity: PARITIES[parity] ?? "none" };
}

export function same(one: Way, other: Way): boolean {
  return one.address === other.address && one.rate === other.rate && one.parity === other.parity;
}

/** The ways to a board that are tried in turn, and which is the one now. The browser keeps them: those to a simulated
 * board with its EEPROM, which is this tab's. */
export class Ways {
  private all: readonly Way[];
  /** That from the next start of the board on, where it is another. */
  private next: Way | null = null;

  constructor(private readonly simulated: boolean) {
    this.all = wayList(simulated ? keptHere("ways") : kept("ways-desk"));
  }

  get now(): Way {
    return this.all[0] ?? USUAL;
  }

  /** The board keeps this for its next start. */
  expect(way: Way): void {
    this.next = same(way, this.now) ? null : way;
    this.set(this.next ? [this.now, this.next] : [this.now]);
  }

  /** The board has begun again: whether it speaks otherwise since. */
  begun(): boolean {
    const { next } = this;
    if (!next) return false;
    this.next = null;
    this.set([next, ...this.all]);
    return true;
  }

  /** Speaks so from now on, because a person says so. */
  choose(way: Way): void {
    this.next = null;
    this.set([way]);
  }

  /** No answer: whether there is another way to try, which is the one now. */
  turn(): boolean {
    const [now, ...others] = this.all;
    if (!now || others.length === 0) return false;
    this.all = [...others, now];
    this.next = null;
    return true;
  }

  private set(all: readonly Way[]): void {
    const ways = [...all, USUAL];
    this.all = ways.filter((way, index) => ways.findIndex((one) => same(one, way)) === index).slice(0, 3);
    const told = JSON.stringify(this.all);
    if (this.simulated) keepHere("ways", told);
    else keep("ways-desk", told);
  }
}

function wayList(text: string | null): readonly Way[] {
  try {
    const all = JSON.parse(text ?? "[]") as unknown;
    return Array.isArray(all) && all.every(isWay) && all.length > 0 ? all : [USUAL];
  } catch {
    return [USUAL];
  }
}

function isWay(value: unknown): value is Way {
  const way = (value ?? {}) as Partial<Record<keyof Way, unknown>>;
  return [way.address, way.rate, way.parity].every((part) => typeof part === "number");
}
