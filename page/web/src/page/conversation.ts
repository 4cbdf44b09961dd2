// A conversation with a board: Rust says what is sent and when; here are the line and the clock.

import type { SerialFormat } from "unoclp-uno";
import type { Line } from "../line/line";
import type { Ask, News, Order } from "../tools/answers";
import type { Asks } from "../tools/asks";
import { Died, type Tools } from "../tools/tools";

/** The time by which a board lives: a simulated one may stand, or be slow. */
export interface Clock {
  /** ms since any moment, never less than before. */
  now(): number;
  /** How much of it passes in a unit of real time; 0: it stands. */
  factor(): number;
  /** Who hears that it goes at another speed from now on. */
  readonly turned: Set<() => void>;
}

export const WALL: Clock = { now: () => performance.now(), factor: () => 1, turned: new Set() };

export class Conversation {
  private came: number[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private until = 0;
  private over = false;

  private constructor(
    private tools: Tools,
    private board: number,
    private readonly line: Line,
    private readonly clock: Clock,
    private readonly hear: (news: News) => void,
    private readonly died: () => void,
  ) {
    clock.turned.add(this.turned);
  }

  /** Opens a line and begins to speak. `heard` gets all bytes that come, `lost` is called when the line closes by itself. */
  static async open(
    tools: Tools,
    open: Ask<"open">,
    line: Line,
    format: SerialFormat,
    clock: Clock,
    hear: (news: News) => void,
    heard: (bytes: Uint8Array) => void,
    lost: () => void,
    died: () => void,
  ): Promise<Conversation> {
    const talk = new Conversation(tools, tools.ask("open", open), line, clock, hear, died);
    await line.open(format, {
      bytes: (bytes) => {
        heard(bytes);
        for (const byte of bytes) talk.came.push(byte);
        talk.step();
      },
      closed: (why) => {
        if (why === "asked") return;
        talk.end();
        lost();
      },
    });
    talk.step();
    return talk;
  }

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
    if (this.over) return;
    const came = this.came;
    this.came = [];
    const step = this.asked(came);
    if (!step) return;
    this.until = step.until;
    // A line that is closed says so by itself.
    if (step.send.length > 0) this.line.write(Uint8Array.from(step.send)).catch(() => undefined);
    this.schedule();
    for (const news of step.news) this.hear(news);
  }

  private asked(came: number[]): Asks["step"]["answer"] | null {
    try {
      return this.tools.ask("step", { board: this.board, now: this.clock.now(), came });
    } catch (error) {
      if (!(error instanceof Died)) throw error;
      this.died();
      return null;
    }
  }

  /** What was to be waited for was reckoned at the speed of before. */
  private readonly turned = (): void => this.schedule();

  private schedule(): void {
    clearTimeout(this.timer);
    const factor = this.clock.factor();
    if (this.over || factor <= 0) return;
    const wait = (this.until - this.clock.now()) / factor;
    this.timer = setTimeout(() => this.step(), Math.min(Math.max(wait, 0), 60_000));
  }
}
