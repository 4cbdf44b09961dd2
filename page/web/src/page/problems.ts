// The problems of the text, as a list: each leads to its place.

import type { Checked } from "../tools/answers";
import { say, told } from "../words/words";
import type { ProgramDocument } from "./document";
import { h } from "./dom";

/** Where a problem leads. */
interface Go {
  text(line: number, column: number): void;
  drawing(): void;
  adapt(): void;
}

/** That the board lacks a point, in a text whose points can have others. */
const NO_SUCH_POINT: readonly string[] = ["ST-138", "IL-41", "XML-506"];

/** Lists them again; `lacks` is how much of the drawing is to be completed. */
export function showProblems(panel: HTMLElement, checked: Checked, lacks: number, go: Go): void {
  const drawing = lacks === 0 ? [] : [h("li", {}, h("button", { type: "button", click: () => go.drawing() },
    h("span", { class: "error" }, say("drawingUnfinished", { n: lacks }))))];
  const items = checked.problems.map((problem) =>
    h("li", {}, h("button", { type: "button", click: () => go.text(problem.line, problem.column) },
      h("span", { class: problem.severity }, problem.number),
      h("span", { class: "note" }, say("lineAt", { line: problem.line })),
      h("span", {}, told(problem.message)),
      told(problem.help) ? h("span", { class: "help" }, told(problem.help)) : null)));
  const lacking = checked.problems.some(({ number }) => NO_SUCH_POINT.includes(number));
  const adapt = lacking ? h("button", { type: "button", id: "adapt", click: () => go.adapt() }, say("adaptPoints")) : null;
  const more = checked.more > 0 ? h("p", { class: "note" }, say("problemMore", { n: checked.more })) : null;
  const none = items.length + drawing.length === 0 ? h("p", { class: "empty" }, say("problemNone")) : null;
  panel.replaceChildren(...[h("ul", { class: "problems" }, ...drawing, ...items), adapt, more, none].filter((part) => part !== null));
}

/** Why what is written and drawn does not run. */
export function whyNot({ lacks, looked }: ProgramDocument): string {
  if (lacks.value > 0) return say("drawingUnfinished", { n: lacks.value });
  return say(looked.value?.checked.blank ? "blankRun" : "checkErrors");
}

/** How many there are, in words; what is missing in the drawing comes first. */
export function countOf(checked: Checked, lacks: number): string {
  if (lacks > 0) return say("drawingLacks", { n: lacks });
  if (checked.blank) return say("programBlank");
  const n = checked.problems.length + checked.more;
  return n === 0 ? say("problemNone") : n === 1 ? say("problemOne") : say("problemMany", { n });
}
