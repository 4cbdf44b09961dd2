// The examples: each program once, opened in the language that one chooses.

import type { Text } from "../tools/answers";
import { say, told } from "../words/words";
import { stemOf } from "./document";
import { h } from "./dom";
import { fetched } from "./fetched";

interface Example extends Text {
  readonly about: { readonly en: string; readonly pt: string };
}

/** Shows them all; a click opens one. */
export async function showExamples(open: (text: Text) => void): Promise<void> {
  const all = await fetched<Example>("examples.json");
  if (!all) return;
  const close = h("button", { type: "button", class: "quiet", "aria-label": say("close"), click: () => shown.close() }, "×");
  const stems = [...new Set(all.map(({ name }) => stemOf(name)))];
  const cards = stems.map((stem) => [stem, all.filter(({ name }) => stemOf(name) === stem)] as const).map(([stem, languages]) => h("li", { class: "gallery-card" }, h("h3", {}, stem), h("p", { class: "note" }, told(languages[0]?.about ?? { en: "", pt: "" })),
    h("div", { class: "row" }, ...languages.map(({ name, text }) => h("button", { type: "button", "data-example": name, "aria-label": name, click: () => {
      shown.close();
      open({ name, text });
    } }, name.slice(stem.length + 1).toUpperCase())))));
  const shown = h("dialog", { id: "examples-list", class: "gallery", "aria-label": say("examples") },
    h("div", { class: "row gallery-head" }, h("h2", {}, say("examples")), h("span", { style: "flex:1" }), close), h("ul", { class: "gallery-cards" }, ...cards));
  shown.addEventListener("close", () => shown.remove());
  shown.addEventListener("click", (event) => {
    if (event.target === shown) shown.close();
  });
  document.body.append(shown);
  shown.showModal();
}
