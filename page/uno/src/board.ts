// A simulated board: the chip through resets and power cuts, and what is connected to it. Its time is cycles, and goes on
// while there is no power; it knows no clock, no page and no worker.

import { Agenda } from "./agenda";
import { Card, SILENCE } from "./card";
import { type Around, Chip } from "./chip/chip";
import { Eeprom } from "./chip/eeprom";
import type { Fetches } from "./chip/fetches";
import { tellFetches } from "./chip/opcodes";
import { Contacts } from "./contacts";
import type { Analogue, BoardId, Pins, ResetCause, SerialFormat } from "./messages";
import { USUAL_FORMAT } from "./messages";
import { WIRINGS, type Wiring } from "./wiring";
import { Surroundings } from "./pins";
import { type Setting, bitsOf, lengthOf, read, settingOf } from "./serial";

/** Who hears of what happens on the board. */
export interface Witness {
  /** A byte has come out of the serial port, as the page's end of the line reads it. */
  serial(byte: number): void;
  /** An output changed its level, but for pulses: 1 is point 01. */
  output(output: number, high: boolean): void;
  reset(cause: ResetCause): void;
  power(on: boolean): void;
  /** A byte of the EEPROM changes. */
  eeprom(): void;
  /** The board has written this block of the card. */
  card(block: number): void;
}

export class Board {
  readonly eeprom: Eeprom;
  readonly surroundings: Surroundings;
  private readonly agenda = new Agenda();
  private readonly contacts: Contacts;
  private chip: Chip | null = null;
  private image: Uint8Array | null = null;
  private card: Card | null = null;
  private line: Setting = settingOf(USUAL_FORMAT);
  /** When the last byte on the line to the board is over. */
  private lineFree = 0;
  private cutAtWrite = false;
  private told: Fetches | null = null;
  /** The cycle while there is no chip to count them. */
  private idle = 0;

  readonly wiring: Wiring;

  /** A board without power, with this program in its flash. A write to the EEPROM takes as long as on the chip. */
  constructor(
    readonly id: BoardId,
    private readonly flash: Uint16Array,
    private readonly witness: Witness,
    eepromWriteCycles?: number,
  ) {
    this.wiring = WIRINGS[id];
    this.eeprom = new Eeprom(this.wiring.chip.eeprom, () => this.now, () => this.eepromWrites(), eepromWriteCycles);
    this.surroundings = new Surroundings(this.wiring, (output, high) => this.witness.output(output, high));
    this.contacts = new Contacts(this.agenda, () => this.drive());
  }

  /** Another such board, without power, with the same flash and EEPROM: to try something. */
  copy(witness: Witness): Board {
    const copy = new Board(this.id, this.flash, witness, this.eeprom.writeCycles);
    copy.eeprom.bytes.set(this.eeprom.bytes);
    return copy;
  }

  /** Cycles since the board was made. */
  get now(): number {
    return this.chip?.cpu.cycles ?? this.idle;
  }

  get hasPower(): boolean {
    return this.chip !== null;
  }

  /** The chip, to look into, while there is power. */
  get inside(): Chip | null {
    return this.chip;
  }

  /** Who is told of what the firmware's engine fetches, and may stop it there; `null`: nobody, which costs nothing. */
  set fetches(fetches: Fetches | null) {
    this.told = fetches;
    tellFetches(fetches !== null);
    if (this.chip) this.chip.fetches = fetches;
  }

  plug(on: boolean): void {
    if (on === this.hasPower) return;
    this.cutAtWrite = false;
    if (on) {
      this.insert(this.image);
      this.witness.power(true);
      this.begin("power", null);
      return;
    }
    this.idle = this.now;
    this.chip?.noLaterThan(0);
    this.chip = null;
    this.eeprom.losePower();
    this.witness.eeprom();
    this.surroundings.look(null, this.idle);
    this.witness.power(false);
  }

  /** Pulls the plug in the middle of the next write to the EEPROM, or no longer. */
  pullPlugAtWrite(armed: boolean): void {
    this.cutAtWrite = armed && this.hasPower;
  }

