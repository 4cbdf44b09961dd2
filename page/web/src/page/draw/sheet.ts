// The sheet: the ladder that is drawn, what of it is selected or wrong, and the places that take an element.

import type { Drawn, Place } from "../../tools/answers";
import { say } from "../../words/draw";
import { LadderView } from "../ladder";
import { dress } from "../dom";
import { reveal } from "../reveal";
import type { Carried } from "./carrying";

/** How near a place has to be, in units of the drawing. */
const NEAR = 60;

type Sheeted = NonNullable<Drawn["sheet"]>;
type Places = NonNullable<Sheeted["rungs"][number]["drawn"]>["places"];

export class Sheet implements Carried {
  readonly ladder: LadderView;
  private sheet: Sheeted | null = null;
  /** The places of each rung, by its name. */
  private places = new Map<number, Places>();
  private lights: SVGGElement | null = null;

  constructor(
    readonly paper: HTMLElement,
    readonly put: (what: string, at: number, place: Place) => void,
    room: () => void,
  ) {
    // Clicks are the screen's: what they do depends on what one is at.
    this.ladder = new LadderView(paper, { line: () => undefined, point: () => undefined, room });
  }

  private get svg(): SVGSVGElement | null {
    return this.paper.querySelector("svg");
  }

  show(drawn: Drawn): void {
    if (drawn.sheet) {
      this.sheet = drawn.sheet;
      this.light(false);
      this.ladder.change(drawn.sheet);
      this.open(drawn.sheet);
      // The paper around it is what a screen reader is at, and hears of.
      this.svg?.setAttribute("aria-label", drawn.title || say("sheet"));
    }
    const wrong = new Map(drawn.mistakes.map((mistake) => [mistake.at, mistake.error]));
    const selected = new Set(drawn.selected);
    for (const one of this.paper.querySelectorAll<SVGElement>("[data-id]")) {
      const id = Number(one.dataset["id"]);
      one.classList.toggle("selected", selected.has(id));
      one.classList.toggle("wrong", wrong.get(id) === true);
      one.classList.toggle("warned", wrong.get(id) === false);
    }
    // Headings have no area of their own in an empty rung: the rung is marked.
    const seen = this.paper.querySelector(".selected");
    if (seen) reveal(seen);
  }

  /** Keeps the places of the rungs that are as they were. */
  private open({ rungs }: Sheeted): void {
    const were = this.places;
    this.places = new Map(rungs.map(({ id, drawn }) => [id, drawn?.places ?? were.get(id) ?? []]));
  }

  /** All places that take an element, where they are on the sheet. */
  private openings(): Places {
    const rungs = this.sheet?.rungs ?? [];
    const of = (id: number): Places => this.places.get(id) ?? [];
    return rungs.flatMap(({ id, top }) => of(id).map(([at, place, [x, y, ...size]]) => [at, place, [x, top + y, ...size]] as const));
  }

  /** Shows nothing. */
  clear(): void {
    this.sheet = null;
    this.places.clear();
    this.ladder.show("");
  }

  /** Where something is in the window; null where it is not drawn. */
  box(id: number): DOMRect | null {
    const element = this.paper.querySelector(`.element[data-id="${id}"]`) ?? this.paper.querySelector(`[data-id="${id}"]`);
    return element?.getBoundingClientRect() ?? null;
  }

  light(on: boolean): void {
    this.lights?.remove();
    this.lights = null;
    const { svg, sheet } = this;
    if (!on || !svg || !sheet) return;
    const lights = document.createElementNS("http://www.w3.org/2000/svg", "g");
    dress(lights, { class: "places" });
    for (const [, , [x, y, width, height]] of this.openings()) {
      const rect = document.createElementNS("http://www.w3.org/2000/svg", "rect");
      dress(rect, { x, y, width, height, rx: 3 });
      lights.append(rect);
    }
    svg.append(lights);
    this.lights = lights;
  }

  near(clientX: number, clientY: number): { at: number; place: Place } | null {
    const { svg, sheet } = this;
    if (!svg || !sheet) return null;
    const box = svg.getBoundingClientRect();
    const paper = this.paper.getBoundingClientRect();
    const inside = clientX >= paper.left && clientX <= paper.right && clientY >= paper.top && clientY <= paper.bottom;
    const x = ((clientX - box.left) / box.width) * sheet.width;
    const y = ((clientY - box.top) / box.height) * sheet.height;
    const away = ([left, top, width, height]: Places[number][2]): number =>
      Math.hypot(Math.max(left - x, 0, x - left - width), Math.max(top - y, 0, y - top - height));
    const openings = this.openings();
    let best = -1;
    let least = NEAR;
    if (inside) {
      openings.forEach(([, , area], index) => {
        const distance = away(area);
        if (distance < least) [best, least] = [index, distance];
      });
    }
    [...(this.lights?.children ?? [])].forEach((rect, index) => rect.classList.toggle("near", index === best));
    const found = openings[best];
    return found ? { at: found[0], place: found[1] } : null;
  }
}
