// A picture of a machine as Rust draws it: shown once, then its changes are applied.

import { h } from "./dom";

/** What changes in it: the element, its attribute or null for its text, and what that is now. */
export type Changes = readonly (readonly [string, string | null, string])[];

export class Scene {
  readonly root = h("div", { class: "machine-picture" });
  private readonly inside = this.root.attachShadow({ mode: "open" });

  constructor(id = "") {
    if (id) this.root.id = id;
  }

  /** Shows a drawing; gives its element, which has no role yet. */
  show(svg: string, title: string): Element {
    const drawn = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
    // A sheet that is adopted, and not written into the page: a page may forbid the latter.
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`${drawn.querySelector("style")?.textContent ?? ""} svg { width: 100%; height: auto; max-height: var(--picture-most, none); display: block; } .touch { cursor: pointer; outline: none; } .touch:focus-visible { outline: 3px solid #0b6e65; }`);
    drawn.querySelector("style")?.remove();
    drawn.setAttribute("aria-label", title);
    this.inside.adoptedStyleSheets = [sheet];
    this.inside.replaceChildren(document.adoptNode(drawn));
    return drawn;
  }

  /** Applies what has changed since. */
  apply(changes: Changes): void {
    for (const [id, attribute, value] of changes) {
      const element = this.inside.getElementById(id);
      if (attribute === null) {
        if (element) element.textContent = value;
      } else element?.setAttribute(attribute, value);
    }
  }

  /** The symbol of a part. */
  symbolOf(part: string): SVGElement | null {
    return this.inside.querySelector<SVGElement>(`[data-part="${CSS.escape(part)}"]`);
  }
}
