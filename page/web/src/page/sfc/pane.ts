// A chart beside the ladder that it becomes: its drawing, live, and what a person does to it. Rust draws it and changes the
// text; here it is shown.

import type { ChartDrawn, ChartPart, Problem, Text } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { say } from "../../words/chart";
import { speak, translate } from "../../words/words";
import { asked } from "../asked";
import type { Bench } from "../bench";
import type { Looked, ProgramDocument } from "../document";
import { h } from "../dom";
import { keep, kept } from "../kept";
import { announce } from "../notes";
import type { Past } from "../project/past";
import { attend, reveal } from "../reveal";
import { DRAWN } from "./drawn";
import { type Done, Form } from "./form";
import { LiveChart } from "./live";

/** What of the page the chart works with. */
export interface Around {
  readonly program: ProgramDocument;
  readonly tools: RemoteTools;
  readonly bench: Bench;
  /** Shows a text in the editor too. */
  readonly write: (text: Text) => void;
}

/** What a button does to the selected part, and its key. */
const ACTS = [
  ["after", "chartAfter", "a"], ["before", "chartBefore", "i"], ["branch", "chartBranch", "b"], ["beside", "chartBeside", "p"],
  ["act", "chartAct", "q"], ["left", "chartLeft", "<"], ["right", "chartRight", ">"], ["remove", "chartRemove", "Delete"],
] as const;
/** Those that a sign says, where a word would take the room of two. */
const SIGNS: Readonly<Record<string, string>> = { left: "←", right: "→" };
const ARROWS: Readonly<Record<string, readonly [x: number, y: number]>> = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };
/** What the browser keeps: the look of GRAFCET, or of IEC 61131-3. */
const LOOK = "chart-look";
/** Units of the drawing: parts that are nearer stand beside each other. */
const BESIDE = 4;

export class ChartPane {
  private readonly paper = h("div", { class: "paper", id: "chart-sheet", tabindex: 0, role: "application", "data-say-label": "chartSheet" });
  private readonly undo = h("button", { type: "button", id: "chart-undo", "data-say-label": "chartUndo", click: () => void this.back("undo") }, "↶");
  private readonly redo = h("button", { type: "button", id: "chart-redo", "data-say-label": "chartRedo", click: () => void this.back("redo") }, "↷");
  private readonly units = h("select", { id: "chart-unit", "data-say-label": "chart", change: () => void this.turnTo(this.units.selectedIndex) });
  private readonly pane: HTMLElement;
  private readonly form: Form;
  private readonly live: LiveChart;
  private chart: ChartDrawn | null = null;
  /** What is wrong with the text, as far as that is known already. */
  private problems: readonly Problem[] = [];
  /** The unit whose chart is shown; none: the one that a person picks. */
  private unit: string | undefined;
  /** The number of the chart among those of the text. */
  private number = 0;
  private selected = "s0";
  private queue: Promise<void> = Promise.resolve();

  constructor(
    private readonly around: Around,
    private readonly past: Past,
  ) {
    this.form = new Form((act) => void this.act(act), () => attend(this.paper));
    this.live = new LiveChart(this.paper, around.program, around.bench);
    const buttons = ACTS.map(([what, word, key]) =>
      h("button", { type: "button", id: `chart-${what}`, [SIGNS[what] ? "data-say-label" : "data-say"]: word, title: key, click: () => void this.act({ what }).then(() => attend(this.paper)) }, SIGNS[what] ?? ""));
    const look = h("button", { type: "button", id: "chart-look", "data-say": "chartLook", click: () => {
      keep(LOOK, this.look === "grafcet" ? "norm" : "grafcet");
      void this.turnTo(this.number);
    } });
    this.pane = h("section", { class: "chart-pane", id: "chart", "data-say-label": "chart" },
      h("div", { class: "bar chart-bar" }, this.units, this.undo, this.redo, ...buttons, look),
      h("div", { class: "chart-work" }, this.paper, this.form.root));
    this.paper.addEventListener("keydown", (event) => this.key(event));
    this.paper.addEventListener("click", (event) => {
      const part = (event.target as Element).closest<SVGElement>("[data-id]");
      if (part?.dataset["id"]) this.select(part.dataset["id"]);
    });
    this.paper.addEventListener("dblclick", () => this.form.focus());
    speak.follow(() => {
      translate(this.pane);
      this.select(this.selected);
      this.tell();
    });
  }

