// The buttons of the inputs: held by mouse, finger or key; latched with shift, or while the switch says so.

import { say, speak } from "../words/words";
import { h } from "./dom";
import { keepHere, keptHere } from "./place";

/** What a button does: whether it is pressed, and how its contact stands then. */
export type Press = (input: number, pressed: boolean, closed: boolean) => void;

export class Buttons {
  readonly root = h("div", { class: "points" });
  /** Makes each press latch, or let go: a finger has no shift. */
  readonly latching = h("button", { type: "button", class: "quiet small", id: "latch", "data-say": "latch", "aria-pressed": "false" });
  private readonly places: HTMLElement[] = [];
  private readonly latched = new Set<number>();
  private readonly held = new Set<number>();
  /** Those whose contacts are normally closed. */
  private closed = new Set(closedBefore());

  constructor(private readonly press: Press) {
    for (let input = 1; input <= 8; input++) this.places.push(this.place(input));
    this.root.append(...this.places);
    this.show(4);
    this.latching.addEventListener("click", () => this.latching.setAttribute("aria-pressed", String(!this.latches)));
    // Keys work wherever nothing is typed.
    const digit = (event: KeyboardEvent): number => {
      const target = event.target as HTMLElement;
      const types = target.closest("input:not([type=checkbox]):not([type=range]), textarea, select, .cm-editor");
      const bare = !event.ctrlKey && !event.altKey && !event.metaKey;
      const match = /^(?:Digit|Numpad)([1-8])$/.exec(event.code);
      return !types && bare && match ? Number(match[1]) : 0;
    };
    document.addEventListener("keydown", (event) => {
      const input = digit(event);
      if (!input || event.repeat) return;
      if (event.shiftKey || this.latches) this.latch(input);
      else this.hold(input, true);
    });
    document.addEventListener("keyup", (event) => {
      const match = /^(?:Digit|Numpad)([1-8])$/.exec(event.code);
      if (match) this.hold(Number(match[1]), false);
    });
    addEventListener("blur", () => {
      for (const input of [...this.held]) this.hold(input, false);
    });
  }

  /** Makes the contacts of these inputs normally closed, and all others normally open. */
  normallyClosed(inputs: readonly number[]): void {
    const before = this.closed;
    this.closed = new Set(inputs);
    keepHere("contacts", JSON.stringify([...this.closed]));
    for (let input = 1; input <= 8; input++) {
      this.kind(input);
      if (before.has(input) !== this.closed.has(input)) this.tell(input);
    }
    if (inputs.some((input) => input > 4)) this.show(8);
  }

  /** Tells a board that has just got its power how the contacts stand. */
  tellAll(): void {
    for (const input of new Set([...this.closed, ...this.latched])) this.tell(input);
  }

  /** Shows the first four, or all; none that is pressed is hidden. */
  show(count: number): void {
    this.places.forEach((place, index) => {
      place.hidden = index >= count;
    });
  }

  /** What the program calls its inputs. */
  names(symbols: Readonly<Record<string, string>>): void {
    this.places.forEach((place, index) => {
      const name = place.querySelector(".name");
      if (name) name.textContent = symbols[`I${index + 1}`] ?? "";
    });
  }

  /** Marks what is forced: bit 0 is input 01. */
  forced(points: number, to: number): void {
    this.places.forEach((place, index) => {
      const forced = ((points >> index) & 1) !== 0;
      place.classList.toggle("is-forced", forced);
      const mark = place.querySelector(".forced-mark");
      if (mark) mark.textContent = forced ? `${say("forced")} ${(to >> index) & 1}` : "";
    });
  }

  private place(input: number): HTMLElement {
    const button = h("button", { type: "button", class: "press", "aria-pressed": "false", "data-input": input }, String(input));
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      if (event.shiftKey || this.latches) return this.latch(input);
      button.setPointerCapture(event.pointerId);
      this.hold(input, true);
    });
    for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(kind, () => this.hold(input, false));
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    const key = (down: boolean) => (event: KeyboardEvent): void => {
      if (event.key !== " " && event.key !== "Enter") return;
      event.preventDefault();
      if (event.repeat) return;
      if (down && (event.shiftKey || this.latches)) this.latch(input);
      else this.hold(input, down);
    };
    button.addEventListener("keydown", key(true));
    button.addEventListener("keyup", key(false));
    // A screen reader only clicks.
    button.addEventListener("click", (event) => {
      if (event.detail === 0 && event.isTrusted && !this.byKey) this.latch(input);
    });
    speak.follow(() => button.setAttribute("aria-label", say("buttonOf", { n: input })));
    const kind = h("button", { type: "button", class: "quiet small contact", "data-contact": input, "aria-pressed": "false",
      click: () => this.normallyClosed(this.closed.has(input) ? [...this.closed].filter((one) => one !== input) : [...this.closed, input]) });
    speak.follow(() => this.kind(input, kind));
    return h("div", { class: "place" }, button, kind, h("span", { class: "name" }), h("span", { class: "forced-mark" }));
  }

  private kind(input: number, button = this.places[input - 1]?.querySelector<HTMLElement>(".contact")): void {
    if (!button) return;
    const closed = this.closed.has(input);
    const kind = say(closed ? "contactClosed" : "contactOpen");
    button.textContent = kind;
    button.title = say("contactOf", { kind, n: input });
    button.setAttribute("aria-label", button.title);
    button.setAttribute("aria-pressed", String(closed));
  }

  private get byKey(): boolean {
    return this.held.size > 0;
  }

  private get latches(): boolean {
    return this.latching.getAttribute("aria-pressed") === "true";
  }

  private hold(input: number, down: boolean): void {
    if (down === this.held.has(input)) return;
    if (down) this.held.add(input);
    else this.held.delete(input);
    if (down && this.latched.delete(input)) this.mark(input);
    this.tell(input);
  }

  private latch(input: number): void {
    if (!this.latched.delete(input)) this.latched.add(input);
    this.tell(input);
  }

  private tell(input: number): void {
    this.mark(input);
    const pressed = this.held.has(input) || this.latched.has(input);
    this.press(input, pressed, pressed !== this.closed.has(input));
  }

  private mark(input: number): void {
    const button = this.places[input - 1]?.querySelector(".press");
    button?.setAttribute("aria-pressed", String(this.held.has(input) || this.latched.has(input)));
    button?.classList.toggle("latched", this.latched.has(input));
  }
}

/** Those whose contacts this tab had normally closed. */
function closedBefore(): number[] {
  try {
    const inputs = JSON.parse(keptHere("contacts") ?? "[]") as unknown;
    return Array.isArray(inputs) ? inputs.filter((input) => Number.isInteger(input) && input >= 1 && input <= 8) : [];
  } catch {
    return [];
  }
}
