// A chart of points over time: for each a line of what it was last, and a band from its least to its most.

import type uPlot from "uplot";
import { h } from "../page/dom";
import { decimal } from "../page/numbers";
import { speak } from "../words/words";
import type { Row } from "./ask";

export interface Line {
  readonly label: string;
  readonly rows: readonly Row[];
}

/** Colours of the page for lines, in this order. */
const COLOURS = ["--word", "--power", "--error", "--operand", "--number", "--force", "--accent", "--comment"];

export class Chart {
  /** Where the cursor is, ms since 1970; null: nowhere. */
  cursor: number | null = null;
  private plot: uPlot | null = null;
  private made = "";

  /** `moved` hears that the cursor is elsewhere. */
  constructor(
    private readonly root: HTMLElement,
    private readonly moved: () => void = () => undefined,
    private readonly height = 300,
  ) {
    new ResizeObserver(() => this.size()).observe(root);
  }

  /** Shows this in place of a chart. */
  clear(instead: HTMLElement): void {
    this.plot?.destroy();
    this.plot = null;
    this.root.replaceChildren(instead);
  }

  async draw(lines: readonly Line[], from: number, to: number, label: string): Promise<void> {
    const { default: Plot } = await import("uplot");
    const data = dataOf(lines, from, to);
    const made = [...lines.map((line) => line.label), speak.value, document.documentElement.dataset["theme"]].join();
    if (!this.plot || made !== this.made || !this.root.contains(this.plot.root)) {
      this.plot?.destroy();
      const place = h("div", { role: "img", "aria-label": label });
      this.root.replaceChildren(place, legend(lines));
      this.plot = new Plot(this.options(Plot, lines), data, place);
      this.made = made;
    } else this.plot.setData(data, false);
    this.plot.setScale("x", { min: from / 1000, max: to / 1000 });
  }

  private options(Plot: typeof uPlot, lines: readonly Line[]): uPlot.Options {
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string): string => style.getPropertyValue(name).trim();
    const steps = Plot.paths.stepped?.({ align: 1 });
    const series = lines.flatMap((line, at): uPlot.Series[] => {
      const stroke = colour(COLOURS[at % COLOURS.length] ?? "--ink");
      const one = { label: line.label, stroke, points: { show: false }, ...(steps ? { paths: steps } : {}) };
      // Least, most, last: the band lies between the first two.
      return [{ ...one, width: 0 }, { ...one, width: 0 }, { ...one, width: 2 }];
    });
    const bands = lines.map((_, at): uPlot.Band => ({ series: [at * 3 + 2, at * 3 + 1], fill: `${colour(COLOURS[at % COLOURS.length] ?? "--ink")}40` }));
    const axis = { stroke: colour("--faint"), grid: { stroke: colour("--soft") }, ticks: { stroke: colour("--line") } };
    return {
      width: this.width,
      height: this.height,
      legend: { show: false },
      cursor: { drag: { x: false, y: false } },
      scales: { x: { time: true, auto: false } },
      axes: [{ ...axis, values: (_, ticks) => times(ticks) }, { ...axis, size: 58, values: (_, ticks) => ticks.map(decimal) }],
      series: [{}, ...series],
      bands,
      hooks: {
        setCursor: [(plot) => {
          const at = plot.cursor.left;
          this.cursor = at === undefined || at < 0 ? null : plot.posToVal(at, "x") * 1000;
          this.moved();
        }],
      },
    };
  }

  private get width(): number {
    return Math.max(this.root.clientWidth - 2, 240);
  }

  private size(): void {
    const { plot } = this;
    if (plot && this.root.clientWidth > 0 && Math.abs(plot.width - this.width) > 1) plot.setSize({ width: this.width, height: this.height });
  }
}

/** The moments of an axis: the hour where they are near each other, else the day. */
function times(ticks: readonly number[]): string[] {
  const locale = speak.value === "pt" ? "pt-BR" : "en-GB";
  const step = (ticks[1] ?? 0) - (ticks[0] ?? 0);
  const form: Intl.DateTimeFormatOptions = step >= 86_400 ? { day: "2-digit", month: "2-digit" } : step < 60 ? { timeStyle: "medium" } : { timeStyle: "short" };
  return ticks.map((tick) => new Date(tick * 1000).toLocaleString(locale, form));
}

/** Which colour is whose. */
function legend(lines: readonly Line[]): HTMLElement {
  const mark = (at: number): HTMLElement => {
    const of = h("span", { class: "mark-of-line", "aria-hidden": "true" });
    of.style.background = `var(${COLOURS[at % COLOURS.length] ?? "--ink"})`;
    return of;
  };
  return h("p", { class: "legend" }, ...lines.map((line, at) => h("span", {}, mark(at), line.label)));
}

/** One row of times for all lines: a line keeps its value until its own next row. */
function dataOf(lines: readonly Line[], from: number, to: number): uPlot.AlignedData {
  const times = [...new Set([from, ...lines.flatMap((line) => line.rows.map((row) => row.at)), to])].filter((at) => at >= from && at <= to).sort((one, other) => one - other);
  const columns = lines.flatMap(({ rows }) => {
    const least: (number | null)[] = [];
    const most: (number | null)[] = [];
    const last: (number | null)[] = [];
    let next = 0;
    let row: Row | null = null;
    for (const at of times) {
      let isNew = false;
      for (let one = rows[next]; one && one.at <= at; one = rows[next]) {
        row = one;
        isNew = true;
        next += 1;
      }
      const of = row?.last ?? null;
      least.push(isNew ? row?.least ?? of : of);
      most.push(isNew ? row?.most ?? of : of);
      last.push(of);
    }
    return [least, most, last];
  });
  return [times.map((at) => at / 1000), ...columns];
}
