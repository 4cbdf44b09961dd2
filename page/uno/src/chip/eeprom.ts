// What the EEPROM holds, through resets and power cuts. avr8js tells of a write as it begins, and its registers wait
// until it ends; what a power cut in between leaves behind is settled here.

import { type EEPROMBackend, eepromConfig } from "avr8js";

const ERASED = 0xff;
/** Cycles of erasing and writing a byte: 3.4 ms (ATmega328P datasheet, table 8-1). */
export const WRITE_CYCLES = 54_400;

/** avr8js' registers with the time of the chip, where it adds those of erasing alone and writing alone. */
export function eepromRegisters(writeCycles: number): typeof eepromConfig {
  const { writeCycles: half } = eepromConfig;
  const eraseCycles = Math.max(1, writeCycles - half);
  return { ...eepromConfig, eraseCycles, writeCycles: writeCycles - eraseCycles };
}

export class Eeprom implements EEPROMBackend {
  /** What is read, and what is there when a write has come to its end. */
  readonly bytes: Uint8Array;
  /** The byte that is being written, and until which cycle. */
  private writing: { readonly address: number; readonly until: number } | null = null;

  /** Of so many bytes; `began` is called as a write begins. */
  constructor(
    length: number,
    private readonly now: () => number,
    private readonly began: () => void,
    readonly writeCycles = WRITE_CYCLES,
  ) {
    this.bytes = new Uint8Array(length).fill(ERASED);
  }

  readMemory(address: number): number {
    return this.bytes[address % this.bytes.length] ?? ERASED;
  }

  eraseMemory(address: number): void {
    this.bytes[address % this.bytes.length] = ERASED;
    this.begin(address);
  }

  writeMemory(address: number, value: number): void {
    this.bytes[address % this.bytes.length] = this.readMemory(address) & value;
    this.begin(address);
  }

  /** The power goes: a byte that is being written is left erased. */
  losePower(): void {
    if (this.writing && this.now() < this.writing.until) this.bytes[this.writing.address] = ERASED;
    this.writing = null;
  }

  private begin(address: number): void {
    this.writing = { address: address % this.bytes.length, until: this.now() + this.writeCycles };
    this.began();
  }
}
