// The board as one sees and touches it.

import type { BoardFacts, Made } from "../tools/answers";
import { say, speak } from "../words/words";
import type { Bench } from "./bench";
import { Buttons, kindsIn } from "./buttons";
import type { CardSlot } from "./cardslot";
import { h } from "./dom";
import { icon } from "./icons";
import { keep, kept } from "./kept";
import { Lamps } from "./lamps";
import { announce } from "./notes";
import { layOut } from "./layout";
import { inputsOf, outputsOf, upTo } from "./points";
import { reveal } from "./reveal";

const SPEEDS = [1, 0.1, 0.01];
/** Cards that are seen on request. */
const CARDS = ["hardware", "faults"] as const;
export type Card = (typeof CARDS)[number];
const SHOWN = "cards";

/** Of a board with more points than these one sees those that a program has. */
const FEW = { inputs: 8, outputs: 4 };
const isLarge = (board: BoardFacts): boolean => board.inputs > FEW.inputs;

export class Panel {
  private readonly buttons: Buttons;
  private readonly lamps = new Lamps();
  private readonly contacts: HTMLElement;
  private readonly knobs = h("div", { class: "card knobs", hidden: true });
  private readonly readings = new Map<number, number>();
  /** The program whose points are shown. */
  private made: Made | null = null;
  private readonly cards: Readonly<Record<Card, HTMLElement>>;
  /** How time goes: what the bar shows of it, and what a menu has. */
  readonly time: { readonly speed: HTMLElement; readonly rows: readonly HTMLElement[]; readonly pace: HTMLElement };
  readonly allButtons = h("button", { type: "button", id: "all-buttons", "data-say": "moreButtons", "aria-pressed": "false" });

  constructor(
    private readonly root: HTMLElement,
    private readonly bench: Bench,
    private readonly slot: CardSlot,
    desk: HTMLElement,
    machine: HTMLElement,
    showMachines: () => void,
  ) {
    this.buttons = new Buttons((input, pressed, closed) => this.press(input, pressed, closed));
    this.contacts = this.inputs();
    this.cards = { hardware: this.hardware(), faults: this.faults() };
    this.time = this.clock();
    const lamps = h("div", { class: "card lights" }, h("h3", {}, h("span", { "data-say": "lamps" })), this.lamps.root);
    const docked = h("div", { class: "docked" }, this.contacts, lamps);
    const none = h("div", { class: "no-machine" },
      h("p", { class: "empty", "data-say": "machineNone" }), h("button", { type: "button", id: "choose-machine", "data-say": "machines", click: showMachines }));
    root.append(machine, none, h("div", {}, docked), this.knobs, this.time.pace, ...Object.values(this.cards), desk);
    layOut(docked);
    for (const card of CARDS) this.cards[card].hidden = !(kept(SHOWN) ?? "").split(" ").includes(card);
    bench.board.follow((board) => {
      this.allButtons.hidden = board.shared.length === 0 && !isLarge(board);
      this.allButtons.setAttribute("aria-pressed", "false");
      this.offer(board, false);
    });
    // Where time stands, the last reading is all that is known of that instant: the ladder shows the same.
    const light = (): void => {
      const { where, paused, pins: { value: pins }, seen: { value: seen } } = bench;
      if (where.value === "simulated" && !(paused.value && seen)) return this.lamps.light((output) => pins?.outputs[output - 1] ?? 0);
      if (!seen) return;
      const dimmed = new Map(seen.dimmed);
      this.lamps.light((output) => (dimmed.has(output) ? (dimmed.get(output) ?? 0) / 255 : Number(seen.outputs.includes(output))));
    };
    for (const signal of [bench.pins, bench.seen, bench.paused]) (signal as typeof bench.paused).follow(light);
    bench.seen.follow((seen) => {
      this.buttons.forced(seen?.forcedInputs ?? []);
      this.lamps.forced(seen?.forcedOutputs ?? []);
    });
    bench.power.follow((on) => {
      if (on) this.buttons.tellAll();
    });
    bench.joined.add((where) => {
      if (where === "desk") return;
      this.buttons.tellAll();
      for (const [input, reading] of this.readings) this.turn(input, reading);
    });
  }

  /** Shows a card that is seen on request, or takes it away; the browser remembers. */
  turnCard(card: Card): void {
    const { cards } = this;
    cards[card].hidden = !cards[card].hidden;
    keep(SHOWN, CARDS.filter((one) => !cards[one].hidden).join(" "));
    if (!cards[card].hidden) reveal(cards[card]);
  }

