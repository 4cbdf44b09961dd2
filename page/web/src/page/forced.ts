// What is forced, marked at a button or a lamp.

import { say } from "../words/words";

/** Marks what the point of a place is forced to; undefined: it is not. */
export function markForced(place: HTMLElement, to: boolean | undefined): void {
  place.classList.toggle("is-forced", to !== undefined);
  const mark = place.querySelector(".forced-mark");
  if (mark) mark.textContent = to === undefined ? "" : `${say("forced")} ${Number(to)}`;
}
