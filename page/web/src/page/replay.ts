// What went wrong with a machine, seen again: its pictures from two seconds before, and beneath them the timing diagram.

import type { Ask, Both, Replayed } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say } from "../words/learn";
import { say as sayCommon, speak, told } from "../words/words";
import { h } from "./dom";
import { icon } from "./icons";
import { note } from "./notes";
import { reveal } from "./reveal";
import { Scene } from "./scene";
import { seconds } from "./seconds";

/** Which program, which machine, and what went wrong when. */
export interface Wanted extends Omit<Ask<"replay">, "speak" | "why"> {
  readonly why: Both;
}

export class Replay {
  readonly element = h("figure", { class: "replay", id: "replay" });
  private readonly scene = new Scene("replay-picture");
  private readonly diagram = h("div", { class: "diagram", tabindex: 0, role: "group" });
  private readonly time = h("input", {
    type: "range",
    id: "replay-time",
    min: 0,
    value: 0,
    input: () => this.seek(Number(this.time.value)),
    // Home at the first picture changes no value, but whoever presses it wants to see that picture.
    keydown: (event) => {
      if ((event as KeyboardEvent).key !== "Tab") this.began = null;
    },
  });
  private readonly clock = h("output");
  private got: Replayed | null = null;
  /** The picture that is shown. */
  private at = 0;
  /** When the first picture was shown, by the page's clock; null: it stands. */
  private began: number | null = null;

  constructor(
    private readonly tools: RemoteTools,
    private readonly wanted: Wanted,
  ) {}

  /** Has it in the language of now, and plays it once unless a person wants no motion. */
  async load(plays: boolean): Promise<void> {
    const { why, ...rest } = this.wanted;
    try {
      this.got = await this.tools.ask("replay", { ...rest, why: told(why), speak: speak.value });
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => told(error.both));
      return;
    }
    const { svg, diagram, frames } = this.got;
    this.scene.show(svg, told(why)).setAttribute("role", "img");
    // Drawn by our own Rust, which escapes every text in it.
    this.diagram.innerHTML = diagram;
    this.diagram.setAttribute("aria-label", sayCommon("tabTrend"));
    this.time.max = String(frames.length);
    this.time.setAttribute("aria-label", say("replayTime"));
    const play = h("button", { type: "button", class: "small", id: "replay-play", click: () => this.play() }, icon("play"), h("span", {}, say("replayPlay")));
    this.element.replaceChildren(h("figcaption", {}, say("replayOf")), this.scene.root, h("div", { class: "row" }, play, this.time, this.clock), this.diagram);
    this.at = 0;
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (plays && !still) this.play();
    else this.seek(this.broken);
    // Nobody has to look for it.
    if (plays) reveal(this.element);
  }

  /** The picture at which it went wrong. */
  private get broken(): number {
    return this.got ? Math.floor((this.got.at - this.got.from) / this.got.every) : 0;
  }

  private play(): void {
    const goes = this.began !== null;
    this.seek(0);
    this.began = performance.now();
    if (!goes) requestAnimationFrame(() => this.turn());
  }

  private turn(): void {
    const { got, began } = this;
    if (!got || began === null || !this.element.isConnected) {
      this.began = null;
      return;
    }
    const frame = Math.floor((performance.now() - began) / got.every);
    this.show(frame);
    if (frame < got.frames.length) requestAnimationFrame(() => this.turn());
    else this.began = null;
  }

  private seek(frame: number): void {
    this.began = null;
    this.show(frame);
  }

  private show(frame: number): void {
    const { got } = this;
    if (!got) return;
    const to = Math.min(frame, got.frames.length);
    if (to < this.at) {
      this.scene.show(got.svg, told(this.wanted.why)).setAttribute("role", "img");
      this.at = 0;
    }
    for (; this.at < to; this.at++) this.scene.apply(got.frames[this.at] ?? []);
    const share = got.frames.length > 0 ? to / got.frames.length : 0;
    this.time.value = String(to);
    this.clock.textContent = `${seconds(got.from + to * got.every, 2)} s`;
    this.diagram.querySelector(".cursor")?.setAttribute("transform", `translate(${got.plot[1] * share} 0)`);
  }
}
