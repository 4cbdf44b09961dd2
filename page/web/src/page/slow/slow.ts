// A scan in slow motion: where it stands, how it goes on, and what stands beside it.

import type { Go } from "unoclp-uno/slow";
import { dressIn } from "../../offline/beside";
import type { Made, Seen, Stood, Text } from "../../tools/answers";
import { hasBit } from "../../tools/bits";
import type { RemoteTools } from "../../tools/remote";
import { Refusal } from "../../tools/tools";
import { SLOW } from "../../words/slowtable";
import { type Plain, sayFrom, speak, told, translate } from "../../words/words";
import type { Bench } from "../bench";
import type { ProgramDocument } from "../document";
import { byId, h } from "../dom";
import type { Editor } from "../editor";
import { note } from "../notes";
import { upTo } from "../points";
import { type Stop, lineOf, lineStarts, rungStarts, stopAt } from "./code";
import { DRAWN } from "../sfc/drawn";
import { markDrawings, markText, selected, selectedPart } from "./marks";
import { type Stepper, stepper } from "./stepper";

const say = sayFrom(SLOW);

type Way = "element" | "rung" | "line" | "end" | "here" | "break" | "on";

/** The buttons, with the keys that do the same. */
const WAYS: readonly (readonly [Way, keyof typeof SLOW, keys: string, hint?: keyof typeof SLOW])[] = [
  ["element", "slowElement", "F10"],
  ["rung", "slowRung", "Ctrl-F10"],
  ["line", "slowLine", "Alt-F10"],
  ["end", "slowEnd", "Ctrl-F8"],
  ["here", "slowHere", "Ctrl-F9", "slowHereHint"],
  ["break", "slowBreak", "F9", "slowBreakHint"],
  ["on", "slowOn", "F4", "slowOnHint"],
];

/** What is held: a text, what has become of it, and where its rungs begin. */
interface Held {
  readonly text: Text;
  readonly made: Made;
  readonly rungs: readonly number[];
  readonly stepper: Stepper;
}

/** The bits of a number: outputs above it stay as they were read. */
const BITS = 32;

/** A reading as it is where the board stands: what is shown live, and the outputs at their pins. */
function readAt(seen: Seen, { live, driven }: Stood): Seen {
  const outputs = [...upTo(BITS).filter((output) => hasBit(driven, output)), ...seen.outputs.filter((output) => output > BITS)];
  return { ...seen, live, outputs };
}

/** What takes a breakpoint away. */
function taken({ line, part }: Stop): string {
  return part === undefined ? say("slowTake", { line }) : say("slowTakePart", { part });
}

export class SlowMotion {
  private held: Held | null = null;
  /** Where it stands; null while it runs. */
  private now: Stood | null = null;
  private stops: Stop[] = [];
  private readonly state = h("p", { class: "slow-state", id: "slow-state", role: "status" });
  private readonly beside = h("div", { class: "slow-beside" });
  private readonly breaks = h("div", { class: "slow-breaks", role: "group", "data-say-label": "slowBreaks" });
  private readonly root: HTMLElement;

  constructor(
    private readonly program: ProgramDocument,
    private readonly bench: Bench,
    private readonly tools: RemoteTools,
    private readonly editor: Editor,
  ) {
    const buttons = WAYS.map(([way, words, keys, hint]) =>
      h("button", { type: "button", id: `slow-${way}`, "aria-keyshortcuts": keys.replaceAll("-", "+").replace("Ctrl", "Control"), ...(hint && { "data-say-title": hint }), click: () => void this.take(way) },
        h("span", { "data-say": words }), h("small", { class: "note", "aria-hidden": "true" }, keys)));
    const close = h("button", { type: "button", class: "quiet", id: "slow-close", "data-say-label": "slowClose", click: () => this.end("slowEnded") }, "×");
    this.root = h("section", { class: "slow", id: "slow", "data-say-label": "slow", hidden: true },
      h("div", { class: "slow-head" }, h("div", { class: "slow-bar", role: "toolbar", "data-say-label": "slow" }, ...buttons), this.state, close), this.breaks, this.beside);
    byId("views").after(this.root);
    document.addEventListener("keydown", (event) => this.press(event), { capture: true });
    document.addEventListener(DRAWN, () => this.show());
    program.text.follow(({ text }) => {
      if (this.held && text !== this.held.text.text) this.end("slowChanged");
    });
    const { where, paused, power, seen, on } = bench;
    where.follow(() => this.end("slowEnded"));
    on.follow((text) => {
      if (this.held && text !== null && text.text !== this.held.text.text) this.end("slowChanged");
    });
    power.follow((is) => {
      if (!is) this.end("slowEnded");
    });
    // Somebody has time go on, or the board does something else.
    paused.follow((is) => {
      if (!is && this.held) this.end("slowEnded");
    });
    // While the board stands, what is shown live is where it stands.
    seen.follow((now) => {
      if (now && this.now?.live && now.live !== this.now.live) seen.value = readAt(now, this.now);
    });
    speak.follow(() => {
      translate(this.root);
      this.show();
    });
  }

