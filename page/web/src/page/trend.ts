// The timing diagram: a lane for each channel.

import type uPlot from "uplot";
import type { Seen } from "../tools/answers";
import { say, speak } from "../words/words";
import type { Bench } from "./bench";
import { h } from "./dom";
import { download } from "./files";
import { Moments } from "./moments";
import { announce } from "./notes";
import { decimal, fixed } from "./numbers";
import { type Point, forcedNames, forcedTo, upTo } from "./points";
import { Recorder } from "./recorder";
import { timingSvg } from "./timing";

const SPANS = [2, 5, 10, 30, 120];
/** What is shown at least, ms. */
const LEAST = 1;
/** Height of a lane, CSS pixels. */
const LANE = 30;
/** More channels than this are not all shown at first. */
const MANY = 8;
/** From one picture to the next at least, ms: each is drawn whole, and a slow computer has a board to simulate. */
const PICTURE = 50;

export class Trend {
  readonly panel = h("div");
  readonly recorder = new Recorder();
  private readonly moments = new Moments();
  /** A reading of the simulated board, and its time: what pins have done until then comes behind it. */
  private held: { readonly seen: Seen; readonly at: number } | null = null;
  /** The pins of the inputs, bit 0 input 01, and what the inputs are forced to. */
  private closed = 0;
  private forced: ReadonlyMap<number, boolean> = new Map();
  private readonly plot = h("div", { class: "trend", role: "img" });
  private readonly channels = h("div", { class: "channels" });
  /** The time of the cursor, and what each channel is there. */
  private readonly reading = h("span", { class: "note", id: "trend-reading" });
  private readonly hidden = new Set<string>();
  /** Those that a person has shown or hidden: they stay so. */
  private readonly chosen = new Set<string>();
  /** The names of all that is forced. */
  private marked: ReadonlySet<string> = new Set();
  private points: readonly Point[] = [];
  private chart: uPlot | null = null;
  /** The channels of the chart; none: it is to be made again. */
  private drawn: string[] = [];
  /** The channels that the chart was made with. */
  private made: readonly string[] = [];
  /** The times that it shows, ms. */
  private times: readonly number[] = [];
  private span = 10;
  private follows = true;
  private asked = false;
  /** When it was last drawn, ms of the page. */
  private drawnAt = -PICTURE;

  constructor(private readonly bench: Bench) {
    bench.events.add((event) => {
      const { recorder } = this;
      if (bench.where.value !== "simulated") return;
      if (event.kind === "power" && event.on) this.clear();
      if (event.kind === "pins") {
        this.inputs(event.at, event.pins.closed);
        for (const edge of event.edges) {
          recorder.note(`Q${edge.output}`, edge.at, Number(edge.high));
          this.moments.turned(edge.at, "output");
        }
        event.pins.outputs.forEach((share, index) => {
          if (!recorder.channels.has(`Q${index + 1}`)) recorder.note(`Q${index + 1}`, event.at, Number(share > 0));
        });
      }
      if (event.kind === "pins" || event.kind === "pace" || event.kind === "paused") {
        this.settle();
        recorder.now = Math.max(recorder.now, event.at);
      }
      this.redraw();
    });
    bench.seen.follow((seen) => {
      if (!seen) return;
      this.settle();
      this.marked = new Set(forcedNames(seen));
      // The page's own clock runs ahead of a board that a busy computer simulates: a cause would come after its effect.
      if (bench.where.value === "simulated") this.held = { seen, at: bench.simulated.spoke() };
      else {
        for (const point of this.points) {
          const forced = point.hand === "force" ? forcedTo(seen, point.name) : null;
          this.recorder.note(point.name, seen.at, forced === null ? point.value(seen) : Number(forced), point.kind === "bit");
        }
        this.recorder.now = Math.max(this.recorder.now, seen.at);
      }
      this.redraw();
    });
    speak.follow(() => this.build());
    new ResizeObserver(() => this.size()).observe(this.panel);
  }

