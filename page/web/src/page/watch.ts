// Watched values: set and forced here; what is forced is marked, and let go on request.

import type { Seen } from "../tools/answers";
import { say, speak } from "../words/words";
import type { Bench } from "./bench";
import { h, put } from "./dom";
import { announce } from "./notes";
import { decimal } from "./numbers";
import { type Point, forcedNames, forcedTo, pinOf } from "./points";

interface Row {
  readonly point: Point;
  readonly root: HTMLTableRowElement;
  readonly value: HTMLElement;
  readonly preset: HTMLElement;
}

export class Watch {
  readonly panel = h("div");
  private rows: Row[] = [];
  private points: readonly Point[] = [];
  /** What a screen reader was told last. */
  private forced = "";

  constructor(private readonly bench: Bench) {
    bench.seen.follow((seen) => {
      this.show(seen);
      this.tell(seen);
    });
    speak.follow(() => this.build());
  }

  /** Shows these points from now on. */
  watch(points: readonly Point[]): void {
    const names = (points: readonly Point[]): string => points.map((point) => `${point.name}=${point.called}`).join();
    if (names(points) === names(this.points)) return;
    this.points = points;
    this.build();
  }

  private build(): void {
    this.rows = this.points.map((point) => this.row(point));
    const head = ["watchPoint", "watchName", "watchValue", "watchPreset", "watchForce"] as const;
    const release = h("button", { type: "button", class: "small", id: "release", click: () => void this.bench.ask({ do: "release" }) }, say("letAllGo"));
    const table = h("table", {},
      h("thead", {}, h("tr", {}, ...head.map((key) => h("th", { scope: "col" }, say(key), key === "watchForce" && release)))),
      h("tbody", {}, ...this.rows.map((row) => row.root)));
    this.panel.replaceChildren(...(this.points.length > 0 ? [table] : [h("p", { class: "empty" }, say("watchEmpty"))]));
    this.show(this.bench.seen.value);
  }

  private row(point: Point): Row {
    const value = h("td", { class: "value" }, "–");
    const preset = h("td", { class: "value" });
    const root = h("tr", { "data-point": point.name },
      h("th", { scope: "row" }, point.name), h("td", {}, point.called), value, preset, h("td", {}, ...this.hands(point)));
    return { point, root, value, preset };
  }

  private hands(point: Point): HTMLElement[] {
    const small = (text: string, click: () => void): HTMLElement =>
      h("button", { type: "button", class: "small", "aria-label": `${point.name}: ${text}`, click }, text);
    const pin = pinOf(point.name);
    if (pin && point.hand === "force") {
      const force = (to: boolean | null) => (): void => void this.bench.ask({ do: "force", ...pin, to });
      return [h("span", { class: "group" }, small(say("force1"), force(true)), small(say("force0"), force(false)), small(say("letGo"), force(null)))];
    }
    if (point.hand === "none") return [];
    if (point.kind === "bit") {
      const set = (value: number) => (): void => void this.bench.ask({ do: "set", point: point.name, value });
      return [h("span", { class: "group" }, small("1", set(1)), small("0", set(0)))];
    }
    const input = h("input", { type: "number", "aria-label": say("setTo", { point: point.name }), step: point.kind === "real" ? "any" : 1 });
    const set = (): void => {
      const number = input.valueAsNumber;
      if (!Number.isFinite(number)) return;
      const value = point.kind === "real" ? (new Int32Array(Float32Array.of(number).buffer)[0] ?? 0) : Math.trunc(number);
      if (value >= -(2 ** 31) && value < 2 ** 31) void this.bench.ask({ do: "set", point: point.name, value });
    };
    input.addEventListener("keydown", (event) => {
      if (event.key === "Enter") set();
    });
    return [h("span", { class: "row" }, input, small(say("watchSet"), set))];
  }

  private tell(seen: Seen | null): void {
    if (!seen) return;
    const forced = forcedNames(seen).join(", ");
    if (forced === this.forced) return;
    this.forced = forced;
    announce(forced ? `${say("forced")}: ${forced}` : say("allLetGo"));
  }

  private show(seen: Seen | null): void {
    for (const { point, root, value, preset } of this.rows) {
      put(value, seen ? shown(point, point.value(seen)) : "–");
      put(preset, seen && point.preset ? String(point.preset(seen)) : "");
      const is = seen !== null && point.hand === "force" && forcedTo(seen, point.name) !== null;
      root.classList.toggle("is-forced", is);
      if (is) put(value, `${value.textContent} · ${say("forced")}`);
    }
  }
}

function shown(point: Point, value: number): string {
  if (point.kind === "bit") return value ? "1 ●" : "0 ○";
  return decimal(value);
}
