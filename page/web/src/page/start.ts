// The button that puts the program on the board and runs it.

import { Refusal } from "../tools/tools";
import { say, speak, told } from "../words/words";
import type { Bench } from "./bench";
import type { ProgramDocument } from "./document";
import { h, put } from "./dom";
import type { ForBoard } from "./forboard";
import { icon } from "./icons";
import { note } from "./notes";
import { whyNot } from "./problems";
import type { Tabs } from "./tabs";

export function startControl(bench: Bench, program: ProgramDocument, forBoard: ForBoard, tabs: Tabs, goDraw: () => void): { control: HTMLElement; run: () => Promise<void> } {
  const button = h("button", { type: "button", class: "primary", id: "run" }, icon("play"));
  const word = h("span");
  button.append(word);
  const bar = h("progress", { max: 1, value: 0, hidden: true, "aria-label": "upload" });
  const about = h("p", { class: "note", id: "about-program" });
  const run = async (): Promise<void> => {
    const looked = await program.now();
    if (!program.whole) {
      if (program.lacks.value > 0) goDraw();
      else tabs.open("problems");
      return note(() => whyNot(program));
    }
    try {
      if (!(await atHand())) return;
      await bench.put(looked.text);
      bench.on.value = looked.text;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
    }
  };
  /** The board that the program is for is at hand; said where another is. */
  const atHand = async (): Promise<boolean> => {
    const { chosen } = forBoard;
    if (chosen.firmware) {
      if (bench.where.value === "core") await bench.useSimulated();
      return true;
    }
    const unsent = program.whole?.made.unsent;
    if (bench.where.value === "desk") {
      note(() => (unsent ? told(unsent) : whyNot(program)));
      return false;
    }
    await bench.useCore(chosen);
    return true;
  };
  button.addEventListener("click", () => void run());
  document.addEventListener("keydown", (event) => {
    if ((event.ctrlKey || event.metaKey) && event.key === "Enter") {
      event.preventDefault();
      void run();
    }
  });
  const show = (): void => {
    const here = !forBoard.chosen.firmware;
    const there = bench.identity.value !== null || here;
    word.dataset["say"] = here ? "runHere" : "run";
    put(word, say(here ? "runHere" : "run"));
    button.disabled = !there || bench.upload.value !== null;
    const on = bench.on.value;
    const text = program.text.value;
    const changed = on !== null && (on.text !== text.text || on.name !== text.name);
    put(about, changed ? say("changed") : bench.seen.value?.same === false && bench.seen.value.state !== "EMPTY" ? say("otherProgram") : "");
  };
  bench.upload.follow((upload) => {
    bar.hidden = upload === null;
    if (upload !== null && upload !== "storing") bar.value = upload.share;
    else if (upload === "storing") bar.removeAttribute("value");
    show();
  });
  for (const signal of [bench.identity, bench.on, bench.seen, program.text, program.board, speak]) (signal as typeof bench.identity).follow(show);
  return { control: h("div", { class: "row" }, button, bar, about), run };
}
