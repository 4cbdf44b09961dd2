// The first visit: a sentence that says what this is, a program that runs with something to press, and three doors. Who has been
// here finds what they left, and a link what it holds.

import { translate } from "../words/words";
import type { Bench } from "./bench";
import { byId, h } from "./dom";
import { keep, kept } from "./kept";
import { keptHere } from "./place";
import { sharedToken } from "./shared";

const KEY = "greeted";

/** Whether nobody has been here before; to be asked before anything is kept. */
export function isFirstVisit(): boolean {
  return kept(KEY) !== "yes" && keptHere("program") === null && location.hash === "" && sharedToken() === null;
}

/** What the doors lead to. */
export interface Doors {
  draw(): void;
  exercises(): void;
  examples(): void;
}

/** Shows the sentence and the doors; it has its place before anything else is seen. */
export function greet(doors: Doors): void {
  const root = byId("welcome");
  const away = (): void => {
    keep(KEY, "yes");
    root.hidden = true;
  };
  const door = (id: keyof Doors, key: string): HTMLElement => h("button", { type: "button", id: `door-${id}`, class: id === "draw" ? "primary" : "", "data-say": key, click: () => {
    away();
    doors[id]();
  } });
  root.append(h("p", { "data-say": "welcome" }), door("draw", "doorDraw"), door("exercises", "exercises"), door("examples", "examples"),
    h("button", { type: "button", class: "quiet", id: "welcome-close", "data-say-label": "close", click: away }, "×"));
  translate(root);
  root.hidden = false;
}

/** Runs the program that the page begins with as soon as the board answers, unless somebody has changed it meanwhile. */
export async function begin(bench: Bench, isUntouched: () => boolean, run: () => Promise<void>): Promise<void> {
  await bench.answers();
  if (isUntouched()) await run();
}
