// The program on paper: the pages that Rust lays out, each the drawing of a whole sheet.

import { h } from "../dom";

/** Prints pages, each an SVG that says its size, on paper of that size. */
export function print(pages: readonly string[]): void {
  const paper = h("div", { id: "printed" });
  // Drawn by our own Rust, which escapes every text in it.
  paper.innerHTML = pages.join("");
  const size = ["width", "height"].map((side) => paper.querySelector("svg")?.getAttribute(side) ?? "auto");
  const sheet = h("style", {}, `@page { size: ${size.join(" ")}; margin: 0; }`);
  document.body.append(sheet, paper);
  document.documentElement.classList.add("printing");
  addEventListener("afterprint", () => {
    paper.remove();
    sheet.remove();
    document.documentElement.classList.remove("printing");
  }, { once: true });
  window.print();
}
