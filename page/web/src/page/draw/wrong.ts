// What is wrong with a field of a form: told beside it, with what could stand there instead.

import type { Wrong } from "../../tools/answers";
import { told } from "../../words/words";
import { h } from "../dom";
import { announce } from "../notes";

/** A form with its fields by their keys. */
export interface Fields {
  readonly form: HTMLFormElement;
  readonly inputs: ReadonlyMap<string, HTMLInputElement>;
}

/** Takes back what was told. */
export function clear({ form }: Fields): void {
  for (const told of form.querySelectorAll(".field-wrong")) told.remove();
  for (const input of form.querySelectorAll("[aria-invalid]")) {
    input.removeAttribute("aria-invalid");
    input.removeAttribute("aria-describedby");
  }
}

/** Tells what is wrong beside its field, or above the buttons; an offer that is taken is sent. */
export function show(fields: Fields, wrong: Wrong, send: (sure: boolean) => void): void {
  clear(fields);
  const { form, inputs } = fields;
  const input = inputs.get(wrong.field ?? "");
  const offers = (wrong.offers ?? []).map((offer) => h("button", {
    type: "button", "data-offer": offer.value,
    click: () => {
      if (input) input.value = offer.value;
      send(offer.sure);
    },
  }, told(offer.say)));
  const id = `${input?.id ?? form.id}-wrong`;
  const text = h("p", { class: "field-wrong", id }, told(wrong), ...offers);
  announce(told(wrong));
  if (!input) return form.lastElementChild?.before(text);
  input.setAttribute("aria-invalid", "true");
  input.setAttribute("aria-describedby", id);
  (input.closest("label") ?? input).after(text);
  input.focus();
  input.select();
}
