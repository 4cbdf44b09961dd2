// The screen on which one draws a program: palette, sheet, and what goes with them.

import { dressIn } from "../../offline/beside";
import type { Act, Drawn, Place, Shelf, Text } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { say } from "../../words/draw";
import { speak, told, translate } from "../../words/words";
import { asked } from "../asked";
import type { Bench } from "../bench";
import { type ProgramDocument, stemOf } from "../document";
import { h } from "../dom";
import { force, liveOf } from "../forcing";
import { keep, kept } from "../kept";
import { entry, menu, openAt } from "../menu";
import { announce, note } from "../notes";
import { isLetter } from "../paper";
import { attend } from "../reveal";
import { ACTIONS, type Action, keyOf } from "./actions";
import { carry } from "./carrying";
import { ask } from "./form";
import { Finder } from "./find";
import { help, texts } from "./panels";
import { Nearby } from "./nearby";
import { palette } from "./palette";
import { print } from "./print";
import { Session } from "./session";
import { Sheet } from "./sheet";
import { symbols } from "./symbols";

/** What of the page the screen works with. */
export interface Around {
  readonly program: ProgramDocument;
  readonly tools: RemoteTools;
  readonly bench: Bench;
  /** Shows a text in the editor too. */
  readonly write: (text: Text) => void;
  /** Opens another program, which can be undone. */
  readonly open: (text: Text) => void;
}

const PLACES = ["behind", "beside", "before"] as const;
const PLACE_WORDS = { behind: "placeBehind", beside: "placeBeside", before: "placeBefore" } as const;
const PALETTE = "palette";

export class Screen {
  private readonly session: Session;
  private readonly sheet: Sheet;
  private readonly paper = h("div", { class: "paper", id: "sheet", tabindex: 0, role: "application", "data-say-label": "sheet" });
  private readonly over = h("div", { class: "over" });
  private readonly banner = h("div", { class: "banner", id: "draw-banner", hidden: true });
  private readonly mistakes = h("ul", { class: "mistakes", id: "mistakes", "data-say-label": "drawProblems" });
  private readonly state = h("p", { class: "note", id: "draw-state", role: "status" });
  /** Shows the palette, or folds it away. */
  private readonly drawing = h("button", { type: "button", id: "draw-palette", "data-say": "drawPalette", "aria-pressed": "false" });
  private readonly bars: readonly HTMLElement[];
  private readonly operating = h("input", { type: "checkbox", id: "operate" });
  private readonly where = h("button", { type: "button", id: "draw-where", "data-say-title": "drawWhere", click: () => this.turn() });
  private readonly finder: Finder;
  private readonly nearby: Nearby;
  private readonly menu: HTMLElement;
  private place: Place = "behind";
  private heard = "";
  /** The program that is shown, as the document counts them: a form at an element of another one is closed. */
  private of = -1;
  /** The columns that it was drawn in last. */
  private fitted = 0;

  /** Loads what the screen needs besides its code. */
  static async open(root: HTMLElement, tools: HTMLElement, around: Around): Promise<Screen> {
    await dressIn("draw.css");
    return new Screen(root, tools, around, await around.tools.ask("palette", {}));
  }

