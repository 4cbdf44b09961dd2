// A button that opens a list of others.

import { type PlainKey, say, translate } from "../words/words";
import { h } from "./dom";
import { icon } from "./icons";

/** A row of a menu: a command by its words, a control of its own, or a line between two groups. */
export type Row = Command | HTMLElement | "line";
export interface Command {
  readonly id: string;
  readonly say: PlainKey;
  act(): void;
  /** Where it says so, the row is shown only then. */
  when?(): boolean;
}

/** The elements of rows: those that are not for now are left out. */
export function elementsOf(rows: readonly Row[]): HTMLElement[] {
  return rows.flatMap((row) => {
    if (row === "line") return [h("hr")];
    if (row instanceof HTMLElement) return [row];
    return row.when?.() === false ? [] : [entry(say(row.say), () => row.act(), "", row.id)];
  });
}

/** A menu under words of a table; its entries are made each time that it opens. */
export function menu(key: string, picture: Parameters<typeof icon>[0] | null, entries: () => HTMLElement[]): HTMLElement {
  const list = h("div", { hidden: true });
  const button = h("button", { type: "button", "aria-haspopup": "true", "aria-expanded": "false", id: `menu-${key}` }, picture && icon(picture), h("span", { "data-say": key }));
  const root = h("div", { class: "menu" }, button, list);
  const open = (opens: boolean): void => {
    list.hidden = !opens;
    button.setAttribute("aria-expanded", String(opens));
    if (opens) {
      list.replaceChildren(...entries());
      translate(list);
      list.querySelector<HTMLButtonElement>("button:enabled:not([hidden])")?.focus();
    }
  };
  button.addEventListener("click", () => {
    const opens = list.hidden;
    open(opens);
    place(list, null);
  });
  root.addEventListener("open-at", (event) => {
    open(true);
    place(list, (event as CustomEvent<At>).detail);
  });
  list.addEventListener("click", (event) => {
    if (!(event.target as Element).closest("button")) return;
    open(false);
    // What was done may have taken the focus somewhere.
    const now = document.activeElement;
    if (!now || now === document.body || list.contains(now)) button.focus();
  });
  root.addEventListener("keydown", (event) => {
    const buttons = [...list.querySelectorAll<HTMLButtonElement>("button:enabled")].filter((one) => one.offsetParent !== null);
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape" && !list.hidden) {
      open(false);
      button.focus();
    } else if ((event.key === "ArrowDown" || event.key === "ArrowUp") && !(event.target as Element).matches("select, input")) {
      event.preventDefault();
      buttons[(at + (event.key === "ArrowDown" ? 1 : -1) + buttons.length) % buttons.length]?.focus();
    }
  });
  document.addEventListener("pointerdown", (event) => {
    if (!root.contains(event.target as Node)) open(false);
  });
  return root;
}

/** A point of the window. */
export interface At {
  readonly x: number;
  readonly y: number;
}

/** Opens a menu at a point of the window. */
export function openAt(menu: HTMLElement, at: At): void {
  menu.dispatchEvent(new CustomEvent<At>("open-at", { detail: at }));
}

/** Puts an open list where it is wanted, all of it in the window; null: under its button. */
function place(list: HTMLElement, at: At | null): void {
  list.classList.toggle("at-point", at !== null);
  const within = (wanted: number, size: number, room: number): number => Math.max(4, Math.min(wanted, room - size - 4));
  list.style.left = at ? `${within(at.x, list.offsetWidth, innerWidth)}px` : "";
  list.style.top = at ? `${within(at.y, list.offsetHeight, innerHeight)}px` : "";
  if (at || list.hidden) return;
  const { left } = list.getBoundingClientRect();
  // A list that hangs over widens what the window counts on a phone.
  if (getComputedStyle(list.parentElement ?? list).position === "static") return;
  list.style.left = `${within(left, list.offsetWidth, document.documentElement.clientWidth) - left}px`;
}

/** An entry of a menu. */
export function entry(text: string, click: () => void, about = "", id = ""): HTMLElement {
  const one = h("button", { type: "button", click }, h("span", {}, text, about ? h("small", { class: "note" }, ` – ${about}`) : null));
  if (id) one.id = id;
  return one;
}
