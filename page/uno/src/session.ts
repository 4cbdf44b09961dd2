// The simulated board as the page sees it: obeys commands, lets time go on, and tells events. It knows the messages and
// a clock, and no worker.

import { Board, type Witness } from "./board";
import { CYCLES_PER_MS } from "./chip/registers";
import { flashOf } from "./hex";
import type { Machine } from "./machine";
import {
  type Analogue,
  BLOCK_LEN,
  type BoardId,
  type Command,
  type Edge,
  type Event,
  type Pins,
  type ResetCause,
  type Trouble,
  USUAL_FORMAT,
} from "./messages";
import { Pace } from "./pace";
import { WIRINGS } from "./wiring";

/** How long a turn works at most, and how long one takes that has all done in time: ms. */
const WORK = 12;
const TURN = 16;
/** How long a turn takes after which the board still owes an answer: ms. */
const SOON = 4;
/** Simulated ms between two looks at the clock. */
const CHUNK = 0.5;
/** Whoever asks the board something is not kept waiting for the next turn: the time until its answer is simulated at once,
 * up to so many ms of real time ahead, and passes then. */
const AHEAD = 12;
/** Simulated ms after which nobody waits for an answer any more. */
const OWED = 50;
/** Chunks without a byte behind an answer: it is over. */
const QUIET = 2;
/** Edges that one event tells; of more, the first are left out. */
const EDGES = 1000;
const RATES = { least: 300, most: 1_000_000 };

export class Session implements Witness {
  /** The board at hand. */
  board: Board | null = null;
  /** Runs the board for so many cycles at most in place of it, and says whether time stands from now on. */
  stopper: ((cycles: number) => boolean) | null = null;
  private image: Uint8Array | null = null;
  private format = USUAL_FORMAT;
  private readonly pace = new Pace();
  private factor = 1;
  /** Simulated ms that time may still go on; `Infinity` while it runs, 0 while it stands. */
  private left = 0;
  private poweredAt = 0;
  /** Simulated ms in which the board may still answer what was sent to it; 0 once it has. */
  private owed = 0;
  // What is told at the end of a turn.
  private sent: number[] = [];
  private edges: Edge[] = [];
  private eepromChanged = false;
  private readonly written = new Set<number>();
  private shown = "";
  private machine: Machine | null = null;
  /** The cycle of its next step, and what it gave before. */
  private machineAt = 0;
  private given = 0;
  private readonly readings = new Map<number, number>();

  /** `clock` is real time in ms. */
  constructor(
    private readonly tell: (event: Event) => void,
    private readonly clock: () => number,
  ) {
    tell({ kind: "ready" });
  }

  /** Wires a machine to the board, in place of another, or none: then its contacts are open. */
  wire(machine: Machine | null): void {
    if (this.machine) this.give(this.machine.inputs, 0);
    this.machine = machine;
    this.machineAt = (this.board?.now ?? 0) + CYCLES_PER_MS;
    this.given = 0;
    this.readings.clear();
  }

  /** Obeys a command. After it there may be something to do: see `turn`. */
  obey(command: Command): void {
    const trouble = this.attempt(command);
    if (trouble) this.tell({ kind: "trouble", trouble });
    // A button is told at its time: at the end of the turn its outputs, which have theirs, would come before it.
    if (this.stands || command.kind === "button") this.report();
  }

  /**
   * Lets time go on for a while. Gives the ms until the next turn, 0 if there is more to do than this turn could, `null`
   * if time stands.
   */
  turn(): number | null {
    if (this.stands) return null;
    const began = this.clock();
    const behind = this.goOn(began);
    if (this.stands) return null;
    const passed = this.clock() - began;
    return behind ? 0 : Math.max(0, (this.owed > 0 ? SOON : TURN) - passed);
  }

  /** Lets as much time go on as is due, tells what has changed, and says whether some is left. */
  private goOn(began: number): boolean {
    const due = Math.min(this.left, this.left === Infinity ? this.pace.due(began) : Infinity);
    const ahead = this.owed > 0 && this.left === Infinity ? AHEAD * Math.min(this.factor, 1) : 0;
    const behind = this.work(due, ahead, began + WORK);
    this.report();
    const measured = this.left === Infinity ? this.pace.measure(this.clock()) : null;
    if (measured) this.tell({ kind: "pace", at: this.at, ...measured });
    return behind;
  }

