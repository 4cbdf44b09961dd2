// The palette: a click inserts an element at the cursor, a drag carries it to a place of the sheet.

import type { Shelf } from "../../tools/answers";
import { speak, told } from "../../words/words";
import { say } from "../../words/draw";
import { h } from "../dom";
import { type Carried, carry } from "./carrying";

/** What the palette tells. */
export interface Chosen {
  insert(what: string): void;
  carried: Carried;
}

export function palette(shelves: readonly Shelf[], chosen: Chosen): HTMLElement {
  const root = h("div", { class: "palette", role: "toolbar", "data-say-label": "palette" });
  const button = (item: Shelf["items"][number]): HTMLElement => {
    const name = told(item.name);
    const title = item.key ? `${name} (${item.key.toUpperCase()})` : name;
    const one = h("button", { type: "button", "data-what": item.id, title }, h("span", { "aria-hidden": "true", class: isBox(item.face) ? "boxed" : "" }, item.face), h("span", { class: "hidden" }, name));
    carry(one, () => item.face, { click: () => chosen.insert(item.id), drop: (at, place) => chosen.carried.put(item.id, at, place) }, chosen.carried);
    return one;
  };
  speak.follow(() => {
    const groups = shelves.slice(0, -1).map((shelf) => h("div", { class: "shelf", role: "group", "aria-label": told(shelf.name) },
      h("span", { class: "shelf-name" }, told(shelf.name)), ...shelf.items.map(button)));
    const others = h("select", { id: "palette-others", "aria-label": say("paletteOthers") }, h("option", { value: "" }, say("paletteOthers")),
      ...(shelves.at(-1)?.items ?? []).map((item) => h("option", { value: item.id }, told(item.name))));
    others.addEventListener("change", () => {
      if (others.value) chosen.insert(others.value);
      others.value = "";
    });
    root.replaceChildren(...groups, others);
    root.setAttribute("aria-label", say("palette"));
  });
  return root;
}

/** Whether an element is drawn as a box: of a contact or a coil its face has the signs. */
function isBox(face: string): boolean {
  return !/[┤├()]/.test(face);
}
