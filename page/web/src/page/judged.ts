// The program of the page, judged by the rules of a machine through the machine's own script: what an exercise does for its
// machine, for any other.

import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say } from "../words/learn";
import { told } from "../words/words";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import type { MachineFile } from "./machine";
import { announce, note } from "./notes";
import { whyNot } from "./problems";
import { Replay } from "./replay";

/** Judges it, and shows in this element what came of it. */
export async function judge(tools: RemoteTools, program: ProgramDocument, { name: plant, text: plantText }: MachineFile, into: HTMLElement): Promise<void> {
  if (program.lacks.value > 0) return note(() => whyNot(program));
  const text = program.text.value;
  try {
    const { passed, why, at } = await tools.ask("trial", { of: text, plant, plantText });
    const line = h("p", { class: `verdict ${passed ? "good" : "bad"}`, id: "machine-judged-verdict", role: "status" }, why ? told(why) : say("judgedWell"));
    into.replaceChildren(line);
    announce(line.textContent ?? "");
    if (!why || at === null) return;
    const replay = new Replay(tools, { of: text, plant, plantText, at, why });
    into.append(replay.element);
    await replay.load(true);
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    note(() => told(error.both));
  }
}
