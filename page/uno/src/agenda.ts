// What happens around the chip at a later cycle, through resets and power cuts.

interface Entry {
  readonly at: number;
  readonly action: () => void;
}

export class Agenda {
  /** In order of time; what was added first comes first. */
  private readonly entries: Entry[] = [];

  /** The cycle of the first entry. */
  get next(): number {
    return this.entries[0]?.at ?? Infinity;
  }

  add(at: number, action: () => void): void {
    const before = this.entries.findLastIndex((entry) => entry.at <= at);
    this.entries.splice(before + 1, 0, { at, action });
  }

  /** Does all that is due at this cycle. */
  do(now: number): void {
    while (this.next <= now) this.entries.shift()?.action();
  }
}
