// The drawer: tabs, as keyboards and screen readers know them. It is closed until somebody wants one of them.

import { type PlainKey, say, speak } from "../words/words";
import { h } from "./dom";
import { keep, kept } from "./kept";
import { turnTo } from "./reveal";

export interface Tab {
  readonly id: string;
  readonly title: PlainKey;
  /** What its button says in place of the title. */
  readonly label?: HTMLElement;
  readonly panel: HTMLElement;
  /** It is opened from a menu: its button is seen only while it is open. */
  readonly isRare?: boolean;
  /** It is on the screen now. */
  shown?(): void;
}

const KEPT = "drawer";

export class Tabs {
  private readonly list = h("div", { class: "tablist", role: "tablist" });
  private readonly buttons: HTMLButtonElement[];
  /** The one that is open; -1: the drawer is closed. */
  private at = -1;

  constructor(
    private readonly root: HTMLElement,
    private readonly tabs: readonly Tab[],
  ) {
    this.buttons = tabs.map((tab, index) => {
      tab.panel.id = `panel-${tab.id}`;
      tab.panel.classList.add("tabpanel");
      for (const [name, value] of [["role", "tabpanel"], ["aria-labelledby", `tab-${tab.id}`], ["tabindex", "0"]] as const) tab.panel.setAttribute(name, value);
      const button = h("button", { type: "button", role: "tab", id: `tab-${tab.id}`, "aria-controls": `panel-${tab.id}`, click: () => this.show(index === this.at ? -1 : index) }, tab.label ?? null);
      button.addEventListener("keydown", (event) => {
        const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (by === 0) return;
        let next = index;
        do next = (next + by + tabs.length) % tabs.length; while (this.buttons[next]?.hidden);
        this.show(next);
        this.buttons[next]?.focus();
      });
      return button;
    });
    this.list.append(...this.buttons);
    root.append(this.list, ...tabs.map((tab) => tab.panel));
    speak.follow(() => {
      this.list.setAttribute("aria-label", say("tabs"));
      tabs.forEach((tab, index) => {
        const button = this.buttons[index];
        if (button && !tab.label) button.textContent = say(tab.title);
      });
    });
    this.show(tabs.findIndex(({ id }) => id === kept(KEPT)));
  }

  private show(index: number): void {
    this.at = index;
    this.root.classList.toggle("closed", index < 0);
    const first = Math.max(index, 0);
    this.tabs.forEach((tab, at) => {
      const is = at === index;
      const button = this.buttons[at];
      tab.panel.hidden = !is;
      if (!button) return;
      button.hidden = tab.isRare === true && !is;
      button.setAttribute("aria-selected", String(is));
      button.setAttribute("aria-expanded", String(is));
      button.tabIndex = at === first ? 0 : -1;
    });
    keep(KEPT, this.tabs[index]?.id ?? "");
    this.tabs[index]?.shown?.();
  }

  /** Shows the tab of this name. */
  open(id: string): void {
    this.show(this.tabs.findIndex((tab) => tab.id === id));
    // On a phone it is a page of its own.
    if (matchMedia("(max-width: 760px)").matches) turnTo(this.root);
  }
}