  /** Begins: the board stops before the first element of its next scan. */
  async open(): Promise<void> {
    if (this.held) return this.focus();
    const { bench, program, tools } = this;
    const looked = program.looked.value;
    const made = looked?.checked.program;
    if (bench.where.value === "desk") return note(() => say("slowDesk"));
    const isOn = made && bench.seen.value?.same === true && bench.on.value?.text === looked.text.text && bench.seen.value.state === "RUN";
    if (!looked || !made || !isOn) return note(() => say("slowNothing"));
    await dressIn("slow.css");
    const { text } = looked;
    const { svg } = await tools.ask("ladder", { of: text, width: 80, isBlocks: false, speak: speak.value });
    const held = await stepper(bench, tools, text, (now) => this.stand(now));
    if (!held) return note(() => say("slowNothing"));
    if (!program.isStill(text)) {
      held.release();
      return note(() => say("slowChanged"));
    }
    this.held = { text, made, rungs: rungStarts(svg), stepper: held };
    this.stops = [];
    bench.pause();
    this.root.hidden = false;
    translate(this.root);
    this.go({ to: null, through: false });
    this.focus();
  }

  private focus(): void {
    byId("slow-element").focus();
  }

  private press(event: KeyboardEvent): void {
    if (!this.held || event.shiftKey || event.metaKey) return;
    const keys = `${event.ctrlKey ? "Ctrl-" : ""}${event.altKey ? "Alt-" : ""}${event.key}`;
    const way = WAYS.find(([, , own]) => own === keys);
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    void this.take(way[0]);
  }

  private take(way: Way): void {
    const { held } = this;
    if (!held) return;
    switch (way) {
      case "element":
        return this.go({ to: null, through: false });
      case "rung":
        return this.go({ to: held.rungs, through: false });
      case "line":
        return this.go({ to: lineStarts(held.made), through: false });
      case "end":
        return this.go({ to: [], through: false });
      case "on":
        return this.go({ to: this.stops.map(({ step }) => step), through: true });
      case "here": {
        const stop = this.chosen(held.made);
        return stop ? this.go({ to: [stop.step], through: true }) : undefined;
      }
      case "break": {
        const stop = this.chosen(held.made);
        if (stop) this.turn(stop);
      }
    }
  }

  /** What the cursor is at, in the chart, in the drawing or in the text. */
  private chosen(made: Made): Stop | null {
    const part = selectedPart();
    if (part?.step === null) {
      note(() => say("slowNoPart", { part: part.name }));
      return null;
    }
    if (part) return { step: part.step, line: lineOf(made, part.step) ?? 1, part: part.name };
    const drawn = byId("views").dataset["view"] === "draw" ? selected() : null;
    if (drawn !== null) return { step: drawn, line: lineOf(made, drawn) ?? 1 };
    const { state } = this.editor.view;
    const line = state.doc.lineAt(state.selection.main.head).number;
    const stop = stopAt(made, line);
    if (!stop) note(() => say("slowNoneBehind", { line }));
    else if (stop.line !== line) note(() => say("slowNoCode", { line, there: stop.line }));
    return stop;
  }

