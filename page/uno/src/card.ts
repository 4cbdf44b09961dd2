// A virtual memory card of high capacity on the SPI bus, as far as the firmware speaks with one (SD Physical Layer
// Simplified Specification, chapter 7). Nothing garbles its line, so it checks no checksums; those it sends are right.

import { BLOCK_LEN } from "./messages";

/** What the line gives while the card has nothing to say. */
export const SILENCE = 0xff;
const BUSY = 0x00;
/** Stands before the bytes of a block. */
const BLOCK_BEGINS = 0xfe;
/** The answer to a block that was written. */
const ACCEPTED = 0xe5;

/** Bits of the answer R1. */
const IDLE = 0x01;
const ILLEGAL = 0x04;
const BAD_ADDRESS = 0x40;

/** OCR: ready, addressed in blocks, 2.7 to 3.6 V. */
const OCR = [0xc0, 0xff, 0x80, 0x00];
/** How many bytes a block that was written keeps the card busy. */
const WRITE_BUSY = 16;
/** How many rounds of ACMD41 it stays idle. */
const ROUNDS = 3;

export class Card {
  private selected = false;
  private idle = true;
  private rounds = 0;
  /** The last command was CMD55. */
  private application = false;
  private frame: number[] = [];
  /** What goes to the host next. */
  private out: number[] = [];
  private busy = 0;
  /** The block that is awaited or comes in, with its checksum behind it. */
  private write: { readonly block: number; readonly data: number[]; begun: boolean } | null = null;

  /** A card that has just been powered. `written` is told of each block that the host has written. */
  constructor(
    readonly image: Uint8Array,
    private readonly written: (block: number) => void,
  ) {}

  /** Drives the select line: low is selected. */
  select(low: boolean): void {
    if (!low) this.frame = [];
    this.selected = low;
  }

  /** Eight clocks: takes a byte and gives one, which the card decided on before. */
  exchange(byte: number): number {
    if (!this.selected) {
      this.busy = Math.max(0, this.busy - 1);
      return SILENCE;
    }
    const answer = this.next();
    this.take(byte);
    return answer;
  }

  private next(): number {
    const byte = this.out.shift();
    if (byte !== undefined) return byte;
    if (this.busy === 0) return SILENCE;
    this.busy -= 1;
    return BUSY;
  }

  private take(byte: number): void {
    const { write } = this;
    if (write?.begun) {
      write.data.push(byte);
      if (write.data.length === BLOCK_LEN + 2) this.store(write.block, write.data);
    } else if (write && byte === BLOCK_BEGINS && this.out.length === 0) {
      write.begun = true;
    } else if (this.frame.length > 0 || (byte & 0xc0) === 0x40) {
      this.frame.push(byte);
      if (this.frame.length === 6) this.obey(this.frame.splice(0));
    }
  }

  private store(block: number, data: readonly number[]): void {
    this.image.set(data.slice(0, BLOCK_LEN), block * BLOCK_LEN);
    this.write = null;
    this.out.push(ACCEPTED);
    this.busy = WRITE_BUSY;
    this.written(block);
  }

  private obey(frame: readonly number[]): void {
    const [command = 0, a = 0, b = 0, c = 0, d = 0] = frame;
    const number = command & 0x3f;
    const argument = ((a << 24) | (b << 16) | (c << 8) | d) >>> 0;
    const application = this.application;
    this.application = number === 55;
    this.write = null;
    this.out = [SILENCE];
    switch (number) {
      case 0:
        this.idle = true;
        this.rounds = 0;
        return this.answer();
      case 8:
        return this.answer([0, 0, 1, d]);
      case 41:
        if (!application) return this.refuse(ILLEGAL);
        if (this.rounds === ROUNDS) this.idle = false;
        else this.rounds += 1;
        return this.answer();
      case 55:
      case 59:
        return this.answer();
      case 58:
        return this.answer(OCR);
      default:
        return this.idle ? this.refuse(ILLEGAL) : this.move(number, argument);
    }
  }

  /** The commands of a card that is ready. */
  private move(number: number, block: number): void {
    if (number === 13) return this.answer([0]);
    if (number !== 17 && number !== 24) return this.refuse(ILLEGAL);
    if ((block + 1) * BLOCK_LEN > this.image.length) return this.refuse(BAD_ADDRESS);
    if (number === 24) {
      this.write = { block, data: [], begun: false };
      return this.answer();
    }
    const data = this.image.subarray(block * BLOCK_LEN, (block + 1) * BLOCK_LEN);
    const sum = crc16(data);
    this.answer([SILENCE, SILENCE, BLOCK_BEGINS, ...data, sum >> 8, sum & 0xff]);
  }

  private answer(more: readonly number[] = []): void {
    this.out.push(this.idle ? IDLE : 0, ...more);
  }

  private refuse(bit: number): void {
    this.out.push((this.idle ? IDLE : 0) | bit);
  }
}

/** CRC-16 of a block: x¹⁶ + x¹² + x⁵ + 1, from 0. */
export function crc16(data: Uint8Array): number {
  let crc = 0;
  for (const byte of data) {
    crc ^= byte << 8;
    for (let bit = 0; bit < 8; bit += 1) crc = crc & 0x8000 ? (crc << 1) ^ 0x1021 : crc << 1;
    crc &= 0xffff;
  }
  return crc;
}
