// The variables of a unit, as a table that is edited.

import type { Problem, ProjectRow } from "../../tools/answers";
import { say } from "../../words/project";
import { speak, told } from "../../words/words";
import { h } from "../dom";
import { refill } from "../refill";
import type { Altered } from "./pane";

/** How the standard calls a section. */
const SECTIONS: Readonly<Record<string, string>> = {
  localVars: "VAR", inputVars: "VAR_INPUT", outputVars: "VAR_OUTPUT", inOutVars: "VAR_IN_OUT", externalVars: "VAR_EXTERNAL", tempVars: "VAR_TEMP", globalVars: "VAR_GLOBAL",
};
/** The fields of a row that are written. */
const FIELDS = [["name", "projectName"], ["kind", "projectKind"], ["first", "projectFirst"], ["place", "projectPlace"], ["comment", "projectComment"]] as const;

export class Table {
  readonly root = h("div", { class: "project-table" });
  private made = "";

  constructor(private readonly alter: (altered: Altered) => void) {}

  /** Shows these variables; a field in which somebody writes stays as it is. */
  show(rows: readonly ProjectRow[], ofUnit: boolean, problems: readonly Problem[]): void {
    const wrong = (row: ProjectRow): Problem | undefined => problems.find(({ from }) => from >= row.from && from < row.to);
    const made = JSON.stringify([rows.map((row) => [{ ...row, from: 0, to: 0 }, wrong(row)?.message]), ofUnit, speak.value]);
    if (made === this.made) return;
    const keeps = this.made !== "";
    this.made = made;
    const head = [say("projectSection"), ...FIELDS.map(([, word]) => say(word)), say("projectRetained")];
    refill(this.root, [
      h("table", { id: "project-table" }, h("thead", {}, h("tr", {}, ...head.map((word) => h("th", {}, word)), h("th", {}, h("span", { class: "hidden" }, say("projectRemove"))))), h("tbody", {}, ...rows.map((row, at) => this.row(row, at, wrong(row))))),
      this.adder(ofUnit),
    ], keeps);
  }

  /** Its fields show what is so, the next time that it is shown. */
  again(): void {
    this.made = "";
  }

  private row(row: ProjectRow, at: number, wrong: Problem | undefined): HTMLElement {
    const fields = FIELDS.map(([what, word]) => {
      const field = h("input", {
        id: `variable-${at}-${what}`, "data-of": row.name, value: row[what] ?? "", "aria-label": `${row.name}: ${say(word)}`, spellcheck: "false", autocomplete: "off",
        change: () => this.alter({ what, at: row.name, to: field.value }),
      });
      return h("td", {}, field);
    });
    const retained = h("input", { type: "checkbox", id: `variable-${at}-retained`, "aria-label": `${row.name}: ${say("projectRetained")}`, checked: row.retained, change: () => this.alter({ what: "retained", at: row.name, to: String(retained.checked) }) });
    return h("tr", { "data-variable": row.name, class: wrong?.severity ?? "", title: wrong ? told(wrong.message) : "" },
      h("td", {}, `${SECTIONS[row.section] ?? row.section}${row.constant ? " CONSTANT" : ""}`), ...fields, h("td", {}, retained),
      h("td", {}, h("button", { type: "button", class: "small quiet", id: `variable-${at}-remove`, "aria-label": `${row.name}: ${say("projectRemove")}`, click: () => this.alter({ what: "remove", at: row.name, to: "" }) }, "×")));
  }

  /** Where a new variable is named. */
  private adder(ofUnit: boolean): HTMLElement {
    const sections = ofUnit ? ["localVars", "inputVars", "outputVars"] : ["globalVars"];
    const section = h("select", { id: "variable-section", "aria-label": say("projectSection") }, ...sections.map((one) => h("option", { value: one }, SECTIONS[one] ?? one)));
    const name = h("input", { id: "variable-new", "aria-label": say("projectNew"), placeholder: say("projectNew"), spellcheck: "false", autocomplete: "off" });
    const add = (): void => {
      if (name.value.trim()) this.alter({ what: "add", at: section.value, to: name.value });
    };
    return h("form", { class: "row", submit: (event) => { event.preventDefault(); add(); } }, section, name, h("button", { class: "small", id: "variable-add" }, say("projectAdd")));
  }
}
