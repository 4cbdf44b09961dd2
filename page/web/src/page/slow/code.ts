// Where a program can stop: its instructions by lines of the text, and by rungs.

import type { Made } from "../../tools/answers";

/** Where a person wants it to stop: an instruction, and the line of the text that it comes from. */
export interface Stop {
  readonly step: number;
  readonly line: number;
  /** The part of a chart, in words, where it is one. */
  readonly part?: string;
}

/** The line that an instruction comes from, from 1. */
export function lineOf({ map }: Made, step: number): number | null {
  return map[step]?.[0] ?? null;
}

/** The instructions that begin what comes from a line. */
export function lineStarts({ map }: Made): number[] {
  return map.flatMap(([line], step) => (line === map[step - 1]?.[0] ? [] : [step]));
}

/** The first instruction of a line, or of the next line that makes code; `null` where none does. */
export function stopAt({ map }: Made, line: number): Stop | null {
  const there = Math.min(...map.map(([of]) => of).filter((of) => of >= line));
  const step = map.findIndex(([of]) => of === there);
  return step < 0 ? null : { step, line: there };
}

/** The first instruction of each rung, as a drawing has them. */
export function rungStarts(svg: string): number[] {
  return [...svg.matchAll(/data-first="(\d+)"/g)].map(([, first]) => Number(first));
}
