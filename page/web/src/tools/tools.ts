// The Rust of unoclp: one text in, one text out.

import type { Asks, Wrong } from "./answers";

/** What the module exports; wasm/src/lib.rs says how it is called. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  unoclp_room(bytes: number): number;
  unoclp_call(): number;
  unoclp_answer(): number;
}

/** What Rust says is wrong with a request. */
export class Refusal extends Error {
  constructor(readonly both: Wrong) {
    super(both.en);
  }
}

/** The module at hand has not what this takes: the one that has everything does. */
export class NeedsMore extends Error {}

/** The module has broken down, and answers nothing any more: another is made in its place. */
export class Died extends Error {}

export class Tools {
  private dead = false;

  private constructor(
    private readonly rust: Exports,
    private readonly module: WebAssembly.Module,
  ) {}

  static async of(module: WebAssembly.Module): Promise<Tools> {
    const instance = await WebAssembly.instantiate(module, {});
    return new Tools(instance.exports as unknown as Exports, module);
  }

  /** The same tools from the beginning, which know nothing of what was asked of these. */
  anew(): Promise<Tools> {
    return Tools.of(this.module);
  }

  /** Asks, or throws a `Refusal`, `NeedsMore`, or `Died`: what a module says after it has broken down is worth nothing. */
  ask<K extends keyof Asks>(what: K, request: Asks[K]["ask"]): Asks[K]["answer"] {
    if (this.dead) throw new Died("the module has broken down");
    try {
      return this.call(what, request);
    } catch (error) {
      if (error instanceof Refusal || error instanceof NeedsMore) throw error;
      this.dead = true;
      throw new Died(String(error));
    }
  }

  private call<K extends keyof Asks>(what: K, request: Asks[K]["ask"]): Asks[K]["answer"] {
    const text = new TextEncoder().encode(JSON.stringify({ ask: what, ...request }));
    const room = this.rust.unoclp_room(text.length);
    new Uint8Array(this.rust.memory.buffer, room, text.length).set(text);
    const length = this.rust.unoclp_call();
    // The memory may have grown meanwhile.
    const answer = new Uint8Array(this.rust.memory.buffer, this.rust.unoclp_answer(), length);
    const told = JSON.parse(new TextDecoder().decode(answer)) as { ok?: unknown; error?: Wrong; more?: true };
    if (told.more) throw new NeedsMore();
    if (told.error) throw new Refusal(told.error);
    return told.ok as Asks[K]["answer"];
  }
}
