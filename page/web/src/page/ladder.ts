// The ladder: drawn once for each program, then only classes and short texts change. What a rung names, its nets and its
// steps, counts from the rung's own first: a rung that is moved stays as it is.

import type { Drawn, Live, Seen } from "../tools/answers";
import { dress, h, put } from "./dom";
import { keep, kept } from "./kept";
import { decimal } from "./numbers";
import { holds } from "./look";
import { forcedNames } from "./points";

/** CSS pixels beside the drawing. */
const MARGIN = 14;
/** Units of the drawing: a column, and what is beside them all. */
const [COLUMN, BESIDE] = [9, 48];
/** Columns that a drawing may have: a wider one is made larger, a narrower one is scrolled. */
const [NARROWEST, WIDEST] = [44, 180];
/** A drawing that fits nearly as it is, is not scaled: its lines cover whole pixels. */
const NEARLY = 0.04;
/** Between these the drawing is made to fit, until somebody chooses. */
const FITS = [0.6, 1.3] as const;
const ZOOMS = [0.6, 0.7, 0.8, 0.9, 1, 1.15, 1.3, 1.5, 1.8];

/** Who hears of clicks on the drawing. */
export interface Touched {
  /** The heading of a rung: its first line in the text. */
  line(line: number): void;
  /** A symbol that reads or writes this point. */
  point(point: string, at: DOMRect): void;
  /** There is room for another number of columns. */
  room(): void;
}

/** What is live in a rung. */
interface Named {
  readonly nets: readonly (readonly [net: number, Element])[];
  readonly boxes: readonly (readonly [step: number, Box])[];
  readonly values: readonly (readonly [step: number, Element])[];
  readonly points: readonly (readonly [point: string, Element])[];
  /** What shows points, whatever the power is: of a block diagram. */
  readonly seen: readonly (readonly [says: string, Element])[];
}

/** What stands beside the pins of a timer or a counter. */
interface Box {
  readonly preset: Element;
  readonly count: Element;
}

type Sheet = NonNullable<Drawn["sheet"]>;

const SVG = "http://www.w3.org/2000/svg";

export class LadderView {
  private readonly named = new WeakMap<Element, Named>();
  private readonly nets = new Map<number, Element[]>();
  private readonly boxes = new Map<number, Box>();
  private readonly values = new Map<number, Element>();
  private readonly points = new Map<string, Element[]>();
  private readonly says = new Map<string, Element[]>();
  private lit = new Set<number>();
  private svg: SVGSVGElement | null = null;
  private zoom = Number(kept("zoom") ?? "0") || FITS[1];
  private fits = kept("zoom") === null;
  /** The columns that there was room for last. */
  private room = 0;

  constructor(
    private readonly paper: HTMLElement,
    private readonly touched: Touched,
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
    this.find();
  }

  /** Shows a drawing that is edited: of a rung that is as it was only the place changes. */
  change({ width, height, rungs }: Sheet): void {
    const svg = this.svg ?? this.begin();
    dress(svg, { viewBox: `0 0 ${width} ${height}` });
    const all = svg.firstElementChild as SVGGElement;
    const were = new Map(this.rungs().map((rung) => [Number(rung.dataset["id"]), rung]));
    rungs.forEach(({ id, top, nets, first, drawn }, index) => {
      const rung = drawn ? made(drawn.svg) : were.get(id);
      if (!rung) return;
      if (drawn) were.get(id)?.remove();
      dress(rung, { "data-rung": index + 1, "data-nets": nets, "data-first": first, transform: `translate(0 ${top})` });
      const there = all.children[index];
      if (there !== rung) all.insertBefore(rung, there ?? null);
    });
    while (all.children.length > rungs.length) all.lastElementChild?.remove();
    this.find();
  }

  /** An empty drawing. */
  private begin(): SVGSVGElement {
    const svg = document.createElementNS(SVG, "svg");
    dress(svg, { class: "ladder", role: "img" });
    svg.append(document.createElementNS(SVG, "g"));
    this.paper.replaceChildren(svg);
    this.svg = svg;
    return svg;
  }

  private rungs(): SVGGElement[] {
    return [...this.paper.querySelectorAll<SVGGElement>(".rung")];
  }

