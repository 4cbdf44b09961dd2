// A program as a picture of its ladder.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { speak } from "../words/words";
import { h } from "./dom";

/** Columns of such a picture: it stands beside a text. */
const WIDTH = 56;

/** The picture, as soon as it is drawn; a text without a ladder has none. Whoever does not see it reads this. */
export function picture(tools: RemoteTools, of: Text, alt: string): HTMLImageElement {
  const image = h("img", { alt, class: "ladder-picture" });
  void tools.ask("list", { of, as: "svg", width: WIDTH, speak: speak.value }).then(
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
