// The symbol table: what the points are called and what they are for.

import type { Act, Drawn } from "../../tools/answers";
import { say } from "../../words/draw";
import type { Refusal } from "../../tools/tools";
import { h } from "../dom";
import { dialog } from "./panels";
import { clear, show as showWrong } from "./wrong";

type Rows = Drawn["table"];

/** Opens the table; each change is one of the drawing. */
export function symbols(rows: () => Rows, attempt: (act: Act) => Promise<Refusal | null>): void {
  const body = h("tbody");
  const show = (): void => {
    const line = ({ point, name, comment }: Rows[number]): HTMLElement => {
      const called = h("input", { type: "text", value: name, "aria-label": `${say("symbolName")} ${point}` });
      const about = h("input", { type: "text", value: comment, "aria-label": `${say("symbolComment")} ${point}` });
      const form = h("form", { class: "row" }, called);
      const fields = { form, inputs: new Map([["name", called]]) };
      const change = async (): Promise<void> => {
        clear(fields);
        const refused = await attempt({ do: "name", point, name: called.value.trim(), comment: about.value, sure: true });
        if (refused) showWrong(fields, { ...refused.both, field: "name" }, () => undefined);
      };
      form.addEventListener("submit", (event) => event.preventDefault());
      called.addEventListener("change", () => void change());
      about.addEventListener("change", () => void change());
      return h("tr", { "data-point": point }, h("td", {}, point), h("td", {}, form), h("td", {}, about));
    };
    const all = rows().map(line);
    body.replaceChildren(...(all.length > 0 ? all : [h("tr", {}, h("td", { colspan: 3, class: "note" }, say("symbolsNone")))]));
  };
  const point = h("input", { type: "text", id: "symbol-point", size: 5, "aria-label": say("symbolPoint"), placeholder: "I1" });
  const name = h("input", { type: "text", id: "symbol-name", "aria-label": say("symbolName"), placeholder: say("symbolName") });
  const comment = h("input", { type: "text", id: "symbol-comment", "aria-label": say("symbolComment"), placeholder: say("symbolComment") });
  const add = h("form", { class: "row" }, point, name, comment, h("button", { type: "submit" }, say("symbolAdd")));
  const fields = { form: add, inputs: new Map([["point", point], ["name", name]]) };
  const send = async (sure: boolean): Promise<void> => {
    clear(fields);
    // What is offered for a point may name it too.
    const [first = "", ...called] = point.value.trim().split(/\s+/);
    const refused = await attempt({ do: "name", point: first, name: name.value.trim() || called.join(" "), comment: comment.value, ...(sure && { sure }) });
    if (refused) return showWrong(fields, { field: "name", ...refused.both }, (sure) => void send(sure));
    [point, name, comment].forEach((input) => (input.value = ""));
    show();
    point.focus();
  };
  add.addEventListener("submit", (event) => {
    event.preventDefault();
    void send(false);
  });
  show();
  const head = h("tr", {}, ...(["symbolPoint", "symbolName", "symbolComment"] as const).map((key) => h("th", {}, say(key))));
  dialog("symbols", say("symbols"), h("table", {}, h("thead", {}, head), body), add);
}
