// The line to the simulated board in a worker.

import type { Command, Event, SerialFormat } from "unoclp-uno";
import type { Line, Listener } from "./line";

/** What a line needs of a worker: `Worker` is one, and tests bring their own. */
export interface BoardWorker {
  postMessage(command: Command): void;
  addEventListener(kind: "message", hear: (message: { readonly data: Event }) => void): void;
}

export class SimulatedLine implements Line {
  private listener: Listener | null = null;

  constructor(private readonly worker: BoardWorker) {
    worker.addEventListener("message", ({ data }) => {
      if (data.kind === "serial") this.listener?.bytes(data.bytes);
    });
  }

  async open(format: SerialFormat, listener: Listener): Promise<void> {
    this.worker.postMessage({ kind: "line", format });
    this.listener = listener;
  }

  async write(bytes: Uint8Array): Promise<void> {
    if (!this.listener) throw new Error("the line is closed");
    this.worker.postMessage({ kind: "serial", bytes });
  }

  async reset(): Promise<void> {
    this.worker.postMessage({ kind: "reset" });
  }

  async close(): Promise<void> {
    const listener = this.listener;
    this.listener = null;
    listener?.closed("asked");
  }
}
