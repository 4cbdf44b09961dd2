// The sheet: the ladder that is drawn, what of it is selected or wrong, and the places that take an element.

import type { Drawn, Place } from "../../tools/answers";
import { say } from "../../words/draw";
import { LadderView } from "../ladder";
import { dress } from "../dom";
import type { Carried } from "./carrying";

/** How near a place has to be, in units of the drawing. */
const NEAR = 60;

type Sheeted = NonNullable<Drawn["sheet"]>;

export class Sheet implements Carried {
  readonly ladder: LadderView;
  private sheet: Sheeted | null = null;
  private lights: SVGGElement | null = null;

  constructor(
    readonly paper: HTMLElement,
    readonly put: (what: string, at: number, place: Place) => void,
  ) {
    // Clicks are the screen's: what they do depends on what one is at.
    this.ladder = new LadderView(paper, { line: () => undefined, point: () => undefined });
  }

  private get svg(): SVGSVGElement | null {
    return this.paper.querySelector("svg");
  }

  show(drawn: Drawn): void {
    if (drawn.sheet) {
      this.sheet = drawn.sheet;
      this.ladder.show(drawn.sheet.svg);
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
    this.paper.querySelector(".selected")?.scrollIntoView({ block: "nearest", inline: "nearest" });
  }

  /** Shows nothing. */
  clear(): void {
    this.sheet = null;
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
    for (const [, , [x, y, width, height]] of sheet.places) {
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
    const x = ((clientX - box.left) / box.width) * sheet.area[2];
    const y = ((clientY - box.top) / box.height) * sheet.area[3];
    const away = ([left, top, width, height]: Sheeted["places"][number][2]): number =>
      Math.hypot(Math.max(left - x, 0, x - left - width), Math.max(top - y, 0, y - top - height));
    let best = -1;
    let least = NEAR;
    if (inside) {
      sheet.places.forEach(([, , area], index) => {
        const distance = away(area);
        if (distance < least) [best, least] = [index, distance];
      });
    }
    [...(this.lights?.children ?? [])].forEach((rect, index) => rect.classList.toggle("near", index === best));
    const found = sheet.places[best];
    return found ? { at: found[0], place: found[1] } : null;
  }
}
