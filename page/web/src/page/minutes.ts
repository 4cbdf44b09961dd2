// How long a student has had an exercise before them: while it is open, and its page is the one that is seen.

import { keep, kept } from "./kept";

const KEPT = "minutes";

export class Minutes {
  private name: string | null = null;
  /** Since when it is seen, ms since 1970; null while nobody sees it. */
  private since: number | null = null;

  constructor() {
    for (const event of ["visibilitychange", "pagehide"]) addEventListener(event, () => this.turn(this.name), { capture: true });
  }

  /** Goes on with the exercise of this name; with none where it was closed. */
  turn(name: string | null): void {
    if (this.name !== null && this.since !== null) {
      const spent = all();
      keep(KEPT, JSON.stringify({ ...spent, [this.name]: (spent[this.name] ?? 0) + Date.now() - this.since }));
    }
    this.name = name;
    this.since = document.visibilityState === "visible" ? Date.now() : null;
  }

  /** The minutes of one so far, the last one begun. */
  of(name: string): number {
    this.turn(this.name);
    return Math.ceil((all()[name] ?? 0) / 60_000);
  }
}

/** The ms of each exercise. */
function all(): Readonly<Record<string, number>> {
  try {
    const found = Object.entries(JSON.parse(kept(KEPT) ?? "{}") as object);
    return Object.fromEntries(found.filter((one): one is [string, number] => typeof one[1] === "number"));
  } catch {
    return {};
  }
}
