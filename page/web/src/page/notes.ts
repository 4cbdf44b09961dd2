// What the person should know now: seen in a corner, heard by a screen reader.

import { say } from "../words/words";
import { byId, h } from "./dom";

const LASTS = 8000;
/** What was announced last stays for those who read more slowly than it comes. */
const SAID = 3;

/** Something that a note offers to do. */
export interface Offer {
  readonly text: string;
  take(): void;
}

/** Shows a note, and what it offers, for a while; one without which the page is of no use stays. */
export function note(text: string, offer?: Offer, stays = false): void {
  const notes = byId("notes");
  const close = (): void => shown.remove();
  const shown = h("div", {}, h("span", {}, text),
    offer ? h("button", { type: "button", click: () => { close(); offer.take(); } }, offer.text) : null,
    h("button", { type: "button", "aria-label": say("close"), click: close }, "×"));
  while (notes.children.length > 2) notes.firstElementChild?.remove();
  notes.append(shown);
  if (!stays) setTimeout(close, LASTS);
}

/** Has a screen reader say it, even if it has just said the same. */
export function announce(text: string): void {
  const live = byId("live");
  live.append(h("p", {}, text));
  while (live.children.length > SAID) live.firstElementChild?.remove();
}