  /** Has a button and a lamp for each point of a small board; of another one for those that the program has, or for all. */
  private offer(board: BoardFacts, all: boolean): void {
    const uses = this.made?.uses;
    const outputs = uses ? outputsOf(uses) : [];
    if (!board.firmware || (isLarge(board) && !all)) {
      const inputs = uses?.inputs.length || !board.firmware ? (uses?.inputs ?? []) : upTo(FEW.inputs);
      this.buttons.offer(inputs, inputs.length);
      this.lamps.offer(outputs.length > 0 || !board.firmware ? outputs : upTo(FEW.outputs));
    } else {
      const { own, shared } = inputsOf(board);
      this.buttons.offer([...own, ...shared], all ? own.length + shared.length : own.length);
      this.lamps.offer(upTo(board.outputs));
    }
    if (this.made) this.names(this.made);
  }

  private names({ symbols }: Made): void {
    this.buttons.names(symbols);
    this.lamps.names(symbols);
  }

  /** Makes the buttons as the comment of a program says, if it says something. */
  kindsOf(text: string): void {
    const kinds = kindsIn(text);
    if (kinds) this.buttons.become(kinds);
  }

  /** What the program on the board uses: knobs for its analogue inputs, names for its points. */
  uses(made: Made): void {
    this.made = made;
    const { board } = this.bench;
    if (!board.value.firmware || isLarge(board.value)) this.offer(board.value, this.allButtons.getAttribute("aria-pressed") === "true");
    else this.names(made);
    this.buttons.showTo(made.uses.inputs);
    const inputs = made.uses.analogue;
    if (inputs.join() === [...this.readings.keys()].join()) return;
    for (const input of this.readings.keys()) if (!inputs.includes(input)) this.simulated({ kind: "analogue", input, to: "open" });
    this.readings.clear();
    this.knobs.hidden = inputs.length === 0;
    this.knobs.replaceChildren(h("h3", {}, say("knobs")), ...inputs.map((input) => this.knob(input)));
  }

  private knob(input: number): HTMLElement {
    const output = h("output", {}, "512");
    const turn = (reading: number): void => {
      output.textContent = String(reading);
      this.readings.set(input, reading);
      this.turn(input, reading);
    };
    const range = h("input", {
      type: "range", min: 0, max: 1023, value: 512, "aria-label": say("knobOf", { n: input }), "data-analogue": input,
      input: (event) => turn(Number((event.target as HTMLInputElement).value)),
    });
    turn(512);
    return h("div", { class: "knob" }, h("b", {}, `A${input}`), range, output);
  }

  private turn(input: number, reading: number): void {
    if (this.bench.where.value === "core") void this.bench.ask({ do: "turn", input, reading });
    else this.simulated({ kind: "analogue", input, to: { reading } });
  }

  private simulated(command: Parameters<Bench["simulated"]["tell"]>[0]): void {
    this.bench.simulated.tell(command);
  }

  /** A machine has buttons and knobs of its own: those of the board fold away. */
  fold(folds: boolean): void {
    const had = this.root.classList.contains("has-machine");
    this.root.classList.toggle("has-machine", folds);
    // The machine has left the contacts open. A board on the desk has buttons of its own.
    if (had && !folds && this.bench.where.value !== "desk") this.buttons.tellAll();
  }

  /** Makes the buttons of these inputs normally closed, and no others. */
  normallyClosed(inputs: readonly number[]): void {
    this.buttons.normallyClosed(inputs);
  }

  private press(input: number, pressed: boolean, closed: boolean): void {
    this.lamps.listen();
    if (this.bench.where.value === "simulated") this.simulated({ kind: "button", input, closed });
    else if (this.bench.where.value === "core") void this.bench.ask({ do: "press", input, closed });
    // The buttons of a board on the desk are on the desk; these force its inputs.
    else void this.bench.ask({ do: "force", output: false, number: input, to: pressed ? closed : null });
  }

  private inputs(): HTMLElement {
    const more = this.allButtons;
    more.addEventListener("click", () => {
      const all = more.getAttribute("aria-pressed") !== "true";
      more.setAttribute("aria-pressed", String(all));
      this.offer(this.bench.board.value, all);
    });
    return h("div", { class: "card contacts", "data-say-title": "buttonsHint" }, h("h3", {}, h("span", { "data-say": "buttons" }), h("span", {}, this.buttons.latching, this.buttons.choosing)), this.buttons.root);
  }

