// The program as text and as ladder, and what of both is live.

import type { Text } from "../tools/answers";
import { LANGUAGES } from "../tools/languages";
import type { RemoteTools } from "../tools/remote";
import { say, speak } from "../words/words";
import { asked } from "./asked";
import type { Bench } from "./bench";
import { type Looked, type ProgramDocument } from "./document";
import { byId, h } from "./dom";
import type { Screen } from "./draw/screen";
import type { Editor } from "./editor";
import type { ForBoard } from "./forboard";
import { force, liveOf } from "./forcing";
import { keep, kept } from "./kept";
import { LadderView } from "./ladder";
import { later } from "./later";
import { blocks } from "./look";
import { note } from "./notes";
import { pointsOf } from "./points";
import { countOf, showProblems } from "./problems";
import type { Beside } from "./project/beside";
import { turnTo } from "./reveal";

const VIEWS = ["draw", "both", "text"] as const;
const TITLES = { draw: "viewDraw", both: "viewBoth", text: "viewText" } as const;
/** Only a text with one of these has a chart, or is a project. */
const BESIDE = /\bINITIAL_STEP\b|plcopen\.org\/xml/i;

export class ProgramView {
  private readonly ladder: LadderView;
  /** How many problems there are: what the tab of the problems says. */
  readonly count = h("span", { class: "problem-count", id: "problem-count" });
  private readonly size = h("span", { class: "chip" });
  /** The screen on which one draws, as soon as somebody has wanted it. */
  private screen: (() => Promise<Screen | null>) | null = null;
  /** Its chart, or its units, as soon as a program has had any. */
  private beside: (() => Promise<Beside | null>) | null = null;
  /** Of a text whose ladder is a compiler's code none is shown unless somebody asks for it: said here. */
  private readonly bytes = h("p", { class: "empty", id: "ladder-bytes", hidden: true }, h("span", { "data-say": "ladderBytes" }), " ",
    h("button", { type: "button", id: "ladder-anyway", "data-say": "ladderAnyway", click: () => {
      this.asked = this.program.text.value.name;
      this.bytes.hidden = true;
      byId("ladder").hidden = false;
    } }));
  /** The program whose code somebody wants to see as a ladder. */
  private asked = "";
  /** What is drawn: of this text. */
  private drawn: string | null = null;

  constructor(
    private readonly program: ProgramDocument,
    private readonly editor: Editor,
    private readonly tools: RemoteTools,
    private readonly bench: Bench,
    private readonly problems: HTMLElement,
    /** Opens another program, which can be undone. */
    private readonly open: (text: Text) => void,
    forBoard: ForBoard,
  ) {
    this.ladder = new LadderView(byId("ladder"), {
      line: (line) => this.goText(line),
      point: (point) => force(this.bench, point),
      room: () => this.ladderNow(),
    });
    byId("ladder").before(this.bytes);
    byId("drawing").append(this.ladder.zoomButtons());
    byId("program-bar").prepend(this.views());
    byId("program-bar").append(h("span", { class: "grow" }), this.size);
    byId("program-bar").after(forBoard.note);
    const name = byId("name") as HTMLInputElement;
    name.addEventListener("change", () => {
      this.program.text.value = { ...this.program.text.value, name: name.value.trim() || "program.il" };
    });
    program.text.follow((text) => {
      if (name.value !== text.name) name.value = text.name;
      this.live();
    });
    program.looked.follow((looked) => this.show(looked));
    program.lacks.follow(() => this.show(program.looked.value));
    speak.follow(() => {
      this.drawn = null;
      this.show(program.looked.value);
    });
    blocks.follow(() => this.ladderNow());
    bench.seen.follow(() => this.live());
  }

  private views(): HTMLElement {
    const root = byId("views");
    const buttons = VIEWS.map((view) => {
      const button = h("button", { type: "button", "data-say": TITLES[view], id: `view-${view}` });
      button.addEventListener("click", () => show(view));
      return button;
    });
    const show = (view: (typeof VIEWS)[number]): void => {
      root.dataset["view"] = view;
      keep("view", view);
      buttons.forEach((button, index) => button.setAttribute("aria-pressed", String(VIEWS[index] === view)));
      this.ladderNow();
      this.screened();
      void this.charted();
    };
    // What 0.2.0 called the ladder is the drawing now.
    show(VIEWS.find((view) => view === kept("view")) ?? "draw");
    return h("div", { class: "group", role: "group", "data-say-label": "views" }, ...buttons);
  }

  /** Shows the screen on which one draws; with the palette where somebody wants to draw at once. */
  goDraw(begins = false): void {
    byId("view-draw").click();
    turnTo(byId("program"));
    if (begins) void this.drawing().then((screen) => screen?.begin());
  }