  private get look(): string {
    return kept(LOOK) ?? "norm";
  }

  /** Stands here, before all else, as soon as there is a chart. */
  at(root: HTMLElement): void {
    if (this.isAt(root)) return;
    this.pane.parentElement?.removeAttribute("data-chart");
    root.prepend(this.pane);
  }

  isAt(root: HTMLElement): boolean {
    return this.pane.parentElement === root;
  }

  /** Stands here no longer. */
  leave(root: HTMLElement): void {
    if (!this.isAt(root)) return;
    root.removeAttribute("data-chart");
    this.pane.remove();
  }

  /** Shows the chart of a text, if it has one; of a project that of a unit. */
  show({ text, checked }: Looked, unit?: string): Promise<void> {
    return this.next(async () => {
      if (text !== this.around.program.text.value) return;
      if (unit !== this.unit) [this.unit, this.selected] = [unit, "s0"];
      if (this.past.meet(text) === "another") [this.number, this.selected] = [0, "s0"];
      this.problems = checked.problems;
      await (checked.language === "st" || unit !== undefined ? this.draw(text) : this.take([]));
    });
  }

  private async draw(of: Text): Promise<void> {
    await asked(this.around.tools.ask("chart", { of, look: this.look, chart: Math.max(0, this.number) }), ({ charts }) => this.take(charts));
  }

  /** These are the charts of the text. */
  private take(charts: readonly ChartDrawn[]): void {
    const own = charts.findIndex(({ unit }) => unit === this.unit);
    this.number = this.unit === undefined ? Math.max(0, Math.min(this.number, charts.length - 1)) : own;
    const before = this.chart;
    const chart = this.chart = charts[this.number] ?? null;
    this.pane.parentElement?.toggleAttribute("data-chart", chart !== null);
    this.units.hidden = charts.length < 2 || this.unit !== undefined;
    this.units.replaceChildren(...charts.map(({ unit }, at) => h("option", { selected: at === this.number }, unit)));
    this.undo.disabled = !this.past.has("undo");
    this.redo.disabled = !this.past.has("redo");
    if (!chart) return;
    if (chart.svg !== before?.svg) {
      const { scrollTop, scrollLeft } = this.paper;
      this.paper.innerHTML = chart.svg;
      this.paper.scrollTo(scrollLeft, scrollTop);
    }
    this.tell();
    this.select(this.selected);
    for (const part of chart.parts) {
      const wrong = this.wrongIn(part);
      const group = this.paper.querySelector(`[data-id="${part.id}"]`);
      group?.classList.toggle("wrong", wrong.some(({ severity }) => severity === "error"));
      group?.classList.toggle("warned", wrong.some(({ severity }) => severity === "warning"));
    }
    this.live.show(chart);
  }

  /** Each part says what it is, and which instructions it has become: slow motion stops there. */
  private tell(): void {
    for (const part of this.chart?.parts ?? []) {
      const { dataset } = this.paper.querySelector<SVGElement>(`[data-id="${part.id}"]`) ?? {};
      if (dataset) [dataset["code"], dataset["said"]] = [part.steps.join(" "), called(part)];
    }
    this.paper.dispatchEvent(new CustomEvent(DRAWN, { bubbles: true }));
  }

  private wrongIn({ places }: ChartPart): readonly Problem[] {
    return this.problems.filter((problem) => places.some(([from = 0, to = 0]) => problem.from >= from && problem.from < to));
  }

