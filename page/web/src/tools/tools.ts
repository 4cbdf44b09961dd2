// The Rust of unoclp: one text in, one text out.

import type { Ask, Text, Wrong } from "./answers";
import type { Asks } from "./asks";
import { NUMBERS } from "./numbers";

/** What the module exports; wasm/src/lib.rs says how it is called. */
interface Exports {
  readonly memory: WebAssembly.Memory;
  unoclp_room(bytes: number): number;
  unoclp_call(): number;
  unoclp_answer(): number;
  /** Of the module that has everything alone. */
  unoclp_shares(): number;
  unoclp_readings(): number;
  unoclp_step(levels: number, ms: number): number;
}

/** Texts whose versions are kept here; Rust keeps more. */
const TEXTS = 4;

const encoder = new TextEncoder();
const decoder = new TextDecoder();

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
  /** Where a machine reads its outputs, until the memory grows. */
  private shares = new Uint8Array();
  /** The texts that were asked about last, the last one last. */
  private readonly known: (Text & { readonly board: string | undefined; readonly version: number })[] = [];

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
  ask<K extends keyof Asks>(what: K, request: Ask<K>): Asks[K]["answer"] {
    return this.alive(() => this.call(what, request));
  }

  /** The machine that is open goes on for so many ms, at most 250, with these outputs: bit n is output n + 1; of each, what
   * share of 255 it was high. Gives the inputs that are 1 as bits too, or null where none is open; throws `Died`. */
  step(levels: number, shares: readonly number[], ms: number): number | null {
    return this.alive(() => {
      const { buffer } = this.rust.memory;
      // Number 0 is no output.
      if (this.shares.buffer !== buffer) this.shares = new Uint8Array(buffer, this.rust.unoclp_shares() + 1, NUMBERS - 1);
      this.shares.set(shares);
      const closed = this.rust.unoclp_step(levels, ms);
      return closed < 0 ? null : closed;
    });
  }

  /** What a machine has set A 00 and the analogue inputs after it to, 0 to 1023; until the next call. */
  readings(): Uint16Array {
    return new Uint16Array(this.rust.memory.buffer, this.rust.unoclp_readings(), NUMBERS);
  }

  private alive<T>(work: () => T): T {
    if (this.dead) throw new Died("the module has broken down");
    try {
      return work();
    } catch (error) {
      if (error instanceof Refusal || error instanceof NeedsMore) throw error;
      this.dead = true;
      throw new Died(String(error));
    }
  }

  private call<K extends keyof Asks>(what: K, request: Ask<K>): Asks[K]["answer"] {
    const asked = request as Request;
    const { order } = asked;
    const text = encoder.encode(JSON.stringify({ ask: what, ...this.versioned(asked), ...(order && { order: this.versioned(order) }) }));
    const room = this.rust.unoclp_room(text.length);
    new Uint8Array(this.rust.memory.buffer, room, text.length).set(text);
    const length = this.rust.unoclp_call();
    // The memory may have grown meanwhile.
    const answer = new Uint8Array(this.rust.memory.buffer, this.rust.unoclp_answer(), length);
    const told = JSON.parse(decoder.decode(answer)) as { ok?: unknown; error?: Wrong; more?: true };
    if (told.more) throw new NeedsMore();
    if (told.error) throw new Refusal(told.error);
    this.hear(asked, told.ok);
    return told.ok as Asks[K]["answer"];
  }

  /** A request with the version of its text in place of that. */
  private versioned({ of, ...rest }: Request): object {
    return of ? { ...rest, version: this.version(of, rest.board) } : rest;
  }

  /** The version of a text: Rust is given each text once. */
  private version({ name, text }: Text, board: unknown): number {
    const of = typeof board === "string" ? board : undefined;
    const at = this.known.findIndex((one) => one.text === text && one.name === name && one.board === of);
    const [known] = at < 0 ? [{ name, text, board: of, version: this.call("text", { name, text, board: of }) }] : this.known.splice(at, 1);
    return this.know(known!);
  }

  /** A drawing has a text of its own, whose version comes with it. */
  private hear({ name, board }: Request, answer: unknown): void {
    const { version, text } = (answer ?? {}) as { version?: unknown; text?: unknown };
    if (typeof version !== "number" || typeof text !== "string" || name === undefined) return;
    this.know({ name, text, board: typeof board === "string" ? board : undefined, version });
  }

  private know(known: (typeof this.known)[number]): number {
    this.known.push(known);
    if (this.known.length > TEXTS) this.known.shift();
    return known.version;
  }
}

/** What a request may have that is about a text. */
interface Request {
  readonly of?: Text | null;
  /** The board that a text is for, by its name; a conversation has a number. */
  readonly board?: string | number | undefined;
  readonly name?: string;
  readonly order?: Request;
}
