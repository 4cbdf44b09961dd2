// The machine beside the board: seen, touched, and judged. It is drawn by Rust; here its changes are applied, and what a
// person does to it is told.

import type { Both, Hand, MachineFacts, MachineLook, Searched, Seen } from "../tools/answers";
import { Refusal } from "../tools/tools";
import { say, speak, told } from "../words/words";
import type { Bench, Where } from "./bench";
import { h } from "./dom";
import type { ForBoard } from "./forboard";
import { icon } from "./icons";
import type { Machines } from "./machines";
import { announce, note } from "./notes";
import { Scene } from "./scene";
import { seconds } from "./seconds";
import { copyLink } from "./links";
import { Signal } from "./signal";

/** A machine as a file. */
export interface MachineFile {
  readonly name: string;
  readonly text: string;
  /** The exercise whose fault is hidden in it. */
  readonly find?: string;
  /** Whether it is somebody's own: then a link can carry it. */
  readonly isOwn?: boolean;
}

/** Shows a hand as it stands, at this moment of the machine, in ms. */
type Show = (value: number, at: number) => void;

/** A button stays pressed for so long at least, in ms of the machine: the program sees a tap that is shorter. */
const TAP = 20;

export class MachineArea {
  readonly root = h("section", { class: "card machine", id: "machine", hidden: true, "aria-labelledby": "machine-title" });
  private readonly title = h("span", { id: "machine-title" });
  private readonly about = h("p", { class: "note" });
  /** That the board of the program lacks points of the machine, and how to choose the one that has them. */
  private readonly other = h("div", { id: "machine-other", role: "status", hidden: true });
  private readonly age = h("p", { class: "note", id: "machine-age", hidden: true });
  private readonly scene = new Scene("machine-picture");
  private readonly below = h("div", { class: "row machine-hands" });
  private readonly verdict = h("ul", { class: "machine-rules", id: "machine-rules" });
  private readonly faults = h("div", { class: "machine-faults" });
  private readonly failing = h("details", { id: "machine-failing" }, h("summary", { "data-say": "machineFaults" }), this.faults);
  private readonly judged = h("div", { id: "machine-judged" });
  private readonly judging = h("button", { type: "button", class: "small", id: "machine-judge", click: () => this.file && this.judgeBy(this.file, this.judged) }, icon("tick"), h("span", { "data-say": "machineJudge" }));
  private readonly link = h("button", { type: "button", class: "small quiet", id: "machine-link", "data-say-label": "machineLink", click: () => void this.share() }, icon("share"));
  /** How far somebody is who looks for its fault; null: none is hidden. */
  readonly search = new Signal<Searched | null>(null);
  private file: MachineFile | null = null;
  private facts: MachineFacts | null = null;
  private forced = "";
  private beside: Where = "simulated";
  private besideBoard: unknown = null;
  private mover: Machines | null = null;
  private broken = 0;
  private looking = false;
  /** What shows a hand as it stands, in the order of the hands. */
  private shows: Show[] = [];

  constructor(
    private readonly bench: Bench,
    /** What the machine is wired to; null: there is none. */
    private readonly wired: (facts: MachineFacts | null) => void,
    /** Has the program judged by the rules of the machine, and shows in this element what came of it. */
    private readonly judgeBy: (file: MachineFile, into: HTMLElement) => void,
    private readonly forBoard: ForBoard,
    private readonly target: Signal<string>,
  ) {
    const reset = h("button", { type: "button", class: "small", id: "machine-reset", click: () => void this.reset() }, icon("reset"), h("span", { "data-say": "machineReset" }));
    const close = h("button", { type: "button", class: "small quiet", id: "machine-close", "data-say-label": "machineClose", click: () => void this.close() }, "×");
    this.root.append(h("h3", {}, this.title, close), this.about, this.other, this.age, this.scene.root, this.below, h("div", { class: "row" }, reset, this.judging, this.link), this.verdict,
      this.judged, this.failing);
    speak.follow(() => {
      if (this.file) void this.open(this.file, true);
    });
    bench.ofDesk.interval.follow((ms) => {
      this.age.hidden = ms === null;
      if (ms !== null) this.age.textContent = say("machineAge", { ms });
    });
    bench.seen.follow((seen) => this.countForced(seen));
    // Beside another board it begins again.
    bench.joined.add((where) => {
      if (this.file && (where !== this.beside || bench.board.value !== this.besideBoard)) void this.open(this.file);
    });
    target.follow(() => this.compare());
  }

