// A conversation with a board: Rust says what is sent and when; here are the line and the clock.

import type { SerialFormat } from "unoclp-uno";
import type { Go } from "unoclp-uno/slow";
import type { Line, Listener } from "../line/line";
import type { Ask, News, Order, Stood } from "../tools/answers";
import type { Asks } from "../tools/asks";
import { Died, type Tools } from "../tools/tools";
import { formatOf } from "./ways";

/** The time by which a board lives: a simulated one may stand, or be slow. */
export interface Clock {
  /** ms since any moment, never less than before. */
  now(): number;
  /** How much of it passes in a unit of real time; 0: it stands. */
  factor(): number;
  /** Who hears that it goes at another speed from now on. */
  readonly turned: Set<() => void>;
  /** Where the time is an estimate: asks what it is, behind all that has come until then. */
  ask?(): Promise<void>;
}

export const WALL: Clock = { now: () => performance.now(), factor: () => 1, turned: new Set() };

/** Who hears of a conversation. */
export interface Ears {
  news(news: News): void;
  /** All bytes that come. */
  bytes(bytes: Uint8Array): void;
  /** The line has closed by itself. */
  lost(): void;
  /** What may be the cause of that. */
  cause(): string;
  /** The tools have broken down. */
  died(): void;
}

export class Conversation {
  private came: number[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private until = 0;
  private over = false;
  /** The board is being reset, or the line is opened in another format: nothing is said meanwhile. */
  private turning = false;
  /** There is no line any more. */
  private gone = false;

  private constructor(
    private tools: Tools,
    private board: number,
    private readonly line: Line,
    private format: SerialFormat,
    private readonly clock: Clock,
    private readonly ears: Ears,
  ) {
    clock.turned.add(this.turned);
  }

  /** Opens a line and begins to speak. */
  static async open(
    tools: Tools,
    open: Ask<"open">,
    line: Line,
    format: SerialFormat,
    clock: Clock,
    ears: Ears,
  ): Promise<Conversation> {
    const talk = new Conversation(tools, tools.ask("open", open), line, format, clock, ears);
    await line.open(format, talk.listener);
    talk.step();
    return talk;
  }

  private readonly listener: Listener = {
    bytes: (bytes) => {
      this.ears.bytes(bytes);
      for (const byte of bytes) this.came.push(byte);
      this.step();
    },
    closed: (why) => {
      if (why === "lost") this.lose(this.ears.cause());
    },
  };

  /** Has something done; `numbered` gets the number by which the news speak of it, before they do: what takes nothing of
   * the board is done at once. */
  order(order: Order, numbered: (number: number) => void): void {
    numbered(this.tools.ask("order", { board: this.board, order }));
    this.step();
  }

  /** Goes on by other tools, on the same line, which stays open: the board does not notice. */
  move(tools: Tools, open: Ask<"open">): void {
    if (this.over) return;
    const board = tools.ask("open", open);
    this.leave();
    [this.tools, this.board, this.came] = [tools, board, []];
    this.step();
  }

  /** Goes on with the scan that this computer makes; null where it has not come to a stop yet. */
  slowly(go: Go): Stood | null {
    return this.tools.ask("slowly", { board: this.board, ...go });
  }

  async close(): Promise<void> {
    this.end();
    await this.line.close();
  }

  private end(): void {
    if (this.over) return;
    this.over = true;
    this.clock.turned.delete(this.turned);
    clearTimeout(this.timer);
    this.leave();
  }

  /** The tools need no longer know of this; those that have broken down know of nothing. */
  private leave(): void {
    try {
      this.tools.ask("close", { board: this.board });
    } catch (error) {
      if (!(error instanceof Died)) throw error;
    }
  }

  private step(): void {
    if (this.over || this.turning) return;
    const came = this.came;
    this.came = [];
    const step = this.asked(came);
    if (!step) return;
    this.until = step.until;
    const format = formatOf(step);
    const other = format.baud !== this.format.baud || format.parity !== this.format.parity;
    if (!this.gone && (other || step.reset)) void this.turn(other ? format : null, step);
    // A line that is closed says so by itself.
    else if (step.send.length > 0) this.line.write(Uint8Array.from(step.send)).catch(() => undefined);
    this.schedule();
    for (const news of step.news) this.ears.news(news);
  }

  /** Speaks in another format from now on, and resets the board, where the step asks for that; then goes on. */
  private async turn(other: SerialFormat | null, { reset, send }: Asks["step"]["answer"]): Promise<void> {
    this.turning = true;
    try {
      if (other) await this.line.open(other, this.listener);
      this.format = other ?? this.format;
      if (reset) await this.line.reset();
      this.came = [];
      if (send.length > 0) await this.line.write(Uint8Array.from(send));
      this.turning = false;
      this.step();
    } catch (error) {
      this.lose(error instanceof Error ? error.message : String(error));
    }
  }

  /** The line is gone, and why: what was ordered is not done, and its end is told. */
  private lose(why: string): void {
    if (this.over || this.gone) return;
    this.gone = true;
    this.turning = false;
    try {
      this.tools.ask("lose", { board: this.board, why });
    } catch (error) {
      if (!(error instanceof Died)) throw error;
    }
    this.step();
    this.end();
    this.ears.lost();
  }

  private asked(came: number[]): Asks["step"]["answer"] | null {
    try {
      return this.tools.ask("step", { board: this.board, now: this.clock.now(), came });
    } catch (error) {
      if (!(error instanceof Died)) throw error;
      this.ears.died();
      return null;
    }
  }

  /** The time has come, by the page: on a slow computer the answer may lie there unread, or the board be slower than thought. */
  private async due(): Promise<void> {
    await this.clock.ask?.();
    this.step();
  }

  /** What was to be waited for was reckoned at the speed of before. */
  private readonly turned = (): void => this.schedule();

  private schedule(): void {
    clearTimeout(this.timer);
    const factor = this.clock.factor();
    if (this.over || factor <= 0) return;
    const wait = (this.until - this.clock.now()) / factor;
    this.timer = setTimeout(() => void this.due(), Math.min(Math.max(wait, 0), 60_000));
  }
}
