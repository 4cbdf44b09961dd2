// The points that a program uses, and what a reading says of each.

import type { BoardFacts, Made, Seen } from "../tools/answers";

export interface Point {
  /** `I1`, `Q2`, `M5`, `D12`, `T1`, `C2`, `A0`. */
  readonly name: string;
  /** What the text calls it; empty where it gives the address. */
  readonly called: string;
  readonly kind: "bit" | "number" | "real" | "meter";
  /** Whether it can be forced, set, or neither. */
  readonly hand: "force" | "set" | "none";
  /** Its value: a bit as 0 or 1. */
  value(seen: Seen): number;
  /** The preset of a timer or counter. */
  preset?(seen: Seen): number;
}

/** The inputs of a board that have a pin of their own, and those that share theirs with an analogue input. */
export function inputsOf({ inputs, shared }: BoardFacts): { own: number[]; shared: number[] } {
  const is = new Set(shared.map(([input]) => input));
  return { own: upTo(inputs).filter((input) => !is.has(input)), shared: [...is] };
}

/** The numbers of so many points. */
export function upTo(count: number): number[] {
  return Array.from({ length: count }, (_, index) => index + 1);
}

/** An input or an output, by its number. */
interface Pin {
  readonly output: boolean;
  readonly number: number;
}

/** The input or output of this name; null for all else. */
export function pinOf(name: string): Pin | null {
  const [, letter, number] = /^([A-Z])(\d+)$/.exec(name) ?? [];
  return letter === "I" || letter === "Q" ? { output: letter === "Q", number: Number(number) } : null;
}

/** What an input or output is forced to; null where it is not. */
export function forcedTo(seen: Seen, name: string): boolean | null {
  const pin = pinOf(name);
  const all = pin?.output ? seen.forcedOutputs : seen.forcedInputs;
  return all.find(([number]) => number === pin?.number)?.[1] ?? null;
}

/** The names of all that is forced. */
export function forcedNames({ forcedInputs, forcedOutputs }: Seen): string[] {
  return [...forcedInputs.map(([number]) => `I${number}`), ...forcedOutputs.map(([number]) => `Q${number}`)];
}

/** A number of 32 bits as the REAL that they hold. */
export function real(bits: number): number {
  return new Float32Array(Int32Array.of(bits).buffer)[0] ?? 0;
}

/** The outputs that a program uses, by bits or by pulses. */
export function outputsOf({ outputs, pwm }: Made["uses"]): number[] {
  return [...new Set([...outputs, ...pwm])].sort((one, other) => one - other);
}

export function pointsOf(made: Made): Point[] {
  const { uses, symbols } = made;
  const points: Point[] = [];
  const add = (letter: string, numbers: readonly number[], rest: (number: number) => Omit<Point, "name" | "called">): void => {
    for (const number of numbers) points.push({ name: letter + number, called: symbols[letter + number] ?? "", ...rest(number) });
  };
  add("I", uses.inputs, (n) => ({ kind: "bit", hand: "force", value: (seen) => Number(seen.inputs.includes(n)) }));
  add("Q", outputsOf(uses), (n) => ({ kind: "bit", hand: "force", value: (seen) => Number(seen.outputs.includes(n)) }));
  add("A", uses.analogue, (n) => ({ kind: "number", hand: "none", value: (seen) => seen.analogue[n] ?? 0 }));
  const meter = (of: "timers" | "counters") => (n: number): Omit<Point, "name" | "called"> => ({
    kind: "meter",
    hand: "set",
    value: (seen) => seen[of][n - 1]?.[0] ?? 0,
    preset: (seen) => seen[of][n - 1]?.[1] ?? 0,
  });
  add("T", uses.timers.map((_, index) => index + 1), meter("timers"));
  add("C", uses.counters, meter("counters"));
  add("M", uses.markers, (n) => ({ kind: "bit", hand: "set", value: (seen) => Number(seen.markers.includes(n)) }));
  add("D", uses.registers, (n) => {
    const isReal = uses.reals.includes(n);
    const value = (seen: Seen): number => seen.registers[n - 1] ?? 0;
    return { kind: isReal ? "real" : "number", hand: "set", value: isReal ? (seen) => real(value(seen)) : value };
  });
  return points;
}
