// The body of a unit in its editor: a text, a chart, or a drawing as its file lays it out, whose elements are edited.

import type { Problem, ProjectUnit, UnitElement, UnitShown } from "../../tools/answers";
import { say } from "../../words/project";
import { speak } from "../../words/words";
import type { Looked } from "../document";
import { h } from "../dom";
import { liveOf } from "../forcing";
import { pointsOf } from "../points";
import { refill } from "../refill";
import { attend, reveal } from "../reveal";
import type { Around, ChartPane } from "../sfc/pane";
import { type Drawn, Palette } from "./palette";
import type { Altered } from "./pane";

const EDGES = ["", "rising", "falling"] as const;
const STORAGES = ["", "set", "reset"] as const;
const WORDS = { "": "projectNone", rising: "projectRising", falling: "projectFalling", set: "projectSet", reset: "projectReset" } as const;
/** What names nothing that could be another. */
const FIXED = /^(leftPowerRail|rightPowerRail|comment|return|connector|continuation|vendorElement)$/;

export class Body {
  readonly root = h("div", { class: "project-body", id: "project-body" });
  private readonly paper = h("div", { class: "paper", id: "unit-sheet", tabindex: 0, role: "application", "data-say-label": "projectSheet" });
  private readonly form = h("form", { class: "chart-form", id: "unit-form", submit: (event) => event.preventDefault() });
  private shown: UnitShown | null = null;
  private problems: readonly Problem[] = [];
  private unit = "";
  private selected = "";
  private made = "";
  private readonly palette = new Palette((drawn) => this.draw(drawn));
  /** Whether what comes next is new, and is selected. */
  private isNew = false;

  constructor(
    private readonly around: Around,
    private readonly chart: ChartPane,
    private readonly alter: (altered: Altered) => void,
    private readonly back: (way: "undo" | "redo") => void,
  ) {
    this.paper.addEventListener("click", (event) => {
      const piece = (event.target as Element).closest<SVGElement>("[data-id]");
      if (piece?.dataset["id"]) this.select(piece.dataset["id"]);
    });
    this.paper.addEventListener("keydown", (event) => this.key(event));
    around.bench.seen.follow(() => this.live());
    speak.follow(() => this.select(this.selected));
  }

  /** Shows the body of a unit; null: there is none. */
  async show(unit: ProjectUnit | null, looked: Looked | null, problems: readonly Problem[], units: readonly ProjectUnit[]): Promise<void> {
    this.problems = problems;
    const isChart = unit?.language === "SFC";
    if (isChart && looked) {
      this.shown = null;
      this.made = "";
      if (!this.chart.isAt(this.root)) this.root.replaceChildren();
      this.chart.at(this.root);
      await this.chart.show(looked, unit.name);
      return;
    }
    this.chart.leave(this.root);
    const of = this.around.program.text.value;
    this.shown = unit && (await this.around.tools.ask("unit", { of, unit: unit.name }));
    if (unit?.name !== this.unit) this.selected = "";
    this.unit = unit?.name ?? "";
    const { shown } = this;
    const made = JSON.stringify([this.unit, shown?.language, shown?.text, shown?.svg]);
    if (made !== this.made) {
      this.build(shown);
      // A new element has the largest number.
      if (this.isNew) this.selected = String(Math.max(...(shown?.elements ?? []).map(({ id }) => Number(id) || 0)));
      this.isNew = false;
    }
    this.made = made;
    if (shown?.svg) this.palette.show(shown.language, units.filter(({ name, kind }) => kind !== "program" && name !== this.unit).map(({ name }) => name));
    this.select(this.selected);
    this.live();
  }

  private build(shown: UnitShown | null): void {
    if (!shown) return this.root.replaceChildren();
    if (shown.svg === "") {
      const text = h("textarea", { id: "unit-text", spellcheck: "false", "aria-label": say("projectText"), change: () => this.alter({ what: "body", at: "", to: text.value }) });
      text.value = shown.text;
      text.addEventListener("keydown", ({ key, ctrlKey, metaKey }) => {
        if (key === "Enter" && (ctrlKey || metaKey)) text.blur();
      });
      return this.root.replaceChildren(text);
    }
    const { scrollTop, scrollLeft } = this.paper;
    this.paper.innerHTML = shown.svg;
    if (!this.root.contains(this.paper)) this.root.replaceChildren(this.palette.root, this.paper, this.form);
    this.paper.scrollTo(scrollLeft, scrollTop);
  }

