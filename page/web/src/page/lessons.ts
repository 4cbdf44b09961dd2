// The tutorial: each step with its words, its program, and checks of what somebody has written.

import { beside } from "../offline/beside";
import type { Both, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { type PlainKey, say, speak, told } from "../words/words";
import { showColumn } from "./column";
import { type ProgramDocument, stemOf } from "./document";
import { byId, h } from "./dom";
import { keep, kept } from "./kept";
import { readable } from "./picture";
import { Verdict } from "./verdict";

interface Lesson {
  readonly title: Both;
  /** HTML that the build has made of docs/tutorial.md. */
  readonly words: Both;
  readonly name: string;
  readonly text: string;
  readonly step: string;
  readonly exercise: string;
  readonly solution: string;
}

export class Lessons {
  private lessons: readonly Lesson[] = [];
  private at = -1;

  constructor(
    private readonly root: HTMLElement,
    private readonly tools: RemoteTools,
    private readonly program: ProgramDocument,
    private readonly open: (text: Text) => void,
  ) {
    speak.follow(() => this.show());
  }

  /** Opens the tutorial where it was left. */
  async start(): Promise<void> {
    if (this.lessons.length === 0) this.lessons = (await (await beside("lessons.json")).json()) as Lesson[];
    this.go(Number(kept("lesson") ?? "0"));
  }

  close(): void {
    this.at = -1;
    this.show();
  }

  private go(at: number): void {
    this.at = Math.min(Math.max(at, 0), this.lessons.length - 1);
    keep("lesson", String(this.at));
    this.show();
    this.root.scrollTo(0, 0);
  }

  private show(): void {
    const lesson = this.lessons[this.at];
    this.root.hidden = !lesson;
    showColumn();
    if (!lesson) return;
    const words = h("div", { class: "words" });
    // Made at build time of a page of this repository.
    words.innerHTML = told(lesson.words);
    this.furnish(words, lesson);
    const verdict = new Verdict(this.tools);
    const check = (scenario: string): void => void verdict.check(this.program, scenario, lesson.name);
    const button = (key: PlainKey, click: () => void, kind = ""): HTMLElement => h("button", { type: "button", class: kind, click }, say(key));
    const load = (text: string): void => this.open({ name: lesson.name, text });
    const draw = (): void => {
      load("");
      byId("view-draw").click();
    };
    const close = h("button", { type: "button", class: "quiet", "aria-label": say("close"), click: () => this.close() }, "×");
    const before = this.at > 0 ? button("lessonBefore", () => this.go(this.at - 1)) : null;
    const next = this.at + 1 < this.lessons.length ? button("lessonNext", () => this.go(this.at + 1)) : null;
    this.root.replaceChildren(
      h("div", { class: "row" }, h("span", { class: "chip" }, say("lessonOf", { n: this.at + 1, all: this.lessons.length })), h("span", { style: "flex:1" }), before, next, close),
      h("h3", {}, told(lesson.title)), words, verdict.element,
      h("div", { class: "pinned" }, verdict.line, h("div", { class: "row" }, button("lessonLoad", () => load(lesson.text), "primary"),
        lesson.name.endsWith(".il") ? button("lessonDraw", draw) : null,
        button("checkStep", () => check(lesson.step)),
        button("checkExercise", () => check(lesson.exercise)),
        button("lessonSolution", () => load(lesson.solution)))));
  }

  /** Puts a button at each listing, and the picture of a ladder in its place: of the listing before it, or of the step's program. */
  private furnish(words: HTMLElement, lesson: Lesson): void {
    let last: Text = { name: lesson.name, text: lesson.text };
    for (const figure of words.querySelectorAll<HTMLElement>("figure")) {
      const text = figure.textContent ?? "";
      const end = figure.dataset["end"];
      if (end === undefined) {
        figure.replaceChildren(readable(this.tools, last, text));
        continue;
      }
      const own = { name: `${stemOf(lesson.name)}.${end}`, text };
      last = own;
      // A listing that is wider than the column is scrolled with the keyboard too.
      figure.querySelector("pre")?.setAttribute("tabindex", "0");
      figure.append(h("button", { type: "button", class: "quiet small", click: () => this.open(own) }, say("lessonPut")));
    }
  }
}
