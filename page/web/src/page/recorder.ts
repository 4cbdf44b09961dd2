// What has happened over time: a list of changes for each channel.

/** The changes of one channel, in the order of time. */
export interface Channel {
  readonly name: string;
  readonly digital: boolean;
  readonly times: number[];
  readonly values: number[];
}

/** Changes of a channel that are kept; the oldest go first. A number may change with each reading: that is three minutes. */
const MOST = { digital: 20_000, number: 4_000 };

export class Recorder {
  readonly channels = new Map<string, Channel>();
  /** The time of the newest change or sign of life, ms. */
  now = 0;

  /** Notes what a channel is at a time in ms; what has not changed is not kept. */
  note(name: string, at: number, value: number, digital = true): void {
    let channel = this.channels.get(name);
    if (!channel) {
      channel = { name, digital, times: [], values: [] };
      this.channels.set(name, channel);
    }
    this.now = Math.max(this.now, at);
    if (channel.values.at(-1) === value) return;
    // An edge may be told after a reading that was later.
    const last = channel.times.at(-1) ?? 0;
    channel.times.push(Math.max(at, last));
    channel.values.push(value);
    const most = digital ? MOST.digital : MOST.number;
    if (channel.times.length > most) {
      channel.times.splice(0, most / 10);
      channel.values.splice(0, most / 10);
    }
  }

  /** What a channel was last. */
  last(name: string): number | undefined {
    return this.channels.get(name)?.values.at(-1);
  }

  /** What was before now is forgotten; what each channel is stays known. */
  forget(): void {
    for (const { times, values } of this.channels.values()) {
      times.splice(0, times.length, this.now);
      values.splice(0, values.length - 1);
    }
  }

  clear(): void {
    this.channels.clear();
    this.now = 0;
  }

  /** The times of all changes of these channels from one time to another, and what each was then. */
  table(names: readonly string[], from: number, to: number): { times: number[]; values: number[][] } {
    const channels = names.map((name) => this.channels.get(name));
    const times = new Set([from, to]);
    for (const channel of channels) for (const time of channel?.times ?? []) if (time > from && time < to) times.add(time);
    const sorted = [...times].sort((one, other) => one - other);
    return { times: sorted, values: channels.map((channel) => (channel ? at(channel, sorted) : sorted.map(() => Number.NaN))) };
  }

  /** As a table for a spreadsheet: a line for each change. */
  csv(names: readonly string[], headed = (name: string): string => name): string {
    const { times, values } = this.table(names, 0, this.now);
    const line = (time: number, index: number): string => [time.toFixed(3), ...values.map((one) => (Number.isNaN(one[index]) ? "" : String(one[index])))].join(",");
    return [["ms", ...names.map(headed)].join(","), ...times.map(line)].join("\n") + "\n";
  }
}

/** What a channel was at each of these times, which are in order. */
function at(channel: Channel, times: readonly number[]): number[] {
  let index = -1;
  return times.map((time) => {
    while (index + 1 < channel.times.length && (channel.times[index + 1] ?? 0) <= time) index += 1;
    return index < 0 ? Number.NaN : (channel.values[index] ?? Number.NaN);
  });
}
