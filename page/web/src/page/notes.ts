// What the person should know now: seen in a corner, heard by a screen reader.

import { say, speak } from "../words/words";
import { byId, h } from "./dom";

const LASTS = 8000;
/** What was announced last stays for those who read more slowly than it comes. */
const SAID = 3;

/** A text in the language of now. */
type Say = () => string;

/** Something that a note offers to do. */
export interface Offer {
  readonly text: Say;
  take(): void;
}

/** What says each note that is shown again, in another language. */
const shown = new Map<Element, () => void>();
speak.follow(() => {
  for (const again of shown.values()) again();
});

/** Shows a note, and what it offers, for a while, which begins again with each step by keyboard: who goes to it so gets there;
 * one without which the page is of no use stays. One that says the same takes the place of the older. */
export function note(text: Say, offer?: Offer, stays = false): void {
  const notes = byId("notes");
  const remove = (one: Element | null): void => {
    if (!one) return;
    one.remove();
    shown.delete(one);
  };
  const close = (): void => remove(own);
  const said = h("span", {});
  const offered = offer ? h("button", { type: "button", click: () => { close(); offer.take(); } }) : null;
  const away = h("button", { type: "button", click: close }, "×");
  const own = h("div", {}, said, offered, away);
  const again = (): void => {
    said.textContent = text();
    if (offer && offered) offered.textContent = offer.text();
    away.setAttribute("aria-label", say("close"));
  };
  again();
  for (const other of [...notes.children]) if (other.firstElementChild?.textContent === said.textContent) remove(other);
  while (notes.children.length > 2) remove(notes.firstElementChild);
  notes.append(own);
  shown.set(own, again);
  if (stays) return;
  let ends = setTimeout(close, LASTS);
  const step = ({ key }: KeyboardEvent): void => {
    if (!own.isConnected) document.removeEventListener("keydown", step);
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
