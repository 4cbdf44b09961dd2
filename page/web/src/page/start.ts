// The button that puts the program on the board and runs it.

import { Refusal } from "../tools/tools";
import { say, speak, told } from "../words/words";
import type { Bench } from "./bench";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import type { ForBoard } from "./forboard";
import { icon } from "./icons";
import { note } from "./notes";
import { whyNot } from "./problems";
import type { Tabs } from "./tabs";

export function startControl(bench: Bench, program: ProgramDocument, forBoard: ForBoard, tabs: Tabs, goDraw: () => void): HTMLElement {
  const button = h("button", { type: "button", class: "primary", id: "run" }, icon("play"), h("span", { "data-say": "run" }));
  const bar = h("progress", { max: 1, value: 0, hidden: true, "aria-label": "upload" });
  const about = h("p", { class: "note", id: "about-program" });
  const run = async (): Promise<void> => {
    const looked = await program.now();
    if (!program.whole) {
      if (program.lacks.value > 0) goDraw();
      else tabs.open("problems");
      return note(whyNot(program));
    }
    // What the board at hand lacks is said before anything is sent.
    const board = bench.board.value;
    const lack = forBoard.chosen.firmware ? null : await forBoard.lack(board, looked.text);
    if (lack !== null) return note(say("notOn", { name: board.name, why: lack }));
    try {
      await bench.put(looked.text);
      bench.on.value = looked.text;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(told(error.both));
    }
  };
  button.addEventListener("click", () => void run());
  document.addEventListener("keydown", (event) => {
    if ((event.ctrlKey || event.metaKey) && event.key === "Enter") {
      event.preventDefault();
      void run();
    }
  });
  const show = (): void => {
    const there = bench.identity.value !== null;
    button.disabled = !there || bench.upload.value !== null;
    const on = bench.on.value;
    const text = program.text.value;
    const changed = on !== null && (on.text !== text.text || on.name !== text.name);
    about.textContent = changed ? say("changed") : bench.seen.value?.same === false && bench.seen.value.state !== "EMPTY" ? say("otherProgram") : "";
  };
  bench.upload.follow((upload) => {
    bar.hidden = upload === null;
    if (upload !== null && upload !== "storing") bar.value = upload.share;
    else if (upload === "storing") bar.removeAttribute("value");
    show();
  });
  for (const signal of [bench.identity, bench.on, bench.seen, program.text, speak]) (signal as typeof bench.identity).follow(show);
  return h("div", { class: "row" }, button, bar, about);
}
