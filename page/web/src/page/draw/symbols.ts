// The symbol table: what the points are called and what they are for.

import type { Act, Drawn } from "../../tools/answers";
import { say } from "../../words/draw";
import { h } from "../dom";
import { dialog } from "./panels";

type Rows = Drawn["table"];

/** Opens the table; each change is one of the drawing. */
export function symbols(rows: () => Rows, act: (act: Act) => Promise<boolean>): void {
  const body = h("tbody");
  const show = (): void => {
    const line = ({ point, name, comment }: Rows[number]): HTMLElement => {
      const called = h("input", { type: "text", value: name, "aria-label": `${say("symbolName")} ${point}` });
      const about = h("input", { type: "text", value: comment, "aria-label": `${say("symbolComment")} ${point}` });
      const change = (): void => void act({ do: "name", point, name: called.value.trim(), comment: about.value }).then((done) => !done && show());
      called.addEventListener("change", change);
      about.addEventListener("change", change);
      return h("tr", { "data-point": point }, h("td", {}, point), h("td", {}, called), h("td", {}, about));
    };
    const all = rows().map(line);
    body.replaceChildren(...(all.length > 0 ? all : [h("tr", {}, h("td", { colspan: 3, class: "note" }, say("symbolsNone")))]));
  };
  const point = h("input", { type: "text", id: "symbol-point", size: 5, "aria-label": say("symbolPoint"), placeholder: "I1" });
  const name = h("input", { type: "text", id: "symbol-name", "aria-label": say("symbolName"), placeholder: say("symbolName") });
  const comment = h("input", { type: "text", id: "symbol-comment", "aria-label": say("symbolComment"), placeholder: say("symbolComment") });
  const add = h("form", { class: "row" }, point, name, comment, h("button", { type: "submit" }, say("symbolAdd")));
  add.addEventListener("submit", (event) => {
    event.preventDefault();
    void act({ do: "name", point: point.value.trim(), name: name.value.trim(), comment: comment.value }).then((done) => {
      if (done) [point, name, comment].forEach((input) => (input.value = ""));
      show();
      point.focus();
    });
  });
  show();
  const head = h("tr", {}, ...(["symbolPoint", "symbolName", "symbolComment"] as const).map((key) => h("th", {}, say(key))));
  dialog("symbols", say("symbols"), h("table", {}, h("thead", {}, head), body), add);
}
