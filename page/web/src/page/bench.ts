// The bench: one board at a time, simulated or on the desk, and what is known of it.

import type { Event, Pins } from "unoclp-uno";
import { BOARDS, type BoardId, firmwareName } from "unoclp-uno/boards";
import type { Go } from "unoclp-uno/slow";
import type { Line } from "../line/line";
import type { Ask, BoardFacts, Both, News, Order, Seen, Settings, Stood, Text } from "../tools/answers";
import type { Modules } from "../tools/modules";
import { Died, NeedsMore, Refusal, Tools } from "../tools/tools";
import { NoLine } from "../line/none";
import { beside } from "../offline/beside";
import { both, say } from "../words/words";
import { type Clock, Conversation, WALL } from "./conversation";
import { DeskMachine } from "./deskmachine";
import { type Machines, OwnMachine, WorkerMachine } from "./machines";
import { OwnTime } from "./owntime";
import { Signal } from "./signal";
import { SimulatedBoard } from "./simulated";
import { type Way, Ways, formatOf } from "./ways";

/** The simulated board, one on the desk, or the core on this computer, which runs what is written for no board. */
export type Where = "simulated" | "desk" | "core";

/** How far an upload is: 0 to 1; storing. */
export type Upload = { readonly share: number } | "storing" | null;

/** The firmware of a board that is simulated. */
export async function firmwareOf(id: BoardId): Promise<Uint8Array> {
  return new Uint8Array(await (await beside(`${firmwareName(id)}.bin`)).arrayBuffer());
}

export class Bench {
  readonly where = new Signal<Where>("simulated");
  /** What the board at hand has. */
  readonly board: Signal<BoardFacts>;
  readonly seen = new Signal<Seen | null>(null);
  readonly identity = new Signal<string | null>(null);
  /** Why there is no board. */
  readonly lost = new Signal<Both | null>(null);
  readonly pins = new Signal<Pins | null>(null);
  readonly power = new Signal(false);
  readonly upload = new Signal<Upload>(null);
  /** How far a firmware is, 0 to 1. */
  readonly flashing = new Signal<number | null>(null);
  /** The program that was put on the board from here. */
  readonly on = new Signal<Text | null>(null);
  /** What the board has sent, as far as it is text. */
  readonly serial = new Signal("");
  readonly pace = new Signal<{ factor: number; asked: number } | null>(null);
  readonly paused = new Signal(false);
  /** Events of the simulated board, for those who want more of them. */
  readonly events = new Set<(event: Event) => void>();
  readonly simulated: SimulatedBoard;
  private readonly pending = new Set<Promise<unknown>>();
  /** What the board keeps for its next start; null until it was asked. */
  readonly settings = new Signal<Settings | null>(null);
  /** Who hears that something else is spoken to from now on. */
  readonly joined = new Set<(where: Where) => void>();
  private readonly ways = { simulated: new Ways(true), desk: new Ways(false), core: new Ways(true) };
  private readonly own = new OwnTime();
  private readonly ofWorker: Machines;
  private readonly ofCore = new OwnMachine(() => this.tools);
  readonly ofDesk = new DeskMachine(this, () => this.tools, async () => {
    await this.grow();
    return this.tools;
  });
  /** What the simulated board has. */
  private facts: BoardFacts;
  private whenLost = (): void => undefined;
  private line: Line | null = null;
  private talk: Conversation | null = null;
  /** The program that a board was asked for, as numeric code. */
  private fetched = "";
  private readonly orders = new Map<number, (told: { said: Both | null } | { why: Both }) => void>();

  constructor(
    private tools: Tools,
    private readonly modules: Modules,
    worker: Worker,
    private readonly tell: (both: Both) => void,
  ) {
    this.facts = tools.ask("board", {});
    this.board = new Signal(this.facts);
    this.simulated = new SimulatedBoard(worker, (event) => this.hearBoard(event));
    this.ofWorker = new WorkerMachine(worker, modules);
  }

