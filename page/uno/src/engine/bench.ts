// A simulated board on the bench: what the suite does to it, and what it is told of a run.

import { Board, type Witness } from "../board";
import type { BoardId } from "../messages";
import { WIRINGS } from "../wiring";

/** How a run ended. */
const TIME_OVER = 0;
const THERE = 1;
const BROKEN = 2;

export class Bench {
  board: BoardId = "uno";
  flash: Uint16Array = new Uint16Array(0);
  private uno: Board | null = null;
  private sent: number[] = [];
  /** Bit n: output n + 1 has changed since the power came. */
  private moved = 0;

  /** A new board with this card in its slot and an erased EEPROM, just powered. */
  start(card: Uint8Array, eepromWriteCycles: number): void {
    const witness: Witness = {
      serial: (byte) => this.sent.push(byte),
      output: (output) => {
        this.moved |= 1 << (output - 1);
      },
      reset: () => {},
      power: () => {},
      eeprom: () => {},
      card: () => {},
    };
    this.uno = new Board(this.board, this.flash, witness, eepromWriteCycles);
    this.uno.insert(card);
    this.uno.plug(true);
    this.forget();
  }

  /** Takes the power away and gives it back. */
  cutPower(): void {
    this.uno?.plug(false);
    this.uno?.plug(true);
    this.forget();
  }

  /** Writes to registers, as the program does, or to RAM. */
  write(address: number, bytes: Uint8Array): void {
    const cpu = this.uno?.inside?.cpu;
    if (address >= WIRINGS[this.board].chip.ram) cpu?.data.set(bytes, address);
    else bytes.forEach((byte, n) => cpu?.writeData(address + n, byte));
  }

  press(closed: number): void {
    for (let input = 1; input <= WIRINGS[this.board].inputs.length; input += 1) this.uno?.press(input, ((closed >> (input - 1)) & 1) === 1);
  }

  turn(input: number, reading: number): void {
    this.uno?.setAnalogue(input, { reading });
  }

  send(bytes: Uint8Array): void {
    this.uno?.send(bytes);
  }

  /**
   * Runs to this address, or for so many cycles. The answer: how it ended u8, outputs that have moved u32, where it is
   * u32, cycles since the board was made as a double, length u32 and bytes of what was sent since the last run or of
   * what went wrong; then registers and RAM.
   */
  run(address: number | null, cycles: number): Uint8Array {
    let ended = TIME_OVER;
    let said: Uint8Array;
    try {
      if (!this.uno) throw new Error("no board has been started");
      if (address === null) this.uno.run(cycles);
      else if (this.uno.runTo(address, cycles)) ended = THERE;
      said = Uint8Array.from(this.sent.splice(0));
    } catch (error) {
      ended = BROKEN;
      said = new TextEncoder().encode(String(error));
    }
    const cpu = this.uno?.inside?.cpu;
    const { ram, ramLen } = WIRINGS[this.board].chip;
    const answer = new Uint8Array(21 + said.length + ram + ramLen);
    const view = new DataView(answer.buffer);
    view.setUint8(0, ended);
    view.setUint32(1, this.moved, true);
    view.setUint32(5, 2 * (cpu?.pc ?? 0), true);
    view.setFloat64(9, this.uno?.now ?? 0, true);
    view.setUint32(17, said.length, true);
    answer.set(said, 21);
    if (cpu) answer.set(cpu.data, 21 + said.length);
    return answer;
  }

  private forget(): void {
    this.moved = 0;
    this.sent = [];
  }
}
