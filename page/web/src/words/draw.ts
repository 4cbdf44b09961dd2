// The texts of the drawing screen as the rest of the page says its own.

import { DRAW } from "./drawtable";
import { sayFrom } from "./words";

export const say = sayFrom(DRAW);
