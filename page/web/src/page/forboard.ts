// The board that a program is written for: a real one, or one that only the core runs. Of that the page says that it is
// none, and which board would hold the program.

import type { BoardFacts, Problem, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal, type Tools } from "../tools/tools";
import { say, speak, told } from "../words/words";
import type { Looked, ProgramDocument } from "./document";
import { h } from "./dom";

/** What a board lacks for a program; null: nothing. */
export type Lack = string | null;

export class ForBoard {
  /** The choice; there is none where all boards have the same points. */
  readonly control: HTMLElement;
  /** What there is to say of a board that is none. */
  readonly note = h("p", { class: "note board-note", id: "board-note", role: "status", hidden: true });
  /** The boards that one can buy, and all from which one chooses: of boards with the same points the first. */
  private readonly real: readonly BoardFacts[];
  private readonly choices: readonly BoardFacts[];

  constructor(
    tools: Tools,
    private readonly remote: RemoteTools,
    private readonly program: ProgramDocument,
  ) {
    const all = tools.ask("board", {}).all.map((board) => tools.ask("board", { board }));
    this.real = all.filter(({ firmware }) => firmware);
    this.choices = all.filter((board) => board === this.real[0] || !board.firmware);
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
    for (const signal of [program.looked, speak]) (signal as typeof program.looked).follow(() => void this.show(program.looked.value));
  }

  /** What the program is written for. */
  get chosen(): BoardFacts {
    const chosen = this.choices.find(({ id }) => id === this.program.board.value) ?? this.choices[0];
    if (!chosen) throw new Error("there is no board");
    return chosen;
  }

  /** What this board lacks for a program. */
  async lack(board: BoardFacts, text: Text): Promise<Lack> {
    try {
      const { program, problems } = await this.remote.ask("check", { ...text, board: board.id });
      return program ? null : why(problems);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return told(error.both);
    }
  }

  private async show(looked: Looked | null): Promise<void> {
    const { chosen } = this;
    if (!looked || chosen.firmware || !looked.checked.program) {
      this.note.hidden = true;
      return;
    }
    const lacks = await Promise.all(this.real.map((board) => this.lack(board, looked.text)));
    // Another was written or chosen meanwhile.
    if (this.program.looked.value !== looked || this.chosen !== chosen) return;
    const held = this.real.filter((_, at) => lacks[at] === null).map(({ name }) => name);
    this.note.textContent = `${say("noBoard", { name: chosen.name })} ${held.length > 0 ? say("heldBy", { names: held.join(", ") }) : say("heldByNone", { name: this.real[0]?.name ?? "", why: lacks[0] ?? "" })}`;
    this.note.hidden = false;
  }
}

function why(problems: readonly Problem[]): string {
  const first = problems.find(({ severity }) => severity === "error") ?? problems[0];
  return first ? told(first.message) : "";
}