  private constructor(
    root: HTMLElement,
    bar: HTMLElement,
    private readonly around: Around,
    private readonly shelves: readonly Shelf[],
  ) {
    const { program, tools, bench, write } = around;
    this.session = new Session(program, tools, () => this.sheet.ladder.columns(), write);
    const act = (act: Act): Promise<boolean> => this.session.act(act);
    this.sheet = new Sheet(this.paper, (what, at, place) => void this.put({ do: "put", what, at, place }), () => this.fit());
    this.nearby = new Nearby(this.paper, (one) => void act(one), () => void this.edit());
    this.finder = new Finder(tools, (id) => void act({ do: "select", from: id, to: id }));
    const undo = h("button", { type: "button", id: "draw-undo", "data-say-label": "drawUndo", click: () => void act({ do: "undo" }) }, "↶");
    const redo = h("button", { type: "button", id: "draw-redo", "data-say-label": "drawRedo", click: () => void act({ do: "redo" }) }, "↷");
    const edit = this.menu = menu("drawEdit", null, () => ACTIONS.filter((action) => !action.quiet).map((action) => entry(say(action.say), () => void this.do(action), action.key)));
    const more = menu("drawMore", null, () => [
      entry(say("symbols"), () => symbols(() => this.session.drawn.value?.table ?? [], (act) => this.session.attempt(act)), "", "draw-symbols"),
      entry(say("find"), () => this.finder.open(), "", "draw-find"),
      entry(say("asText"), () => void texts(tools), "", "draw-texts"),
      entry(say("print"), () => this.print(), "", "draw-print"),
      entry(say("keys"), () => help(shelves), "", "draw-keys"),
      h("label", { class: "menu-field" }, h("span", {}, say("operate")), this.operating),
    ]);
    this.drawing.addEventListener("click", () => this.fold(this.drawing.getAttribute("aria-pressed") === "true"));
    bar.replaceChildren(this.drawing, h("div", { class: "drawing-tools" }, undo, redo, this.where, edit, more));
    this.over.append(this.paper, this.sheet.ladder.zoomButtons());
    root.replaceChildren(this.finder.bar, this.banner,
      h("div", { class: "draw-body" }, palette(shelves, { insert: (what) => void this.insert(what, this.place), carried: this.sheet }), this.over),
      h("div", { class: "draw-foot" }, this.state, this.mistakes));
    this.bars = [root, bar];
    this.fold(kept(PALETTE) !== "open");
    new ResizeObserver(() => this.fit()).observe(this.paper);
    this.touch();
    this.paper.addEventListener("keydown", (event) => this.key(event));
    this.session.drawn.follow((drawn) => {
      if (this.of !== program.opened) this.over.querySelector<HTMLElement>("#form-cancel")?.click();
      this.of = program.opened;
      undo.disabled = !drawn || drawn.undo === 0;
      redo.disabled = !drawn || drawn.redo === 0;
      if (drawn) this.show(drawn);
      else this.blank();
      this.fit();
      this.bar();
    });
    this.session.closed.follow((closed) => {
      this.bar();
      const drawn = this.session.drawn.value;
      if (closed) this.nearby.clear();
      else if (drawn) this.nearby.show(drawn);
    });
    program.text.follow(() => this.bar());
    bench.seen.follow(() => this.live());
    program.text.follow(() => this.live());
    speak.follow(() => {
      this.bars.forEach(translate);
      this.turnTo(this.place);
      this.bar();
    });
  }

  /** It is on the screen, or no longer. */
  show(visible: boolean | Drawn): void {
    if (typeof visible === "boolean") return this.session.show(visible);
    const drawn = visible;
    this.sheet.show(drawn);
    if (this.session.closed.value) this.nearby.clear();
    else this.nearby.show(drawn);
    const errors = drawn.mistakes.filter((mistake) => mistake.error).length;
    this.state.textContent = errors > 0 ? say("unfinished", { n: errors }) : drawn.text ? say("finished") : "";
    this.mistakes.replaceChildren(...drawn.mistakes.slice(0, 20).map(({ at, rung, error, message }) => {
      const text = rung > 0 ? `${say("inRung", { rung })}: ${told(message)}` : told(message);
      const go = (): void => void (at !== null && this.session.act({ do: "select", from: at, to: at }).then(() => attend(this.paper)));
      return h("li", {}, h("button", { type: "button", class: error ? "error" : "warning", click: go }, text));
    }));
    this.hear(drawn);
    this.live();
  }

  /** Nothing can be drawn: the program has errors. */
  private blank(): void {
    this.sheet.clear();
    this.nearby.clear();
    this.state.textContent = "";
    this.mistakes.replaceChildren();
  }

