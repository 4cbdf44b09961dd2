// All programs that the browser keeps: by name, last change and a small picture, with what each was before.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { type PlainKey, say } from "../words/words";
import { type ProgramDocument, stemOf, endOf } from "./document";
import { h } from "./dom";
import { picture } from "./picture";
import { duplicate, here, others, remove, rename, versionsOf } from "./place";

/** Shows them; opening one goes to its place, opening how it was makes another. */
export function showPrograms(program: ProgramDocument, tools: RemoteTools, goTo: (id: string) => void, open: (text: Text) => void): void {
  const list = h("ul", { class: "programs" });
  const said = h("p", { class: "note", role: "status" });
  const when = (at: number): string => new Date(at).toLocaleString(document.documentElement.lang);
  const button = (key: PlainKey, name: string, click: () => void): HTMLElement =>
    h("button", { type: "button", class: "small", "aria-label": `${say(key)}: ${name}`, click }, say(key));
  /** The pictures that were made: a program that is renamed keeps its own. */
  const pictures = new Map<string, HTMLElement>();
  const pictured = (id: string, of: Text): HTMLElement => {
    const key = `${id}\n${of.text}`;
    const known = pictures.get(key) ?? h("span", { class: "program-picture" }, picture(tools, of, ""));
    pictures.set(key, known);
    return known;
  };
  const build = (): void => {
    const now = program.text.value;
    const all = [{ id: here(), ...now, at: Date.now() }, ...others()];
    list.replaceChildren(...all.map(({ id, name, text, at }) => {
      const isHere = id === here();
      const field = h("input", { type: "text", value: name, "aria-label": say("fileName"), spellcheck: "false", change: () => {
        const to = field.value.trim() || name;
        if (isHere) program.text.value = { ...program.text.value, name: to };
        else rename(id, to);
        build();
      } });
      const versions = versionsOf(id);
      const before = versions.length > 0 ? h("details", {}, h("summary", {}, say("programVersions", { n: versions.length })), ...versions.map((one) =>
        h("button", { type: "button", class: "small quiet", "data-version": String(one.at), click: () => {
          shown.close();
          open({ name: one.name, text: one.text });
        } }, when(one.at)))) : null;
      return h("li", { "data-program": name }, pictured(id, { name, text }), field, h("span", { class: "note" }, isHere ? say("programHere") : when(at)),
        h("div", { class: "row" },
          isHere ? null : button("programOpen", name, () => {
            shown.close();
            goTo(id);
          }),
          button("programCopy", name, () => {
            duplicate(id, `${stemOf(name)}-2${endOf(name)}`);
            build();
          }),
          isHere ? null : button("programDelete", name, () => {
            const back = remove(id);
            build();
            // A note would lie under this dialog.
            said.replaceChildren(say("programDeleted", { name }), " ", h("button", { type: "button", class: "small", id: "program-back", click: () => {
              back();
              said.replaceChildren();
              build();
            } }, say("undo")));
          })), before);
    }));
  };
  // In the menu it has dots, for it opens this.
  const title = say("programs").replace("…", "");
  const close = h("button", { type: "button", class: "quiet", "aria-label": say("close"), click: () => shown.close() }, "×");
  const shown = h("dialog", { id: "programs-list", class: "gallery", "aria-label": title },
    h("div", { class: "row gallery-head" }, h("h2", {}, title), h("span", { style: "flex:1" }), close), list, said);
  build();
  shown.addEventListener("close", () => shown.remove());
  document.body.append(shown);
  shown.showModal();
}
