// The board as one sees and touches it.

import type { ArduinoUnoElement } from "@wokwi/elements/dist/esm/arduino-uno-element";
import type { Made } from "../tools/answers";
import { say, speak, told } from "../words/words";
import type { Bench } from "./bench";
import { Buttons } from "./buttons";
import type { CardSlot } from "./cardslot";
import { h } from "./dom";
import { icon } from "./icons";
import { Lamps } from "./lamps";
import { announce } from "./notes";
import { inputsOf, upTo } from "./points";
import { Signal } from "./signal";

const SPEEDS = [1, 0.1, 0.01];

export class Panel {
  private readonly buttons: Buttons;
  private readonly lamps = new Lamps();
  private readonly status = h("div", { class: "status", id: "status" });
  private readonly contacts: HTMLElement;
  private readonly knobs = h("div", { class: "card knobs", hidden: true });
  private readonly uno = document.createElement("wokwi-arduino-uno") as ArduinoUnoElement;
  private readonly readings = new Map<number, number>();
  private shown = "";

  constructor(
    private readonly root: HTMLElement,
    private readonly bench: Bench,
    private readonly slot: CardSlot,
    start: HTMLElement,
    desk: HTMLElement,
    machine: HTMLElement,
  ) {
    this.buttons = new Buttons((input, pressed, closed) => this.press(input, pressed, closed));
    this.contacts = this.inputs();
    root.append(
      h("div", { class: "card" }, this.status, start, desk),
      machine,
      this.contacts,
      h("div", { class: "card" }, h("h3", {}, h("span", { "data-say": "lamps" })), this.lamps.root),
      this.knobs,
      this.time(),
      this.hardware(),
      this.faults(),
    );
    bench.board.follow((board) => {
      // Of the points of what is no board those are shown that the program has.
      if (!board.firmware) return;
      const { own, shared } = inputsOf(board);
      this.buttons.offer([...own, ...shared], own.length);
      this.lamps.offer(upTo(board.outputs));
    });
    bench.pins.follow((pins) => {
      if (bench.where.value !== "simulated") return;
      this.lamps.light((output) => pins?.outputs[output - 1] ?? 0);
      this.uno.led13 = (pins?.led ?? 0) > 0;
    });
    bench.seen.follow((seen) => {
      this.state();
      this.buttons.forced(seen?.forcedInputs ?? []);
      this.lamps.forced(seen?.forcedOutputs ?? []);
      if (bench.where.value !== "simulated" && seen) {
        const dimmed = new Map(seen.dimmed);
        this.lamps.light((output) => (dimmed.has(output) ? (dimmed.get(output) ?? 0) / 255 : Number(seen.outputs.includes(output))));
      }
    });
    for (const signal of [bench.lost, bench.power, bench.upload, bench.paused, speak]) (signal as typeof bench.lost).follow(() => this.state());
    bench.power.follow((on) => {
      this.uno.ledPower = on;
      if (on) this.buttons.tellAll();
    });
    bench.joined.add((where) => {
      if (where === "desk") return;
      this.buttons.tellAll();
      for (const [input, reading] of this.readings) this.turn(input, reading);
    });
  }

  /** Loads the picture of the UNO, which stands below what one needs first. Without it the board runs as well. */
  furnish(): void {
    import("@wokwi/elements/dist/esm/arduino-uno-element").catch(() => undefined);
  }

  /** What the program on the board uses: knobs for its analogue inputs, names for its points. */
  uses(made: Made): void {
    if (!this.bench.board.value.firmware) {
      this.buttons.offer(made.uses.inputs, made.uses.inputs.length);
      this.lamps.offer([...new Set([...made.uses.outputs, ...made.uses.pwm])].sort((one, other) => one - other));
    }
    this.buttons.names(made.symbols);
    this.lamps.names(made.symbols);
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
    const more = h("button", { type: "button", class: "quiet small", "data-say": "moreButtons", "aria-pressed": "false" });
    more.addEventListener("click", () => {
      const all = more.getAttribute("aria-pressed") !== "true";
      more.setAttribute("aria-pressed", String(all));
      const { own, shared } = inputsOf(this.bench.board.value);
      this.buttons.show(all ? own.length + shared.length : own.length);
    });
    this.bench.board.follow((board) => {
      more.hidden = board.shared.length === 0;
    });
    return h("div", { class: "card contacts" }, h("h3", {}, h("span", { "data-say": "buttons" }), h("span", {}, this.buttons.latching, more)), this.buttons.root,
      h("p", { class: "note", "data-say": "buttonsHint" }));
  }

