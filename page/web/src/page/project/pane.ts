// A project: the tree of its units at the side, the variables of one in a table, and its body. Rust reads and changes the
// file; all that it does not know of stays there.

import type { Ask, Problem, Project, ProjectUnit, Text } from "../../tools/answers";
import { say } from "../../words/project";
import { speak, told, translate } from "../../words/words";
import { asked } from "../asked";
import type { Looked } from "../document";
import { h } from "../dom";
import { keep, kept } from "../kept";
import type { Around, ChartPane } from "../sfc/pane";
import { Body } from "./body";
import type { Past } from "./past";
import { Table } from "./table";

/** What is changed of a unit. */
export type Altered = Pick<Ask<"alter">, "what" | "at" | "to">;

/** What the browser keeps: whether the variables stand above the body, or are folded away. */
const FOLD = "variables";
/** On a phone there is room for one of both. */
const PHONE = "(max-width: 760px)";

/** How the standard calls a unit. */
const KINDS: Readonly<Record<string, string>> = { program: "PROGRAM", functionBlock: "FUNCTION_BLOCK", function: "FUNCTION" };

export class ProjectPane {
  private readonly tree = h("nav", { class: "project-tree", id: "project-tree", "data-say-label": "projectTree" });
  private readonly heading = h("h3", { id: "project-unit" });
  private readonly mistakes = h("ul", { class: "problems", id: "project-problems" });
  private readonly undo = h("button", { type: "button", id: "project-undo", "data-say-label": "projectUndo", click: () => void this.back("undo") }, "↶");
  private readonly redo = h("button", { type: "button", id: "project-redo", "data-say-label": "projectRedo", click: () => void this.back("redo") }, "↷");
  private readonly fold = h("button", { type: "button", class: "fold", id: "project-variables", "aria-controls": "project-table", "data-say": "projectVariables", click: () => this.turn() });
  private readonly pane: HTMLElement;
  private readonly table: Table;
  private readonly body: Body;
  private project: Project | null = null;
  private looked: Looked | null = null;
  /** The unit that is open; none: the global variables. */
  private open: string | null = null;
  private queue: Promise<void> = Promise.resolve();

