// All boards: what each does, what is wrong with it, and the way to its own page.

import { h } from "../page/dom";
import { say } from "../words/site";
import { speak } from "../words/words";
import { type Board, pageOf } from "./ask";
import { severityOf } from "./alarms";
import type { State } from "./state";
import { value } from "./told";

/** A card shows so many points; the panel has the others. */
const POINTS = 8;

export class Boards {
  readonly root = h("div");
  private readonly find = h("input", { type: "search", id: "find-board" });
  private readonly count = h("p", { class: "note", id: "boards-up" });
  private readonly cards = h("ul", { class: "cards" });

  constructor(private readonly state: State) {
    this.find.addEventListener("input", () => this.draw());
    this.root.append(h("div", { class: "bar" }, this.count, h("span", { class: "grow" }), this.find), this.cards);
    state.boards.follow(() => this.draw());
    speak.follow(() => this.draw());
  }

  shown(): void {
    this.draw();
  }

  private draw(): void {
    if (this.root.hidden) return;
    const boards = this.state.boards.value;
    this.find.setAttribute("aria-label", say("boardFind"));
    this.find.placeholder = say("boardFind");
    this.count.textContent = say("boardsUp", { up: boards.filter((board) => board.up).length, all: boards.length });
    const asked = this.find.value.trim().toLowerCase();
    const found = boards.filter((board) => board.name.toLowerCase().includes(asked));
    const cards = found.map((board) => this.card(board));
    // What has the focus keeps it: the card is another one, its link is the same.
    const focus = this.cards.contains(document.activeElement) ? (document.activeElement as HTMLElement).dataset["key"] : undefined;
    this.cards.replaceChildren(...(cards.length > 0 || boards.length === 0 ? cards : [h("li", { class: "empty" }, say("boardNoMatch"))]));
    if (focus) this.cards.querySelector<HTMLElement>(`[data-key="${focus}"]`)?.focus();
  }

  private card(board: Board): HTMLElement {
    const points = Object.entries(board.points);
    const alarms = this.state.alarms.value.filter((alarm) => alarm.state !== "normal" && alarm.boards.includes(board.name));
    const rows = points.slice(0, POINTS).map(([name, of]) => h("div", {}, h("dt", {}, name), h("dd", {}, value(board.up ? of : null))));
    return h("li", { class: "card board-card", "data-board": board.name },
      h("h3", {}, h("span", {}, board.name), h("small", {}, points.length > 0 ? say("boardPoints", { count: points.length }) : say("boardNoPoints"))),
      h("p", { class: "status", "data-state": board.up ? board.doing ?? "" : "" }, stateOf(board)),
      board.up ? null : h("p", { class: "note" }, board.why ?? ""),
      board.forced && board.up ? h("p", { class: "forced-mark" }, say("boardForced")) : null,
      ...alarms.map((alarm) => h("p", { class: "alarm-mark", "data-severity": alarm.severity }, `${severityOf(alarm.severity)}: ${alarm.text[speak.value]}`)),
      h("dl", {}, ...rows),
      h("div", { class: "row" },
        h("a", { class: "button", href: `#panels/${board.name}`, "data-key": `panel-${board.name}`, "aria-label": `${say("boardPanel")}: ${board.name}` }, say("boardPanel")),
        h("a", { class: "button", href: pageOf(board.name), "data-key": `page-${board.name}`, "aria-label": `${say("boardOpen")}: ${board.name}` }, say("boardOpen"))));
  }
}

/** What a board does, in words. */
function stateOf(board: Board): string {
  if (!board.up) return say("boardAway");
  const { doing, fault, line } = board;
  if (doing === "FAULT" && fault !== undefined) return line === undefined ? say("boardFault", { fault }) : say("boardFaultLine", { fault, line });
  return doing ?? say("boardUp");
}
