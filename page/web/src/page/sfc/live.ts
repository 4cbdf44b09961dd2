// What of a chart is live: its active steps, for how long, and the transitions that wait for their conditions alone.

import type { ChartDrawn, Seen } from "../../tools/answers";
import type { Bench } from "../bench";
import { put } from "../dom";
import type { ProgramDocument } from "../document";
import { liveOf } from "../forcing";

export class LiveChart {
  private chart: ChartDrawn | null = null;
  /** When each step was seen to become active, in ms of the board; null while it is not, undefined where nobody saw it. */
  private since: (number | null | undefined)[] = [];

  constructor(
    private readonly paper: HTMLElement,
    private readonly program: ProgramDocument,
    private readonly bench: Bench,
  ) {
    bench.seen.follow(() => this.now());
  }

  /** The paper has this chart now. */
  show(chart: ChartDrawn): void {
    this.chart = chart;
    this.now();
  }

  private now(): void {
    const { chart, bench } = this;
    if (!chart) return;
    const seen = liveOf(bench, this.program.text.value) ? bench.seen.value : null;
    const active = chart.points.map(([point]) => seen !== null && point !== null && valueOf(seen, point) !== 0);
    this.since = active.map((is, step) => (is ? (this.since[step] === null ? seen?.at : this.since[step]) : seen ? null : undefined));
    for (const part of chart.parts) {
      const group = this.paper.querySelector<SVGElement>(`[data-id="${part.id}"]`);
      const step = Number(/^[sa](\d+)/.exec(part.id)?.[1] ?? -1);
      if (part.kind === "transition") group?.classList.toggle("ready", part.from.length > 0 && part.from.every((from) => active[from]));
      else group?.classList.toggle("active", active[step] ?? false);
      if (part.kind === "step") put(group?.querySelector(".time") ?? undefined, active[step] && seen ? this.time(step, seen) : "");
    }
  }

  /** For how long a step is active: as the program counts it, or else as it was seen here. */
  private time(step: number, seen: Seen): string {
    const point = this.chart?.points[step]?.[1];
    const since = this.since[step];
    const ms = point ? valueOf(seen, point) : typeof since === "number" ? seen.at - since : null;
    return ms === null ? "" : `${(Math.floor(ms / 100) / 10).toFixed(1)} s`;
  }
}

/** What stands at a marker or a register. */
function valueOf(seen: Seen, point: string): number {
  const number = Number(point.slice(1));
  return point.startsWith("M") ? Number(seen.markers.includes(number)) : (seen.registers[number - 1] ?? 0);
}
