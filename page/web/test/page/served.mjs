// The board of `unoclp-uno-sim serve`: the real boot loader or the firmware on simavr, behind a pseudo-terminal.
// @ts-check

import { execFileSync, spawn } from "node:child_process";
import { existsSync, openSync, writeSync } from "node:fs";
import { dirname, join } from "node:path";
import { createInterface } from "node:readline";
import { ReadStream } from "node:tty";
import { fileURLToPath } from "node:url";

const PROGRAM = join(dirname(fileURLToPath(import.meta.url)), "../../../../target/debug/unoclp-uno-sim");

/** A device for a `Cable`. */
export class Served {
  /** @type {(bytes: number[]) => void} */
  hear = () => undefined;

  /** @param {import("node:child_process").ChildProcess} child @param {string} path */
  constructor(child, path) {
    this.child = child;
    this.writes = openSync(path, "w");
    this.reads = new ReadStream(openSync(path, "r+"));
    // Node's own raw mode writes a line feed as two bytes.
    execFileSync("stty", ["-F", path, "raw", "-echo"]);
    this.reads.on("data", (/** @type {Buffer} */ bytes) => this.hear([...bytes]));
    // At its end a pseudo-terminal is an error.
    this.reads.on("error", () => undefined);
  }

  /** @param {string[]} options of `unoclp-uno-sim serve` */
  static async begin(...options) {
    if (!existsSync(PROGRAM)) throw new Error(`no ${PROGRAM}: build it with \`cargo build -p unoclp-uno-sim\``);
    const child = spawn(PROGRAM, ["serve", ...options], { stdio: ["pipe", "pipe", "inherit"] });
    for await (const path of createInterface(child.stdout)) return new Served(child, path);
    throw new Error("unoclp-uno-sim serve has no port");
  }

  /** @param {number} baud */
  open(baud) {
    this.child.stdin?.write(`baud ${baud}\n`);
    this.reset();
  }

  reset() {
    this.child.stdin?.write("reset\n");
  }

  /** @param {number[]} bytes */
  send(bytes) {
    writeSync(this.writes, Uint8Array.from(bytes));
  }

  async end() {
    const ended = new Promise((resolve) => this.child.once("exit", resolve));
    this.child.stdin?.end();
    this.reads.destroy();
    await ended;
  }
}
