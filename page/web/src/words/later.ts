// The texts of parts that few ask for, as the rest of the page says its own.

import { LATER } from "./latertable";
import { sayFrom } from "./words";

export type Key = keyof typeof LATER;
export const say = sayFrom(LATER);
