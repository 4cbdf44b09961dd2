// The fields of the selected part of a chart: each is done when it has changed.

import type { Ask, ChartPart, Problem } from "../../tools/answers";
import { say } from "../../words/chart";
import { speak, told } from "../../words/words";
import { h } from "../dom";
import { isWritten, refill } from "../refill";

/** What is done to a part. */
export type Done = Pick<Ask<"chart">, "what" | "say" | "qualifier" | "time">;

type Word = Parameters<typeof say>[0];

const QUALIFIERS = ["N", "S", "R", "L", "D", "P", "P1", "P0", "SD", "DS", "SL"];
/** Those with a time. */
const TIMED = /^(L|D|SD|DS|SL)$/;
const SECOND = "T#1s";

export class Form {
  readonly root = h("form", { class: "chart-form", id: "chart-form", submit: (event) => event.preventDefault() });
  /** What its fields are made of. */
  private made = "";
  /** The part that they are of. */
  private part = "";

  constructor(
    private readonly act: (act: Done) => void,
    /** The focus goes back to the chart. */
    private readonly leave: () => void,
  ) {}

  /** Shows a part; a field in which somebody writes stays as it is. */
  show(part: ChartPart, steps: readonly string[], wrong: readonly Problem[]): void {
    const { id, kind, name, text, qualifier, time, priority, initial } = part;
    const made = JSON.stringify([id, kind, name, text, qualifier, time, priority, initial, steps, wrong, speak.value]);
    if (made === this.made) return;
    this.made = made;
    const mistakes = wrong.map(({ severity, message, help }) => h("p", { class: severity }, told(message), h("small", {}, told(help))));
    refill(this.root, [...this.fields(part, steps), ...mistakes], id === this.part);
    this.part = id;
  }

  /** The focus goes to its first field. */
  focus(): void {
    const first = this.root.querySelector<HTMLElement>("input, select, textarea");
    first?.focus();
    if (isWritten(first)) first.select();
  }

  private fields(part: ChartPart, steps: readonly string[]): HTMLElement[] {
    const to = (): HTMLElement => this.pick("chartTo", "to", steps, part.name, (say) => ({ what: "lead", say }));
    const does = (more: Done): Done => ({ what: "does", say: part.name, qualifier: part.qualifier, time: part.time, ...more });
    switch (part.kind) {
      case "step":
        return [
          this.line("chartName", "name", part.name, (say) => ({ what: "rename", say })),
          h("button", { type: "button", id: "chart-initial", disabled: part.initial, click: () => this.act({ what: "initial" }) }, say("chartInitial")),
          this.pick("chartJumpTo", "jump", ["", ...steps], "", (say) => ({ what: "jump", say })),
        ];
      case "does":
        return [
          this.line("chartAction", "action", part.name, (say) => does({ say })),
          this.pick("chartQualifier", "qualifier", QUALIFIERS, part.qualifier, (qualifier) => does({ qualifier, time: part.time || (TIMED.test(qualifier) ? SECOND : "") })),
          TIMED.test(part.qualifier) && this.line("chartTime", "time", part.time, (time) => does({ time })),
          this.lines("chartBody", "body", part.text, (say) => ({ what: "body", time: part.name, say })),
        ].filter((field) => field !== false);
      case "transition":
        return [
          this.line("chartCondition", "condition", part.text, (say) => ({ what: "condition", say })),
          this.line("chartPriority", "priority", part.priority, (say) => ({ what: "priority", say })),
          to(),
        ];
      default:
        return [to()];
    }
  }

  private line(word: Word, name: string, value: string, act: (value: string) => Done): HTMLElement {
    const input = h("input", { id: `chart-${name}`, value, autocomplete: "off", spellcheck: "false", change: () => this.act(act(input.value)) });
    input.addEventListener("keydown", ({ key }) => {
      if (key === "Escape") input.value = input.defaultValue;
      if (key === "Escape" || key === "Enter") this.leave();
    });
    return h("label", {}, say(word), input);
  }

  private lines(word: Word, name: string, value: string, act: (value: string) => Done): HTMLElement {
    const input = h("textarea", { id: `chart-${name}`, rows: Math.max(2, value.split("\n").length), spellcheck: "false", change: () => this.act(act(input.value)) }, value);
    input.addEventListener("keydown", ({ key, ctrlKey, metaKey }) => {
      if (key === "Escape") input.value = input.defaultValue;
      if (key === "Escape" || (key === "Enter" && (ctrlKey || metaKey))) this.leave();
    });
    return h("label", {}, say(word), input);
  }

  private pick(word: Word, name: string, values: readonly string[], value: string, act: (value: string) => Done): HTMLElement {
    const list = h("select", { id: `chart-${name}`, change: () => this.act(act(list.value)) }, ...values.map((one) => h("option", { value: one, selected: one === value }, one)));
    list.addEventListener("keydown", ({ key }) => {
      if (key === "Escape" || key === "Enter") this.leave();
    });
    return h("label", {}, say(word), list);
  }
}
