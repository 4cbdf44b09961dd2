// The small editor of panels: what stands on one is listed, changed and seen, and saved as the file that the site file names.

import { h } from "../page/dom";
import { download } from "../page/files";
import { type SiteKey, say } from "../words/site";
import { type Item, type Look, type Named, type Panel, ask } from "./ask";
import { panelFile } from "./file";
import { labelOf } from "./told";

const LOOKS = {
  lamp: "lookLamp", value: "lookValue", bar: "lookBar", trend: "lookTrend", button: "lookButton", switch: "lookSwitch", set: "lookSet",
} as const satisfies Readonly<Record<Look, SiteKey>>;
/** What its buttons do. */
type Moves = "panelUp" | "panelDown" | "panelRemove";
/** What only a point that takes values can be. */
const WRITES: ReadonlySet<Look> = new Set<Look>(["button", "switch", "set"]);

/** The editor of a panel; `draw` shows one, `back` leaves. */
export async function edit(panel: Panel, draw: (panel: Panel) => HTMLElement, back: () => void): Promise<HTMLElement> {
  const names = await ask<readonly Named[]>("api/names");
  let items: readonly Item[] = panel.items;
  const list = h("ol", { class: "edit-items" });
  const preview = h("div", { class: "edit-preview", inert: true });
  const now = (): Panel => ({ ...panel, items });
  const change = (next: readonly Item[]): void => {
    items = next;
    preview.replaceChildren(draw(now()));
  };
  const put = (at: number, of: Partial<Item>): void => change(items.map((item, index) => (index === at ? { ...item, ...of } : item)));
  const build = (): void => {
    list.replaceChildren(...items.map((item, at) => h("li", {}, row(item, at, names, put, (next) => { change(next); build(); }, () => items))));
  };
  const point = h("select", { "aria-label": say("panelPoint"), id: "edit-point" }, ...names.map((one, at) => h("option", { value: at }, `${one.board}.${one.point}`)));
  const add = (): void => {
    const named = names[Number(point.value)];
    if (!named) return;
    const { board, point: name, bit } = named;
    const item: Item = { show: bit ? "lamp" : "value", board, point: name, label: { en: name, pt: name }, unit: "", least: 0, most: 100, size: [1, 1] };
    change([...items, item]);
    build();
    list.lastElementChild?.scrollIntoView({ block: "nearest" });
  };
  const file = `${panel.name}.panel.toml`;
  build();
  change(items);
  return h("div", { class: "edit" },
    h("div", { class: "bar" },
      h("button", { type: "button", id: "edit-back", click: back }, say("panelDone")),
      h("span", { class: "grow" }),
      h("button", { type: "button", id: "edit-save", class: "primary", click: () => download(file, panelFile(now()), "application/toml") }, say("panelSave"))),
    h("p", { class: "note" }, say("panelHow", { file, table: `[[panel]] file = "${file}"` })),
    preview, list,
    h("div", { class: "row" }, point, h("button", { type: "button", id: "edit-add", click: add }, say("panelAdd"))));
}

function row(item: Item, at: number, names: readonly Named[], put: (at: number, of: Partial<Item>) => void, change: (items: readonly Item[]) => void, all: () => readonly Item[]): HTMLElement {
  const now = (): Item => all()[at] ?? item;
  const named = names.find((one) => one.board === item.board && one.point === item.point);
  const looks = (Object.keys(LOOKS) as Look[]).filter((look) => named?.writes === true || !WRITES.has(look));
  const show = h("select", { change: () => put(at, { show: show.value as Look, size: show.value === "trend" ? [2, 2] : [1, 1] }) },
    ...looks.map((look) => h("option", { value: look, selected: look === item.show }, say(LOOKS[look]))));
  const text = (key: SiteKey, value: string, take: (now: Item, value: string) => Partial<Item> | null): HTMLElement => {
    const input = h("input", { type: "text", value, maxlength: 60 });
    let last = value;
    input.addEventListener("change", () => {
      const of = take(now(), input.value);
      if (!of) input.value = last;
      else {
        put(at, of);
        last = input.value;
        call(now());
      }
    });
    return h("label", {}, say(key), input);
  };
  const number = (text: string): number | null => {
    const of = Number(text.trim().replace(",", "."));
    return text.trim() !== "" && Number.isFinite(of) ? of : null;
  };
  const move = (by: number): void => {
    const next = [...all()];
    const other = next[at + by];
    if (!other) return;
    next[at + by] = now();
    next[at] = other;
    change(next);
  };
  const small = (key: Moves, sign: string, click: () => void, disabled = false): HTMLElement => h("button", { type: "button", class: "small", "data-key": key, click, disabled }, sign);
  const group = h("div", { class: "edit-item", role: "group" },
    h("code", {}, `${item.board}.${item.point}`),
    h("label", {}, say("panelShow"), show),
    text("panelLabelEn", item.label.en, (now, en) => ({ label: { ...now.label, en } })),
    text("panelLabelPt", item.label.pt, (now, pt) => ({ label: { ...now.label, pt } })),
    text("panelUnit", item.unit, (_, unit) => ({ unit })),
    text("panelLeast", String(item.least), (now, of) => { const least = number(of); return least === null || least >= now.most ? null : { least }; }),
    text("panelMost", String(item.most), (now, of) => { const most = number(of); return most === null || most <= now.least ? null : { most }; }),
    h("span", { class: "group" }, small("panelUp", "↑", () => move(-1), at === 0), small("panelDown", "↓", () => move(1), at === all().length - 1), small("panelRemove", "×", () => change(all().filter((_, index) => index !== at)))));
  /** Its buttons are called as the item is. */
  const call = (of: Item): void => {
    const name = labelOf(of);
    group.setAttribute("aria-label", name);
    for (const button of group.querySelectorAll<HTMLElement>("[data-key]")) {
      button.title = say(button.dataset["key"] as Moves, { name });
      button.setAttribute("aria-label", button.title);
    }
  };
  call(item);
  return group;
}