  /** The pins of the inputs; one that is forced is not what its pin is. */
  private inputs(at: number, closed: number): void {
    const turned = closed ^ this.closed;
    this.closed = closed;
    for (const input of upTo(this.bench.board.value.inputs)) {
      if (this.forced.has(input)) continue;
      this.recorder.note(`I${input}`, at, isSet(closed, input));
      if (isSet(turned, input)) this.moments.turned(at, "input");
    }
  }

  /** Notes the reading that waits: the pins are known until its time. */
  private settle(): void {
    const { held, recorder } = this;
    if (!held) return;
    this.held = null;
    const { seen, at } = held;
    const moment = this.moments.read(at);
    for (const point of this.points) {
      // The simulated board tells its pins by itself, to the microsecond.
      if (point.hand === "force") continue;
      // A timer that begins to run has its cause before it, one that has come to its end has its effect after it.
      const runs = point.kind === "meter" && recorder.last(point.name) === 0 && point.value(seen) < (point.preset?.(seen) ?? 0);
      recorder.note(point.name, runs ? at : moment, point.value(seen), point.kind === "bit");
    }
    const forced = new Map(seen.forcedInputs);
    for (const input of new Set([...forced.keys(), ...this.forced.keys()])) {
      recorder.note(`I${input}`, moment, Number(forced.get(input) ?? isSet(this.closed, input)));
    }
    this.forced = forced;
    recorder.now = Math.max(recorder.now, at);
  }

  private clear(): void {
    this.recorder.clear();
    this.moments.clear();
    this.held = null;
  }

  /** Shows these points from now on. */
  watch(points: readonly Point[]): void {
    this.points = points;
    for (const { name, called } of points) {
      if (this.chosen.has(name)) continue;
      // Of many those are shown first that a person knows by name, or sees at the board.
      if (points.length > MANY && called === "" && !/^[IQ]/.test(name)) this.hidden.add(name);
      else this.hidden.delete(name);
    }
    this.build();
  }

  /** It is on the screen. */
  shown(): void {
    this.drawn = [];
    this.redraw();
  }

  private get names(): string[] {
    return this.points.map((point) => point.name).filter((name) => !this.hidden.has(name));
  }

  private build(): void {
    const span = h("select", { "aria-label": say("trendSpan"), change: () => { this.span = Number(span.value); this.follow(true); } },
      ...SPANS.map((seconds) => h("option", { value: seconds, selected: seconds === this.span }, say("seconds", { n: seconds }))));
    const follow = h("button", { type: "button", class: "small", id: "follow", "aria-pressed": String(this.follows), click: () => this.follow(!this.follows) }, say("trendFollow"));
    const small = (key: "trendSvg" | "trendCsv" | "trendClear", click: () => void): HTMLElement => h("button", { type: "button", class: "small", click }, say(key));
    const hand = (key: "zoomOut" | "zoomIn" | "trendBefore" | "trendAfter", sign: string, click: () => void): HTMLElement =>
      h("button", { type: "button", class: "small", id: key, title: say(key), "aria-label": `${say("tabTrend")}: ${say(key)}`, click: () => void this.drawnFirst(click) }, sign);
    const boxes = this.points.map((point) => {
      const box = h("input", { type: "checkbox", checked: !this.hidden.has(point.name) });
      box.addEventListener("change", () => {
        this.chosen.add(point.name);
        if (box.checked) this.hidden.delete(point.name);
        else this.hidden.add(point.name);
        this.redraw();
      });
      return h("label", {}, box, point.called ? `${point.called} (${point.name})` : point.name);
    });
    this.channels.replaceChildren(...boxes);
    this.channels.setAttribute("role", "group");
    this.channels.setAttribute("aria-label", say("trendChannels"));
    this.plot.setAttribute("aria-label", say("tabTrend"));
    this.panel.replaceChildren(
      h("div", { class: "trend-tools" }, span, follow,
        h("span", { class: "group" }, hand("zoomOut", "−", () => this.zoom(2)), hand("zoomIn", "+", () => this.zoom(1 / 2))),
        h("span", { class: "group" }, hand("trendBefore", "◂", () => this.step(-1)), hand("trendAfter", "▸", () => this.step(1))),
        small("trendSvg", () => download("timing.svg", this.svg(), "image/svg+xml")),
        small("trendCsv", () => download("timing.csv", this.recorder.csv(this.names, (name) => this.headed(name)), "text/csv")),
        small("trendClear", () => { this.recorder.forget(); this.drawn = []; this.redraw(); }),
        this.channels, this.reading),
      this.points.length > 0 ? this.plot : h("p", { class: "empty" }, say("trendEmpty")));
    this.drawn = [];
    this.redraw();
  }

