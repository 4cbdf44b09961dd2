// What is at hand on the sheet itself: at the selected element a branch and its end, under the last rung another one, and on an
// empty sheet where one begins.

import type { Act, Drawn } from "../../tools/answers";
import { say } from "../../words/draw";
import { h } from "../dom";

/** Between an element and what stands at it, CSS pixels. */
const GAP = 4;

export class Nearby {
  private readonly tools = h("div", { class: "at-selected", role: "group", hidden: true });
  private readonly below = h("div", { class: "below-rungs" });

  constructor(
    private readonly paper: HTMLElement,
    private readonly act: (act: Act) => void,
    private readonly edit: () => void,
  ) {
    for (const own of [this.tools, this.below]) {
      // The sheet has its own meaning for clicks and keys.
      for (const kind of ["pointerdown", "dblclick", "keydown"]) own.addEventListener(kind, (event) => (event as KeyboardEvent).key === "Escape" || event.stopPropagation());
    }
  }

  /** Shows it for a drawing. */
  show(drawn: Drawn): void {
    const { paper, tools, below } = this;
    const button = (id: string, text: string, click: () => void): HTMLElement => h("button", { type: "button", id, click: () => {
      click();
      paper.focus();
    } }, text);
    const isElement = drawn.at.what === "element" || drawn.at.what === "run" || drawn.at.what === "branch";
    tools.setAttribute("aria-label", say("drawEdit"));
    tools.replaceChildren(button("at-edit", say("edit1"), this.edit), button("at-branch", say("branch"), () => this.act({ do: "branch" })),
      button("at-delete", say("remove"), () => this.act({ do: "delete" })));
    tools.hidden = !isElement;
    const last = [...paper.querySelectorAll<SVGElement>(".rung")].at(-1)?.dataset["id"];
    const hint = paper.querySelector(".element") ? null : h("p", { class: "note", id: "draw-hint" }, say("emptyHint"));
    below.replaceChildren(...(hint ? [hint] : []), button("rung-add", `+ ${say("rungAdd")}`, () => {
      if (last) this.act({ do: "select", from: Number(last), to: Number(last) });
      this.act({ do: "insertRung", along: "forth" });
    }));
    if (below.parentElement !== paper) paper.append(below, tools);
    this.place();
  }

  /** Puts it where the selected element is now. */
  place(): void {
    const { paper, tools } = this;
    const selected = paper.querySelector(".element.selected");
    if (!selected) tools.hidden = true;
    if (!selected || tools.hidden) return;
    const [at, on] = [selected.getBoundingClientRect(), paper.getBoundingClientRect()];
    const left = Math.min(at.left - on.left, paper.clientWidth - tools.offsetWidth - GAP);
    tools.style.left = `${Math.max(left, GAP) + paper.scrollLeft}px`;
    tools.style.top = `${at.bottom - on.top + paper.scrollTop + GAP}px`;
  }

  /** Takes it away: nothing is drawn. */
  clear(): void {
    this.tools.remove();
    this.below.remove();
  }
}
