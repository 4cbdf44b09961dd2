// The ladder: drawn once for each program, then only classes and short texts change.

import type { Live, Seen } from "../tools/answers";
import { dress, h, put } from "./dom";
import { keep, kept } from "./kept";
import { decimal } from "./numbers";
import { forcedNames } from "./points";

/** CSS pixels beside the drawing. */
const MARGIN = 14;
/** Between these the drawing is made to fit, until somebody chooses. */
const FITS = [0.6, 1.3] as const;
const ZOOMS = [0.6, 0.7, 0.8, 0.9, 1, 1.15, 1.3, 1.5, 1.8];

/** Who hears of clicks on the drawing. */
export interface Touched {
  /** The heading of a rung: its first line in the text. */
  line(line: number): void;
  /** A symbol that reads or writes this point. */
  point(point: string, at: DOMRect): void;
}

export class LadderView {
  private readonly nets = new Map<number, Element[]>();
  private readonly boxes = new Map<number, Element>();
  private readonly values = new Map<number, Element>();
  private readonly points = new Map<string, Element[]>();
  private lit = new Set<number>();
  private svg: SVGSVGElement | null = null;
  private zoom = Number(kept("zoom") ?? "0") || FITS[1];
  private fits = kept("zoom") === null;

  constructor(
    private readonly paper: HTMLElement,
    touched: Touched,
  ) {
    new ResizeObserver(() => this.size()).observe(paper);
    paper.addEventListener("click", (event) => {
      const target = event.target as Element;
      const rung = target.closest<SVGElement>(".rung");
      const element = target.closest<SVGElement>(".element");
      if (element?.dataset["point"]) touched.point(element.dataset["point"], element.getBoundingClientRect());
      else if (target.matches(".heading") && rung?.dataset["lines"]) touched.line(Number.parseInt(rung.dataset["lines"], 10));
    });
  }

  /** The buttons that make it larger and smaller. */
  zoomButtons(): HTMLElement {
    const turn = (by: number) => (): void => {
      const at = ZOOMS.findIndex((zoom) => zoom >= this.zoom - 0.01);
      this.zoom = ZOOMS[Math.min(Math.max(at + by, 0), ZOOMS.length - 1)] ?? 1;
      this.fits = false;
      keep("zoom", String(this.zoom));
      this.size();
    };
    return h("div", { class: "zoom" },
      h("button", { type: "button", "data-say-label": "zoomOut", click: turn(-1) }, "−"),
      h("button", { type: "button", "data-say-label": "zoomIn", click: turn(1) }, "+"));
  }

  /** Shows a drawing that Rust has made. */
  show(svg: string): void {
    const { scrollTop, scrollLeft } = this.paper;
    this.paper.innerHTML = svg;
    this.paper.scrollTo(scrollLeft, scrollTop);
    this.svg = this.paper.querySelector("svg");
    this.lit = new Set();
    for (const map of [this.nets, this.boxes, this.values, this.points]) map.clear();
    for (const one of this.paper.querySelectorAll<SVGElement>(".wire, .element")) {
      const net = /\bn(\d+)\b/.exec(one.getAttribute("class") ?? "");
      if (net) this.add(this.nets, Number(net[1]), one);
    }
    for (const element of this.paper.querySelectorAll<SVGElement>(".element")) {
      const last = Number(element.dataset["steps"]?.split(" ").at(-1));
      const box = element.querySelector(".boxed");
      const value = element.querySelector(".value");
      if (box) this.boxes.set(last, box);
      if (value) this.values.set(last, value);
      const point = element.dataset["point"];
      if (point) this.add(this.points, point, element);
    }
    this.size();
  }

  private add<K>(map: Map<K, Element[]>, key: K, element: Element): void {
    const there = map.get(key);
    if (there) there.push(element);
    else map.set(key, [element]);
  }

  private size(): void {
    const box = this.svg?.viewBox.baseVal;
    if (!this.svg || !box) return;
    if (this.fits && this.paper.clientWidth > 0) this.zoom = Math.min(Math.max((this.paper.clientWidth - MARGIN) / box.width, FITS[0]), FITS[1]);
    dress(this.svg, { width: Math.round(box.width * this.zoom), height: Math.round(box.height * this.zoom) });
  }

  /** Shows what runs; without it the ladder is a plain drawing. */
  live(live: Live | null): void {
    this.svg?.classList.toggle("live", live !== null);
    const on = new Set(live?.nets ?? []);
    for (const net of this.lit) if (!on.has(net)) this.light(net, false);
    for (const net of on) if (!this.lit.has(net)) this.light(net, true);
    this.lit = on;
    if (!live) return;
    for (const [step, text] of live.boxes) put(this.boxes.get(step), text);
    for (const [step, value] of live.values) put(this.values.get(step), value === null ? "–" : decimal(value));
  }

  /** Marks what is forced. */
  forced(seen: Seen | null): void {
    const forced = new Set(seen ? forcedNames(seen) : []);
    for (const [point, elements] of this.points) {
      for (const element of elements) element.classList.toggle("forced", forced.has(point));
    }
  }

  private light(net: number, on: boolean): void {
    for (const element of this.nets.get(net) ?? []) element.classList.toggle("on", on);
  }
}