  private select(id: string): void {
    const elements = this.shown?.elements ?? [];
    const element = elements.find((one) => one.id === id);
    this.selected = element?.id ?? "";
    for (const piece of this.paper.querySelectorAll<SVGElement>("[data-id]")) {
      const of = elements.find((one) => one.id === piece.dataset["id"]);
      piece.classList.toggle("selected", piece.dataset["id"] === this.selected);
      piece.classList.toggle("wrong", of !== undefined && this.problems.some(({ from, severity }) => severity === "error" && from >= of.from && from < of.to));
    }
    refill(this.form, element ? this.fields(element) : []);
  }

  private fields(element: UnitElement): HTMLElement[] {
    const { id, kind, written, negated, edge, storage } = element;
    if (FIXED.test(kind)) return [];
    const leave = ({ key }: KeyboardEvent): void => {
      if (key === "Enter" || key === "Escape") attend(this.paper);
    };
    const field = h("input", { id: "unit-written", "data-of": id, value: written, spellcheck: "false", autocomplete: "off", change: () => this.alter({ what: "written", at: id, to: field.value }) });
    field.addEventListener("keydown", leave);
    const pick = (what: "edge" | "storage", values: readonly (keyof typeof WORDS)[], value: string): HTMLElement => {
      const list = h("select", { id: `unit-${what}`, change: () => this.alter({ what, at: id, to: list.value }) }, ...values.map((one) => h("option", { value: one, selected: one === value }, say(WORDS[one]))));
      return h("label", {}, say(what === "edge" ? "projectEdge" : "projectStorage"), list);
    };
    const box = h("input", { type: "checkbox", id: "unit-negated", checked: negated, change: () => this.alter({ what: "negated", at: id, to: String(box.checked) }) });
    const isWired = kind === "contact" || kind === "coil";
    return [
      h("label", {}, say(kind === "block" ? "projectInstance" : "projectVariable"), field),
      isWired || kind === "outVariable" || kind === "inVariable" ? h("label", {}, say("projectNegated"), box) : null,
      isWired ? pick("edge", EDGES, edge) : null,
      kind === "coil" ? pick("storage", STORAGES, storage) : null,
    ].filter((one) => one !== null);
  }

  /** Draws something at the selected element, or takes that away. */
  private draw({ what, to }: Drawn): void {
    const { elements } = this.shown ?? { elements: [] };
    const at = this.selected || (elements.find(({ kind }) => !FIXED.test(kind))?.id ?? "");
    this.isNew = what !== "erase";
    if (what === "erase") {
      // What stands before it is selected next.
      const ids = elements.filter(({ kind }) => !FIXED.test(kind)).map(({ id }) => id);
      this.selected = ids[Math.max(ids.indexOf(at) - 1, 0)] ?? "";
    }
    this.alter({ what, at, to });
    attend(this.paper);
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey) {
      const key = event.key.toLowerCase();
      if (key !== "z" && key !== "y") return;
      this.back(key === "y" || event.shiftKey ? "redo" : "undo");
      return event.preventDefault();
    }
    if (event.altKey) return;
    const ids = (this.shown?.elements ?? []).filter(({ kind }) => !FIXED.test(kind)).map(({ id }) => id);
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (by) {
      const at = ids.indexOf(this.selected);
      this.select(ids[Math.min(Math.max(at + by, 0), ids.length - 1)] ?? "");
      const seen = this.paper.querySelector(".selected");
      if (seen) reveal(seen);
    } else if (this.palette.key(event)) {
      // It is drawn.
    } else if (event.key === "Enter") this.form.querySelector<HTMLElement>("input")?.focus();
    else return;
    event.preventDefault();
  }

  /** Marks what is 1, as long as this text runs. */
  private live(): void {
    const { bench, program } = this.around;
    const made = program.looked.value?.checked.program;
    const seen = liveOf(bench, program.text.value) ? bench.seen.value : null;
    if (!this.shown?.svg || !made) return;
    const values = new Map(seen ? pointsOf(made).flatMap((point) => [[point.name.toUpperCase(), point.value(seen)], [point.called.toUpperCase(), point.value(seen)]]) : []);
    for (const { id, written, negated } of this.shown.elements) {
      const value = values.get(written.toUpperCase());
      this.paper.querySelector(`[data-id="${CSS.escape(id)}"]`)?.classList.toggle("on", value !== undefined && (value !== 0) !== negated);
    }
  }
}
