// A chart: its drawing, live, and what a person does to it. Rust draws it and changes the text; here it is only shown.

import type { ChartDrawn, ChartPart, Seen, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { say } from "../words/chart";
import { speak, translate } from "../words/words";
import { asked } from "./asked";
import type { Bench } from "./bench";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import { liveOf } from "./forcing";
import { keep, kept } from "./kept";

const QUALIFIERS = ["N", "S", "R", "L", "D", "P", "P1", "P0", "SD", "DS", "SL"];
/** What a button does to the selected part, and its key. */
const ACTS = [
  ["after", "chartAfter", "a"], ["branch", "chartBranch", "b"], ["beside", "chartBeside", "p"], ["act", "chartAct", "q"],
  ["left", "chartLeft", "<"], ["right", "chartRight", ">"], ["remove", "chartRemove", "Delete"],
] as const;
const ARROWS: Readonly<Record<string, readonly [number, number]>> = { ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0] };

type Done = Readonly<Partial<Record<"what" | "at" | "say" | "qualifier" | "time", string>>>;

export class ChartPane {
  readonly root = h("section", { class: "chart-pane", id: "chart", "data-say-label": "chart" });
  private readonly paper = h("div", { class: "paper", id: "chart-sheet", tabindex: 0, role: "application", "data-say-label": "chartSheet" });
  private readonly form = h("form", { class: "chart-form", id: "chart-form", submit: (event) => event.preventDefault() });
  private readonly undo = h("button", { type: "button", id: "chart-undo", "data-say-label": "chartUndo", disabled: true, click: () => this.back(this.past, this.future) }, "↶");
  private readonly redo = h("button", { type: "button", id: "chart-redo", "data-say-label": "chartRedo", disabled: true, click: () => this.back(this.future, this.past) }, "↷");
  private chart: ChartDrawn | null = null;
  private selected = "s0";
  /** The texts before what was done, and those that were undone. */
  private readonly past: Text[] = [];
  private readonly future: Text[] = [];
  /** The text that it shows. */
  private shown: Text | null = null;

  constructor(
    private readonly program: ProgramDocument,
    private readonly tools: RemoteTools,
    private readonly bench: Bench,
    /** Shows a text in the editor too. */
    private readonly write: (text: Text) => void,
  ) {
    const buttons = ACTS.map(([what, word, key]) =>
      h("button", { type: "button", id: `chart-${what}`, "data-say": word, title: key, click: () => this.done(what) }));
    const look = h("button", { type: "button", id: "chart-look", "data-say": "chartLook", click: () => {
      keep("look", kept("look") === "grafcet" ? "norm" : "grafcet");
      if (this.shown) void this.show(this.shown);
    } });
    this.root.append(h("div", { class: "bar chart-bar" }, this.undo, this.redo, ...buttons, look), this.paper, this.form);
    translate(this.root);
    this.paper.addEventListener("keydown", (event) => this.key(event));
    this.paper.addEventListener("click", (event) => {
      const part = (event.target as Element).closest<SVGElement>("[data-id]");
      if (part?.dataset["id"]) this.select(part.dataset["id"]);
    });
    bench.seen.follow(() => this.live());
    speak.follow(() => this.select(this.selected));
  }

  /** Shows the chart of a text; says whether it has one. */
  async show(text: Text): Promise<boolean> {
    if (this.shown && this.shown.text !== text.text) this.past.length = this.future.length = 0;
    this.shown = text;
    const { charts } = await this.tools.ask("chart", { of: text, look: kept("look") ?? "norm", chart: 0 });
    // Another was asked for meanwhile.
    if (this.shown.text !== text.text) return this.chart !== null;
    this.chart = charts[0] ?? null;
    if (this.chart) this.draw(this.chart);
    return this.chart !== null;
  }

  private draw(chart: ChartDrawn): void {
    const { scrollTop, scrollLeft } = this.paper;
    this.paper.innerHTML = chart.svg;
    this.paper.scrollTo(scrollLeft, scrollTop);
    this.undo.disabled = this.past.length === 0;
    this.redo.disabled = this.future.length === 0;
    this.select(this.selected);
    this.live();
  }

  private find(id: string): ChartPart | undefined {
    return this.chart?.parts.find((part) => part.id === id);
  }

  private select(id: string): void {
    const part = this.find(id) ?? this.chart?.parts[0];
    if (!part) return;
    this.selected = part.id;
    for (const one of this.paper.querySelectorAll<SVGElement>("[data-id]")) one.classList.toggle("selected", one.dataset["id"] === part.id);
    this.form.replaceChildren(...this.fields(part));
  }

