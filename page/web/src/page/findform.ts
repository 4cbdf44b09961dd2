// To find the fault of a machine: one presses, forces and watches, then names a part and how it fails.

import type { MachineFacts, Searched } from "../tools/answers";
import { say } from "../words/learn";
import { told } from "../words/words";
import { h } from "./dom";
import { type MachineArea, partName } from "./machine";
import { announce } from "./notes";

export class FindForm {
  readonly element = h("form", { class: "find", id: "find" });
  /** What was named last. */
  private named: MachineFacts["faults"][number] | null = null;
  private readonly said = h("p", { class: "verdict", id: "find-verdict", role: "status", hidden: true });
  private readonly count = h("p", { class: "note", id: "find-count" });
  private shown: object | null = null;
  private part = -1;
  /** All that was named, as the file of the machine calls it. */
  private tried: string[] = [];

  constructor(
    private readonly machine: MachineArea,
    /** Opens the machine of the exercise. */
    private readonly open: () => void,
    /** The fault has been found. */
    private readonly found: () => void,
  ) {
    this.element.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.name();
    });
    machine.search.follow((search) => this.follow(search));
  }

  /** Shows it in the language of now. */
  show(): void {
    this.shown = null;
    this.follow(this.machine.search.value);
  }

  /** How far the search is. */
  get search(): { readonly answer: string; readonly found: boolean } {
    return { answer: this.tried.join(""), found: this.machine.search.value?.found ?? false };
  }

  private follow(search: Searched | null): void {
    const ways = this.machine.ways;
    const here = search && ways ? ways : null;
    if (here !== this.shown || !here) {
      this.shown = here;
      this.build();
    }
    if (!search || !ways) return;
    const { steps, tries, found } = search;
    this.count.textContent = say("findCount", { steps, tries });
    this.said.hidden = !this.named;
    if (!this.named) return;
    const [part, , fault] = this.named;
    const named = { part: partName(ways, part), fault: told(fault) };
    this.said.className = `verdict ${found ? "good" : "bad"}`;
    this.said.textContent = found ? say("findRight", { ...named, steps, tries }) : say("findWrong", named);
  }

  private build(): void {
    const { ways } = this.machine;
    if (!ways || !this.machine.search.value) {
      this.element.replaceChildren(h("button", { type: "button", class: "primary", id: "find-machine", click: () => this.open() }, say("findMachine")));
      return;
    }
    const able = [...new Set(ways.faults.map(([part]) => part))];
    if (!able.includes(this.part)) this.part = able[0] ?? -1;
    const faults = h("select", { id: "find-fault" });
    const list = (): void => {
      const own = ways.faults.filter(([part]) => part === this.part);
      faults.replaceChildren(...own.map(([, fault, name]) => h("option", { value: fault }, told(name))));
    };
    const parts = h("select", {
      id: "find-part",
      change: (event) => {
        this.part = Number((event.target as HTMLSelectElement).value);
        list();
      },
    }, ...able.map((part) => h("option", { value: part, selected: part === this.part }, partName(ways, part))));
    list();
    this.element.replaceChildren(
      h("label", {}, h("span", {}, say("findPart")), parts), h("label", {}, h("span", {}, say("findFault")), faults),
      h("button", { type: "submit", class: "primary", id: "find-name" }, say("findName")), this.count, this.said);
  }

  private async name(): Promise<void> {
    const { ways } = this.machine;
    const fault = this.element.querySelector<HTMLSelectElement>("#find-fault")?.value;
    const way = ways?.faults.find(([part, name]) => part === this.part && name === fault);
    if (!ways || !way) return;
    const wasFound = this.machine.search.value?.found;
    this.named = way;
    this.tried.push(`${ways.names[this.part] ?? ""} ${way[1]}\n`);
    await this.machine.name(this.part, way[1]);
    const search = this.machine.search.value;
    this.follow(search);
    announce(this.said.textContent ?? "");
    if (search?.found && !wasFound) this.found();
  }

  /** Another exercise: nothing has been named yet. */
  begin(): void {
    this.named = null;
    this.tried = [];
    this.part = -1;
    this.said.hidden = true;
    this.show();
  }
}