  /** The clock of the board at hand. */
  get clock(): Clock {
    return { simulated: this.simulated, desk: WALL, core: this.own }[this.where.value];
  }

  /** Who moves a machine beside the board at hand. */
  get machines(): Machines {
    return { simulated: this.ofWorker, desk: this.ofDesk, core: this.ofCore }[this.where.value];
  }

  /** Speaks to a board. */
  async connect(where: Where, line: Line, reset: boolean, lost = (): void => undefined): Promise<void> {
    await this.disconnect();
    this.line = line;
    this.giveWay(where);
    this.where.value = where;
    this.whenLost = lost;
    const open = (program: Text | null): Promise<Conversation> =>
      Conversation.open(this.tools, this.opening(program, reset), line, formatOf(this.way), this.clock, {
        news: (news) => this.hear(news),
        bytes: (bytes) => this.listen(bytes),
        lost: () => {
          this.talk = null;
          this.forget();
          lost();
        },
        cause: () => say("cableOut"),
        died: () => void this.revive(),
      });
    try {
      this.talk = await open(this.on.value);
    } catch (error) {
      if (!(error instanceof Died)) throw error;
      await this.revive();
      this.talk = await open(null);
    }
    for (const hear of this.joined) hear(where);
  }

  /** Has this computer run what is written for a board that is none. */
  async useCore(board: BoardFacts): Promise<void> {
    if (this.where.value === "core" && this.board.value === board) return;
    // What has a program is not moved to other tools later.
    await this.grow();
    this.board.value = board;
    await this.connect("core", new NoLine(), false);
  }

  /** Goes to this simulated board, which may be another one than before; settled when it answers. */
  async simulate(board: BoardFacts): Promise<void> {
    const id = BOARDS.find((one) => one === board.id) ?? BOARDS[0];
    if (this.simulated.id === id) return this.where.value === "simulated" ? undefined : this.useSimulated();
    const firmware = await firmwareOf(id);
    await this.disconnect();
    this.facts = board;
    this.on.value = null;
    this.giveWay("simulated");
    this.where.value = "simulated";
    this.board.value = board;
    this.paused.value = false;
    this.simulated.start(id, firmware);
    await this.answers();
  }

  /** Settled when a board answers. */
  answers(): Promise<void> {
    return new Promise((found) => this.identity.follow((identity) => identity !== null && found()));
  }

  /** Goes back to the simulated board. */
  async useSimulated(): Promise<void> {
    if (this.power.value) return this.connect("simulated", this.simulated.line, false);
    await this.disconnect();
    this.giveWay("simulated");
    this.where.value = "simulated";
  }

  /** The simulated board stands while this computer runs a program in its place. */
  private giveWay(where: Where): void {
    if (where === this.where.value) return;
    if ([where, this.where.value].includes("core")) this.on.value = null;
    if (where === "core") this.simulated.tell({ kind: "pause" });
    else this.board.value = this.facts;
    if (this.where.value === "core") this.simulated.tell({ kind: "run" });
    this.own.stand(false);
    this.paused.value = false;
  }

  private opening(program: Text | null, reset: boolean): Ask<"open"> {
    // This computer has no program until it is given one.
    const core = this.where.value === "core" ? { of: null, core: true } : {};
    return { of: program, reset, board: this.board.value.id, ...this.way, ...core };
  }

  private isWhole = false;
  private reviving: Promise<void> | null = null;

  /** The tools have broken down: others take their place, on the same line. What they were asked is not done, and what the
   * board runs is no longer known: it may be what they broke down over. */
  private revive(): Promise<void> {
    this.reviving ??= (async () => {
      this.tools = await this.tools.anew();
      this.on.value = null;
      this.upload.value = null;
      for (const settle of [...this.orders.values()]) settle({ why: both("toolsDied") });
      this.orders.clear();
      this.talk?.move(this.tools, this.opening(null, false));
      this.tellJoined();
    })().finally(() => {
      this.reviving = null;
    });
    return this.reviving;
  }