  /** Sets a breakpoint, or takes it away. */
  private turn(stop: Stop): void {
    const without = this.stops.filter(({ step }) => step !== stop.step);
    this.stops = without.length < this.stops.length ? without : [...this.stops, stop].sort((one, other) => one.step - other.step);
    this.show();
  }

  private go(go: Go): void {
    if (!this.held) return;
    this.now = null;
    this.waits = go.through;
    try {
      this.held.stepper.go(go);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
      return this.end("slowEnded");
    }
    // One that stands already has been shown.
    if (!this.now) this.show();
  }
  private waits = false;

  /** The board stands. */
  private stand(now: Stood): void {
    if (!this.held) return;
    this.now = now;
    const { seen } = this.bench;
    if (seen.value && now.live) seen.value = readAt(seen.value, now);
    this.show();
  }

  /** Lets the board go, and tells why. */
  private end(why: "slowChanged" | "slowEnded"): void {
    const { held, bench } = this;
    if (!held) return;
    this.held = this.now = null;
    this.stops = [];
    held.stepper.release();
    bench.goOn();
    this.root.hidden = true;
    this.show();
    note(() => say(why));
  }

  private show(): void {
    const { held, now } = this;
    const stops = this.stops.map(({ step }) => step);
    const step = now?.step ?? null;
    const line = held && step !== null ? lineOf(held.made, step) : null;
    markDrawings(now && step !== null ? [step, Math.max(now.until, step + 1)] : null, stops);
    markText(this.editor.view, { here: line, stops: this.stops.map((stop) => stop.line) });
    if (!held) return;
    this.state.textContent = this.saying(now, line);
    this.state.ariaBusy = String(!now);
    this.breaks.hidden = this.stops.length === 0;
    this.breaks.replaceChildren(h("b", {}, say("slowBreaks")), ...this.stops.map((stop) =>
      h("button", { type: "button", "data-step": stop.step, "aria-label": taken(stop), title: taken(stop), click: () => this.turn(stop) },
        stop.part ?? say("slowBreakOf", { line: stop.line }), " ×")));
    this.beside.replaceChildren(...(now ? this.registers(now, held.made) : []));
  }

  private saying(now: Stood | null, line: number | null): string {
    if (!now) return say(this.waits && this.stops.length > 0 ? "slowWaits" : "slowRuns");
    if (now.step === null) return say("slowOver");
    return line === null ? say("slowLast") : say("slowNext", { line, acc: Number(now.acc) });
  }

  /** What stands beside the drawing. */
  private registers(now: Stood, made: Made): HTMLElement[] {
    const one = (words: Plain<typeof SLOW>, id: string, value: string): HTMLElement[] => [h("dt", {}, say(words)), h("dd", { id }, value)];
    const bit = (bits: number, number: number): string => String(Number(hasBit(bits, number)));
    const points = (words: Plain<typeof SLOW>, letter: string, numbers: readonly number[], image: number, pins: number): HTMLElement =>
      h("table", { id: `slow-${letter}` },
        h("caption", {}, say(words)),
        h("thead", {}, h("tr", {}, ...(["slowPoint", "slowImage", "slowPin"] as const).map((head) => h("th", { scope: "col" }, say(head))))),
        h("tbody", {}, ...numbers.map((number) => {
          const [own, pin] = [bit(image, number), bit(pins, number)];
          return h("tr", own === pin ? {} : { class: "differs" }, h("th", { scope: "row" }, made.symbols[`${letter}${number}`] ?? `${letter}${number}`), h("td", {}, own), h("td", {}, pin));
        })));
    return [
      h("dl", {}, ...one("slowAcc", "slow-acc", String(Number(now.acc))), ...one("slowValue", "slow-value", String(now.value)),
        ...one("slowStack", "slow-stack", now.pushed.length > 0 ? now.pushed.join(", ") : say("slowEmpty"))),
      points("slowInputs", "I", made.uses.inputs, now.inputs, now.closed),
      points("slowOutputs", "Q", made.uses.outputs, now.outputs, now.driven),
    ];
  }
}