  private clock(): Panel["time"] {
    const { bench } = this;
    const pause = h("button", { type: "button", id: "pause", click: () => (bench.paused.value ? bench.goOn() : bench.pause()) });
    bench.paused.follow((paused) => {
      pause.replaceChildren(icon(paused ? "play" : "pause"), h("span", { "data-say": paused ? "goOn" : "pause" }, say(paused ? "goOn" : "pause")));
    });
    const turn = (): void => {
      const factor = Number(speed.value);
      if (factor === 0) return bench.pause();
      bench.speed(factor);
      if (bench.paused.value) bench.goOn();
      before = speed.value;
    };
    let before = "1";
    const speed = h("select", { "data-say-label": "speed", id: "speed", change: turn },
      ...SPEEDS.map((factor) => h("option", { value: factor }, factor === 1 ? "1 ×" : `1/${1 / factor}`)), h("option", { value: 0 }, "❚❚"));
    bench.paused.follow((paused) => {
      speed.value = paused ? "0" : before;
    });
    const pace = h("p", { class: "pace", id: "pace" });
    const show = (): void => {
      const now = bench.pace.value;
      const two = (factor: number): string => factor.toLocaleString(speak.value === "pt" ? "pt-BR" : "en-US", { maximumSignificantDigits: 2 });
      const slow = now !== null && now.factor < 0.9 * now.asked;
      pace.textContent = bench.paused.value || !now ? (bench.paused.value ? say("paused") : "") : say(slow ? "paceSlow" : "paceOf", { factor: two(now.factor), asked: two(now.asked) });
      pace.classList.toggle("warn", slow && !bench.paused.value);
    };
    bench.pace.follow(show);
    let stood = false;
    bench.paused.follow((paused) => {
      show();
      if (paused !== stood) announce(say(paused ? "paused" : "goesOn"));
      stood = paused;
    });
    speak.follow(show);
    const scan = h("button", { type: "button", id: "scan", "data-say-title": "scanHint", click: () => void this.scan() }, icon("step"), h("span", { "data-say": "scan" }));
    bench.where.follow((where) => {
      pause.hidden = speed.hidden = where === "desk";
      pace.hidden = where !== "simulated";
    });
    const resume = h("button", { type: "button", id: "command-run", click: () => void bench.ask({ do: "run" }) }, h("span", { "data-say": "commandRun" }));
    return { speed, rows: [pause, scan, resume], pace };
  }

  private async scan(): Promise<void> {
    this.bench.takeTime();
    await this.bench.ask({ do: "scan" });
  }

  private hardware(): HTMLElement {
    const { bench } = this;
    const stop = h("input", { type: "checkbox", role: "switch", id: "stop-switch", change: () => this.simulated({ kind: "stop", closed: stop.checked }) });
    const plug = h("input", { type: "checkbox", role: "switch", id: "plug", change: () => this.simulated({ kind: "plug", on: plug.checked }) });
    bench.power.follow((on) => {
      plug.checked = on;
    });
    const reset = h("button", { type: "button", id: "reset", click: () => this.simulated({ kind: "reset" }) }, icon("reset"), h("span", { "data-say": "reset" }));
    const card = h("div", { class: "card", id: "hardware" }, h("h3", {}, h("span", { "data-say": "simulated" }), this.away("hardware")),
      h("div", { class: "row" }, reset,
        h("label", { class: "switch" }, stop, h("span", { "data-say": "stopSwitch" })),
        h("label", { class: "switch" }, plug, h("span", { "data-say": "plug" })),
        this.slot.control));
    // A board on the desk has switches of its own.
    bench.where.follow((where) => card.classList.toggle("elsewhere", where !== "simulated"));
    return card;
  }

  private faults(): HTMLElement {
    const { bench } = this;
    const bounce = h("input", { type: "checkbox", role: "switch", id: "bouncing", change: () => this.simulated({ kind: "bouncing", on: bounce.checked }) });
    const armed = h("input", { type: "checkbox", role: "switch", id: "plug-at-write", change: () => this.simulated({ kind: "plug-at-write", armed: armed.checked }) });
    bench.power.follow(() => {
      armed.checked = false;
    });
    const card = h("div", { class: "card", id: "faults" }, h("h3", {}, h("span", { "data-say": "faults" }), this.away("faults")),
      h("div", { class: "row" }, h("label", { class: "switch" }, bounce, h("span", { "data-say": "faultBounce" }))),
      h("div", { class: "row" }, h("label", { class: "switch" }, armed, h("span", { "data-say": "faultPlug" }))),
      h("div", { class: "row" }, this.slot.pull, h("button", { type: "button", id: "too-large", click: () => document.dispatchEvent(new Event("too-large")) }, h("span", { "data-say": "faultLarge" }))));
    // A board on the desk has switches of its own.
    bench.where.follow((where) => card.classList.toggle("elsewhere", where !== "simulated"));
    return card;
  }

  /** What closes a card. */
  private away(card: Card): HTMLElement {
    return h("button", { type: "button", class: "quiet", "data-say-label": "close", click: () => this.turnCard(card) }, "×");
  }
}
