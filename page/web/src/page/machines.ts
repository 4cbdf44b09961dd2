// How the page asks the machine beside its board: the simulated UNO's lives in the worker of that, this computer's with the
// program that it runs, and that of a board on the desk (`deskmachine.ts`) with the page's tools.

import type { ForMachine, OfMachine } from "../board/messages";
import type { Ask } from "../tools/answers";
import type { Asks } from "../tools/asks";
import type { Modules } from "../tools/modules";
import { Refusal, type Tools } from "../tools/tools";
import { both } from "../words/words";

export type MachineAsk = Extract<keyof Asks, `machine${string}`>;

/** Who answers for a machine. */
export interface Machines {
  ask<K extends MachineAsk>(what: K, request: Ask<K>): Promise<Asks[K]["answer"]>;
  /** Another board is at hand, and the machine is moved elsewhere. */
  leave(): void;
}

/** That of this computer: the tools that run the program have the machine too. */
export class OwnMachine implements Machines {
  constructor(private readonly tools: () => Tools) {}

  async ask<K extends MachineAsk>(what: K, request: Ask<K>): Promise<Asks[K]["answer"]> {
    return this.tools().ask(what, request);
  }

  /** The tools have but one: the next takes its place. */
  leave(): void {}
}

/** What the board's worker needs to be. */
interface Asked {
  postMessage(message: ForMachine): void;
  addEventListener(kind: "message", hear: (message: { readonly data: OfMachine | { readonly kind: string } }) => void): void;
}

/** That of the simulated UNO. */
export class WorkerMachine implements Machines {
  private last = 0;
  private readonly waiting = new Map<number, (answer: OfMachine) => void>();
  private sent: Promise<void> | null = null;

  constructor(
    private readonly worker: Asked,
    private readonly modules: Modules,
  ) {
    worker.addEventListener("message", ({ data }) => {
      if (!isAnswer(data)) return;
      this.waiting.get(data.id)?.(data);
      this.waiting.delete(data.id);
    });
  }

  async ask<K extends MachineAsk>(what: K, request: Ask<K>): Promise<Asks[K]["answer"]> {
    await this.send();
    const id = ++this.last;
    const answered = await new Promise<OfMachine>((resolve) => {
      this.waiting.set(id, resolve);
      this.worker.postMessage({ kind: "machine-ask", id, what, request });
    });
    if (answered.error) throw new Refusal(answered.error);
    if (answered.ok === undefined) throw new Refusal(both("machineDied"));
    return answered.ok as Asks[K]["answer"];
  }

  leave(): void {
    void this.ask("machineClose", {}).catch(() => null);
  }

  private send(): Promise<void> {
    this.sent ??= this.modules.full().then(
      (module) => this.worker.postMessage({ kind: "machine-module", module }),
      (error: unknown) => {
        // The next time it may come.
        this.sent = null;
        throw error;
      },
    );
    return this.sent;
  }
}

function isAnswer(data: { readonly kind: string }): data is OfMachine {
  return data.kind === "machine-answer";
}
