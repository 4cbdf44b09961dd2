// The machines, by pictures that Rust draws: each with its exercises, and how far a student is with them.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say } from "../words/learn";
import { say as sayCommon, speak, told } from "../words/words";
import { h } from "./dom";
import type { Listed } from "./exercises";
import type { Learning } from "./learning";
import { type ListedMachine, listedMachines } from "./listed";
import type { MachineArea } from "./machine";
import { note } from "./notes";

export class Gallery {
  private readonly dialog = h("dialog", { id: "gallery", class: "gallery", "aria-labelledby": "gallery-title" });
  private machines: readonly ListedMachine[] | null = null;

  constructor(
    private readonly tools: RemoteTools,
    private readonly learning: Learning,
    private readonly machine: MachineArea,
    private readonly open: (text: Text) => void,
  ) {
    document.body.append(this.dialog);
    // A click beside it closes it.
    this.dialog.addEventListener("click", (event) => {
      if (event.target === this.dialog) this.dialog.close();
    });
    speak.follow(() => {
      if (this.dialog.open) void this.build();
    });
  }

  async show(): Promise<void> {
    if (!this.dialog.open) this.dialog.showModal();
    await this.build();
  }

  private async build(): Promise<void> {
    const machines = (this.machines ??= await listedMachines());
    const exercises = await this.learning.exercises.listed();
    if (machines.length === 0) {
      // Why has been told, and the next time they may come.
      this.machines = null;
      this.dialog.close();
      return;
    }
    const cards = machines.map((listed) => this.card(listed, exercises.filter(({ shelf }) => shelf === listed.name)));
    this.dialog.replaceChildren(
      h("div", { class: "row gallery-head" }, h("h2", { id: "gallery-title" }, sayCommon("machines")), h("span", { style: "flex:1" }),
        h("button", { type: "button", class: "quiet", id: "gallery-close", "aria-label": sayCommon("close"), click: () => this.dialog.close() }, "×")),
      h("ul", { class: "gallery-cards" }, ...cards.map(({ root }) => root)));
    // One after the other, for a worker that draws in no time what it knows.
    const language = speak.value;
    for (const { picture, listed } of cards) {
      if (language !== speak.value) return;
      await this.draw(picture, listed);
    }
  }

  private card(listed: ListedMachine, exercises: readonly Listed[]): { root: HTMLElement; picture: HTMLImageElement; listed: ListedMachine } {
    const picture = h("img", { alt: "", loading: "lazy" });
    const done = exercises.filter(({ passed }) => passed).length;
    const far = exercises.length > 0 ? say("galleryDone", { done, all: exercises.length }) : say("galleryNone");
    const open = h("button", { type: "button", "data-machine": listed.name, "aria-label": `${say("galleryOpen")}: ${told(listed.title)}`, click: () => void this.begin(listed) }, say("galleryOpen"));
    const rows = exercises.map(({ name, title, passed }) =>
      h("li", {}, h("button", { type: "button", class: "quiet small", "data-exercise": name, click: () => void this.solve(name) }, `${passed ? "✓" : "○"} ${told(title)}`)));
    const root = h("li", { class: "card gallery-card" }, picture, h("h3", {}, told(listed.title)), h("p", { class: "note" }, told(listed.about)),
      open, h("p", { class: `gallery-far${done > 0 && done === exercises.length ? " good" : ""}` }, far), rows.length > 0 ? h("ul", {}, ...rows) : null);
    return { root, picture, listed };
  }

  private async draw(picture: HTMLImageElement, { name, text }: ListedMachine): Promise<void> {
    try {
      const svg = await this.tools.ask("picture", { name, text, speak: speak.value });
      picture.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      picture.alt = told(error.both);
    }
  }

  private async begin(listed: ListedMachine): Promise<void> {
    this.dialog.close();
    await this.machine.open(listed);
    const { solution } = listed;
    if (solution) note(() => told(listed.title), { text: () => sayCommon("machineSolve"), take: () => this.open(solution) });
  }

  private async solve(name: string): Promise<void> {
    this.dialog.close();
    await this.learning.choose(name);
  }
}
