// Where the areas of the screen begin and end: splitters that one drags, or moves by arrows, and that the browser remembers;
// on a phone three pages beside each other, with buttons and lamps under the program.

import type { Key } from "../words/table";
import { byId, h } from "./dom";
import { keep, kept } from "./kept";
import { turnTo } from "./reveal";

interface Border {
  readonly id: string;
  readonly say: Key;
  /** The size that it changes, as the style sheet names it, CSS pixels. */
  readonly size: string;
  readonly usual: number;
  readonly least: number;
  readonly most: number;
  readonly isUpright: boolean;
}

const BORDERS: readonly Border[] = [
  { id: "split-machine", say: "splitMachine", size: "--machine", usual: 304, least: 240, most: 640, isUpright: true },
  { id: "split-drawer", say: "splitDrawer", size: "--drawer", usual: 200, least: 80, most: 600, isUpright: false },
];
/** What an arrow moves, CSS pixels. */
const STEP = 16;
const PAGES = [["page-program", "pageProgram", "program"], ["page-machine", "pageMachine", "board"], ["page-drawer", "pageDrawer", "below"]] as const;

/** Lays the areas out; what is docked stands under the program where the screen is narrow, and in its own area elsewhere. */
export function layOut(docked: HTMLElement): void {
  const main = byId("main");
  for (const border of BORDERS) byId(border.isUpright ? "board" : "below").before(splitter(main, border));
  const narrow = matchMedia("(max-width: 760px)");
  const home = docked.parentElement;
  const place = (): void => (narrow.matches ? byId("dock") : home)?.append(docked);
  narrow.addEventListener("change", place);
  place();
  pages(main);
}

function splitter(main: HTMLElement, { id, say, size, usual, least, most, isUpright }: Border): HTMLElement {
  const root = document.documentElement.style;
  let now = usual;
  const bar = h("div", { id, class: `splitter ${isUpright ? "across" : "along"}`, role: "separator", tabindex: 0, "data-say-label": say,
    "aria-orientation": isUpright ? "vertical" : "horizontal", "aria-valuemin": least, "aria-valuemax": most });
  const set = (to: number): void => {
    now = Math.round(Math.min(Math.max(to, least), most, isUpright ? main.clientWidth / 2 || most : most));
    root.setProperty(size, `${now}px`);
    bar.setAttribute("aria-valuenow", String(now));
  };
  const move = (to: number): void => {
    set(to);
    keep(id, String(now));
  };
  set(Number(kept(id)) || usual);
  bar.addEventListener("pointerdown", (down) => {
    if (down.button !== 0) return;
    bar.setPointerCapture(down.pointerId);
    bar.classList.add("held");
    const from = now;
    const drag = (event: PointerEvent): void => move(from + (isUpright ? down.clientX - event.clientX : down.clientY - event.clientY));
    bar.addEventListener("pointermove", drag);
    bar.addEventListener("lostpointercapture", () => {
      bar.classList.remove("held");
      bar.removeEventListener("pointermove", drag);
    }, { once: true });
  });
  bar.addEventListener("keydown", ({ key }) => {
    const by = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[key];
    if (by !== undefined) move(now + by * STEP);
  });
  bar.addEventListener("dblclick", () => move(usual));
  return bar;
}

/** The buttons that lead to the pages of a phone. */
function pages(main: HTMLElement): void {
  const buttons = PAGES.map(([id, say, area]) => h("button", { type: "button", id, "data-say": say, "aria-pressed": "false",
    click: () => turnTo(byId(area)) }));
  byId("pages").append(...buttons);
  const mark = (): void => {
    const at = Math.round(main.scrollLeft / Math.max(main.clientWidth, 1));
    buttons.forEach((button, index) => button.setAttribute("aria-pressed", String(index === at)));
  };
  main.addEventListener("scroll", mark);
  mark();
}