  /** Has this machine, as it is at first, or as it is. */
  async open(file: MachineFile, keep = false): Promise<void> {
    const { machines } = this.bench;
    this.beside = this.bench.where.value;
    this.besideBoard = this.bench.board.value;
    try {
      const facts = await machines.ask("machine", { name: file.name, text: file.text, speak: speak.value, keep, board: this.bench.board.value.id, ...(file.find === undefined ? {} : { find: file.find }) });
      const before = this.mover;
      this.mover = machines;
      // The one before stands.
      if (before && before !== machines) before.leave();
      this.file = file;
      this.show(facts);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
      // One that was there before this file stays where it was; beside a board on the desk its inputs have been let go.
      if (this.file?.text === file.text || this.beside === "desk") this.forget();
    }
  }

  /** The file of the one that is open. */
  get opened(): MachineFile | null {
    return this.file;
  }

  private show(facts: MachineFacts): void {
    this.facts = facts;
    this.title.textContent = told(facts.title);
    this.about.textContent = told(facts.about);
    // It is no picture alone: one can press what is in it.
    this.scene.show(facts.svg, told(facts.title)).setAttribute("role", "group");
    this.below.replaceChildren();
    const taken = new Set<string>();
    this.shows = facts.hands.map((hand) => {
      const symbol = taken.has(hand.name) || !isFlag(hand) ? null : this.scene.symbolOf(hand.name);
      taken.add(hand.name);
      return symbol ? this.touch(symbol, hand) : this.lever(hand);
    });
    this.below.hidden = this.below.children.length === 0;
    this.verdict.removeAttribute("data-shown");
    this.judge({ broken: [], met: [] });
    this.link.hidden = this.file?.isOwn !== true;
    // What is hidden is found by looking, and not by a list.
    this.failing.hidden = this.judging.hidden = this.file?.find !== undefined;
    this.judged.replaceChildren();
    this.faults.replaceChildren(...facts.faults.map(([part, fault, name]) => {
      const box = h("input", { type: "checkbox", change: () => void this.ask("machineFault", { part, fault, is: box.checked }) });
      return h("label", { class: "switch" }, box, h("span", {}, `${partName(facts, part)}: ${told(name)}`));
    }));
    this.compare();
    this.root.hidden = false;
    this.wired(facts);
    if (!this.looking) void this.look();
  }

  /** Whether the board that the program is written for has the points of the machine; else one may choose that which has. */
  private compare(): void {
    const { facts } = this;
    if (!facts) return;
    const { name, inputs, analogue, outputs } = this.forBoard.chosen;
    const [ins, readings, outs] = facts.uses.map((numbers) => Math.max(0, ...numbers)) as [number, number, number];
    this.other.hidden = ins <= inputs && outs <= outputs && (facts.uses[1].length === 0 || readings < analogue);
    if (this.other.hidden) return;
    const board = this.forBoard.nameOf(facts.board);
    const choose = h("button", { type: "button", class: "small", id: "machine-board", click: () => { this.target.value = facts.board; } }, say("machineOther", { board }));
    this.other.replaceChildren(h("p", {}, say("machineLacks", { board, ins, outs, name, inputs, outputs })), choose);
  }

  /** Lets go of it. */
  async close(): Promise<void> {
    await this.ask("machineClose", {});
    this.forget();
  }

  private forget(): void {
    this.file = this.facts = this.mover = null;
    this.search.value = null;
    this.root.hidden = true;
    this.wired(null);
  }

  private async reset(): Promise<void> {
    await this.ask("machineReset", {});
    for (const box of this.faults.querySelectorAll("input")) box.checked = false;
    this.broken = 0;
  }

  /** What has changed is drawn, as often as the screen is. */
  private async look(): Promise<void> {
    this.looking = true;
    while (this.facts) {
      await new Promise<void>((go) => requestAnimationFrame(() => go()));
      const seen = this.facts && (await this.ask("machineLook", {}));
      if (!seen) break;
      this.scene.apply(seen.changes);
      seen.hands.forEach((value, hand) => this.shows[hand]?.(value, seen.at));
      this.judge(seen);
      this.tell(seen.search);
    }
    this.looking = false;
  }

  private tell(search: Searched | null): void {
    if (JSON.stringify(search) !== JSON.stringify(this.search.value)) this.search.value = search;
  }

  /** How its parts can fail; null: there is no machine. */
  get ways(): MachineFacts | null {
    return this.facts;
  }

  /** Somebody names the fault that is hidden in it. */
  async name(part: number, fault: string): Promise<void> {
    try {
      this.tell((await this.mover?.ask("machineName", { part, fault })) ?? null);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
    }
  }

  /** Each point that somebody forces is a step of a search. A board on the desk has its inputs forced by the machine. */
  private countForced(seen: Seen | null): void {
    const forced = JSON.stringify(seen ? [seen.forcedOutputs, this.bench.where.value === "desk" ? [] : seen.forcedInputs] : []);
    if (forced === this.forced) return;
    const isMore = /true|false/.test(forced);
    this.forced = forced;
    if (isMore && this.search.value) void this.ask("machineForced", {});
  }