  /** The diagram as a picture for a report. */
  svg(): string {
    const [from, to] = this.window();
    const labels = this.names.map((name) => ({ name, label: this.markedName(name) }));
    return timingSvg(this.recorder, labels, from, to);
  }

  private follow(follows: boolean): void {
    this.follows = follows;
    this.panel.querySelector("#follow")?.setAttribute("aria-pressed", String(follows));
    this.redraw();
  }

  private window(): [number, number] {
    const { chart, recorder } = this;
    const scale = chart?.scales["x"];
    if (!this.follows && scale?.min !== undefined && scale.max !== undefined) return [scale.min * 1000, scale.max * 1000];
    const to = Math.max(recorder.now, this.span * 1000);
    return [to - this.span * 1000, to];
  }

  /** Where the cursor is, ms; null: nowhere. */
  private get cursor(): number | null {
    const at = this.chart?.cursor.idx;
    return at === null || at === undefined ? null : (this.times[at] ?? null);
  }

  /** Acts on the diagram that is chosen: one that is not drawn yet, or is another, is drawn before. */
  private async drawnFirst(act: () => void): Promise<void> {
    if (!this.chart || this.drawn.join() !== this.names.join()) await this.draw();
    act();
  }

  /** Shows so many times as much, about the cursor. */
  private zoom(by: number): void {
    const [from, to] = this.window();
    const { cursor } = this;
    const about = cursor !== null && cursor > from && cursor < to ? cursor : (from + to) / 2;
    this.show(Math.max(about - (about - from) * by, 0), Math.max(about + (to - about) * by, LEAST));
    this.point(cursor);
  }

  /** Goes to the next change, or to the one before. */
  private step(by: 1 | -1): void {
    const [from, to] = this.window();
    const { times } = this.recorder.table(this.names, 0, this.recorder.now);
    const changes = times.slice(1, -1);
    const at = this.cursor ?? (by > 0 ? from : to);
    const next = by > 0 ? changes.find((time) => time > at + 0.0005) : changes.findLast((time) => time < at - 0.0005);
    if (next === undefined) return;
    const half = (to - from) / 2;
    this.show(...(next < from || next > to ? [Math.max(next - half, 0), next + half] as const : [from, to] as const));
    this.point(next);
    announce(this.reading.textContent ?? "");
  }

  private show(from: number, to: number): void {
    if (to - from < LEAST) return;
    this.follow(false);
    this.lay(this.made, from, to);
  }

  /** Lays data and window under the cursor, both at once: a place in the diagram is a time only by its window. */
  private lay(names: readonly string[], from: number, to: number): void {
    const { chart, follows, recorder } = this;
    chart?.batch(() => {
      chart.setData(this.data(names, follows ? from : 0, follows ? to : recorder.now), false);
      chart.setScale("x", { min: from / 1000, max: to / 1000 });
    });
  }

  private point(at: number | null): void {
    const { chart } = this;
    if (chart && at !== null) chart.setCursor({ left: chart.valToPos(at / 1000, "x"), top: 1 });
  }

  private redraw(): void {
    if (this.asked || this.panel.hidden || this.points.length === 0) return;
    this.asked = true;
    const draw = (): void => {
      this.asked = false;
      this.drawnAt = performance.now();
      void this.draw();
    };
    setTimeout(() => requestAnimationFrame(draw), Math.max(this.drawnAt + PICTURE - performance.now(), 0));
  }

  private async draw(): Promise<void> {
    const { default: Plot } = await import("uplot");
    const { names, cursor } = this;
    const [from, to] = this.window();
    // None at all are others too, where the chart has some.
    const isNew = names.join() !== this.drawn.join() || names.length !== this.made.length || !this.chart;
    if (isNew || !this.chart) {
      this.chart?.destroy();
      this.chart = this.make(Plot, names);
      this.drawn = names;
      this.made = names;
    }
    this.lay(names, from, to);
    if (isNew) this.point(cursor);
  }

