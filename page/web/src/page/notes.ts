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

/** Shows a note, and what it offers, for a while, which begins again with each step by keyboard: who goes to it so gets there;
 * one without which the page is of no use stays. One that says the same takes the place of the older. */
export function note(text: string, offer?: Offer, stays = false): void {
  const notes = byId("notes");
  const close = (): void => shown.remove();
  const shown = h("div", {}, h("span", {}, text),
    offer ? h("button", { type: "button", click: () => { close(); offer.take(); } }, offer.text) : null,
    h("button", { type: "button", "aria-label": say("close"), click: close }, "×"));
  for (const other of [...notes.children]) if (other.firstElementChild?.textContent === text) other.remove();
  while (notes.children.length > 2) notes.firstElementChild?.remove();
  notes.append(shown);
  if (stays) return;
  let ends = setTimeout(close, LASTS);
  const step = ({ key }: KeyboardEvent): void => {
    if (!shown.isConnected) document.removeEventListener("keydown", step);
    else if (key === "Tab") {
      clearTimeout(ends);
      ends = setTimeout(close, LASTS);
    }
  };
  document.addEventListener("keydown", step);
}

/** Has a screen reader say it, even if it has just said the same. */
export function announce(text: string): void {
  const live = byId("live");
  live.append(h("p", {}, text));
  while (live.children.length > SAID) live.firstElementChild?.remove();
}