  /** The tools that have everything speak from now on, behind what was ordered before. The line stays open: a board at
   * a port would be reset, and its program would begin again. */
  private async grow(): Promise<void> {
    if (this.isWhole) return;
    const whole = await Tools.of(await this.modules.full());
    while (this.pending.size > 0) await Promise.allSettled(this.pending);
    this.tools = whole;
    this.isWhole = true;
    this.talk?.move(this.tools, this.opening(this.on.value, false));
  }

  /** Other tools know nothing of what this computer ran. */
  private tellJoined(): void {
    if (this.where.value === "core") for (const hear of this.joined) hear("core");
  }

  /** The same line, spoken to from the beginning. */
  private async reconnect(): Promise<void> {
    const { line, where } = this;
    if (line) await this.connect(where.value, line, where.value === "desk", this.whenLost);
  }

  /** How the board is spoken to. */
  get way(): Way {
    return this.ways[this.where.value].now;
  }

  /** Speaks to the board otherwise from now on. */
  async speak(way: Way): Promise<void> {
    this.ways[this.where.value].choose(way);
    await this.reconnect();
  }

  /** The board begins again: it speaks as it has kept it. */
  begun(): void {
    this.settings.value = null;
    if (this.ways[this.where.value].begun()) void this.reconnect();
  }

  async disconnect(): Promise<void> {
    const { talk } = this;
    this.talk = null;
    this.forget();
    await talk?.close();
  }

  /** Has something done; settled when it is done, or told to the person when it is not. */
  async order(order: Order): Promise<Both | null> {
    try {
      return await this.once(order);
    } catch (error) {
      if (!(error instanceof NeedsMore)) throw error;
      await this.grow();
      return this.once(order);
    }
  }

  private once(order: Order): Promise<Both | null> {
    const done = new Promise<Both | null>((resolve, reject) => {
      if (!this.talk) return reject(new Refusal({ en: "there is no board", pt: "não há placa" }));
      try {
        this.talk.order(order, (number) => {
          this.orders.set(number, (told) => ("why" in told ? reject(new Refusal(told.why)) : resolve(told.said)));
        });
      } catch (error) {
        if (error instanceof Died) void this.revive();
        reject(error instanceof Died ? new Refusal(both("toolsDied")) : error);
      }
    });
    const over = (): void => void this.pending.delete(done);
    this.pending.add(done);
    done.then(over, over);
    return done;
  }

  /** The same, for those who have nothing to do behind it. */
  async ask(order: Order): Promise<void> {
    try {
      await this.order(order);
    } catch (error) {
      if (error instanceof Refusal) this.tell(error.both);
      else throw error;
    }
  }

  /** Watches the board by a program that it has. */
  async watch(text: Text): Promise<void> {
    await this.order({ do: "watch", of: text, board: this.board.value.id });
    this.on.value = text;
  }

  /** The program that the board keeps, as numeric code. */
  async fetch(): Promise<string> {
    this.takeTime();
    await this.order({ do: "fetch" });
    return this.fetched;
  }

  /** Puts a program on the board and runs it. */
  async put(text: Text): Promise<void> {
    this.upload.value = { share: 0 };
    try {
      this.takeTime();
      const said = await this.order({ do: "upload", of: text, board: this.board.value.id });
      if (said) this.tell(said);
    } finally {
      this.upload.value = null;
    }
  }

  /** Whether there is a line to a board. */
  get isOpen(): boolean {
    return this.talk !== null;
  }

  /** Writes a firmware, as Intel hex, by the boot loader of this kind of board. */
  async flash(hex: string, model: string): Promise<void> {
    try {
      await this.order({ do: "flash", hex, model });
    } finally {
      this.flashing.value = null;
    }
  }

  /** Goes on with the scan that this computer makes. */
  slowly(go: Go): Stood | null {
    return this.talk?.slowly(go) ?? null;
  }

  /** What is asked of the board at hand takes time: a simulated one goes on. */
  takeTime(): void {
    if (this.paused.value && this.where.value !== "desk") this.goOn();
  }