  /** What is drawn: times in s, and a lane for each channel. */
  private data(names: readonly string[], from: number, to: number): uPlot.AlignedData {
    const { times, values } = this.recorder.table(names, from, to);
    this.times = times;
    return [times.map((time) => time / 1000), ...values.map((one, lane) => this.lane(one, names.length - 1 - lane))];
  }

  /** Values put into their lane: bits as they are, numbers from their least to their most. */
  private lane(values: readonly number[], lane: number): (number | null)[] {
    const seen = values.filter((value) => !Number.isNaN(value));
    const least = Math.min(0, ...seen);
    const most = Math.max(1, ...seen);
    return values.map((value) => (Number.isNaN(value) ? null : lane + 0.12 + (0.7 * (value - least)) / (most - least)));
  }

  private make(Plot: typeof uPlot, names: readonly string[]): uPlot {
    this.plot.replaceChildren();
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string): string => style.getPropertyValue(name).trim();
    const steps = Plot.paths.stepped?.({ align: 1 });
    const called = (name: string): string => this.points.find((point) => point.name === name)?.called || name;
    const series = names.map((name): uPlot.Series => {
      const stroke = colour(name.startsWith("I") ? "--word" : name.startsWith("Q") ? "--power" : "--operand");
      return { label: called(name), stroke, width: 2, points: { show: false }, ...(steps ? { paths: steps } : {}) };
    });
    const options: uPlot.Options = {
      width: Math.max(this.plot.clientWidth, 280),
      height: names.length * LANE + 34,
      legend: { show: false },
      cursor: { drag: { x: true, y: false } },
      scales: { x: { time: false, auto: false }, y: { auto: false, range: [0, Math.max(names.length, 1)] } },
      axes: [
        { stroke: colour("--faint"), grid: { stroke: colour("--soft") }, ticks: { stroke: colour("--line") }, values: (_, ticks) => ticks.map((tick) => `${decimal(tick)} s`), size: 32 },
        {
          stroke: colour("--ink"), size: 128, grid: { stroke: colour("--soft") }, ticks: { show: false },
          splits: () => names.map((_, lane) => lane + 0.4),
          values: () => names.map((_, lane) => this.labelOf(names[names.length - 1 - lane] ?? "")),
        },
      ],
      series: [{}, ...series],
      hooks: {
        setSelect: [() => this.follow(false)],
        setCursor: [() => this.read()],
      },
    };
    const chart = new Plot(options, [[0], ...names.map(() => [null])], this.plot);
    chart.over.addEventListener("dblclick", () => this.follow(true));
    return chart;
  }

  /** What the column of a channel is headed by in a table. */
  private headed(name: string): string {
    const called = this.points.find((point) => point.name === name)?.called;
    return called ? `${called} ${name}` : name;
  }

  /** What a point is called, marked where it is forced. */
  private markedName(name: string): string {
    const called = this.points.find((point) => point.name === name)?.called || name;
    return this.marked.has(name) ? `${called} (${say("forced")})` : called;
  }

  /** A lane's name, and its value under the cursor. */
  private labelOf(name: string): string {
    const called = this.markedName(name);
    const value = this.cursor === null ? undefined : this.recorder.table([name], this.cursor, this.cursor).values[0]?.[0];
    return value === undefined || Number.isNaN(value) ? called : `${called} = ${decimal(value)}`;
  }

  private read(): void {
    const { cursor } = this;
    this.reading.textContent = cursor === null ? "" : [say("seconds", { n: fixed(cursor / 1000, 3) }), ...this.names.map((name) => this.labelOf(name))].join(", ");
    this.chart?.redraw(false, true);
  }

  private size(): void {
    const { chart } = this;
    if (chart && this.plot.clientWidth > 0 && Math.abs(chart.width - this.plot.clientWidth) > 1) {
      chart.setSize({ width: this.plot.clientWidth, height: chart.height });
    }
  }
}

/** Whether the pin of an input is closed, 0 or 1: bit 0 is input 01. */
function isSet(pins: number, input: number): number {
  return (pins >> (input - 1)) & 1;
}
