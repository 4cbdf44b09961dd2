// The problems of the text, as a list: each leads to its place.

import type { Checked } from "../tools/answers";
import { say, told } from "../words/words";
import { h } from "./dom";

/** Lists them anew. */
export function showProblems(panel: HTMLElement, checked: Checked, go: (line: number, column: number) => void): void {
  const items = checked.problems.map((problem) =>
    h("li", {}, h("button", { type: "button", click: () => go(problem.line, problem.column) },
      h("span", { class: problem.severity }, problem.number),
      h("span", { class: "note" }, say("lineAt", { line: problem.line })),
      h("span", {}, told(problem.message)),
      told(problem.help) ? h("span", { class: "help" }, told(problem.help)) : null)));
  const more = checked.more > 0 ? h("p", { class: "note" }, say("problemMore", { n: checked.more })) : null;
  const none = items.length === 0 ? h("p", { class: "empty" }, say("problemNone")) : null;
  panel.replaceChildren(...[h("ul", { class: "problems" }, ...items), more, none].filter((part) => part !== null));
}

/** How many there are, in words. */
export function countOf(checked: Checked): string {
  const n = checked.problems.length + checked.more;
  return n === 0 ? say("problemNone") : n === 1 ? say("problemOne") : say("problemMany", { n });
}
