// The language of the page, and its texts.

import type { Both, Speak } from "../tools/answers";
import { keep, kept } from "../page/kept";
import { Signal } from "../page/signal";
import { type Key, TABLE } from "./table";

/** The language that is spoken: that of the browser, until a person changes it. */
export const speak = new Signal<Speak>(begin());

function begin(): Speak {
  const chosen = kept("speak");
  if (chosen === "en" || chosen === "pt") return chosen;
  return navigator.language.toLowerCase().startsWith("pt") ? "pt" : "en";
}

export function setSpeak(language: Speak): void {
  keep("speak", language);
  speak.value = language;
}

/** A text, with its `{values}` put in. */
export function say(key: Key, values: Readonly<Record<string, string | number>> = {}): string {
  const text: string = TABLE[key][speak.value === "pt" ? 1 : 0];
  return text.replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}

/** What Rust has said in both languages. */
export function told(both: Both): string {
  return both[speak.value];
}

/** Keeps a part of the page in the language that is spoken: `data-say` for its text, `data-say-label` for its name,
 * `data-say-title` for its hint. */
export function speakIn(root: ParentNode): void {
  speak.follow((language) => {
    document.documentElement.lang = language === "pt" ? "pt-BR" : "en";
    translate(root);
  });
}

/** Puts the texts of elements that name one into the language that is spoken. */
export function translate(root: ParentNode): void {
  for (const element of root.querySelectorAll<HTMLElement>("[data-say]")) {
    element.textContent = say(element.dataset["say"] as Key);
  }
  for (const element of root.querySelectorAll<HTMLElement>("[data-say-title]")) element.title = say(element.dataset["sayTitle"] as Key);
  for (const element of root.querySelectorAll<HTMLElement>("[data-say-label]")) {
    const label = say(element.dataset["sayLabel"] as Key);
    element.setAttribute("aria-label", label);
    element.title = label;
  }
}