  /** Shows another chart of the text, or the same in another look. */
  private turnTo(number: number): Promise<void> {
    return this.next(async () => {
      if (number !== this.number) [this.number, this.selected] = [number, "s0"];
      if (this.past.now) await this.draw(this.past.now);
    });
  }

  private select(id: string): void {
    const { chart } = this;
    const part = chart?.parts.find((part) => part.id === id) ?? chart?.parts[0];
    if (!chart || !part) return;
    if (part.id !== this.selected) announce(called(part));
    this.selected = part.id;
    for (const one of this.paper.querySelectorAll<SVGElement>("[data-id]")) one.classList.toggle("selected", one.dataset["id"] === part.id);
    this.form.show(part, chart.parts.filter(({ kind }) => kind === "step").map(({ name }) => name), this.wrongIn(part));
  }

  /** Does something to the selected part. */
  private act(act: Done): Promise<void> {
    return this.next(async () => {
      const { program, tools, write } = this.around;
      const of = this.past.now;
      if (!of) return;
      await asked(tools.ask("chart", { of, look: this.look, chart: this.number, at: this.selected, ...act }), ({ charts, text, select }) => {
        if (text === null || !program.isStill(of)) return;
        this.selected = select ?? this.selected;
        const after = { ...of, text };
        this.past.did(after);
        this.problems = [];
        this.take(charts);
        write(after);
      });
    });
  }

  private back(way: "undo" | "redo"): Promise<void> {
    return this.next(async () => {
      const text = this.past.go(way);
      if (!text) return;
      this.problems = [];
      this.around.write(text);
      await this.draw(text);
      attend(this.paper);
    });
  }

  /** One thing after the other: each begins with the text that the last has made. */
  private next(job: () => Promise<void> | void): Promise<void> {
    this.queue = this.queue.then(job);
    return this.queue;
  }

  private key(event: KeyboardEvent): void {
    const { key } = event;
    const control = event.ctrlKey || event.metaKey;
    const arrow = ARROWS[key];
    const letter = key.length === 1 ? key.toLowerCase() : key;
    if (control && letter === "z") void this.back(event.shiftKey ? "redo" : "undo");
    else if (control && letter === "y") void this.back("redo");
    else if (control || event.altKey) return;
    else if (arrow) void this.next(() => this.move(arrow));
    else if (key === "Enter") void this.next(() => this.form.focus());
    else {
      const act = ACTS.find(([, , own]) => own === (letter === "Backspace" ? "Delete" : letter));
      if (!act) return;
      void this.act({ what: act[0] });
    }
    event.preventDefault();
  }

  /** Selects the nearest part in a direction. */
  private move([x, y]: readonly [x: number, y: number]): void {
    const parts = this.chart?.parts ?? [];
    const own = parts.find(({ id }) => id === this.selected);
    if (!own) return;
    const far = (part: ChartPart): number => {
      const along = (part.x - own.x) * x + (part.y - own.y) * y;
      const across = Math.abs((part.x - own.x) * y) + Math.abs((part.y - own.y) * x);
      return along < BESIDE ? Infinity : along + 2 * across;
    };
    const nearest = parts.reduce((best, part) => (far(part) < far(best) ? part : best), own);
    this.select(nearest.id);
    const seen = this.paper.querySelector(`[data-id="${nearest.id}"]`);
    if (seen) reveal(seen);
  }
}

/** A part in words. */
function called({ kind, name, text }: ChartPart): string {
  return `${say(KINDS[kind] ?? "chartStep")} ${kind === "transition" ? text : name}`;
}

/** What the kinds of parts are called. */
const KINDS: Readonly<Record<string, "chartStep" | "chartAction" | "chartTransition" | "chartJump" | "chartWait">> = {
  step: "chartStep", does: "chartAction", transition: "chartTransition", jump: "chartJump", wait: "chartWait",
};
