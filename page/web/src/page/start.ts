// Run and Stop: what is written is put on the board and runs, or the board stops.

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

export function startControl(bench: Bench, program: ProgramDocument, forBoard: ForBoard, tabs: Tabs, goDraw: () => void): { controls: readonly HTMLElement[]; run: () => Promise<void> } {
  const button = h("button", { type: "button", class: "primary", id: "run" }, icon("play"), h("span", { "data-say": "run" }));
  const stop = h("button", { type: "button", id: "command-stop", click: () => void bench.ask({ do: "stop" }) }, icon("stop"), h("span", { "data-say": "stop" }));
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
      if (bench.where.value !== "desk") await bench.simulate(chosen);
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
    button.disabled = (bench.identity.value === null && !here) || bench.upload.value !== null;
    button.title = `${say(here ? "runHere" : "runBoard")} (Ctrl+Enter)`;
    const state = bench.seen.value?.state;
    stop.disabled = state === undefined || state === "STOP" || state === "EMPTY";
  };
  for (const signal of [bench.identity, bench.upload, bench.seen, program.board, speak]) (signal as typeof bench.identity).follow(show);
  return { controls: [button, stop], run };
}
