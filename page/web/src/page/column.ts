// The column beside the program, in which one learns: it is there while a step or an exercise is open.

import { byId } from "./dom";

/** Shows the column, or takes it away, by what is in it. */
export function showColumn(): void {
  const isEmpty = [...byId("learn").querySelectorAll<HTMLElement>(".lesson")].every((one) => one.hidden);
  byId("learn").hidden = isEmpty;
  byId("main").classList.toggle("learning", !isEmpty);
}
