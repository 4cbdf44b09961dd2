// The buttons of the inputs: held by mouse, finger or key; latched with shift, or while the switch says so.

import type { Forced } from "../tools/answers";
import { say, speak } from "../words/words";
import { h } from "./dom";
import { markForced } from "./forced";
import { keepHere, keptHere } from "./place";

/** What a button does: whether it is pressed, and how its contact stands then. */
export type Press = (input: number, pressed: boolean, closed: boolean) => void;

export class Buttons {
  readonly root = h("div", { class: "points" });
  /** Makes each press latch, or let go: a finger has no shift. */
  readonly latching = h("button", { type: "button", class: "quiet small", id: "latch", "data-say": "latch", "aria-pressed": "false" });
  /** By the numbers of the inputs. */
  private readonly places = new Map<number, HTMLElement>();
  private readonly latched = new Set<number>();
  private readonly held = new Set<number>();
  /** Those whose contacts are normally closed. */
  private closed = new Set(closedBefore());

  constructor(private readonly press: Press) {
    this.latching.addEventListener("click", () => this.latching.setAttribute("aria-pressed", String(!this.latches)));
    speak.follow(() => {
      for (const [input, place] of this.places) {
        place.querySelector(".press")?.setAttribute("aria-label", say("buttonOf", { n: input }));
        this.kind(input);
      }
    });
    // Keys work wherever nothing is typed.
    const digit = (event: KeyboardEvent): number => {
      const target = event.target as HTMLElement;
      const types = target.closest("input:not([type=checkbox]):not([type=range]), textarea, select, .cm-editor");
      const bare = !event.ctrlKey && !event.altKey && !event.metaKey;
      return !types && bare ? this.keyOf(event) : 0;
    };
    document.addEventListener("keydown", (event) => {
      const input = digit(event);
      if (!input || event.repeat) return;
      if (event.shiftKey || this.latches) this.latch(input);
      else this.hold(input, true);
    });
    document.addEventListener("keyup", (event) => {
      const input = this.keyOf(event);
      if (input) this.hold(input, false);
    });
    addEventListener("blur", () => {
      for (const input of [...this.held]) this.hold(input, false);
    });
  }

  /** The input of a key with a digit; 0 where there is none. */
  private keyOf(event: KeyboardEvent): number {
    const input = Number(/^(?:Digit|Numpad)(\d)$/.exec(event.code)?.[1]);
    return this.places.has(input) ? input : 0;
  }

  /** Has a button for each of these inputs, and shows the first so many. */
  offer(inputs: readonly number[], first: number): void {
    for (const input of [...this.held, ...this.latched].filter((input) => !inputs.includes(input))) {
      this.held.delete(input);
      this.latched.delete(input);
      this.tell(input);
    }
    const places = inputs.map((input) => [input, this.places.get(input) ?? this.place(input)] as const);
    this.places.clear();
    for (const [input, place] of places) this.places.set(input, place);
    this.root.replaceChildren(...this.places.values());
    this.show(first);
  }

  /** Makes the contacts of these inputs normally closed, and all others normally open. */
  normallyClosed(inputs: readonly number[]): void {
    const before = this.closed;
    this.closed = new Set(inputs);
    keepHere("contacts", JSON.stringify([...this.closed]));
    for (const input of this.places.keys()) {
      this.kind(input);
      if (before.has(input) !== this.closed.has(input)) this.tell(input);
    }
    this.showTo(inputs);
  }

  /** Shows all, where one of these is hidden. */
  showTo(inputs: readonly number[]): void {
    if (inputs.some((input) => this.places.get(input)?.hidden)) this.show(this.places.size);
  }

  /** Tells a board that has just got its power, or takes the place of another, how the contacts stand. */
  tellAll(): void {
    for (const input of this.places.keys()) this.tell(input);
  }

  /** Shows the first so many. */
  show(count: number): void {
    [...this.places.values()].forEach((place, index) => {
      place.hidden = index >= count;
    });
  }

  /** What the program calls its inputs. */
  names(symbols: Readonly<Record<string, string>>): void {
    for (const [input, place] of this.places) {
      const name = place.querySelector(".name");
      if (name) name.textContent = symbols[`I${input}`] ?? "";
    }
  }

  /** Marks what is forced. */
  forced(points: readonly Forced[]): void {
    const forced = new Map(points);
    for (const [input, place] of this.places) markForced(place, forced.get(input));
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
    button.setAttribute("aria-label", say("buttonOf", { n: input }));
    const kind = h("button", { type: "button", class: "quiet small contact", "data-contact": input, "aria-pressed": "false",
      click: () => this.normallyClosed(this.closed.has(input) ? [...this.closed].filter((one) => one !== input) : [...this.closed, input]) });
    this.kind(input, kind);
    return h("div", { class: "place" }, button, kind, h("span", { class: "name" }), h("span", { class: "forced-mark" }));
  }

  private kind(input: number, button = this.places.get(input)?.querySelector<HTMLElement>(".contact")): void {
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
    const button = this.places.get(input)?.querySelector(".press");
    button?.setAttribute("aria-pressed", String(this.held.has(input) || this.latched.has(input)));
    button?.classList.toggle("latched", this.latched.has(input));
  }
}

/** Those whose contacts this tab had normally closed. */
function closedBefore(): number[] {
  try {
    const inputs = JSON.parse(keptHere("contacts") ?? "[]") as unknown;
    return Array.isArray(inputs) ? inputs.filter((input) => Number.isInteger(input)) : [];
  } catch {
    return [];
  }
}
