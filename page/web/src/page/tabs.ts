// Tabs, as keyboards and screen readers know them.

import type { Key } from "../words/table";
import { say, speak } from "../words/words";
import { h } from "./dom";

export interface Tab {
  readonly id: string;
  readonly title: Key;
  readonly panel: HTMLElement;
  /** It is on the screen now. */
  shown?(): void;
}

export class Tabs {
  private readonly list = h("div", { class: "tablist", role: "tablist" });
  private readonly buttons: HTMLButtonElement[];

  constructor(
    root: HTMLElement,
    private readonly tabs: readonly Tab[],
  ) {
    this.buttons = tabs.map((tab, index) => {
      tab.panel.id = `panel-${tab.id}`;
      tab.panel.classList.add("tabpanel");
      for (const [name, value] of [["role", "tabpanel"], ["aria-labelledby", `tab-${tab.id}`], ["tabindex", "0"]] as const) tab.panel.setAttribute(name, value);
      const button = h("button", { type: "button", role: "tab", id: `tab-${tab.id}`, "aria-controls": `panel-${tab.id}`, click: () => this.show(index) });
      button.addEventListener("keydown", (event) => {
        const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
        if (by === 0) return;
        const next = (index + by + tabs.length) % tabs.length;
        this.show(next);
        this.buttons[next]?.focus();
      });
      return button;
    });
    this.list.append(...this.buttons);
    root.append(this.list, ...tabs.map((tab) => tab.panel));
    speak.follow(() => {
      this.list.setAttribute("aria-label", say("tabs"));
      tabs.forEach((tab, index) => this.title(index, say(tab.title)));
    });
    this.show(0);
  }

  private title(index: number, text: string): void {
    const button = this.buttons[index];
    if (button) button.textContent = text;
  }

  show(index: number): void {
    this.tabs.forEach((tab, at) => {
      const is = at === index;
      tab.panel.hidden = !is;
      this.buttons[at]?.setAttribute("aria-selected", String(is));
      if (this.buttons[at]) this.buttons[at].tabIndex = is ? 0 : -1;
    });
    this.tabs[index]?.shown?.();
  }

  /** Shows the tab of this name. */
  open(id: string): void {
    this.show(this.tabs.findIndex((tab) => tab.id === id));
  }
}
