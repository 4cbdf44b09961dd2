// The board that a program is written for: a real one, or one that only the core runs. Of that the page says that it is
// none, and which board would hold the program.

import type { BoardFacts } from "../tools/answers";
import type { Tools } from "../tools/tools";
import { say, speak, told } from "../words/words";
import type { Looked, ProgramDocument } from "./document";
import { h } from "./dom";

const hasPointsOf = (one: BoardFacts, other: BoardFacts): boolean => one.inputs === other.inputs && one.outputs === other.outputs && one.analogue === other.analogue;

export class ForBoard {
  /** The choice; there is none where all boards have the same points. */
  readonly control: HTMLElement;
  /** What there is to say of a board that is none. */
  readonly note = h("p", { class: "note board-note", id: "board-note", role: "status", hidden: true });
  /** Those from which one chooses: of boards with the same points the first. */
  private readonly choices: readonly BoardFacts[];

  constructor(
    tools: Tools,
    private readonly program: ProgramDocument,
  ) {
    const all = tools.ask("board", {}).all.map((board) => tools.ask("board", { board }));
    this.choices = all.filter((board, at) => !board.firmware || all.findIndex((other) => hasPointsOf(board, other)) === at);
    const list = h("select", { id: "for-board", "data-say-label": "forBoard" }, ...this.choices.map(({ id, name }) => h("option", { value: id }, name)));
    list.addEventListener("change", () => {
      program.board.value = list.value;
    });
    program.board.follow((board) => {
      list.value = this.chosen.id;
      // A board that another version of the page had.
      if (board !== "" && board !== list.value) program.board.value = "";
    });
    list.hidden = this.choices.length < 2;
    this.control = list;
    for (const signal of [program.looked, speak]) (signal as typeof program.looked).follow(() => this.show(program.looked.value));
  }

  /** What the program is written for. */
  get chosen(): BoardFacts {
    const chosen = this.choices.find(({ id }) => id === this.program.board.value) ?? this.choices[0];
    if (!chosen) throw new Error("there is no board");
    return chosen;
  }

  /** What the board of this name is called. */
  nameOf(id: string): string {
    return this.choices.find((board) => board.id === id)?.name ?? id;
  }

  private show(looked: Looked | null): void {
    const made = looked?.checked.program;
    this.note.hidden = this.chosen.firmware || !made?.unsent;
    if (!made?.unsent) return;
    const held = made.lacking ? say("heldByNone", { why: told(made.lacking) }) : say("heldBy", { names: made.heldBy.join(", ") });
    this.note.textContent = `${say("noBoard", { name: this.chosen.name })} ${held}`;
  }
}
