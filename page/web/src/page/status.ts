// The one status: what the board does, and beneath it why what is written is not what runs. It keeps its height.

import { countOf, whyNot } from "./problems";
import { say, speak, told } from "../words/words";
import type { Bench } from "./bench";
import type { ProgramDocument } from "./document";
import { h, put } from "./dom";
import { announce } from "./notes";

export function statusOf(bench: Bench, program: ProgramDocument): HTMLElement {
  const board = h("b", { id: "board-state" });
  const about = h("small", { id: "about-program" });
  const bar = h("progress", { max: 1, value: 0, hidden: true, "data-say-label": "uploading" });
  const root = h("div", { class: "status", id: "status" }, h("div", {}, board, about), bar);
  let shown = "";
  const show = (): void => {
    const { state, text } = stateOf(bench);
    root.dataset["state"] = state;
    put(board, text);
    put(about, aboutOf(bench, program));
    root.title = [text, about.textContent].filter(Boolean).join("\n");
    if (`${state} ${text}` === shown) return;
    shown = `${state} ${text}`;
    const { value: upload } = bench.upload;
    if (!upload || upload === "storing") announce(text);
  };
  bench.upload.follow((upload) => {
    bar.hidden = upload === null;
    if (upload !== null && upload !== "storing") bar.value = upload.share;
    else if (upload === "storing") bar.removeAttribute("value");
  });
  for (const signal of [bench.seen, bench.lost, bench.power, bench.upload, bench.paused, bench.on, bench.where, program.looked, program.lacks, speak]) {
    (signal as typeof bench.seen).follow(show);
  }
  return root;
}

/** What the board does, in words. */
function stateOf({ where, seen: { value: seen }, upload: { value: upload }, power, lost }: Bench): { state: string; text: string } {
  const here = where.value === "core";
  const simulated = where.value === "simulated";
  const plain = (text: string): { state: string; text: string } => ({ state: "", text });
  if (simulated && !power.value) return plain(say("stateOff"));
  if (upload === "storing") return plain(say("storing"));
  if (upload) return plain(say("sending", { percent: Math.round(upload.share * 100) }));
  if (!seen) return plain(lost.value ? told(lost.value) : simulated ? say("stateStarting") : say("stateNone"));
  const { state } = seen;
  switch (state) {
    case "RUN": return { state, text: say(here ? "stateRunHere" : "stateRun") };
    case "STOP": return { state, text: say("stateStop") };
    case "EMPTY": return { state, text: say("stateEmpty") };
    default: return { state, text: seen.fault ? `${say("stateFault")} – ${told(seen.fault.text)}` : say("stateFault") };
  }
}

/** Why what is written is not what runs; nothing where it is. */
function aboutOf({ on: { value: on }, seen: { value: seen } }: Bench, program: ProgramDocument): string {
  const text = program.text.value;
  const looked = program.looked.value;
  if (program.lacks.value > 0) return whyNot(program);
  if (looked && looked.text === text && !looked.checked.program && !looked.checked.blank) return `${countOf(looked.checked, 0)}. ${say("checkErrors")}`;
  if (on !== null && (on.text !== text.text || on.name !== text.name)) return say("changed");
  return seen?.same === false && seen.state !== "EMPTY" ? say("otherProgram") : "";
}
