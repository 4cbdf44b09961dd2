// A drawing in SVG on a panel, whose elements move with points. What could load or run something is left out of it.

import { decimal } from "../page/numbers";
import type { Bind } from "./ask";

/** What a drawing may have; anything else is left out, with all that is in it. */
const ELEMENTS = new Set(["svg", "g", "path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "tspan", "defs", "linearGradient", "radialGradient", "stop", "clipPath", "mask", "title", "desc", "symbol", "use", "marker", "pattern"]);
/** Attributes that could lead out of the drawing. */
const LEADS_OUT = /^on|^style$/i;

/** The drawing of this text; null where it is none. */
export function drawing(text: string, label: string): SVGSVGElement | null {
  const read = new DOMParser().parseFromString(text, "image/svg+xml");
  const root = read.documentElement;
  if (!(root instanceof SVGSVGElement)) return null;
  clean(root);
  const svg = document.importNode(root, true);
  svg.classList.add("panel-drawing");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", label);
  return svg;
}

function clean(element: Element): void {
  for (const { name, value } of [...element.attributes]) {
    const isOwn = /^\s*#/.test(value);
    const isReference = /(^|:)href$/i.test(name);
    const urls = [...value.matchAll(/url\(\s*['"]?([^)'"]*)/gi)].map((found) => found[1] ?? "");
    if (LEADS_OUT.test(name) || (isReference && !isOwn) || urls.some((url) => !url.startsWith("#"))) element.removeAttribute(name);
  }
  for (const child of [...element.children]) {
    if (ELEMENTS.has(child.localName) && child.namespaceURI === "http://www.w3.org/2000/svg") clean(child);
    else child.remove();
  }
}

/** What an element was before anything moved it. */
const heights = new WeakMap<Element, { readonly y: number; readonly height: number }>();

/** Has an element show a value. */
export function move(svg: SVGSVGElement, bind: Bind, value: number | null | undefined): void {
  const element = svg.querySelector(`#${CSS.escape(bind.id)}`);
  if (!(element instanceof SVGGraphicsElement)) return;
  const isKnown = value !== null && value !== undefined;
  element.classList.toggle("unknown", !isKnown);
  if (!isKnown) return;
  const share = Math.min(Math.max((value - bind.least) / (bind.most - bind.least), 0), 1);
  switch (bind.does) {
    case "show":
      element.style.visibility = value === 0 ? "hidden" : "visible";
      break;
    case "light":
      element.classList.toggle("lit", value !== 0);
      break;
    case "text":
      element.textContent = decimal(value);
      break;
    case "level": {
      const before = heights.get(element) ?? { y: Number(element.getAttribute("y") ?? 0), height: Number(element.getAttribute("height") ?? 0) };
      heights.set(element, before);
      element.setAttribute("height", String(before.height * share));
      element.setAttribute("y", String(before.y + before.height * (1 - share)));
      break;
    }
    case "turn":
      element.style.transformBox = "fill-box";
      element.style.transformOrigin = "center";
      element.style.transform = `rotate(${share * 360}deg)`;
      break;
  }
}