  /** A screen reader says what the cursor is at, and what is wrong there. */
  private hear(drawn: Drawn): void {
    const wrong = drawn.mistakes.filter((mistake) => mistake.at === drawn.cursor[0]).map((mistake) => told(mistake.message));
    const text = [told(drawn.at.say), ...wrong].join(". ");
    if (text !== this.heard) announce(text);
    this.heard = text;
  }

  private live(): void {
    const { ladder } = this.sheet;
    // The nets are those of the program only where the drawing is one.
    const is = this.session.drawn.value?.isProgram === true && this.session.drawn.value.text === this.around.program.text.value.text;
    ladder.live(is ? liveOf(this.around.bench, this.around.program.text.value) : null);
    ladder.forced(this.around.bench.seen.value);
  }

  /** Has it drawn as wide as there is room now. */
  private fit(): void {
    this.nearby.place();
    const columns = this.sheet.ladder.columns();
    if (columns === this.fitted || this.paper.clientWidth === 0 || !this.session.drawn.value) return;
    this.fitted = columns;
    void this.session.again();
  }

  /** What keeps one from drawing, and what one can do about it. */
  private bar(): void {
    const closed = this.session.closed.value;
    this.banner.hidden = closed === null;
    const { program, tools, open } = this.around;
    const stem = stemOf(program.text.value.name);
    const copy = async (name: string): Promise<void> => open({ name, text: await tools.ask("drawn", { as: "il" }) });
    if (closed === "readOnly") this.banner.replaceChildren(say("readOnly"), h("button", { type: "button", id: "draw-copy", click: () => void copy(`${stem}.il`) }, say("drawCopy")));
    const loses = this.session.drawn.value?.loses;
    if (closed === "loses" && loses) this.banner.replaceChildren(`${told(loses)}. `,
      h("button", { type: "button", id: "draw-copy", click: () => void copy(`${stem}-${say("copyName")}.il`) }, say("drawCopy")),
      h("button", { type: "button", id: "draw-agree", click: () => this.session.agree() }, say("drawHere")));
    if (closed === "faulty") this.banner.replaceChildren(say("faulty"), h("button", { type: "button", id: "draw-empty", click: () => open({ name: `${stem}.il`, text: "" }) }, say("drawEmpty")));
  }

  /** Somebody wants to draw. */
  begin(): void {
    this.fold(false);
    this.paper.focus();
  }

  private fold(folds: boolean): void {
    this.drawing.setAttribute("aria-pressed", String(!folds));
    for (const bar of this.bars) bar.classList.toggle("folded", folds);
    this.nearby.place();
    keep(PALETTE, folds ? "folded" : "open");
  }

  private turn(): void {
    this.turnTo(PLACES[(PLACES.indexOf(this.place) + 1) % PLACES.length] ?? "behind");
    announce(say(PLACE_WORDS[this.place]));
  }

  private turnTo(place: Place): void {
    this.place = place;
    this.where.textContent = `↳ ${say(PLACE_WORDS[place])}`;
  }

  private async insert(what: string, place: Place): Promise<void> {
    await this.put({ do: "insert", what, place });
  }

  /** Inserts something, and asks at once for what it lacks. */
  private async put(act: Act): Promise<void> {
    if (await this.session.act(act)) await this.edit();
    else attend(this.paper);
  }

  private async edit(comment = false): Promise<void> {
    const drawn = this.session.drawn.value;
    if (!drawn || this.session.closed.value || this.session.isOther) return;
    const asked: Drawn = comment ? { ...drawn, at: { ...drawn.at, what: "rung", fields: [] } } : drawn;
    if (asked.at.what === "rung" || (asked.at.what === "element" && asked.at.fields.length > 0)) {
      await ask(this.over, asked, this.sheet.box(drawn.cursor[0]), (act) => this.session.attempt(act));
    }
    attend(this.paper);
  }

