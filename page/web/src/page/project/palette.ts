// What is drawn in a unit: the palette of its language, where it goes, and the keys of both, which are those of the drawing
// sheet.

import { say } from "../../words/project";
import { h } from "../dom";

/** Where something new stands beside the selected element. */
const WHERES = ["after", "beside", "before"] as const;
type Where = (typeof WHERES)[number] | "below";
const WORDS = { after: "projectAfter", beside: "projectBeside", before: "projectBefore" } as const;

/** The elements of a language: what is asked for, its face, its key. */
type Item = readonly [what: string, face: string, key: string];
const OF: Readonly<Record<string, readonly Item[]>> = {
  LD: [["contact", "┤ ├", "c"], ["coil", "( )", "l"], ["TON", "TON", "o"], ["TOF", "TOF", "f"], ["TP", "TP", "y"], ["CTU", "CTU", "u"], ["GT", ">", ">"], ["MOVE", "MOVE", "m"]],
  FBD: [["value", "x ─", "v"], ["variable", "─ y", "m"], ["AND", "&", "&"], ["OR", "≥1", "|"], ["NOT", "NOT", "!"], ["TON", "TON", "o"], ["TOF", "TOF", "f"], ["CTU", "CTU", "u"]],
};
/** What the list has besides. */
const OTHERS = ["AND", "OR", "XOR", "NOT", "TP", "CTD", "CTUD", "SR", "RS", "R_TRIG", "F_TRIG", "GT", "GE", "EQ", "NE", "LE", "LT", "ADD", "SUB", "MUL", "DIV", "MOD", "MOVE"];

/** What a person asks for. */
export interface Drawn {
  readonly what: Where | "erase";
  readonly to: string;
}

export class Palette {
  readonly root = h("div", { class: "bar project-palette", role: "toolbar", id: "unit-palette" });
  private language = "";
  private where: (typeof WHERES)[number] = "after";

  constructor(private readonly draw: (drawn: Drawn) => void) {}

  /** Shows what a language has, with these blocks and functions of the project. */
  show(language: string, units: readonly string[]): void {
    this.language = language;
    const items = OF[language] ?? [];
    const button = ([what, face, key]: Item): HTMLElement =>
      h("button", { type: "button", "data-what": what, title: key.toUpperCase(), "aria-label": this.said(what), click: () => this.draw({ what: this.where, to: what }) }, face);
    const names = [...OTHERS.filter((name) => !items.some(([what]) => what === name)), ...units];
    const others = h("select", { id: "unit-others", "aria-label": say("projectOthers"), change: () => this.draw({ what: this.where, to: others.value }) },
      h("option", { value: "" }, say("projectOthers")), ...names.map((name) => h("option", { value: name }, name)));
    const where = h("select", { id: "unit-where", title: "W", "aria-label": say("projectWhere"), change: () => this.turn(WHERES[where.selectedIndex] ?? "after") },
      ...WHERES.map((one) => h("option", { value: one, selected: one === this.where }, say(WORDS[one]))));
    this.root.setAttribute("aria-label", say("projectPalette"));
    this.root.replaceChildren(...items.map(button), others, where,
      h("button", { type: "button", id: "unit-below", title: "Shift+Enter", click: () => this.below() }, say("projectBelow")),
      h("button", { type: "button", id: "unit-erase", title: "Delete", click: () => this.draw({ what: "erase", to: "" }) }, say("projectErase")));
  }

  /** What a key draws; whether it is one of these. Shift draws beside what is selected. */
  key({ key, shiftKey }: KeyboardEvent): boolean {
    const item = OF[this.language]?.find(([, , own]) => own === key.toLowerCase());
    if (item) this.draw({ what: shiftKey && /[a-z]/.test(item[2]) ? "beside" : this.where, to: item[0] });
    else if (key === "Delete" || key === "Backspace") this.draw({ what: "erase", to: "" });
    else if (key === "Enter" && shiftKey) this.below();
    else if (key.toLowerCase() === "w") this.turn(WHERES[(WHERES.indexOf(this.where) + 1) % WHERES.length] ?? "after");
    else return false;
    return true;
  }

  private below(): void {
    this.draw({ what: "below", to: this.language === "LD" ? "coil" : "variable" });
  }

  private turn(where: (typeof WHERES)[number]): void {
    this.where = where;
    const list = this.root.querySelector<HTMLSelectElement>("#unit-where");
    if (list) list.value = where;
  }

  private said(what: string): string {
    const words = { contact: "projectContact", coil: "projectCoil", value: "projectValue", variable: "projectOutput" } as const;
    return what in words ? say(words[what as keyof typeof words]) : what;
  }
}