  private time(): HTMLElement {
    const { bench } = this;
    const pause = h("button", { type: "button", id: "pause", click: () => (bench.paused.value ? bench.goOn() : bench.pause()) });
    bench.paused.follow((paused) => {
      pause.replaceChildren(icon(paused ? "play" : "pause"), h("span", { "data-say": paused ? "goOn" : "pause" }, say(paused ? "goOn" : "pause")));
    });
    const speed = h("select", { "data-say-label": "speed", id: "speed", change: () => bench.speed(Number(speed.value)) },
      ...SPEEDS.map((factor) => h("option", { value: factor }, factor === 1 ? "1 ×" : `1/${1 / factor}`)));
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
    // STOP begins the program again: scans of a program that runs are its own.
    const running = new Signal(false);
    const offer = (): void => {
      const key = running.value ? "scanStop" : "scanHint";
      scan.disabled = running.value;
      scan.dataset["sayTitle"] = key;
      scan.title = say(key);
    };
    running.follow(offer);
    speak.follow(offer);
    bench.seen.follow((seen) => {
      running.value = seen?.state === "RUN";
    });
    const card = h("div", { class: "card" }, h("h3", {}, h("span", { "data-say": "time" })),
      h("div", { class: "row" }, pause, speed, scan,
        h("button", { type: "button", id: "command-run", click: () => void bench.ask({ do: "run" }) }, h("span", { "data-say": "commandRun" })),
        h("button", { type: "button", id: "command-stop", click: () => void bench.ask({ do: "stop" }) }, h("span", { "data-say": "commandStop" }))),
      pace);
    bench.where.follow((where) => {
      pause.hidden = speed.hidden = where === "desk";
      pace.hidden = where !== "simulated";
    });
    return card;
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
    const card = h("div", { class: "card", id: "hardware" }, h("h3", {}, h("span", { "data-say": "simulated" })),
      h("div", { class: "uno", inert: true }, this.uno),
      h("div", { class: "row" }, reset,
        h("label", { class: "switch" }, stop, h("span", { "data-say": "stopSwitch" })),
        h("label", { class: "switch" }, plug, h("span", { "data-say": "plug" })),
        this.slot.control));
    bench.where.follow((where) => {
      card.hidden = where !== "simulated";
    });
    return card;
  }

  private faults(): HTMLElement {
    const { bench } = this;
    const bounce = h("input", { type: "checkbox", role: "switch", id: "bouncing", change: () => this.simulated({ kind: "bouncing", on: bounce.checked }) });
    const armed = h("input", { type: "checkbox", role: "switch", id: "plug-at-write", change: () => this.simulated({ kind: "plug-at-write", armed: armed.checked }) });
    bench.power.follow(() => {
      armed.checked = false;
    });
    const card = h("details", { class: "card" }, h("summary", { "data-say": "faults" }),
      h("div", { class: "row" }, h("label", { class: "switch" }, bounce, h("span", { "data-say": "faultBounce" }))),
      h("div", { class: "row" }, h("label", { class: "switch" }, armed, h("span", { "data-say": "faultPlug" }))),
      h("div", { class: "row" }, this.slot.pull, h("button", { type: "button", id: "too-large", click: () => document.dispatchEvent(new Event("too-large")) }, h("span", { "data-say": "faultLarge" }))));
    bench.where.follow((where) => {
      card.hidden = where !== "simulated";
    });
    return card;
  }

  /** What the board does, in words; a screen reader hears each change. */
  private state(): void {
    const { bench } = this;
    const seen = bench.seen.value;
    const upload = bench.upload.value;
    const simulated = bench.where.value === "simulated";
    const here = bench.where.value === "core";
    let state = "";
    let text: string;
    if (simulated && !bench.power.value) text = say("stateOff");
    else if (upload === "storing") text = say("storing");
    else if (upload) text = say("sending", { percent: Math.round(upload.share * 100) });
    else if (!seen) text = bench.lost.value ? told(bench.lost.value) : simulated ? say("stateStarting") : say("stateNone");
    else {
      state = seen.state;
      if (seen.state === "RUN") text = say(here ? "stateRunHere" : "stateRun");
      else if (seen.state === "STOP") text = say("stateStop");
      else if (seen.state === "EMPTY") text = say(here ? "stateEmptyHere" : "stateEmpty");
      else text = seen.fault ? `${say("stateFault")} – ${told(seen.fault.text)}` : say("stateFault");
    }
    const now = `${state} ${text}`;
    if (now === this.shown) return;
    this.shown = now;
    this.status.dataset["state"] = state;
    this.status.textContent = text;
    if (!upload || upload === "storing") announce(text);
  }
}