  private async share(): Promise<void> {
    if (this.file) await copyLink("m", [this.file.name, this.file.text]);
  }

  /** Which rules hold: each is said once as it breaks. */
  private judge({ broken, met }: Pick<MachineLook, "broken" | "met">): void {
    const { facts } = this;
    if (!facts) return;
    const nevers = facts.rules.length - met.length;
    const at = new Map(broken);
    const rows = facts.rules.map((rule, number) => {
      const when = at.get(number);
      const count = number >= nevers ? (met[number - nevers] ?? 0) : 0;
      const state = when !== undefined ? "broken" : count > 0 ? "met" : "open";
      const rest = when !== undefined ? ` – ${say("machineBroke", { s: seconds(when) })}` : count > 0 ? ` – ${say("machineMet", { n: count })}` : "";
      return { state, text: `${told(rule)}${rest}` };
    });
    const shown = JSON.stringify(rows);
    if (this.verdict.dataset["shown"] === shown) return;
    this.verdict.dataset["shown"] = shown;
    this.verdict.replaceChildren(...rows.map(({ state, text }) => h("li", { "data-state": state }, text)));
    if (broken.length < this.broken) this.broken = 0;
    for (const [rule] of broken.slice(this.broken)) announce(`${say("machineBrokeNow")}: ${told(facts.rules[rule] as Both)}`);
    this.broken = Math.max(this.broken, broken.length);
  }

  private hand({ part, value }: Hand, to: number): void {
    void this.ask("machineHand", { part, value, to });
  }

  /** A symbol that is pressed or turned where it stands. */
  private touch(symbol: SVGElement, hand: Hand): Show {
    const name = `${told(hand.label)}`;
    symbol.classList.add("touch");
    for (const [key, value] of [["tabindex", "0"], ["role", "button"], ["aria-label", name], ["aria-pressed", "false"]] as const) symbol.setAttribute(key, value);
    let is = 0;
    // Since when the machine has known it pressed, whether that is long enough, and whether it is to be let go.
    let since: number | null = null;
    let isLong = false;
    let isLeft = false;
    const press = (): void => {
      [since, isLong, isLeft] = [null, false, false];
      this.hand(hand, hand.isHeld ? hand.high : is ? hand.low : hand.high);
    };
    const letGo = (): void => {
      if (!isLeft || !isLong) return;
      isLeft = false;
      this.hand(hand, hand.low);
    };
    const release = (): void => {
      isLeft = hand.isHeld;
      letGo();
    };
    symbol.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      symbol.setPointerCapture(event.pointerId);
      press();
    });
    for (const kind of ["pointerup", "pointercancel"]) symbol.addEventListener(kind, release);
    symbol.addEventListener("keydown", (event) => {
      if ((event.key !== " " && event.key !== "Enter") || event.repeat) return;
      event.preventDefault();
      press();
    });
    symbol.addEventListener("keyup", (event) => {
      if (event.key === " " || event.key === "Enter") release();
    });
    symbol.addEventListener("blur", release);
    return (value, at) => {
      since = value === hand.high ? (since ?? at) : null;
      isLong = since !== null && at >= since + TAP;
      letGo();
      if (value === is) return;
      is = value;
      symbol.setAttribute("aria-pressed", String(is !== 0));
    };
  }

  /** What has no symbol of its own, or more than two states. */
  private lever(hand: Hand): Show {
    const label = `${told(hand.label)}`;
    if (isFlag(hand)) {
      const box = h("input", { type: "checkbox", change: () => this.hand(hand, box.checked ? 1 : 0) });
      this.below.append(h("label", { class: "switch" }, box, h("span", {}, label)));
      return (value) => {
        box.checked = value !== 0;
      };
    }
    const range = h("input", { type: "range", min: hand.low, max: hand.high, "aria-label": label, input: () => this.hand(hand, Number(range.value)) });
    this.below.append(h("label", { class: "knob" }, h("b", {}, label), range));
    return (value) => {
      if (document.activeElement !== range) range.value = String(value);
    };
  }

  private async ask<K extends "machineLook" | "machineHand" | "machineFault" | "machineForced" | "machineReset" | "machineClose">(
    what: K, request: Parameters<Machines["ask"]>[1],
  ): Promise<MachineLook | null> {
    try {
      return ((await this.mover?.ask(what, request as never)) ?? null) as MachineLook | null;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
      this.forget();
      return null;
    }
  }
}

/** What a part is called; where another is called the same, its name in the file too. */
export function partName({ parts, names }: MachineFacts, part: number): string {
  const label = parts[part];
  if (!label) return "";
  const same = parts.filter((other) => told(other) === told(label)).length > 1;
  return same ? `${told(label)} (${names[part] ?? ""})` : told(label);
}

function isFlag({ low, high }: Hand): boolean {
  return low === 0 && high === 1;
}
