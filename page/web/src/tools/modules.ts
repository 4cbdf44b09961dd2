// The modules of Rust: the one that a page begins with, and the one that has everything.

import { beside } from "../offline/beside";

/** Loads each once. */
export class Modules {
  private whole: Promise<WebAssembly.Module> | null = null;
  private readonly small: Promise<WebAssembly.Module>;

  constructor() {
    this.small = WebAssembly.compileStreaming(beside("unoclp.wasm"));
  }

  /** Numeric code, the program that a page begins with, the ladder, and boards. */
  first(): Promise<WebAssembly.Module> {
    return this.small;
  }

  /** All languages, exercises and cards too. */
  full(): Promise<WebAssembly.Module> {
    this.whole ??= WebAssembly.compileStreaming(beside("unoclp-full.wasm")).catch((error: unknown) => {
      // The next time it may come.
      this.whole = null;
      throw error;
    });
    return this.whole;
  }
}