  /** The fields of a part: each is done when it has changed. */
  private fields(part: ChartPart): HTMLElement[] {
    const field = (key: Parameters<typeof say>[0], name: string, value: string, act: (value: string) => Done): HTMLElement => {
      const input = h("input", { id: `chart-${name}`, value, autocomplete: "off", spellcheck: "false", change: () => void this.act(act(input.value)) });
      input.addEventListener("keydown", (event) => {
        if (event.key === "Escape" || event.key === "Enter") this.paper.focus();
      });
      return h("label", {}, say(key), input);
    };
    const pick = (key: Parameters<typeof say>[0], name: string, values: readonly string[], value: string, act: (value: string) => Done): HTMLElement => {
      const input = h("select", { id: `chart-${name}`, change: () => void this.act(act(input.value)) }, ...values.map((one) => h("option", { value: one, selected: one === value }, one)));
      return h("label", {}, say(key), input);
    };
    const steps = (this.chart?.parts ?? []).filter(({ kind }) => kind === "step").map(({ name }) => name);
    const to = (): HTMLElement => pick("chartTo", "to", steps, part.name, (say) => ({ what: "lead", say }));
    const does = (more: Done): Done => ({ what: "does", say: part.name, qualifier: part.qualifier, time: part.time, ...more });
    switch (part.kind) {
      case "step":
        return [
          field("chartName", "name", part.name, (say) => ({ what: "rename", say })),
          h("button", { type: "button", id: "chart-initial", disabled: part.initial, click: () => void this.act({ what: "initial" }) }, say("chartInitial")),
          pick("chartJump", "jump", ["", ...steps], "", (say) => ({ what: "jump", say })),
        ];
      case "does":
        return [
          field("chartAction", "action", part.name, (say) => does({ say })),
          pick("chartQualifier", "qualifier", QUALIFIERS, part.qualifier, (qualifier) => does({ qualifier, time: part.time || (/^(L|D|SD|DS|SL)$/.test(qualifier) ? "T#1s" : "") })),
          field("chartTime", "time", part.time, (time) => does({ time })),
          field("chartBody", "body", part.text, (say) => ({ what: "body", time: part.name, say })),
        ];
      case "transition":
        return [
          field("chartCondition", "condition", part.text, (say) => ({ what: "condition", say })),
          field("chartPriority", "priority", part.priority, (say) => ({ what: "priority", say })),
          to(),
        ];
      default:
        return [to()];
    }
  }

  private done(what: string): void {
    void this.act({ what });
    this.paper.focus();
  }

  /** Does something to the selected part. */
  private async act(act: Done): Promise<void> {
    const before = this.shown;
    if (!before) return;
    await asked(this.tools.ask("chart", { of: before, look: kept("look") ?? "norm", chart: 0, at: this.selected, ...act }), ({ charts, text, select }) => {
      const chart = charts[0];
      if (text === null || !chart || this.shown?.text !== before.text) return;
      this.past.push(before);
      this.future.length = 0;
      this.selected = select ?? this.selected;
      this.take({ ...before, text }, chart);
    });
  }

  /** Shows a text that it has made itself. */
  private take(text: Text, chart: ChartDrawn): void {
    this.shown = text;
    this.chart = chart;
    this.draw(chart);
    this.write(text);
  }

  private back(from: Text[], to: Text[]): void {
    const text = from.pop();
    if (!text || !this.shown) return;
    to.push(this.shown);
    this.shown = text;
    this.write(text);
    void this.show(text);
  }

  private key(event: KeyboardEvent): void {
    const { key } = event;
    const control = event.ctrlKey || event.metaKey;
    const arrow = ARROWS[key];
    if (control && key.toLowerCase() === "z") this.back(event.shiftKey ? this.future : this.past, event.shiftKey ? this.past : this.future);
    else if (control && key.toLowerCase() === "y") this.back(this.future, this.past);
    else if (control) return;
    else if (arrow) this.move(arrow);
    else if (key === "Enter") this.form.querySelector<HTMLElement>("input, select")?.focus();
    else {
      const act = ACTS.find(([, , own]) => own === key) ?? (key === "Backspace" ? ACTS.at(-1) : undefined);
      if (!act) return;
      void this.act({ what: act[0] });
    }
    event.preventDefault();
  }

  /** Selects the nearest part in a direction. */
  private move([x, y]: readonly [number, number]): void {
    const own = this.find(this.selected);
    if (!own || !this.chart) return;
    let [best, least] = [own, Infinity];
    for (const part of this.chart.parts) {
      const along = (part.x - own.x) * x + (part.y - own.y) * y;
      const across = Math.abs((part.x - own.x) * y) + Math.abs((part.y - own.y) * x);
      if (part === own || along < 4) continue;
      const far = along + 2 * across;
      if (far < least) [best, least] = [part, far];
    }
    this.select(best.id);
    this.paper.querySelector(`[data-id="${best.id}"]`)?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  /** Shows which steps are active, as long as this text runs. */
  private live(): void {
    const { chart, shown } = this;
    const seen = this.bench.seen.value;
    if (!chart || !shown) return;
    const runs = seen !== null && liveOf(this.bench, this.program.text.value) !== null;
    const active = chart.points.map(([point]) => runs && point !== null && valueOf(seen, point) !== 0);
    for (const part of chart.parts) {
      const group = this.paper.querySelector<SVGElement>(`[data-id="${part.id}"]`);
      const step = /^[sa](\d+)/.exec(part.id)?.[1];
      if (step) group?.classList.toggle("active", active[Number(step)] ?? false);
      if (part.kind === "transition") group?.classList.toggle("ready", part.from.length > 0 && part.from.every((from) => active[from]));
      if (part.kind !== "step") continue;
      const time = group?.querySelector(".time");
      const point = chart.points[Number(step)]?.[1];
      if (time) time.textContent = runs && seen && point && active[Number(step)] ? `${(valueOf(seen, point) / 1000).toFixed(1)} s` : "";
    }
  }
}

/** What stands at a marker or a register. */
function valueOf(seen: Seen, point: string): number {
  const number = Number(point.slice(1));
  return point.startsWith("M") ? Number(seen.markers.includes(number)) : (seen.registers[number - 1] ?? 0);
}