  private async do({ act }: Action): Promise<void> {
    switch (act) {
      case "edit": return this.edit();
      case "comment": return this.edit(true);
      case "where": return this.turn();
      case "help": return help(this.shelves);
      case "find": return this.finder.open();
      case "paste":
        await this.session.act({ do: "paste", place: this.place });
        return attend(this.paper);
      case "rung": {
        const rung = this.paper.querySelector<SVGElement>(`.rung[data-rung="${this.session.drawn.value?.at.rung}"]`);
        const id = Number(rung?.dataset["id"]);
        if (rung && (await this.session.act({ do: "select", from: id, to: id }))) await this.session.act({ do: "delete" });
        return attend(this.paper);
      }
      default:
        await this.session.act(act);
        attend(this.paper);
    }
  }

  private key(event: KeyboardEvent): void {
    const key = keyOf(event) === "Backspace" ? "Delete" : keyOf(event);
    const action = ACTIONS.find((action) => action.key === key);
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    const letter = event.key.toLowerCase();
    const item = plain ? this.shelves.flatMap((shelf) => shelf.items).find((item) => item.key !== "" && item.key === letter) : undefined;
    if (action) void this.do(action);
    else if (item) void this.insert(item.id, event.shiftKey && /[a-z]/.test(letter) ? "beside" : this.place);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Mouse, pen and finger on the sheet. */
  private touch(): void {
    const id = (event: Event): number => {
      const target = event.target as Element;
      const one = target.closest<SVGElement>(".element") ?? target.closest<SVGElement>(".rung");
      return Number(one?.dataset["id"] ?? 0);
    };
    const point = (event: Event): string | undefined => (event.target as Element).closest<SVGElement>(".element")?.dataset["point"];
    let held = 0;
    // What is selected is carried; a finger that is elsewhere scrolls.
    const face = (event: PointerEvent): string | null => {
      held = id(event);
      const element = (event.target as Element).closest(".element");
      const may = element !== null && !this.operating.checked && (event.pointerType !== "touch" || element.classList.contains("selected"));
      return may ? (element.querySelector("text")?.textContent ?? "•") : null;
    };
    const click = (event: PointerEvent): void => {
      const named = point(event);
      if (named && (this.operating.checked || event.altKey)) return force(this.around.bench, named);
      const at = id(event);
      const from = event.shiftKey ? (this.session.drawn.value?.cursor[0] ?? at) : at;
      if (at) void this.session.act({ do: "select", from, to: at });
      this.paper.focus({ preventScroll: true });
    };
    const drop = async (at: number, place: Place): Promise<void> => {
      const selected = this.session.drawn.value?.selected ?? [];
      if (!selected.includes(held)) await this.session.act({ do: "select", from: held, to: held });
      await this.session.act({ do: "carry", at, place });
      attend(this.paper);
    };
    carry(this.paper, face, { click, drop: (at, place) => void drop(at, place) }, this.sheet);
    this.paper.addEventListener("dblclick", () => void this.session.settled().then(() => this.edit()));
    this.paper.addEventListener("contextmenu", (event) => {
      event.preventDefault();
      const { clientX: x, clientY: y } = event;
      // A finger that was held has selected nothing yet.
      const at = id(event);
      const opens = (): void => openAt(this.menu, { x, y });
      if (at && !this.paper.querySelector(`.selected[data-id="${at}"]`)) void this.session.act({ do: "select", from: at, to: at }).then(opens);
      else opens();
    });
  }

  private print(): void {
    const { drawn } = this.session;
    const errors = drawn.value?.mistakes.filter((mistake) => mistake.error).length ?? 0;
    if (drawn.value?.text === null) return note(() => say("unfinished", { n: errors }));
    const shown = { of: this.around.program.text.value, width: 80, speak: speak.value };
    void asked(this.around.tools.ask("pages", { ...shown, letter: isLetter() }), print);
  }
}
