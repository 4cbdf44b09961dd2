// Panels: what is on them, moving, and what may be set there.

import { h } from "../page/dom";
import { announce, note } from "../page/notes";
import { decimal } from "../page/numbers";
import { say } from "../words/site";
import { speak } from "../words/words";
import { type Item, No, type Panel, ask, whyOf } from "./ask";
import { Chart } from "./chart";
import { drawing, move } from "./drawing";
import type { State } from "./state";
import { labelOf, refused, value } from "./told";
import { past } from "./trends";

const HOUR = 3_600_000;
/** From one picture of a trend to the next, ms. */
const EVERY = 5000;
/** How often the gateway hears that a button is pressed still, ms: it lets go after three times as long. */
const BEAT = 1000;

type Value = number | null | undefined;

export class Panels {
  readonly root = h("div");
  private readonly bar = h("div", { class: "bar" });
  private readonly sheet = h("div");
  private name = "";
  /** Has what stands on the panel show what the points are. */
  private moves: (() => void)[] = [];
  private trends: (() => void)[] = [];
  /** Lets go of what is pressed. */
  private releases: ((atOnce: boolean) => void)[] = [];

  constructor(private readonly state: State) {
    this.root.append(this.bar, this.sheet);
    state.panels.follow(() => this.build());
    speak.follow(() => this.build());
    state.boards.follow(() => this.move());
    addEventListener("pagehide", () => this.release(true));
    setInterval(() => {
      if (!this.root.hidden && document.visibilityState === "visible") for (const trend of this.trends) trend();
    }, EVERY);
  }

  shown(rest = ""): void {
    if (rest) this.name = rest;
    this.build();
  }

  private get panel(): Panel | undefined {
    const panels = this.state.panels.value;
    return panels.find((panel) => panel.name === this.name) ?? panels[0];
  }

  private build(): void {
    this.release();
    if (this.root.hidden) return;
    const { panel } = this;
    this.releases = [];
    this.moves = [];
    this.trends = [];
    if (!panel) return;
    const list = h("select", { id: "panel-choose", "aria-label": say("panelChoose"), change: () => { location.hash = `panels/${list.value}`; } },
      ...this.state.panels.value.map((one) => h("option", { value: one.name, selected: one === panel }, one.title[speak.value])));
    this.bar.replaceChildren(list, h("span", { class: "grow" }), h("button", { type: "button", id: "panel-edit", click: () => void this.edit(panel) }, say("panelEdit")));
    this.sheet.replaceChildren(...(panel.made ? [h("p", { class: "note" }, say("panelMade"))] : []), ...this.drawn(panel), this.grid(panel));
    this.move();
  }

  private release(atOnce = false): void {
    for (const release of this.releases) release(atOnce);
  }

  private async edit(panel: Panel): Promise<void> {
    this.release();
    const { edit } = await import("./edit");
    this.bar.replaceChildren();
    this.moves = [];
    this.trends = [];
    this.sheet.replaceChildren(await edit(panel, (drawn) => this.grid(drawn), () => this.build()));
  }

  private drawn(panel: Panel): SVGSVGElement[] {
    const svg = panel.drawing === undefined ? null : drawing(panel.drawing, panel.title[speak.value]);
    if (!svg) return [];
    this.moves.push(() => {
      for (const bind of panel.binds) move(svg, bind, this.state.valueOf(bind.board, bind.point));
    });
    return [svg];
  }

  private grid(panel: Panel): HTMLElement {
    const grid = h("div", { class: "panel-grid" }, ...panel.items.map((item) => this.item(item)));
    grid.style.setProperty("--columns", String(panel.columns));
    return grid;
  }

  private item(item: Item): HTMLElement {
    const [wide, tall] = item.size;
    const body = this.body(item);
    // A button has its label on itself.
    const title = item.show === "button" ? null : h("span", { class: "item-label" }, labelOf(item));
    const card = h("div", { class: "card item", "data-show": item.show, "data-point": `${item.board}.${item.point}` }, title, body);
    card.style.setProperty("--place", item.at ? `${item.at[1]} / ${item.at[0]} / span ${tall} / span ${wide}` : `auto / auto / span ${tall} / span ${wide}`);
    this.moves.push(() => card.classList.toggle("unknown", this.of(item) === null || this.of(item) === undefined));
    return card;
  }

  private of(item: Item): Value {
    return this.state.valueOf(item.board, item.point);
  }

  private body(item: Item): HTMLElement {
    switch (item.show) {
      case "lamp": return this.lamp(item);
      case "value": return this.number(item);
      case "bar": return this.bars(item);
      case "trend": return this.trend(item);
      case "button": return this.button(item);
      case "switch": return this.turn(item);
      case "set": return this.set(item);
    }
  }

  private lamp(item: Item): HTMLElement {
    const text = h("span");
    const lamp = h("span", { class: "lamp" }, text);
    this.moves.push(() => {
      const of = this.of(item);
      lamp.dataset["on"] = String(of !== 0 && of !== null && of !== undefined);
      text.textContent = of === null || of === undefined ? value(of) : say(of === 0 ? "isOff" : "isOn");
    });
    return lamp;
  }

  private number(item: Item): HTMLElement {
    const number = h("span", { class: "number" });
    this.moves.push(() => {
      number.textContent = value(this.of(item), item.unit);
    });
    return number;
  }