  /** Simulates so many ms, and up to so many `ahead` until the board has answered, unless the clock comes to `end`; says
   * whether some of those that are due are left. */
  private work(due: number, ahead: number, end: number): boolean {
    const { board } = this;
    if (!board) return false;
    let left = due + ahead;
    let quiet = 0;
    try {
      while ((left > ahead || (left > 0 && quiet < QUIET)) && !this.stands && this.clock() < end) {
        const before = board.now;
        const sent = this.sent.length;
        // A whole number: of less than a cycle, time would not go on.
        const due = this.machine ? this.machineAt - before : Infinity;
        const cycles = Math.max(1, Math.min(Math.ceil(Math.min(left, CHUNK) * CYCLES_PER_MS), due));
        if (!this.stopper) board.run(cycles);
        else if (this.stopper(cycles)) this.left = 0;
        this.move(board);
        const passed = (board.now - before) / CYCLES_PER_MS;
        left -= passed;
        if (this.left === Infinity) this.pace.pay(passed);
        else this.left = Math.max(0, this.left - passed);
        quiet = sent > 0 && this.sent.length === sent ? quiet + 1 : 0;
        this.owed = quiet < QUIET ? Math.max(0, this.owed - passed) : 0;
      }
    } catch {
      this.tell({ kind: "trouble", trouble: "broken" });
      board.plug(false);
      this.left = 0;
    }
    if (this.stands) this.pauses();
    return left > ahead;
  }

  /** The machine goes on for each millisecond that has passed. */
  private move(board: Board): void {
    const { machine } = this;
    while (machine && board.now >= this.machineAt && machine === this.machine) {
      this.machineAt += CYCLES_PER_MS;
      const { closed, analogue } = machine.step(board.surroundings.outputs, board.surroundings.takeShares(board.now));
      if (machine !== this.machine) return;
      this.give(machine.inputs, closed);
      for (const [input, reading] of analogue) this.measure(board, input, reading);
    }
  }

  /** What an analogue input reads from now on. */
  private measure(board: Board, input: number, reading: number): void {
    if (this.readings.get(input) === reading || !isNumber(input, 0, board.wiring.analogue.length - 1)) return;
    this.readings.set(input, reading);
    board.setAnalogue(input, { reading });
  }

  /** Moves the contacts at these inputs that stand otherwise. */
  private give(inputs: number, closed: number): void {
    const turned = (closed ^ this.given) & inputs;
    for (let input = 1; input <= (this.board?.wiring.inputs.length ?? 0); input += 1) {
      if ((turned >> (input - 1)) & 1) this.board?.press(input, ((closed >> (input - 1)) & 1) === 1);
    }
    this.given = closed;
  }

  private attempt(command: Command): Trouble | null {
    const { board } = this;
    const wiring = WIRINGS[board?.id ?? "uno"];
    switch (command.kind) {
      case "firmware":
        return this.load(command.board, command.bytes);
      case "eeprom":
        if (!board || board.hasPower || command.bytes.length !== board.eeprom.bytes.length) return "bad-eeprom";
        board.eeprom.bytes.set(command.bytes);
        return null;
      case "plug":
        if (!board) return "no-firmware";
        board.plug(command.on);
        this.shown = "";
        return null;
      case "plug-at-write":
        board?.pullPlugAtWrite(command.armed);
        return null;
      case "reset":
        board?.reset();
        return null;
      case "button":
        if (!isNumber(command.input, 1, wiring.inputs.length)) return "bad-value";
        board?.press(command.input, command.closed);
        return null;
      case "bouncing":
        if (board) board.bouncing = command.on;
        return null;
      case "analogue":
        if (!isNumber(command.input, 0, wiring.analogue.length - 1) || !isAnalogue(command.to)) return "bad-value";
        board?.setAnalogue(command.input, command.to);
        return null;
      case "stop":
        board?.setStop(command.closed);
        return null;
      case "card":
        return this.insert(command.image);
      case "speed":
        if (!(command.factor > 0)) return "bad-value";
        this.factor = command.factor;
        this.pace.start(this.clock(), command.factor);
        return null;
      case "run":
        if (this.left !== Infinity) this.pace.start(this.clock(), this.factor);
        this.left = Infinity;
        return null;
      case "pause":
        this.left = 0;
        this.report();
        this.pauses();
        return null;
      case "step":
        if (!(command.millis > 0 && command.millis < Infinity)) return "bad-value";
        if (this.left !== Infinity) this.left = command.millis;
        return null;
      case "line":
        if (!isNumber(command.format.baud, RATES.least, RATES.most)) return "bad-value";
        this.format = command.format;
        board?.setLine(command.format);
        return null;
      case "serial":
        board?.send(command.bytes);
        this.owed = OWED;
        return null;
      case "time":
        // That of the last turn would be up to 16 ms old.
        if (!this.stands) this.goOn(this.clock());
        this.report();
        this.tell({ kind: "time", at: this.at });
        return null;
    }
  }

