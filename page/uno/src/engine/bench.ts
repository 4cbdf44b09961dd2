// A simulated board on the bench: what the suite does to it, and what it is told of a run.

import { Board, type Witness } from "../board";
import type { BoardId } from "../messages";
import { type Places, Slow, type Standing } from "../slow";
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
  private slow: Slow | null = null;
  private stops: Standing[] = [];

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

  /** From now on a run to where a scan begins goes from one seam of the program to the next; says whether there are any. */
  goSlowly(places: Places): boolean {
    this.slow?.release();
    this.slow = this.uno && Slow.of(this.uno, places);
    return this.slow !== null;
  }

  /** How the engine stood at each seam since this was asked last: count u16, then each: the next instruction u16, acc u8, how
   * many values are pushed u8, value u32. */
  trail(): Uint8Array {
    const stops = this.stops.splice(0).filter(({ step }) => step !== null);
    const answer = new Uint8Array(2 + 8 * stops.length);
    const view = new DataView(answer.buffer);
    view.setUint16(0, stops.length, true);
    stops.forEach(({ step, acc, pushed, value }, n) => {
      view.setUint16(2 + 8 * n, step ?? 0, true);
      view.setUint8(4 + 8 * n, Number(acc));
      view.setUint8(5 + 8 * n, pushed.length);
      view.setInt32(6 + 8 * n, value, true);
    });
    return answer;
  }

  private runTo(board: Board, address: number, cycles: number): boolean {
    if (!this.slow) return board.runTo(address, cycles);
    const end = board.now + cycles;
    this.slow.go({ to: null, through: false });
    for (let at: Standing | null; board.now < end && (at = this.slow.run(end - board.now)); this.stops.push(at)) if (at.step === null) return true;
    return false;
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
      else if (this.runTo(this.uno, address, cycles)) ended = THERE;
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
    this.slow = null;
    this.moved = 0;
    this.sent = [];
  }
}
