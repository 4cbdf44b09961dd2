// Light or dark, as the person wants it; until then as the computer has it.

import { h } from "./dom";
import { keep, kept } from "./kept";

/** The button that changes it. */
export function theme(): HTMLElement {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const chosen = kept("theme");
  const set = (is: boolean): void => {
    document.documentElement.dataset["theme"] = is ? "dark" : "light";
    document.documentElement.style.colorScheme = is ? "dark" : "light";
  };
  set(chosen ? chosen === "dark" : dark.matches);
  dark.addEventListener("change", () => {
    if (!kept("theme")) set(dark.matches);
  });
  return h("button", {
    type: "button", id: "theme", "data-say": "theme",
    click: () => {
      const is = document.documentElement.dataset["theme"] !== "dark";
      keep("theme", is ? "dark" : "light");
      set(is);
    },
  });
}