  private bars(item: Item): HTMLElement {
    const number = this.number(item);
    const bar = h("span", { class: "meter", role: "meter", "aria-label": labelOf(item), "aria-valuemin": item.least, "aria-valuemax": item.most, "aria-valuenow": item.least }, h("span"));
    this.moves.push(() => {
      const of = this.of(item) ?? item.least;
      const share = Math.min(Math.max((of - item.least) / (item.most - item.least), 0), 1);
      bar.style.setProperty("--share", String(share));
      bar.setAttribute("aria-valuenow", String(Math.min(Math.max(of, item.least), item.most)));
      bar.setAttribute("aria-valuetext", value(this.of(item), item.unit));
    });
    return h("span", { class: "bar-of" }, number, bar);
  }

  private trend(item: Item): HTMLElement {
    const place = h("div", { class: "item-trend" });
    const chart = new Chart(place, undefined, 96 * item.size[1] - 30);
    const draw = async (): Promise<void> => {
      const to = Date.now();
      try {
        await chart.draw([{ label: labelOf(item), rows: await past(item, to - HOUR, to) }], to - HOUR, to, labelOf(item));
      } catch (error) {
        if (!(error instanceof No)) throw error;
        if (error.why === "no history") chart.clear(h("p", { class: "note" }, say("trendNone")));
      }
    };
    this.trends.push(() => void draw());
    void draw();
    return place;
  }

  /** Writes 1 while it is pressed; it is let go however the pointer, the key, the panel or the page leaves it. Of a page that
   *  is gone the gateway hears no more, and lets go itself. */
  private button(item: Item): HTMLElement {
    let press: Promise<boolean> | null = null;
    let beat = 0;
    const begin = (): void => {
      if (press || button.disabled) return;
      press = this.write(item, 1, "begin");
      button.classList.add("pressed");
      // One after the other, so that none comes after the button is let go.
      let waits = false;
      beat = window.setInterval(() => {
        if (!press || waits) return;
        waits = true;
        press = press.then(async (taken) => {
          const held = taken && (await this.still(item));
          waits = false;
          return held;
        });
      }, BEAT);
    };
    const end = (atOnce = false): void => {
      const before = press;
      if (!before) return;
      press = null;
      window.clearInterval(beat);
      button.classList.remove("pressed");
      const release = (): void => void this.write(item, 0, undefined, true);
      // Two requests may overtake each other: the second waits for the first, unless the page goes.
      if (atOnce) release();
      else void before.then(release);
    };
    const leave = (): void => end();
    const button = h("button", {
      type: "button", class: "push", pointerdown: begin, pointerup: leave, pointerleave: leave, pointercancel: leave, blur: leave,
      keydown: (event) => { if (["Enter", " "].includes((event as KeyboardEvent).key)) begin(); }, keyup: leave,
    }, labelOf(item));
    this.releases.push(end);
    this.moves.push(() => {
      button.disabled = !this.state.operates;
      button.dataset["on"] = String(this.of(item) === 1);
    });
    return button;
  }

  private turn(item: Item): HTMLElement {
    const button = h("button", { type: "button", role: "switch", "aria-label": labelOf(item), "aria-checked": "false", click: () => void this.write(item, this.of(item) === 1 ? 0 : 1) });
    this.moves.push(() => {
      const of = this.of(item);
      button.disabled = !this.state.operates || of === null || of === undefined;
      button.setAttribute("aria-checked", String(of === 1));
      button.textContent = of === null || of === undefined ? value(of) : say(of === 1 ? "isOn" : "isOff");
    });
    return button;
  }

  private set(item: Item): HTMLElement {
    const limits = { least: decimal(item.least), most: decimal(item.most) };
    const input = h("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": `${labelOf(item)}: ${say("panelLimits", limits)}`, placeholder: say("panelLimits", limits) });
    const button = h("button", { type: "submit", "aria-label": `${say("panelSet")}: ${labelOf(item)}` }, say("panelSet"));
    const form = h("form", {
      class: "set",
      submit: (event) => {
        event.preventDefault();
        const number = Number(input.value.trim().replace(",", "."));
        if (input.value.trim() === "" || !(number >= item.least && number <= item.most)) return note(() => say("panelOutside", limits));
        void this.write(item, number).then((taken) => {
          if (taken) input.value = "";
        });
      },
    }, input, button);
    this.moves.push(() => {
      input.disabled = button.disabled = !this.state.operates;
    });
    return h("span", { class: "set-of" }, this.number(item), form);
  }

  /** Writes a value; says whether the board has taken it. */
  private async write(item: Item, number: number, hold?: "begin", keepalive = false): Promise<boolean> {
    try {
      await ask("api/write", { board: item.board, point: item.point, value: number, ...(hold ? { hold } : {}) }, keepalive);
      await this.state.now();
      announce(say("panelTaken", { point: labelOf(item), value: decimal(number) }));
      return true;
    } catch (error) {
      refused(whyOf(error));
      return false;
    }
  }

  /** Says that a button is pressed still; false once the gateway has let it go. */
  private async still({ board, point }: Item): Promise<boolean> {
    try {
      await ask("api/write", { board, point, value: 1, hold: "still" });
      return true;
    } catch (error) {
      // What is lost on the way may be heard the next time.
      return whyOf(error) !== "not held";
    }
  }

  private move(): void {
    for (const move of this.moves) move();
  }
}
