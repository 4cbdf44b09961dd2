// Handing in: what a student has done in an exercise, as a file for the teacher. `unoclp grade` reads it, and believes no more
// of it than who, which exercise, and the program.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say } from "../words/learn";
import { say as sayCommon } from "../words/words";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import { download } from "./files";
import { FORM } from "./handedin";
import { keep, kept } from "./kept";
import { Minutes } from "./minutes";
import { note } from "./notes";

/** Who hands in, as the browser keeps them. */
interface Student {
  readonly name: string;
  readonly number: string;
}

/** What is handed in besides the program. */
export interface Solved {
  readonly name: string;
  readonly scenario: string;
  readonly machine: Text | null;
  /** Where a fault is to be found, what was named, a line for each try; and whether it was the fault. */
  readonly search: { readonly answer: string; readonly found: boolean } | null;
}

const KEPT = "student";

export class HandIn {
  readonly minutes = new Minutes();

  constructor(
    private readonly tools: RemoteTools,
    private readonly program: ProgramDocument,
  ) {}

  /** The button of an exercise. */
  button(solved: () => Solved): HTMLElement {
    return h("button", { type: "button", id: "hand-in", click: () => this.ask(solved()) }, say("handIn"));
  }

  /** Asks who hands in, and writes the file. */
  private ask(solved: Solved): void {
    const student = lastStudent();
    const name = h("input", { type: "text", id: "hand-in-name", value: student.name, maxlength: 100, required: true, autocomplete: "name" });
    const number = h("input", { type: "text", id: "hand-in-number", value: student.number, maxlength: 100, autocomplete: "off" });
    const form = h("form", { method: "dialog" },
      h("h2", { id: "hand-in-title" }, say("handIn")), h("p", { class: "note" }, say("handInAbout")),
      h("label", {}, h("span", {}, say("handInName")), name), h("label", {}, h("span", {}, say("handInNumber")), number),
      h("div", { class: "row" }, h("button", { type: "submit", class: "primary", id: "hand-in-save" }, say("handInSave")),
        h("button", { type: "button", id: "hand-in-cancel", click: () => dialog.close() }, sayCommon("close"))));
    const dialog = h("dialog", { class: "hand-in", "aria-labelledby": "hand-in-title", close: () => dialog.remove() }, form);
    form.addEventListener("submit", () => {
      const who = { name: name.value.trim(), number: number.value.trim() };
      keep(KEPT, JSON.stringify(who));
      void this.write(who, solved);
    });
    document.body.append(dialog);
    dialog.showModal();
  }

  private async write(student: Student, solved: Solved): Promise<void> {
    const { text, drawing, lacks } = this.program;
    const program = text.value;
    const whole = {
      form: FORM,
      student,
      exercise: { name: solved.name },
      program,
      drawing: drawing.value,
      ...(solved.search && { answer: solved.search.answer }),
      verdicts: await this.verdicts(program, solved),
      minutes: this.minutes.of(solved.name),
    };
    const file = `${fileName(student.name)}-${fileName(solved.name.split("/").pop() ?? "")}.unoclp.json`;
    download(file, `${JSON.stringify(whole, null, 1)}\n`, "application/json");
    note(() => `${say("handInSaved", { file })}${lacks.value > 0 ? ` ${sayCommon("savedUnfinished")}` : ""}`);
  }

  /** How the program fares now, whatever a check has said before. */
  private async verdicts(of: Text, { name, scenario, machine, search }: Solved): Promise<object> {
    if (search) return { passed: search.found };
    try {
      const came = await this.tools.ask("exercise", { of, scenario, title: name, plant: machine?.name, plantText: machine?.text });
      return { passed: came.passed, cases: came.cases.map(([one, passed]) => ({ title: one.title, passed })), machine: came.machine?.passed ?? null };
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return { passed: false, why: error.both };
    }
  }
}

/** A name as every disk takes it. */
function fileName(name: string): string {
  return name.normalize("NFC").replace(/[^\p{L}\p{M}\p{N}]+/gu, "-").replace(/^-|-$/g, "").toLowerCase().slice(0, 60) || "x";
}

function lastStudent(): Student {
  try {
    const { name, number } = JSON.parse(kept(KEPT) ?? "{}") as Partial<Student>;
    return { name: String(name ?? ""), number: String(number ?? "") };
  } catch {
    return { name: "", number: "" };
  }
}
