// What the tests of the simulated board share.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { Board, type Witness } from "../src/board";
import { CYCLES_PER_MS } from "../src/chip/registers";
import { readHex } from "../src/hex";
import type { ResetCause } from "../src/messages";
import { type Places, placesOf } from "../src/slow";
import { WIRINGS } from "../src/wiring";

// Tests are bundled below target/uno or target/lab, and the firmware into target/firmware.
const target = import.meta.url.slice(0, import.meta.url.lastIndexOf("/target/") + 8);

/** The firmware as it is flashed: the one that was built, or the one that is named. */
export function firmwareHex(): string {
  const hex = process.env["UNOCLP_FIRMWARE"] ?? fileURLToPath(new URL("firmware/unoclp.hex", target));
  return readFileSync(hex, "utf8");
}

/** Its bytes, as the page has them. */
export function firmwareBytes(): Uint8Array {
  return new Uint8Array(firmware().buffer);
}

export function firmware(): Uint16Array {
  const flash = readHex(firmwareHex(), WIRINGS.uno.chip.flash);
  if (!flash) throw new Error("the firmware is no Intel hex");
  return flash;
}

/** Where the tested firmware has what slow motion asks of it. */
export function places(): Places {
  const symbols = readFileSync(fileURLToPath(new URL("../firmware/unoclp-uno.symbols", target)), "utf8");
  return placesOf(symbols);
}

/** The image of a card with the program of this name: `cargo xtask test` puts those in `programs/` here on cards. */
export function card(program: string): Uint8Array {
  return new Uint8Array(readFileSync(fileURLToPath(new URL(`uno/cards/${program}.img`, target))));
}

/** Keeps what it hears. */
export class Notes implements Witness {
  text = "";
  bytes: number[] = [];
  outputs: { output: number; high: boolean }[] = [];
  resets: ResetCause[] = [];
  powers: boolean[] = [];
  eepromWrites = 0;
  blocks: number[] = [];

  serial(byte: number): void {
    this.bytes.push(byte);
    this.text += String.fromCharCode(byte);
  }
  output(output: number, high: boolean): void {
    this.outputs.push({ output, high });
  }
  reset(cause: ResetCause): void {
    this.resets.push(cause);
  }
  power(on: boolean): void {
    this.powers.push(on);
  }
  eeprom(): void {
    this.eepromWrites += 1;
  }
  card(block: number): void {
    this.blocks.push(block);
  }
}

export interface Fixture {
  readonly board: Board;
  readonly notes: Notes;
}

/** A board with the firmware, before its plug goes in. */
export function newBoard(flash = firmware()): Fixture {
  const notes = new Notes();
  return { board: new Board("uno", flash, notes), notes };
}

/** The same, with the plug in, and a card with this program. */
export function poweredBoard(program: string): Fixture {
  const fixture = newBoard();
  fixture.board.insert(card(program));
  fixture.board.plug(true);
  return fixture;
}

/** The same, when it scans. */
export function runningBoard(program: string): Fixture {
  const fixture = poweredBoard(program);
  const { board, notes } = fixture;
  for (let waited = 0; waited < 20_000 && !notes.text.endsWith("RUN\r\n"); waited += 10) board.run(ms(10));
  if (!notes.text.endsWith("RUN\r\n")) throw new Error(`the board does not run: ${notes.text}`);
  return fixture;
}

export function ms(millis: number): number {
  return millis * CYCLES_PER_MS;
}