  pause(): void {
    if (this.where.value === "core") this.own.stand(true);
    else this.simulated.tell({ kind: "pause" });
    this.paused.value = true;
  }

  goOn(): void {
    if (this.where.value === "core") this.own.stand(false);
    else this.simulated.tell({ kind: "run" });
    this.paused.value = false;
  }

  speed(factor: number): void {
    this.own.speed(factor);
    this.simulated.tell({ kind: "speed", factor });
  }

  private forget(): void {
    this.seen.value = null;
    this.identity.value = null;
    this.settings.value = null;
    this.lost.value = null;
    this.upload.value = null;
    const why = { en: "the line is closed", pt: "a linha está fechada" };
    for (const settle of [...this.orders.values()]) settle({ why });
    this.orders.clear();
  }

  private hearBoard(event: Event): void {
    if (event.kind === "pins") this.pins.value = event.pins;
    if (event.kind === "pace") this.pace.value = { factor: event.factor, asked: event.asked };
    if (event.kind === "power") {
      this.power.value = event.on;
      if (this.where.value === "simulated") {
        this.ways.simulated.begun();
        if (event.on) void this.connect("simulated", this.simulated.line, true);
        else void this.disconnect();
      }
    }
    // One by power is known already.
    if (event.kind === "reset" && event.cause !== "power" && this.where.value === "simulated") this.begun();
    for (const hear of this.events) hear(event);
  }

  private hear(news: News): void {
    switch (news.news) {
      case "found":
        // One on the desk says which it is.
        if (news.board !== null && this.where.value === "desk") this.board.value = this.tools.ask("board", { board: news.board });
        this.identity.value = news.identity;
        this.lost.value = null;
        break;
      case "lost":
        this.lost.value = news.why;
        this.seen.value = null;
        this.settings.value = null;
        // It may be set otherwise than is known.
        if (this.ways[this.where.value].turn()) void this.reconnect();
        break;
      case "seen":
        // Its clock begins with it.
        if (news.at < (this.seen.value?.at ?? 0)) this.begun();
        this.seen.value = news;
        break;
      case "sent":
        this.upload.value = { share: news.of > 0 ? news.bytes / news.of : 1 };
        break;
      case "storing":
        this.upload.value = "storing";
        break;
      case "flashing":
        this.flashing.value = news.done / Math.max(news.of, 1);
        break;
      case "fetched":
        this.fetched = news.code;
        break;
      case "settings":
        this.ways[this.where.value].expect(news);
        this.settings.value = news;
        break;
      case "stored":
        break;
      case "done":
      case "undone": {
        const settle = this.orders.get(news.order);
        this.orders.delete(news.order);
        settle?.(news.news === "done" ? { said: news.said } : { why: news.why });
        break;
      }
    }
  }

  /** Keeps the text among the bytes: what a board says at its start. */
  private listen(bytes: Uint8Array): void {
    const text = new TextDecoder("latin1").decode(bytes);
    this.tail = (this.tail + text).slice(-4000);
    const begins = this.tail.lastIndexOf("\r\nunoclp ");
    if (begins < 0) return;
    const said = /^[\r\n\t\x20-\x7e]*/.exec(this.tail.slice(begins))?.[0] ?? "";
    const lines = said.split("\r\n");
    const end = lines.findIndex((line, index) => index > 1 && /^(RUN|STOP|fault )/.test(line));
    const shown = (end < 0 ? lines : lines.slice(0, end + 1)).join("\n").trim();
    if (shown !== this.last) {
      const before = shown.startsWith(this.last) && this.last ? this.serial.value.slice(0, -this.last.length) : this.serial.value && `${this.serial.value}\n\n`;
      this.serial.value = (before + shown).slice(-8000);
      this.last = shown;
    }
    if (end >= 0) {
      this.tail = this.tail.slice(begins + said.length);
      this.last = "";
    }
  }

  private tail = "";
  private last = "";
}
