// The serial port of the chip, with its buffers and errors, in place of avr8js' own, which has none and refuses a byte
// while another one comes (ATmega328P datasheet, section 20). Nine bits, the synchronous modes and MPCM are left out.

import type { CPU } from "avr8js";
import { type Read, type Setting, lengthOf } from "../serial";
import type { Interrupt } from "./interrupt";
import { UBRRH, UBRRL, UCSRA, UCSRB, UCSRC, UDR } from "./registers";

const RXC = 1 << 7;
const TXC = 1 << 6;
const UDRE = 1 << 5;
const FE = 1 << 4;
const DOR = 1 << 3;
const UPE = 1 << 2;
const U2X = 1 << 1;
const ERRORS = FE | DOR | UPE;
const RXEN = 1 << 4;
const TXEN = 1 << 3;
const PARITY = 1 << 5;
const ODD = 1 << 4;
const EIGHT_BITS = 0b110;

/** Characters that the receive buffer holds; one more can wait in the shift register. */
const BUFFER = 2;

interface Received {
  readonly byte: number;
  /** Bits FE, DOR and UPE. */
  readonly errors: number;
}

export class Usart {
  private readonly received: Received[] = [];
  /** A character came while there was no room, and is lost. */
  private lost = false;
  /** The byte that is being sent, and the one behind it. */
  private shifting: number | null = null;
  private next: number | null = null;
  private readonly rxc: Interrupt;
  private readonly udre: Interrupt;
  private readonly txc: Interrupt;

  /** `first` is the first of its three interrupts; `sent` takes each byte as its stop bit ends, with the setting it was sent with. */
  constructor(
    private readonly cpu: CPU,
    first: number,
    private readonly sent: (byte: number, setting: Setting) => void,
  ) {
    const interrupt = (address: number, mask: number, constant: boolean): Interrupt => {
      return { address, flagRegister: UCSRA, flagMask: mask, enableRegister: UCSRB, enableMask: mask, constant };
    };
    this.rxc = interrupt(first, RXC, true);
    this.udre = interrupt(first + 2, UDRE, true);
    this.txc = interrupt(first + 4, TXC, false);
    cpu.data[UCSRA] = UDRE;
    cpu.data[UCSRC] = EIGHT_BITS;
    this.hook();
  }

  /** How the port is set now. */
  get setting(): Setting {
    const data = this.cpu.data;
    const divider = (((data[UBRRH] ?? 0) << 8) | (data[UBRRL] ?? 0)) + 1;
    const control = data[UCSRC] ?? 0;
    const parity = control & PARITY ? (control & ODD ? "odd" : "even") : "none";
    return { bit: divider * ((data[UCSRA] ?? 0) & U2X ? 8 : 16), parity };
  }

  /** A character has come, and this is how the port reads it. */
  receive(character: Read): void {
    if (!((this.cpu.data[UCSRB] ?? 0) & RXEN)) return;
    if (this.received.length > BUFFER) {
      this.received.pop();
      this.lost = true;
    }
    const errors = (character.framing ? FE : 0) | (character.parity ? UPE : 0) | (this.lost ? DOR : 0);
    this.received.push({ byte: character.byte, errors });
    this.lost = false;
    this.showReceived();
  }

  private hook(): void {
    const { cpu } = this;
    const { data } = cpu;
    cpu.writeHooks[UCSRA] = (value, old) => {
      data[UCSRA] = (old & ~U2X) | (value & U2X);
      cpu.clearInterruptByFlag(this.txc, value);
      return true;
    };
    cpu.writeHooks[UCSRB] = (value) => {
      data[UCSRB] = value;
      if (!(value & RXEN)) {
        this.received.length = 0;
        this.lost = false;
      }
      this.showReceived();
      for (const interrupt of [this.rxc, this.udre, this.txc]) cpu.updateInterruptEnable(interrupt, value);
      return true;
    };
    cpu.readHooks[UDR] = () => {
      const first = this.received.shift();
      this.showReceived();
      return first?.byte ?? 0;
    };
    cpu.writeHooks[UDR] = (value) => {
      if (!((data[UCSRB] ?? 0) & TXEN)) return true;
      if (this.shifting === null) {
        this.shift(value);
      } else if (this.next === null) {
        this.next = value;
        cpu.clearInterrupt(this.udre);
      }
      return true;
    };
  }

  /** The flags of what the program reads next. */
  private showReceived(): void {
    const { cpu } = this;
    const first = this.received[0];
    cpu.data[UCSRA] = ((cpu.data[UCSRA] ?? 0) & ~ERRORS) | (first?.errors ?? 0);
    if (first) cpu.setInterruptFlag(this.rxc);
    else cpu.clearInterrupt(this.rxc);
  }

  private shift(byte: number): void {
    this.shifting = byte;
    this.cpu.addClockEvent(this.shifted, lengthOf(this.setting));
  }

  private readonly shifted = (): void => {
    if (this.shifting !== null) this.sent(this.shifting, this.setting);
    this.shifting = null;
    if (this.next !== null) {
      this.shift(this.next);
      this.next = null;
      this.cpu.setInterruptFlag(this.udre);
    } else {
      this.cpu.setInterruptFlag(this.txc);
    }
  };
}
