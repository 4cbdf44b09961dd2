// A program as a picture of its ladder: small, of its first rungs; or beside a text, to be read.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { speak } from "../words/words";
import { h } from "./dom";

/** Columns of a small picture; of one that is read, the fewest that there are. */
const WIDTH = 56;
const READ = 44;

/** The picture, as soon as it is drawn; a text without a ladder has none. Whoever does not see it reads this. */
export function picture(tools: RemoteTools, of: Text, alt: string): HTMLImageElement {
  const image = h("img", { alt, class: "ladder-picture" });
  void tools.ask("list", { of, as: "picture", width: WIDTH, speak: speak.value }).then(
    (svg) => {
      image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
    },
    (error: unknown) => {
      if (!(error instanceof Refusal)) throw error;
      image.remove();
    },
  );
  return image;
}

/** The ladder as it looks on a screen, to be read in a column; a text without one has none. Whoever does not see it reads this. */
export function readable(tools: RemoteTools, of: Text, alt: string): HTMLElement {
  const paper = h("div", { class: "diagram readable" });
  void tools.ask("ladder", { of, width: READ, speak: speak.value }).then(
    ({ svg }) => {
      // Drawn by our own Rust, which escapes every text in it.
      paper.innerHTML = svg;
      paper.firstElementChild?.setAttribute("aria-label", alt);
    },
    (error: unknown) => {
      if (!(error instanceof Refusal)) throw error;
      paper.remove();
    },
  );
  return paper;
}
