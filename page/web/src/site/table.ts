// A table that a screen of a site fills, and saves as a file.

import { h } from "../page/dom";
import { download } from "../page/files";
import { say } from "../words/site";
import { askFile, whyOf } from "./ask";
import { refused } from "./told";

type Cell = Node | string | null;

/** Rows under these heads; on a phone each cell says its head. */
export function table(label: string, heads: readonly string[], rows: readonly (readonly Cell[])[]): HTMLElement {
  const cell = (of: Cell, at: number): HTMLElement => h("td", { "data-head": heads[at] ?? "" }, of);
  return h("div", { class: "sheet table", tabindex: "0", role: "region", "aria-label": label },
    h("table", {},
      h("thead", {}, h("tr", {}, ...heads.map((head) => h("th", { scope: "col" }, head)))),
      h("tbody", {}, ...rows.map((row) => h("tr", {}, ...row.map(cell))))));
}

/** The button that saves what the gateway answers there. */
export function saves(path: string, name: string): HTMLElement {
  const save = async (): Promise<void> => {
    try {
      download(name, await askFile(path), "text/csv");
    } catch (error) {
      refused(whyOf(error));
    }
  };
  return h("button", { type: "button", class: "small", click: () => void save() }, say("tableCsv"));
}
