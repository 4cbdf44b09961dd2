// The same tools in a worker: asked now, answered later.

import type { Ask } from "./answers";
import type { Asks } from "./asks";
import type { Modules } from "./modules";
import { both } from "../words/words";
import { Refusal } from "./tools";
import type { Answered, Asked } from "./worker";

export class RemoteTools {
  /** The board that texts are compiled for, where a request says no other. */
  board: string | undefined;
  private last = 0;
  private readonly waiting = new Map<number, (answered: Answered) => void>();
  private whole: Promise<void> | null = null;
  /** Who hears that the tools begin again, and so know no drawing any more. */
  readonly begun = new Set<() => void>();

  constructor(
    private readonly worker: Worker,
    private readonly modules: Modules,
    first: WebAssembly.Module,
  ) {
    worker.addEventListener("message", ({ data }: MessageEvent<Answered>) => {
      this.waiting.get(data.id)?.(data);
      this.waiting.delete(data.id);
    });
    this.post({ module: first });
  }

  /** Asks, or throws a `Refusal`. What takes more than the first module has waits for the one that has everything. */
  async ask<K extends keyof Asks>(what: K, request: Ask<K>): Promise<Asks[K]["answer"]> {
    let answered = await this.once(what, request);
    if (answered.more) {
      await this.grow();
      answered = await this.once(what, request);
    }
    if (answered.died) {
      this.begin();
      throw new Refusal(both("toolsDied"));
    }
    if (answered.error) throw new Refusal(answered.error);
    return answered.ok as Asks[K]["answer"];
  }

  private once(what: string, request: unknown): Promise<Answered> {
    const id = ++this.last;
    return new Promise((resolve) => {
      this.waiting.set(id, resolve);
      this.post({ id, what, request: { board: this.board, ...(request as object) } });
    });
  }

  private grow(): Promise<void> {
    this.whole ??= this.modules.full().then((module) => {
      this.post({ module });
      this.begin();
    });
    return this.whole;
  }

  private begin(): void {
    for (const hear of this.begun) hear();
  }

  private post(asked: Asked): void {
    this.worker.postMessage(asked);
  }
}
