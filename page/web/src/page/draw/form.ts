// The small form at an element: its address, name, preset; of a rung its comment.

import type { Act, Drawn } from "../../tools/answers";
import { say } from "../../words/draw";
import { told } from "../../words/words";
import type { Refusal } from "../../tools/tools";
import { h } from "../dom";
import { clear, show } from "./wrong";

/** Opens the form at a place of the window; settled when it is closed. It stays, with what was typed, until that is done. */
export function ask(over: HTMLElement, drawn: Drawn, at: DOMRect | null, attempt: (act: Act) => Promise<Refusal | null>): Promise<void> {
  const { what, fields, comment } = drawn.at;
  const inputs = fields.map((field) => {
    const input = h("input", { id: `field-${field.key}`, type: "text", value: field.value, autocomplete: "off", spellcheck: "false",
      inputmode: field.kind === "number" ? "numeric" : "text" });
    const chips = field.kind === "point" || field.kind === "value" ? chipsOf(drawn, input) : null;
    return { field, input, chips };
  });
  const text = h("textarea", { id: "field-comment", rows: 3 }, comment);
  const rows = what === "element"
    ? inputs.map(({ field, input, chips }) => h("div", { class: "field" }, h("label", {}, h("span", {}, told(field.name)), input), chips))
    : [h("label", {}, h("span", {}, say("rungComment")), text)];
  const form = h("form", { class: "at-element", "aria-label": told(drawn.at.say) }, ...rows,
    h("div", { class: "row" }, h("button", { type: "submit", class: "primary" }, say("ok")), h("button", { type: "button", id: "form-cancel" }, say("cancel"))));
  over.querySelector(".at-element")?.remove();
  over.append(form);
  const within = (): void => {
    const box = over.getBoundingClientRect();
    if (!at) return;
    form.style.left = `${Math.max(4, Math.min(at.left - box.left, box.width - form.offsetWidth - 4))}px`;
    form.style.top = `${Math.max(4, Math.min(at.bottom - box.top + 4, box.height - form.offsetHeight - 4))}px`;
  };
  within();
  const first = form.querySelector<HTMLInputElement | HTMLTextAreaElement>("input, textarea");
  first?.focus();
  first?.select();
  return new Promise((resolve) => {
    const end = (): void => {
      form.remove();
      resolve();
    };
    const fields = { form, inputs: new Map(inputs.map(({ field, input }) => [field.key, input])) };
    const send = async (sure: boolean): Promise<void> => {
      const edit = { do: "edit", fields: inputs.map(({ field, input }) => ({ key: field.key, value: input.value })), ...(sure && { sure }) } as const;
      const refused = await attempt(what === "element" ? edit : { do: "comment", text: text.value });
      if (!refused) return end();
      show(fields, refused.both, (sure) => void send(sure));
      within();
    };
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void send(false);
    });
    form.addEventListener("input", () => clear(fields));
    form.querySelector("#form-cancel")?.addEventListener("click", end);
    form.addEventListener("keydown", (event) => {
      if (event.key === "Escape") end();
      // A comment may have several lines.
      if (event.key === "Enter" && event.target === text && !event.shiftKey) {
        event.preventDefault();
        form.requestSubmit();
      }
      event.stopPropagation();
    });
  });
}

/** The points that have names: those that go with what is typed; a click takes one. */
function chipsOf({ table }: Drawn, input: HTMLInputElement): HTMLElement {
  const root = h("div", { class: "chips", role: "group", "aria-label": say("knownPoints") });
  const take = (value: string) => (): void => {
    input.value = value;
    input.dispatchEvent(new Event("input", { bubbles: true }));
    input.focus();
  };
  const show = (): void => {
    const typed = input.value === input.defaultValue ? "" : input.value.trim().toLowerCase();
    const fit = table.filter(({ point, name }) => name && `${point} ${name}`.toLowerCase().includes(typed) && name !== input.value);
    root.replaceChildren(...fit.map(({ point, name }) => h("button", { type: "button", "data-chip": name, tabindex: -1, click: take(name) }, `${name} ${point}`)));
    root.hidden = fit.length === 0;
  };
  input.addEventListener("input", show);
  show();
  return root;
}
