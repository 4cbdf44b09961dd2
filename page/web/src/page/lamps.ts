// The LEDs of the outputs, and what is forced of them.

import "@wokwi/elements/dist/esm/led-element";
import type { LEDElement } from "@wokwi/elements/dist/esm/led-element";
import { say, speak } from "../words/words";
import { h } from "./dom";
import { announce } from "./notes";

/** How often a screen reader hears of a lamp behind each press of a button: one that blinks falls silent. */
const HEARD = 3;
const COLOURS = ["red", "yellow", "green", "blue"];

export class Lamps {
  readonly root = h("div", { class: "points" });
  private readonly places: { root: HTMLElement; led: LEDElement; said: HTMLElement; share: number; heard: number }[] = [];

  constructor() {
    for (let output = 1; output <= 4; output++) {
      const led = document.createElement("wokwi-led") as LEDElement;
      led.color = COLOURS[output - 1] ?? "red";
      led.setAttribute("aria-hidden", "true");
      const said = h("span", { class: "said", "data-output": output });
      const root = h("div", { class: "place" }, h("div", { class: "lamp" }, led), said, h("span", { class: "name" }), h("span", { class: "forced-mark" }));
      this.places.push({ root, led, said, share: 0, heard: 0 });
      this.root.append(root);
    }
    speak.follow(() => this.places.forEach((_, index) => this.say(index)));
  }

  /** Somebody has pressed a button: what comes of it is heard. */
  listen(): void {
    for (const place of this.places) place.heard = 0;
  }

  /** How bright each is, 0 to 1. */
  light(shares: readonly number[]): void {
    shares.forEach((exact, index) => {
      const place = this.places[index];
      const share = Math.round(exact * 100) / 100;
      if (!place || place.share === share) return;
      place.share = share;
      place.led.value = share > 0;
      place.led.brightness = share;
      this.say(index);
      if (place.heard++ < HEARD) announce(place.said.textContent ?? "");
    });
  }

  names(symbols: Readonly<Record<string, string>>): void {
    this.places.forEach(({ root }, index) => {
      const name = root.querySelector(".name");
      if (name) name.textContent = symbols[`Q${index + 1}`] ?? "";
    });
  }

  forced(points: number, to: number): void {
    this.places.forEach(({ root }, index) => {
      const forced = ((points >> index) & 1) !== 0;
      root.classList.toggle("is-forced", forced);
      const mark = root.querySelector(".forced-mark");
      if (mark) mark.textContent = forced ? `${say("forced")} ${(to >> index) & 1}` : "";
    });
  }

  private say(index: number): void {
    const place = this.places[index];
    if (!place) return;
    const { share, said } = place;
    const state = share <= 0 ? say("off") : share >= 1 ? say("on") : say("percentOn", { percent: Math.round(share * 100) });
    said.textContent = `Q${index + 1} ${state}`;
    said.dataset["on"] = String(share > 0);
  }
}
