// No line: what runs in this computer hears and is heard without one.

import type { Line, Listener } from "./line";

export class NoLine implements Line {
  private listener: Listener | null = null;

  async open(_format: unknown, listener: Listener): Promise<void> {
    this.listener = listener;
  }

  async write(): Promise<void> {}

  async reset(): Promise<void> {}

  async close(): Promise<void> {
    const { listener } = this;
    this.listener = null;
    listener?.closed("asked");
  }
}