  /** A board with this firmware, in place of the one before, whose EEPROM, card and line it keeps. */
  private load(id: BoardId, bytes: Uint8Array): Trouble | null {
    const flash = flashOf(bytes, WIRINGS[id].chip.flash);
    if (!flash) return "bad-firmware";
    const before = this.board;
    before?.plug(false);
    const board = new Board(id, flash, this);
    if (before?.id === id) board.eeprom.bytes.set(before.eeprom.bytes);
    board.insert(this.image);
    board.setLine(this.format);
    this.board = board;
    return null;
  }

  private insert(image: Uint8Array | null): Trouble | null {
    if (image && (image.length === 0 || image.length % BLOCK_LEN !== 0)) return "bad-card";
    this.reportCard();
    this.image = image;
    this.board?.insert(image);
    return null;
  }

  private get stands(): boolean {
    return this.left === 0;
  }

  /** Simulated ms since the power came. */
  private get at(): number {
    return ((this.board?.now ?? 0) - this.poweredAt) / CYCLES_PER_MS;
  }

  private pauses(): void {
    this.tell({ kind: "paused", at: this.at });
  }

  serial(byte: number): void {
    this.sent.push(byte);
  }

  output(output: number, high: boolean): void {
    this.edges.push({ at: this.at, output, high });
    if (this.edges.length > EDGES) this.edges.shift();
  }

  reset(cause: ResetCause): void {
    this.reportSerial();
    this.tell({ kind: "reset", cause });
  }

  power(on: boolean): void {
    this.report();
    if (on) this.poweredAt = this.board?.now ?? 0;
    this.tell({ kind: "power", on });
  }

  eeprom(): void {
    this.eepromChanged = true;
  }

  card(block: number): void {
    this.written.add(block);
  }

  /** Tells all that has changed. */
  private report(): void {
    this.reportSerial();
    this.reportPins();
    this.reportCard();
    if (this.eepromChanged && this.board) {
      this.eepromChanged = false;
      this.tell({ kind: "eeprom", bytes: this.board.eeprom.bytes.slice() });
    }
  }

  private reportSerial(): void {
    if (this.sent.length === 0) return;
    this.tell({ kind: "serial", at: this.at, bytes: Uint8Array.from(this.sent) });
    this.sent = [];
  }

  private reportPins(): void {
    if (!this.board) return;
    const pins: Pins = this.board.takePins();
    const shown = JSON.stringify(pins);
    if (shown === this.shown && this.edges.length === 0) return;
    this.shown = shown;
    this.tell({ kind: "pins", at: this.at, pins, edges: this.edges });
    this.edges = [];
  }

  private reportCard(): void {
    for (const block of this.written) {
      const bytes = this.image?.slice(block * BLOCK_LEN, (block + 1) * BLOCK_LEN);
      if (bytes) this.tell({ kind: "card", block, bytes });
    }
    this.written.clear();
  }
}

function isNumber(value: number, least: number, most: number): boolean {
  return Number.isInteger(value) && value >= least && value <= most;
}

function isAnalogue(to: Analogue): boolean {
  if (to === "open") return true;
  return "millivolts" in to ? to.millivolts >= 0 && to.millivolts <= 5000 : isNumber(to.reading, 0, 1023);
}