  /** Goes to a line of the text, counted from 1; shows the text where the drawing alone is seen. */
  private goText(line: number, column = 1): void {
    if (byId("views").dataset["view"] === "draw") byId("view-text").click();
    turnTo(byId("program"));
    this.editor.go(line, column);
  }

  /** Shows a text that was drawn in the editor too. */
  private readonly write = (text: Text): void => {
    this.program.text.value = text;
    this.editor.show(text.text);
  };

  /** Loads the screen on which one draws; null where that cannot be had now. */
  private drawing(): Promise<Screen | null> {
    const { program, tools, bench, write } = this;
    this.screen ??= later(async () => (await import("./draw/screen")).Screen.open(byId("draw"), byId("draw-tools"), { program, tools, bench, write, open: this.open }));
    return this.screen();
  }

  /** Shows that screen where one draws: in the place of a chart or a project there is none. */
  private screened(): void {
    const draws = (): boolean => byId("views").matches('[data-view="draw"]:not([data-chart], [data-project])');
    byId("draw-tools").hidden = !draws();
    if (draws() || this.screen) void this.drawing().then((screen) => screen?.show(draws()));
  }

  /** Shows the chart of the program beside its ladder, or the units of a project. */
  private async charted(): Promise<void> {
    const root = byId("views");
    const looked = this.program.looked.value;
    if (!looked || root.dataset["view"] !== "draw" || (!this.beside && !BESIDE.test(looked.text.text))) return;
    const { program, tools, bench, write } = this;
    this.beside ??= later(async () => (await import("./project/beside")).Beside.open(root, { program, tools, bench, write }));
    await (await this.beside())?.show(looked);
    this.screened();
    this.ladderNow();
  }

  private show(looked: Looked | null): void {
    if (!looked) return;
    const { text, checked } = looked;
    void this.charted();
    this.editor.tell(text.text, checked);
    const lacks = this.program.lacks.value;
    showProblems(this.problems, checked, lacks, {
      text: (line, column) => this.goText(line, column),
      drawing: () => this.goDraw(),
      adapt: () => void this.adapt(),
    });
    this.count.textContent = countOf(checked, lacks);
    this.count.classList.toggle("bad", lacks > 0 || (checked.program === null && !checked.blank));
    this.count.classList.toggle("good", checked.problems.length === 0 && lacks === 0);
    byId("tongue").textContent = LANGUAGES[checked.language || "il"][speak.value];
    const { program } = checked;
    this.size.textContent = program ? say("size", program.size) : "";
    const ladderNote = byId("ladder-note");
    ladderNote.hidden = program !== null;
    ladderNote.textContent = say(this.drawn === null ? "noLadder" : "ladderOld");
    this.ladderNow();
    this.live();
  }

  /** Draws the ladder, where there is one and it is on the screen. */
  private ladderNow(): void {
    const looked = this.program.looked.value;
    const { view, chart } = byId("views").dataset;
    const isShown = view === "both" || (view === "draw" && chart !== undefined);
    if (looked?.checked.program && isShown) void this.draw(looked);
  }

  /** Gives the points of another PLC a place on this board, which can be undone. */
  private async adapt(): Promise<void> {
    const text = this.program.text.value;
    await asked(this.tools.ask("adapt", { of: text }), (adapted) => {
      // Somebody has gone on writing: it is asked for that.
      if (text !== this.program.text.value) return void this.adapt();
      if (adapted === null) return;
      this.open({ ...text, text: adapted.text });
      if (adapted.left.length > 0) note(() => say("adaptLeft", { points: adapted.left.join(", ") }));
    });
  }

  private async draw({ text }: Looked): Promise<void> {
    const width = this.ladder.columns();
    const key = `${width} ${speak.value}\n${blocks.value}\n${text.name}\n${text.text}`;
    if (key === this.drawn) return;
    this.drawn = key;
    const { svg, code } = await this.tools.ask("ladder", { of: text, width, isBlocks: blocks.value, speak: speak.value });
    // Another was asked for meanwhile.
    if (key !== this.drawn) return;
    const hides = code && this.asked !== text.name;
    this.bytes.hidden = !hides;
    byId("ladder").hidden = hides;
    this.ladder.show(svg);
    this.live();
  }

  /** What a variable or point is worth now, in words; null where that is not known. */
  value(name: string): string | null {
    const made = this.program.looked.value?.checked.program;
    const seen = this.bench.seen.value;
    if (!made || !seen || !liveOf(this.bench, this.program.text.value)) return null;
    const is = (own: string): boolean => own.toUpperCase() === name.toUpperCase();
    const point = pointsOf(made).find((point) => is(point.name) || is(point.called));
    return point ? String(point.value(seen)) : null;
  }

  /** Shows what runs, as long as it is what is shown. */
  private live(): void {
    const live = liveOf(this.bench, this.program.text.value);
    this.ladder.live(live);
    this.ladder.forced(this.bench.seen.value);
    this.editor.live(live?.lines ?? []);
  }
}
