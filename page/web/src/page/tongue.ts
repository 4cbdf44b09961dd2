// The language of the page, as the person chooses it.

import { setSpeak, speak } from "../words/words";
import { h } from "./dom";

/** The list that changes it. */
export function tongue(): HTMLSelectElement {
  const list = h("select", { id: "speak", "data-say-label": "language" }, h("option", { value: "en", lang: "en" }, "English"), h("option", { value: "pt", lang: "pt-BR" }, "Português"));
  list.addEventListener("change", () => setSpeak(list.value === "pt" ? "pt" : "en"));
  speak.follow((language) => {
    list.value = language;
  });
  return list;
}