  /** Finds what is live in all of it. */
  private find(): void {
    for (const net of this.lit) this.light(net, false);
    this.lit = new Set();
    for (const map of [this.nets, this.boxes, this.values, this.points, this.says]) map.clear();
    for (const rung of this.rungs()) {
      const [before, first] = [Number(rung.dataset["nets"]), Number(rung.dataset["first"])];
      const { nets, boxes, values, points, seen } = this.namedIn(rung);
      // The left rail is the same net in all of them.
      for (const [net, one] of nets) this.add(this.nets, net === 0 ? 0 : before + net, one);
      for (const [step, box] of boxes) this.boxes.set(first + step, box);
      for (const [step, value] of values) this.values.set(first + step, value);
      for (const [point, one] of points) this.add(this.points, point, one);
      for (const [says, one] of seen) this.add(this.says, says, one);
    }
    this.size();
  }

  private namedIn(rung: SVGGElement): Named {
    const known = this.named.get(rung);
    if (known) return known;
    const nets: [number, Element][] = [];
    const boxes: [number, Box][] = [];
    const values: [number, Element][] = [];
    const points: [string, Element][] = [];
    const seen: [string, Element][] = [];
    for (const one of rung.querySelectorAll<SVGElement>(".wire, .rail, .element")) {
      const net = /\bn(\d+)\b/.exec(one.getAttribute("class") ?? "");
      const says = one.dataset["says"];
      if (says) seen.push([says, one]);
      else if (net) nets.push([Number(net[1]), one]);
    }
    for (const element of rung.querySelectorAll<SVGElement>(".element")) {
      const last = Number(element.dataset["steps"]?.split(" ").at(-1));
      const [preset, count] = [element.querySelector(".preset"), element.querySelector(".count")];
      const value = element.querySelector(".value");
      if (preset && count) boxes.push([last, { preset, count }]);
      if (value) values.push([last, value]);
      const point = element.dataset["point"];
      if (point) points.push([point, element]);
    }
    const named = { nets, boxes, values, points, seen };
    this.named.set(rung, named);
    return named;
  }

  private add<K>(map: Map<K, Element[]>, key: K, element: Element): void {
    const there = map.get(key);
    if (there) there.push(element);
    else map.set(key, [element]);
  }

  /** The columns of a drawing that fills its paper, as large as letters are elsewhere, or as somebody has chosen. */
  columns(): number {
    const zoom = this.fits ? 1 : this.zoom;
    const columns = Math.floor(((this.paper.clientWidth - MARGIN) / zoom - BESIDE) / COLUMN);
    return Math.min(Math.max(columns, NARROWEST), WIDEST);
  }

  private size(): void {
    if (this.paper.clientWidth > 0 && this.room !== this.columns()) {
      this.room = this.columns();
      this.touched.room();
    }
    const box = this.svg?.viewBox.baseVal;
    if (!this.svg || !box) return;
    if (this.fits && this.paper.clientWidth > 0) {
      const zoom = (this.paper.clientWidth - MARGIN) / box.width;
      this.zoom = Math.abs(zoom - 1) < NEARLY ? 1 : Math.min(Math.max(zoom, FITS[0]), FITS[1]);
    }
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
    for (const [step, preset, count] of live.boxes) {
      put(this.boxes.get(step)?.preset, preset);
      put(this.boxes.get(step)?.count, count);
    }
    for (const [step, value] of live.values) put(this.values.get(step), value === null ? "–" : decimal(value));
  }

  /** Marks what is forced, and what points show by themselves. */
  forced(seen: Seen | null): void {
    const forced = new Set(seen ? forcedNames(seen) : []);
    for (const [point, elements] of this.points) {
      for (const element of elements) element.classList.toggle("forced", forced.has(point));
    }
    for (const [says, elements] of this.says) {
      const on = seen !== null && holds(says, seen);
      for (const element of elements) element.classList.toggle("on", on);
    }
  }

  private light(net: number, on: boolean): void {
    for (const element of this.nets.get(net) ?? []) element.classList.toggle("on", on);
  }
}

/** A rung that Rust has drawn. */
function made(svg: string): SVGGElement {
  const around = document.createElementNS(SVG, "g");
  around.innerHTML = svg;
  return around.firstElementChild as SVGGElement;
}
