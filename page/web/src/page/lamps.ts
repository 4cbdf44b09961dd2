// The lamps of the outputs, and what is forced of them.

import type { Forced } from "../tools/answers";
import { say, speak } from "../words/words";
import { h } from "./dom";
import { markForced } from "./forced";
import { announce } from "./notes";

/** How often a screen reader hears of a lamp after each press of a button: one that blinks falls silent. */
const HEARD = 3;
const COLOURS = ["#e5322d", "#e5b400", "#1fa84a", "#2f6fe4"];

interface Lamp {
  readonly output: number;
  readonly root: HTMLElement;
  readonly bulb: HTMLElement;
  readonly said: HTMLElement;
  share: number;
  heard: number;
}

export class Lamps {
  readonly root = h("div", { class: "points" });
  private lamps: readonly Lamp[] = [];

  constructor() {
    speak.follow(() => this.lamps.forEach(tell));
  }

  /** Has a lamp for each of these outputs. */
  offer(outputs: readonly number[]): void {
    this.lamps = outputs.map((output) => this.lamps.find((lamp) => lamp.output === output) ?? made(output));
    this.root.replaceChildren(...this.lamps.map(({ root }) => root));
  }

  /** Somebody has pressed a button: what comes of it is heard. */
  listen(): void {
    for (const lamp of this.lamps) lamp.heard = 0;
  }

  /** How bright each is, 0 to 1. */
  light(shareOf: (output: number) => number): void {
    for (const lamp of this.lamps) {
      const share = Math.round(shareOf(lamp.output) * 100) / 100;
      if (lamp.share === share) continue;
      lamp.share = share;
      lamp.bulb.style.setProperty("--share", String(share));
      tell(lamp);
      if (lamp.heard++ < HEARD) announce(lamp.said.textContent ?? "");
    }
  }

  names(symbols: Readonly<Record<string, string>>): void {
    for (const { output, root } of this.lamps) {
      const name = root.querySelector(".name");
      if (name) name.textContent = symbols[`Q${output}`] ?? "";
    }
  }

  forced(points: readonly Forced[]): void {
    const forced = new Map(points);
    for (const { output, root } of this.lamps) markForced(root, forced.get(output));
  }
}

function made(output: number): Lamp {
  const bulb = h("div", { class: "bulb", "aria-hidden": "true" });
  bulb.style.setProperty("--lit", COLOURS[(output - 1) % COLOURS.length] ?? "");
  const said = h("span", { class: "said", "data-output": output });
  const root = h("div", { class: "place" }, bulb, h("span", { class: "name" }), said, h("span", { class: "forced-mark" }));
  const lamp = { output, root, bulb, said, share: 0, heard: 0 };
  tell(lamp);
  return lamp;
}

/** Says in words what it shows. */
function tell({ output, share, said }: Lamp): void {
  const state = share <= 0 ? say("off") : share >= 1 ? say("on") : say("percentOn", { percent: Math.round(share * 100) });
  said.textContent = `Q${output} ${state}`;
  said.dataset["on"] = String(share > 0);
}
