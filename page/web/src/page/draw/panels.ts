// What opens over the page: all keys, and the drawing as text.

import type { Shelf } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { Refusal } from "../../tools/tools";
import { say } from "../../words/draw";
import { say as sayPage, speak, told } from "../../words/words";
import { h } from "../dom";
import { ACTIONS } from "./actions";

/** A listing is as wide where it can be. */
const COLUMNS = 96;

/** Opens a dialog; it is gone when it is closed. */
export function dialog(id: string, title: string, ...content: (Node | string)[]): HTMLDialogElement {
  const close = h("button", { type: "button", class: "quiet", "aria-label": sayPage("close") }, "×");
  const shown = h("dialog", { id, class: "panel", "aria-label": title }, h("header", {}, h("h3", {}, title), close), ...content);
  close.addEventListener("click", () => shown.close());
  shown.addEventListener("close", () => shown.remove());
  shown.addEventListener("keydown", (event) => event.stopPropagation());
  document.body.append(shown);
  shown.showModal();
  return shown;
}

/** Shows all keys. */
export function help(shelves: readonly Shelf[]): void {
  const row = (key: string, text: string): HTMLElement => h("tr", {}, h("td", {}, h("kbd", {}, key)), h("td", {}, text));
  const elements = shelves.flatMap((shelf) => shelf.items).filter((item) => item.key !== "").map((item) => row(item.key.toUpperCase(), told(item.name)));
  const actions = ACTIONS.map((action) => row(action.key.length === 1 ? action.key.toUpperCase() : action.key, say(action.say)));
  dialog("keys", say("keys"), h("div", { class: "columns", tabindex: 0, role: "region", "aria-label": say("keys") },
    h("section", {}, h("h4", {}, say("keysElements")), h("p", { class: "note" }, say("keysShift")), h("table", {}, h("tbody", {}, ...elements))),
    h("section", {}, h("h4", {}, say("keysActions")), h("table", {}, h("tbody", {}, ...actions)))));
}

/** Shows the drawing as text. */
export async function texts(tools: RemoteTools): Promise<void> {
  const text = h("pre", { tabindex: 0 });
  const form = h("select", { "aria-label": say("asText") }, h("option", { value: "il" }, say("asIl")), h("option", { value: "numeric" }, say("asNumeric")), h("option", { value: "st" }, say("asSt")));
  const show = async (): Promise<void> => {
    try {
      const drawn = await tools.ask("drawn", { as: form.value === "numeric" ? "numeric" : "il" });
      const as = { as: "st", width: COLUMNS, speak: speak.value } as const;
      text.textContent = form.value === "st" ? await tools.ask("list", { of: { name: "drawing.il", text: drawn }, ...as }) : drawn;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      text.textContent = told(error.both);
    }
  };
  form.addEventListener("change", () => void show());
  await show();
  dialog("texts", say("asText"), form, text);
}