  /** The button RESET. */
  reset(): void {
    if (this.chip) this.begin("button", this.chip);
  }

  /** Input 01: 1. */
  press(input: number, closed: boolean): void {
    this.contacts.press(input - 1, closed, this.now);
  }

  set bouncing(on: boolean) {
    this.contacts.bouncing = on;
  }

  setStop(closed: boolean): void {
    this.surroundings.stop = closed;
    this.drive();
  }

  /** Analogue input 00: 0. */
  setAnalogue(input: number, to: Analogue): void {
    this.surroundings.analogue[input] = to;
    this.drive();
  }

  /** Puts a card with this image into the slot, or nothing. The board writes to the image. */
  insert(image: Uint8Array | null): void {
    this.image = image;
    this.card = image && new Card(image, (block) => this.witness.card(block));
    this.selectCard();
  }

  setLine(format: SerialFormat): void {
    this.line = settingOf(format);
  }

  /** Bytes go to the board, behind those that are on their way. */
  send(bytes: Uint8Array): void {
    const sent = this.line;
    for (const byte of bytes) {
      const start = Math.max(this.now, this.lineFree);
      this.lineFree = start + lengthOf(sent);
      // It has been read in the middle of its stop bit.
      this.at(start + (bitsOf(sent) - 0.5) * sent.bit, () => {
        const usart = this.chip?.usart;
        usart?.receive(read(byte, sent, usart.setting));
      });
    }
  }

  /** What is seen since the last call. */
  takePins(): Pins {
    return this.surroundings.take(this.now);
  }

  /** Runs for so many cycles: to the end of the instruction in which they are over. */
  run(cycles: number): void {
    this.advance(this.now + cycles, (chip, until) => {
      chip.run(until);
      return false;
    });
  }

  /** Runs to where the instruction at this byte address is the next, or the engine is to stop, for so many cycles at most;
   * says whether it is there. */
  runTo(address: number, cycles: number): boolean {
    return this.advance(this.now + cycles, (chip, until) => chip.runTo(address, until));
  }

  private advance(end: number, go: (chip: Chip, until: number) => boolean): boolean {
    for (;;) {
      this.agenda.do(this.now);
      if (this.now >= end) return false;
      const until = Math.min(end, this.agenda.next);
      const { chip } = this;
      if (!chip) this.idle = until;
      else if (go(chip, until)) return true;
      else if (chip.bitten) this.begin("watchdog", chip);
    }
  }

  private at(cycle: number, action: () => void): void {
    this.agenda.add(cycle, action);
    this.chip?.noLaterThan(cycle);
  }

  private begin(cause: ResetCause, before: Chip | null): void {
    this.witness.reset(cause);
    this.chip = new Chip(this.wiring.chip, this.flash, this.around(), cause, this.now, before);
    this.chip.fetches = this.told;
    this.portChanged();
  }

  private around(): Around {
    return {
      eeprom: this.eeprom,
      millivolts: (channel) => (this.chip ? this.surroundings.millivolts(channel, this.chip) : 0),
      sent: (byte, setting) => this.witness.serial(read(byte, setting, this.line).byte),
      exchange: (byte, cycles) => {
        this.surroundings.clockCard(cycles);
        return this.card?.exchange(byte) ?? SILENCE;
      },
      portChanged: () => this.portChanged(),
      busSwitched: () => this.surroundings.look(this.chip, this.now),
    };
  }

  private portChanged(): void {
    this.surroundings.look(this.chip, this.now);
    this.selectCard();
    this.drive();
  }

  private selectCard(): void {
    this.card?.select(this.chip !== null && this.surroundings.selectsCard(this.chip));
  }

  private drive(): void {
    this.surroundings.closed = this.contacts.closed;
    if (this.chip) this.surroundings.drive(this.chip);
  }

  private eepromWrites(): void {
    this.witness.eeprom();
    if (!this.cutAtWrite) return;
    this.cutAtWrite = false;
    this.at(this.now + this.eeprom.writeCycles / 2, () => this.plug(false));
  }
}
