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

export class Tools {
  private constructor(private readonly rust: Exports) {}

  static async of(module: WebAssembly.Module): Promise<Tools> {
    const instance = await WebAssembly.instantiate(module, {});
    return new Tools(instance.exports as unknown as Exports);
  }

  /** Asks, or throws a `Refusal`, or `NeedsMore`. */
  ask<K extends keyof Asks>(what: K, request: Asks[K]["ask"]): Asks[K]["answer"] {
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
