// The drawing on paper: each rung a picture of its own, so that none breaks over a page.

import { say } from "../../words/draw";
import { h } from "../dom";

/** Around a rung, in units of the drawing. */
const MARGIN = 6;
/** Millimetres of a unit, as long as the paper is wide enough. */
const MILLIMETRES = 0.28;

/** Prints a drawing under a title, with lines for a name and a date. */
export function print(svg: SVGSVGElement, title: string): void {
  const width = svg.viewBox.baseVal.width;
  const rungs = [...svg.querySelectorAll<SVGGElement>(".rung")].map((rung) => {
    const { y, height } = rung.getBBox();
    const one = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    one.setAttribute("class", "ladder");
    one.setAttribute("viewBox", `0 ${y - MARGIN} ${width} ${height + 2 * MARGIN}`);
    one.style.width = `${width * MILLIMETRES}mm`;
    one.append(rung.cloneNode(true));
    return h("div", { class: "printed-rung" }, one);
  });
  const line = (key: "printName" | "printDate"): HTMLElement => h("span", { class: "line" }, say(key));
  const paper = h("div", { id: "printed" }, h("h1", {}, title), h("p", {}, line("printName"), line("printDate")), ...rungs);
  document.body.append(paper);
  document.documentElement.classList.add("printing");
  addEventListener("afterprint", () => {
    paper.remove();
    document.documentElement.classList.remove("printing");
  }, { once: true });
  window.print();
}
