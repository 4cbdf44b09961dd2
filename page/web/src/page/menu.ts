// A button that opens a list of others.

import { h } from "./dom";
import { icon } from "./icons";

/** A menu under words of a table; its entries are made each time that it opens. */
export function menu(key: string, picture: Parameters<typeof icon>[0], entries: () => HTMLElement[]): HTMLElement {
  const list = h("div", { hidden: true });
  const button = h("button", { type: "button", "aria-haspopup": "true", "aria-expanded": "false", id: `menu-${key}` }, icon(picture), h("span", { "data-say": key }));
  const root = h("div", { class: "menu" }, button, list);
  const open = (opens: boolean): void => {
    list.hidden = !opens;
    button.setAttribute("aria-expanded", String(opens));
    if (opens) {
      list.replaceChildren(...entries());
      list.querySelector("button")?.focus();
    }
  };
  button.addEventListener("click", () => open(list.hidden));
  list.addEventListener("click", (event) => {
    if ((event.target as Element).closest("button")) open(false);
  });
  root.addEventListener("keydown", (event) => {
    const buttons = [...list.querySelectorAll("button")];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape" && !list.hidden) {
      open(false);
      button.focus();
    } else if (event.key === "ArrowDown" || event.key === "ArrowUp") {
      event.preventDefault();
      buttons[(at + (event.key === "ArrowDown" ? 1 : -1) + buttons.length) % buttons.length]?.focus();
    }
  });
  document.addEventListener("pointerdown", (event) => {
    if (!root.contains(event.target as Node)) open(false);
  });
  return root;
}

/** An entry of a menu. */
export function entry(text: string, click: () => void, about = ""): HTMLElement {
  return h("button", { type: "button", click }, h("span", {}, text, about ? h("small", { class: "note" }, ` – ${about}`) : null));
}
