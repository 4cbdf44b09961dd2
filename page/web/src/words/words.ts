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

type Values = Readonly<Record<string, string | number>>;
type Rows = Readonly<Record<string, readonly [string, string]>>;

/** The names of the `{values}` of a text. */
type Places<Text extends string> = Text extends `${string}{${infer Place}}${infer Rest}` ? Place | Places<Rest> : never;
type PlacesOf<T extends Rows, K extends keyof T> = Places<T[K][0]>;
/** What is said with one of these texts: a value for each of its places, nothing where it has none. */
type With<T extends Rows, K extends keyof T> = [PlacesOf<T, K>] extends [never] ? [] : [values: Readonly<Record<PlacesOf<T, K>, string | number>>];
/** The texts of a table that are said as they are. */
export type Plain<T extends Rows> = { [K in keyof T & string]: [PlacesOf<T, K>] extends [never] ? K : never }[keyof T & string];
export type PlainKey = Plain<typeof TABLE>;

/** Those of `TABLE`, and of the tables that were loaded later. */
const rows: Record<string, readonly [string, string]> = { ...TABLE };

/** A text, with its `{values}` put in. */
export function say<K extends Key>(key: K, ...[values]: With<typeof TABLE, K>): string {
  return text(key, values);
}

/** A text in both languages. */
export function both(key: Key): Both {
  const [en, pt] = TABLE[key];
  return { en, pt };
}

/** What says the texts of a table of its own, which is loaded with a part of the page. */
export function sayFrom<T extends Rows>(table: T): <K extends keyof T & string>(key: K, ...values: With<T, K>) => string {
  Object.assign(rows, table);
  return (key, ...[values]) => text(key, values);
}

function text(key: string, values: Values = {}): string {
  const text = rows[key]?.[speak.value === "pt" ? 1 : 0] ?? "";
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
    element.textContent = text(element.dataset["say"] ?? "");
  }
  for (const element of root.querySelectorAll<HTMLElement>("[data-say-title]")) element.title = text(element.dataset["sayTitle"] ?? "");
  for (const element of root.querySelectorAll<HTMLElement>("[data-say-label]")) {
    const label = text(element.dataset["sayLabel"] ?? "");
    element.setAttribute("aria-label", label);
    element.title = label;
  }
}
