// The simulated UNO as an engine of the suite, for `proof/uno-sim/src/avr8js.rs`: requests on standard input, answers on
// standard output, all of them bytes, numbers with the low byte first. Only a run is answered; what comes before it is
// obeyed in order. The page does not contain this.

import { readSync, writeSync } from "node:fs";
import { BOARDS } from "../boards";
import { WIRINGS } from "../wiring";
import { Bench } from "./bench";

/** Requests: a byte, and what follows it. */
const FIRMWARE = 0; // board u8: its place in BOARDS; its flash
const START = 1; // cycles of an EEPROM write u32, length of the card u32, blocks u32, then each: number u32, 512 bytes
const POWER = 2;
const WRITE = 3; // address u16, length u16, bytes
const INPUTS = 4; // closed u32
const ANALOGUE = 5; // input u8, reading u16
const SEND = 6; // length u16, bytes
const RUN = 7; // byte address u32, NOWHERE for none; cycles u32
const SLOW = 8; // byte addresses of symbols u32, in the order of `Places`, NOWHERE for none; answered by 1 where the board keeps a program, else 0
const TRAIL = 9; // answered as `Bench.trail` says

const NOWHERE = 0xffff_ffff;

/** Standard input, as much of it as one asks for. */
class Input {
  private readonly chunk = new Uint8Array(1 << 16);
  private rest = this.chunk.subarray(0, 0);

  /** The next bytes; `null` at the end, if it comes before the first of them. */
  take(length: number): DataView | null {
    const bytes = new Uint8Array(length);
    for (let at = 0; at < length; ) {
      if (this.rest.length === 0) {
        this.rest = this.chunk.subarray(0, readSync(0, this.chunk));
        if (this.rest.length === 0) return null;
      }
      const part = this.rest.subarray(0, length - at);
      bytes.set(part, at);
      at += part.length;
      this.rest = this.rest.subarray(part.length);
    }
    return new DataView(bytes.buffer);
  }

  number(length: 1 | 2 | 4): number {
    const view = this.need(length);
    return length === 1 ? view.getUint8(0) : length === 2 ? view.getUint16(0, true) : view.getUint32(0, true);
  }

  bytes(length: number): Uint8Array {
    return new Uint8Array(this.need(length).buffer);
  }

  private need(length: number): DataView {
    const view = this.take(length);
    if (!view) throw new Error("the input ends in the middle of a request");
    return view;
  }
}

function answer(bytes: Uint8Array): void {
  for (let at = 0; at < bytes.length; ) at += writeSync(1, bytes, at);
}

function readCard(input: Input): Uint8Array {
  const image = new Uint8Array(input.number(4));
  for (let blocks = input.number(4); blocks > 0; blocks -= 1) {
    const block = input.number(4);
    image.set(input.bytes(512), 512 * block);
  }
  return image;
}

const input = new Input();
const bench = new Bench();
for (let request = input.take(1); request; request = input.take(1)) {
  switch (request.getUint8(0)) {
    case FIRMWARE:
      bench.board = BOARDS[input.number(1)] ?? "uno";
      bench.flash = new Uint16Array(input.bytes(WIRINGS[bench.board].chip.flash).buffer);
      break;
    case START: {
      const writeCycles = input.number(4);
      bench.start(readCard(input), writeCycles);
      break;
    }
    case POWER:
      bench.cutPower();
      break;
    case WRITE:
      bench.write(input.number(2), input.bytes(input.number(2)));
      break;
    case INPUTS:
      bench.press(input.number(4));
      break;
    case ANALOGUE:
      bench.turn(input.number(1), input.number(2));
      break;
    case SEND:
      bench.send(input.bytes(input.number(2)));
      break;
    case RUN: {
      const address = input.number(4);
      answer(bench.run(address === NOWHERE ? null : address, input.number(4)));
      break;
    }
    case SLOW: {
      const [engine_link, link_one, link_flush, link_put, engine_end, scan_begin, ENGINE_MORE_INPUTS] = Array.from({ length: 7 }, () => input.number(4)) as [number, number, number, number, number, number, number];
      const cells = input.number(4);
      const places = { engine_link, link_one, link_flush, link_put, engine_end, scan_begin, ENGINE_MORE_INPUTS, ...(cells !== NOWHERE && { OUTPUT_CELLS: cells }) };
      answer(Uint8Array.of(Number(bench.goSlowly(places))));
      break;
    }
    case TRAIL:
      answer(bench.trail());
      break;
    default:
      throw new Error(`no request ${request.getUint8(0)}`);
  }
}
