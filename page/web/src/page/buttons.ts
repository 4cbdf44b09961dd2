// The buttons of the inputs: held by mouse, finger or key; latched with shift, or while the switch says so. Each is one of four
// kinds: a push button, normally open or closed, or one that stays where it is pressed to: a switch, an emergency stop.

import type { Forced } from "../tools/answers";
import { say, speak } from "../words/words";
import { h } from "./dom";
import { markForced } from "./forced";
import { keepHere, keptHere } from "./place";

/** What a button does: whether it is pressed, and how its contact stands then. */
export type Press = (input: number, pressed: boolean, closed: boolean) => void;

/** What a button is: `no` and `nc` spring back, `switch` and `latch` stay; `nc` and `latch` open their contact. */
const KINDS = ["no", "nc", "switch", "latch"] as const;
export type Kind = (typeof KINDS)[number];
const KIND_WORDS = { no: "contactOpen", nc: "contactClosed", switch: "contactSwitch", latch: "contactLatch" } as const;
const isClosed = (kind: Kind): boolean => kind === "nc" || kind === "latch";
const stays = (kind: Kind): boolean => kind === "switch" || kind === "latch";

export class Buttons {
  readonly root = h("div", { class: "points" });
  /** Makes each press latch, or let go: a finger has no shift. */
  readonly latching = h("button", { type: "button", class: "quiet small", id: "latch", "data-say": "latch", "aria-pressed": "false" });
  /** By the numbers of the inputs. */
  private readonly places = new Map<number, HTMLElement>();
  private readonly latched = new Set<number>();
  private readonly held = new Set<number>();
  /** Those that are no push buttons with an open contact. */
  private kinds: ReadonlyMap<number, Kind> = kindsBefore();
  /** Shows what one chooses the kinds by. */
  readonly choosing = h("button", { type: "button", class: "quiet small", id: "kinds", "data-say": "buttonKinds", "aria-pressed": "false" });

  constructor(private readonly press: Press) {
    this.latching.addEventListener("click", () => this.latching.setAttribute("aria-pressed", String(!this.latches)));
    this.choosing.addEventListener("click", () => {
      this.choosing.setAttribute("aria-pressed", String(!this.isChoosing));
      this.showKinds();
    });
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
      if (event.shiftKey || this.staysAt(input)) this.latch(input);
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

  /** Makes the contacts of these inputs normally closed, and all others push buttons that are open. */
  normallyClosed(inputs: readonly number[]): void {
    this.become(new Map(inputs.map((input) => [input, "nc"])));
  }

  /** Makes these buttons of these kinds, and all others push buttons that are open. */
  become(kinds: ReadonlyMap<number, Kind>): void {
    const before = this.kinds;
    this.kinds = kinds;
    keepHere("contacts", JSON.stringify(Object.fromEntries(kinds)));
    for (const input of this.places.keys()) {
      this.kind(input);
      const [was, is] = [before.get(input) ?? "no", this.kindOf(input)];
      if (was === is) continue;
      if (!stays(is)) this.latched.delete(input);
      this.tell(input);
    }
    this.showTo([...kinds.keys()]);
  }

  private kindOf(input: number): Kind {
    return this.kinds.get(input) ?? "no";
  }

  private staysAt(input: number): boolean {
    return this.latches || stays(this.kindOf(input));
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
      if (event.shiftKey || this.staysAt(input)) return this.latch(input);
      button.setPointerCapture(event.pointerId);
      this.hold(input, true);
    });
    for (const kind of ["pointerup", "pointercancel", "lostpointercapture"]) button.addEventListener(kind, () => this.hold(input, false));
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    const key = (down: boolean) => (event: KeyboardEvent): void => {
      if (event.key !== " " && event.key !== "Enter") return;
      event.preventDefault();
      if (event.repeat) return;
      if (down && (event.shiftKey || this.staysAt(input))) this.latch(input);
      else this.hold(input, down);
    };
    button.addEventListener("keydown", key(true));
    button.addEventListener("keyup", key(false));
    // A screen reader only clicks.
    button.addEventListener("click", (event) => {
      if (event.detail === 0 && event.isTrusted && !this.byKey) this.latch(input);
    });
    button.setAttribute("aria-label", say("buttonOf", { n: input }));
    const choice = h("select", { class: "kind-choice", "data-contact": input, hidden: !this.isChoosing, change: () => this.become(new Map([...this.kinds, [input, choice.value as Kind]])) },
      ...KINDS.map((kind) => h("option", { value: kind })));
    const place = h("div", { class: "place" }, button, h("span", { class: "name" }), h("span", { class: "kind" }), choice, h("span", { class: "forced-mark" }));
    this.kind(input, place);
    return place;
  }

  /** What kind it is, in words and as a choice. */
  private kind(input: number, place = this.places.get(input)): void {
    const choice = place?.querySelector("select");
    const said = place?.querySelector<HTMLElement>(".kind");
    if (!choice || !said) return;
    const kind = this.kindOf(input);
    said.textContent = say(KIND_WORDS[kind]);
    said.dataset["kind"] = kind;
    choice.setAttribute("aria-label", say("contactOf", { n: input }));
    [...choice.options].forEach((option, index) => (option.textContent = say(KIND_WORDS[KINDS[index] ?? "no"])));
    choice.value = kind;
  }

  private get isChoosing(): boolean {
    return this.choosing.getAttribute("aria-pressed") === "true";
  }

  private showKinds(): void {
    for (const place of this.places.values()) {
      const choice = place.querySelector("select");
      if (choice) choice.hidden = !this.isChoosing;
    }
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
    this.press(input, pressed, pressed !== isClosed(this.kindOf(input)));
  }

  private mark(input: number): void {
    const button = this.places.get(input)?.querySelector(".press");
    button?.setAttribute("aria-pressed", String(this.held.has(input) || this.latched.has(input)));
    button?.classList.toggle("latched", this.latched.has(input));
  }
}

/** The kinds that this tab had; version 0.2.0 kept a list of those that are normally closed. */
function kindsBefore(): ReadonlyMap<number, Kind> {
  try {
    const held = JSON.parse(keptHere("contacts") ?? "{}") as unknown;
    if (Array.isArray(held)) return new Map(held.filter((input) => Number.isInteger(input)).map((input) => [input as number, "nc"]));
    const pairs = Object.entries((held ?? {}) as object).filter(([, kind]) => KINDS.includes(kind));
    return new Map(pairs.map(([input, kind]) => [Number(input), kind as Kind]));
  } catch {
    return new Map();
  }
}

const WORDS: Readonly<Record<string, Kind>> = { no: "no", na: "no", nc: "nc", nf: "nc", switch: "switch", chave: "switch", latch: "latch", trava: "latch" };

/** What a program's comment says of its buttons: `(* buttons: I2 NC, I3 switch *)`. Null where it says nothing. */
export function kindsIn(text: string): ReadonlyMap<number, Kind> | null {
  const [, said] = /\b(?:buttons|bot[oõ]es)\s*:([^*\n)]*)/i.exec(text) ?? [];
  if (said === undefined) return null;
  const kinds = [...said.matchAll(/I0?(\d+)\s+(\p{L}+)/giu)].flatMap(([, input, word]): [number, Kind][] => {
    const kind = WORDS[word?.toLowerCase() ?? ""];
    return kind ? [[Number(input), kind]] : [];
  });
  return kinds.length > 0 ? new Map(kinds) : null;
}