  constructor(
    private readonly root: HTMLElement,
    private readonly around: Around,
    private readonly past: Past,
    chart: ChartPane,
  ) {
    const alter = (altered: Altered): void => void this.alter(altered);
    this.table = new Table(alter);
    this.body = new Body(around, chart, alter, (way) => void this.back(way));
    this.pane = h("section", { class: "project-pane", id: "project-pane", "data-say-label": "project" },
      h("div", { class: "project-side" }, h("div", { class: "bar" }, this.undo, this.redo), this.tree),
      h("div", { class: "project-open" }, h("div", { class: "project-head" }, this.heading, this.fold), this.mistakes, this.table.root, this.body.root));
    root.prepend(this.pane);
    this.unfold(kept(FOLD) === null ? !matchMedia(PHONE).matches : kept(FOLD) === "open");
    this.pane.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || (event.target as Element).matches("input, textarea, .paper")) return;
      if (event.key === "z") void this.back(event.shiftKey ? "redo" : "undo");
      else if (event.key === "y") void this.back("redo");
      else return;
      event.preventDefault();
    });
    speak.follow(() => {
      translate(this.pane);
      this.build();
    });
  }

  /** Folds the variables away, or shows them again. */
  private turn(): void {
    const is = this.fold.getAttribute("aria-expanded") !== "true";
    keep(FOLD, is ? "open" : "folded");
    this.unfold(is);
  }

  private unfold(is: boolean): void {
    this.fold.setAttribute("aria-expanded", String(is));
    this.pane.toggleAttribute("data-folded", !is);
  }

  /** Shows the project of a text; null: the text is none. */
  show(looked: Looked | null): Promise<void> {
    return this.next(async () => {
      this.root.toggleAttribute("data-project", looked !== null);
      if (looked === null) this.looked = this.project = null;
      if (!looked || looked.text !== this.around.program.text.value) return;
      if (this.past.meet(looked.text) === "another") this.open = null;
      this.looked = looked;
      await this.read(looked.text);
    });
  }

  private async read(of: Text): Promise<void> {
    try {
      this.project = await this.around.tools.ask("project", { of });
    } catch {
      // No project any longer: the problems of its text say why.
      this.project = null;
    }
    const { project } = this;
    if (project && !this.unit && this.open !== "") this.open = (project.units.find(({ kind }) => kind === "program") ?? project.units[0])?.name ?? "";
    this.build();
    await this.body.show(this.unit ?? null, this.looked, this.problems, project?.units ?? []);
    this.body.root.dataset["unit"] = this.open ?? "";
  }

  private get unit(): ProjectUnit | undefined {
    return this.project?.units.find(({ name }) => name === this.open);
  }

  /** What is wrong in a unit: from its beginning to that of the next. */
  private wrongIn(unit: ProjectUnit): readonly Problem[] {
    const end = Math.min(...(this.project?.units ?? []).map(({ from }) => from).filter((from) => from > unit.from));
    return (this.looked?.checked.problems ?? []).filter(({ from }) => from >= unit.from && from < end);
  }

  private get problems(): readonly Problem[] {
    return this.unit ? this.wrongIn(this.unit) : (this.looked?.checked.problems ?? []);
  }

  private build(): void {
    const { project, unit } = this;
    this.undo.disabled = !this.past.has("undo");
    this.redo.disabled = !this.past.has("redo");
    const entry = (name: string, shown: string, note: string, wrong: readonly Problem[]): HTMLElement =>
      h("button", { type: "button", "data-unit": name, "aria-current": String(name === (unit?.name ?? "")), class: wrong.some(({ severity }) => severity === "error") ? "wrong" : "", click: () => void this.turnTo(name) },
        shown, h("small", {}, note));
    this.tree.replaceChildren(h("b", {}, project?.name ?? ""), entry("", say("projectGlobals"), "VAR_GLOBAL", []),
      ...(project?.units ?? []).map((of) => entry(of.name, of.name, `${KINDS[of.kind] ?? ""} ${of.language}`, this.wrongIn(of))));
    // Global variables stand alone.
    this.pane.toggleAttribute("data-alone", unit === undefined);
    // Where the units stand in one line, the one that is open is in view.
    this.tree.scrollLeft = (this.tree.querySelector<HTMLElement>("[aria-current=true]")?.offsetLeft ?? 0) - this.tree.clientWidth / 4;
    this.heading.textContent = unit ? `${KINDS[unit.kind] ?? ""} ${unit.name}${unit.gives ? ` : ${unit.gives}` : ""}` : say("projectGlobals");
    this.mistakes.replaceChildren(...this.problems.map(({ severity, number, message, help }) => h("li", { class: severity }, `${number} ${told(message)} `, h("span", { class: "note" }, told(help)))));
    this.table.show(unit?.variables ?? project?.globals ?? [], unit !== undefined, this.problems);
  }

  private turnTo(name: string): Promise<void> {
    return this.next(async () => {
      this.open = name;
      if (this.past.now) await this.read(this.past.now);
      this.tree.querySelector<HTMLElement>("[aria-current=true]")?.focus();
    });
  }

  /** Changes something of the unit that is open. */
  private alter(altered: Altered): Promise<void> {
    return this.next(async () => {
      const of = this.past.now;
      if (!of) return;
      const unit = this.unit?.name;
      await asked(this.around.tools.ask("alter", { of, ...(unit === undefined ? {} : { unit }), ...altered }), (text) => {
        if (text === of.text || !this.around.program.isStill(of)) return;
        const after = { ...of, text };
        this.past.did(after);
        this.around.write(after);
      });
      // What was refused stands there no longer.
      if (this.past.now !== of) return;
      this.table.again();
      await this.read(of);
    });
  }

  private back(way: "undo" | "redo"): Promise<void> {
    return this.next(async () => {
      const text = this.past.go(way);
      if (text) this.around.write(text);
    });
  }

  private next(job: () => Promise<void>): Promise<void> {
    this.queue = this.queue.then(job);
    return this.queue;
  }
}
