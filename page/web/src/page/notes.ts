// What the person should know now: seen in a corner, heard by a screen reader.

import { say } from "../words/words";
import { byId, h } from "./dom";

const LASTS = 9000;
/** What was announced last stays for those who read more slowly than it comes. */
const SAID = 3;

/** Shows a note for a while; what it offers stays until it is taken or closed. */
export function note(text: string, offer?: { readonly text: string; take(): void }): void {
  const notes = byId("notes");
  const close = (): void => shown.remove();
  const shown = h("div", {}, h("span", {}, text),
    offer ? h("button", { type: "button", click: () => { offer.take(); close(); } }, offer.text) : null,
    h("button", { type: "button", "aria-label": say("close"), click: close }, "×"));
  while (notes.children.length > 2) notes.firstElementChild?.remove();
  notes.append(shown);
  if (!offer) setTimeout(close, LASTS);
}

/** Has a screen reader say it, even if it has just said the same. */
export function announce(text: string): void {
  const live = byId("live");
  live.append(h("p", {}, text));
  while (live.children.length > SAID) live.firstElementChild?.remove();
}
