// What a click on an element of a live drawing does, and what of a drawing is live.

import type { Live, Text } from "../tools/answers";
import type { Bench } from "./bench";
import { forcedTo, pinOf } from "./points";

/** What runs, as long as it is this text. */
export function liveOf({ on, seen }: Bench, text: Text): Live | null {
  const is = on.value !== null && on.value.text === text.text && on.value.name === text.name;
  return is && seen.value?.state !== "FAULT" ? (seen.value?.live ?? null) : null;
}

/** A click on a contact or coil: forced to 1, to 0, let go. */
export function force(bench: Bench, point: string): void {
  const seen = bench.seen.value;
  const pin = pinOf(point);
  if (!seen || !pin) return;
  const now = forcedTo(seen, point);
  void bench.ask({ do: "force", ...pin, to: now === null ? true : now ? false : null });
}
