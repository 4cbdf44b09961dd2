// What points were: some of them over minutes to months, with a cursor.

import { h } from "../page/dom";
import { note } from "../page/notes";
import { type SiteKey, say } from "../words/site";
import { speak } from "../words/words";
import { No, type PointName, type Row, ask } from "./ask";
import { Chart, type Line } from "./chart";
import { table } from "./table";
import { moment, value } from "./told";

const MINUTE = 60_000;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
const SPANS: readonly (readonly [ms: number, key: "minutes" | "hours" | "days", n: number])[] = [
  [5 * MINUTE, "minutes", 5],
  [HOUR, "hours", 1],
  [8 * HOUR, "hours", 8],
  [DAY, "hours", 24],
  [7 * DAY, "days", 7],
  [30 * DAY, "days", 30],
  [365 * DAY, "days", 365],
];
/** Rows that a line has at most: more than a screen is wide. */
const ROWS = 600;
/** Points that are shown at once. */
const MOST = 8;
/** From one picture to the next while it follows now, ms. */
const EVERY = 2000;

const keyOf = ({ board, point }: PointName): string => `${board}.${point}`;

/** What a point was in this time: each change, or a row for each step where there would be too many. */
export async function past(of: PointName, from: number, to: number): Promise<readonly Row[]> {
  const step = Math.ceil((to - from) / ROWS);
  const query = new URLSearchParams({ board: of.board, point: of.point, from: String(from), to: String(to), step: `${step}ms`, most: String(ROWS + 2) });
  const { rows } = await ask<{ readonly rows: readonly Row[] }>(`api/history?${query.toString()}`);
  return rows;
}

export class Trends {
  readonly root = h("div");
  private readonly points = h("fieldset", { class: "channels points-list" });
  private readonly tools = h("div", { class: "trend-tools" });
  private readonly place = h("div", { class: "sheet chart" });
  private readonly told = h("div");
  private readonly chart = new Chart(this.place, () => this.tell());
  private all: readonly PointName[] | null = null;
  private readonly chosen = new Set<string>();
  private lines: readonly Line[] = [];
  private span = HOUR;
  /** Where the picture ends; null: now. */
  private end: number | null = null;
  private asked = 0;

  constructor() {
    this.root.append(this.tools, this.points, this.place, this.told);
    speak.follow(() => this.build());
    setInterval(() => {
      if (this.end === null && document.visibilityState === "visible") void this.draw();
    }, EVERY);
  }

  shown(rest = ""): void {
    void this.begin(rest);
  }

  private async begin(rest: string): Promise<void> {
    try {
      this.all ??= await ask<readonly PointName[]>("api/points");
    } catch (error) {
      if (!(error instanceof No)) throw error;
      this.place.replaceChildren(h("p", { class: "empty" }, say(error.why === "no history" ? "trendNone" : "trendBusy")));
      return;
    }
    const first = this.all.find((one) => keyOf(one) === rest) ?? this.all[0];
    if (first && (rest || this.chosen.size === 0)) this.chosen.add(keyOf(first));
    this.build();
  }

  private build(): void {
    if (!this.all || this.root.hidden) return;
    const span = h("select", { id: "trend-span", "aria-label": say("trendTime"), change: () => { this.span = Number(span.value); void this.draw(); } },
      ...SPANS.map(([ms, key, n]) => h("option", { value: ms, selected: ms === this.span }, say(key, { n }))));
    const button = (key: SiteKey, id: string, click: () => void): HTMLElement => h("button", { type: "button", class: "small", id, click }, say(key));
    const now = button("trendNow", "trend-now", () => this.go(null));
    now.setAttribute("aria-pressed", String(this.end === null));
    this.tools.replaceChildren(span,
      button("trendEarlier", "trend-earlier", () => this.go((this.end ?? Date.now()) - this.span / 2)),
      button("trendLater", "trend-later", () => this.go((this.end ?? Date.now()) + this.span / 2)), now);
    const boxes = this.all.map((one) => {
      const key = keyOf(one);
      const box = h("input", { type: "checkbox", checked: this.chosen.has(key), "data-point": key });
      box.addEventListener("change", () => {
        if (box.checked && this.chosen.size >= MOST) {
          box.checked = false;
          note(() => say("trendMost"));
        } else if (box.checked) this.chosen.add(key);
        else this.chosen.delete(key);
        void this.draw();
      });
      return h("label", {}, box, key);
    });
    this.points.replaceChildren(h("legend", {}, say("trendPoints")), ...boxes);
    void this.draw();
  }

  private go(end: number | null): void {
    this.end = end !== null && end < Date.now() ? end : null;
    this.tools.querySelector("#trend-now")?.setAttribute("aria-pressed", String(this.end === null));
    void this.draw();
  }

  private async draw(): Promise<void> {
    if (!this.all || this.root.hidden) return;
    const mine = ++this.asked;
    const to = this.end ?? Date.now();
    const from = to - this.span;
    const chosen = this.all.filter((one) => this.chosen.has(keyOf(one)));
    const lines: Line[] = [];
    try {
      // One after the other: a gateway answers four at once, and others ask it too.
      for (const one of chosen) lines.push({ label: keyOf(one), rows: await past(one, from, to) });
    } catch (error) {
      if (!(error instanceof No)) throw error;
      // What was drawn stays; it is asked again.
      return;
    }
    if (mine !== this.asked) return;
    this.lines = lines;
    if (lines.length === 0) {
      this.chart.clear(h("p", { class: "empty" }, say("trendChoose")));
      this.told.replaceChildren();
      return;
    }
    await this.chart.draw(lines, from, to, say("trendChart"));
    this.tell();
  }

  /** The same in numbers: at the cursor, and over all of the time. */
  private tell(): void {
    const { cursor } = this.chart;
    const rows = this.lines.map((line) => {
      const known = line.rows.filter((row) => row.last !== null);
      const least = Math.min(...known.map((row) => row.least ?? Infinity));
      const most = Math.max(...known.map((row) => row.most ?? -Infinity));
      const at = cursor === null ? null : line.rows.findLast((row) => row.at <= cursor)?.last;
      const number = (of: number): string => (Number.isFinite(of) ? value(of) : "–");
      return [line.label, cursor === null ? "–" : value(at), value(line.rows.at(-1)?.last), number(least), number(most)];
    });
    const heads = [say("trendPoint"), cursor === null ? say("trendCursor") : moment(cursor), say("trendLast"), say("trendLeast"), say("trendMostOf")];
    this.told.replaceChildren(table(say("trendChart"), heads, rows));
  }
}
