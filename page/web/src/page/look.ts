// Whether a program is shown as a ladder or as a block diagram: the same document, the same power.

import { h } from "./dom";
import { keep, kept } from "./kept";
import type { Seen } from "../tools/answers";
import { Signal } from "./signal";

/** Whether it is shown as blocks. */
export const blocks = new Signal(kept("look") === "blocks");

/** The switch in the menu. */
export function looks(): HTMLElement {
  const button = (is: boolean, say: "viewDraw" | "lookBlocks"): HTMLElement => {
    const one = h("button", { type: "button", id: is ? "look-blocks" : "look-ladder", "data-say": say, click: () => {
      keep("look", is ? "blocks" : "ladder");
      blocks.value = is;
    } });
    blocks.follow((now) => one.setAttribute("aria-pressed", String(now === is)));
    return one;
  };
  return h("div", { class: "group", role: "group", "data-say-label": "looks" }, button(false, "viewDraw"), button(true, "lookBlocks"));
}

/** What a wire says of points that are seen: `I1`, or a gate in front of its inputs, `|2 I1 !I2`. */
export function holds(says: string, seen: Seen): boolean {
  const words = says.split(" ");
  const next = (): boolean => {
    const word = words.shift() ?? "";
    const negated = word.startsWith("!");
    const [sign = "", ...rest] = negated ? word.slice(1) : word;
    const count = Number(rest.join(""));
    if (sign !== "|" && sign !== "&") return of(sign, count) !== negated;
    const inputs = Array.from({ length: count }, next);
    return inputs.includes(sign === "|") === (sign === "|") !== negated;
  };
  const of = (kind: string, number: number): boolean => {
    const { inputs, outputs, markers } = seen;
    return (kind === "I" ? inputs : kind === "Q" ? outputs : markers).includes(number);
  };
  return next();
}
