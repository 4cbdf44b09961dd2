// What came of a check: the cases, of the first that was not passed the timing diagram, and of a machine what went wrong,
// seen again.

import type { Outcome, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say as sayHere } from "../words/learn";
import { say, speak, told } from "../words/words";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import { announce, note } from "./notes";
import { whyNot } from "./problems";
import { Replay } from "./replay";
import { reveal } from "./reveal";

export class Verdict {
  /** The cases, the diagram of the first that fails, the machine. */
  readonly element = h("div", { class: "outcome" });
  /** What came of it in a line, which stays in view. */
  readonly line = h("p", { class: "verdict", id: "verdict", role: "status", hidden: true });
  private came: Outcome | Refusal | null = null;
  private replay: Replay | null = null;
  /** The language in which it was told last. */
  private spoken = speak.value;

  constructor(private readonly tools: RemoteTools) {}

  /** Runs a program through the cases of a scenario file, and shows what came of it. Tells whether it passed. */
  async check(program: ProgramDocument, scenario: string, title: string, machine: Text | null = null): Promise<boolean> {
    // What is not a program yet passes nothing, whatever the last one did.
    if (program.lacks.value > 0) {
      note(() => whyNot(program));
      return false;
    }
    const text = program.text.value;
    this.replay = null;
    try {
      this.came = await this.tools.ask("exercise", { of: text, scenario, title, plant: machine?.name, plantText: machine?.text });
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      this.came = error;
    }
    const fared = this.came instanceof Refusal ? null : this.came.machine;
    if (machine && fared?.why && fared.at !== null) {
      this.replay = new Replay(this.tools, { of: text, plant: machine.name, plantText: machine.text, scenario, at: fared.at, why: fared.why });
      void this.replay.load(true);
    }
    this.spoken = speak.value;
    this.show();
    announce(this.text());
    reveal(this.element);
    return this.passed();
  }

  /** Shows it in the language of now. */
  show(): void {
    if (!this.came) return;
    if (this.spoken !== speak.value) {
      this.spoken = speak.value;
      void this.replay?.load(false);
    }
    this.line.hidden = false;
    this.line.className = `verdict ${this.passed() ? "good" : "bad"}`;
    this.line.textContent = this.text();
    if (this.came instanceof Refusal) {
      this.element.replaceChildren();
      return;
    }
    const cases = this.came.cases.map(([one, passed]) =>
      h("li", { class: passed ? "good" : "bad" }, `${passed ? "✓" : "✗"} ${told(one.title)}`, one.hidden ? h("span", { class: "note" }, ` (${sayHere("caseHidden")})`) : null));
    // It scrolls where the screen is narrow, by the keyboard too.
    const diagram = h("div", { class: "diagram", tabindex: 0, role: "group", "aria-label": say("tabTrend") });
    const shown = this.came.failing?.shown;
    // Drawn by our own Rust, which escapes every text in it.
    if (shown) diagram.innerHTML = told(shown.svg);
    const { machine } = this.came;
    const fared = machine && h("p", { class: machine.passed ? "good" : "bad", id: "machine-verdict" }, `${machine.passed ? "✓" : "✗"} ${sayHere("theMachine")}${machine.why ? `: ${told(machine.why)}` : ""}`);
    this.element.replaceChildren(h("ul", { class: "cases" }, ...cases), diagram, ...(fared ? [fared] : []), ...(this.replay ? [this.replay.element] : []));
  }

  private passed(): boolean {
    return this.came !== null && !(this.came instanceof Refusal) && this.came.passed;
  }

  private text(): string {
    if (!this.came) return "";
    if (this.came instanceof Refusal) return told(this.came.both);
    if (this.came.passed) return sayHere("passed");
    const { failing, cases, machine } = this.came;
    if (!failing && machine?.why) return sayHere("failedMachine", { why: told(machine.why) });
    if (failing && !failing.shown) return sayHere("failedHidden", { title: told(cases[failing.case]?.[0].title ?? { en: "", pt: "" }) });
    const unmet = failing?.shown?.unmet;
    if (unmet) return sayHere("failedAt", { time: unmet.from, place: unmet.place, came: unmet.came, expected: unmet.expected });
    return failing?.shown ? told(failing.shown.why) : sayHere("failedAny");
  }
}
