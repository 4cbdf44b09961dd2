// The examples: each program once, with the picture of its ladder, opened in the language that one chooses.

import type { Both, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { say, told } from "../words/words";
import { stemOf } from "./document";
import { h } from "./dom";
import { fetched } from "./fetched";
import { picture } from "./picture";

interface Example extends Text {
  readonly about: Both;
}

/** Shows them all; a click opens one. */
export async function showExamples(tools: RemoteTools, open: (text: Text) => void): Promise<void> {
  const all = await fetched<Example>("examples.json");
  if (!all) return;
  const dialog = h("dialog", { id: "examples-list", class: "gallery", "aria-labelledby": "example-title", close: () => dialog.remove() });
  const choose = (example: Example): void => {
    dialog.close();
    open({ name: example.name, text: example.text });
  };
  dialog.append(
    h("div", { class: "row gallery-head" }, h("h2", { id: "example-title" }, say("examples")), h("span", { style: "flex:1" }),
      h("button", { type: "button", class: "quiet", "aria-label": say("close"), click: () => dialog.close() }, "×")),
    h("ul", { class: "gallery-cards" }, ...programs(all).map((languages) => card(tools, languages, choose))));
  // A click beside it closes it.
  dialog.addEventListener("click", (event) => {
    if (event.target === dialog) dialog.close();
  });
  document.body.append(dialog);
  dialog.showModal();
}

/** The same program in its languages. Two programs may have one name: what they do tells them apart. */
function programs(all: readonly Example[]): Example[][] {
  const groups = new Map<string, Example[]>();
  for (const example of all) {
    const key = `${stemOf(example.name)}\n${example.about.en}`;
    groups.set(key, [...(groups.get(key) ?? []), example]);
  }
  return [...groups.values()];
}

function card(tools: RemoteTools, languages: readonly Example[], choose: (example: Example) => void): HTMLElement {
  const [first] = languages;
  if (!first) return h("li");
  const [title, more] = titleOf(told(first.about));
  return h("li", { class: "card gallery-card" },
    h("div", { class: "gallery-picture" }, picture(tools, { name: first.name, text: first.text }, "")), h("h3", {}, title), h("p", { class: "note" }, more),
    h("div", { class: "row" }, ...languages.map((example) => h("button", { type: "button", class: "small", "data-example": example.name, click: () => choose(example) }, example.name))));
}

/** What a program does as a title, and what there is to say besides: behind a colon. */
function titleOf(about: string): [title: string, more: string] {
  const [title = "", ...more] = about.split(/: /);
  return [capital(title), capital(more.join(": "))];
}

function capital(text: string): string {
  return text.slice(0, 1).toUpperCase() + text.slice(1);
}
