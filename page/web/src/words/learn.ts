// The texts of exercises and of the gallery as the rest of the page says its own.

import { LEARN } from "./learntable";
import { sayFrom } from "./words";

export const say = sayFrom(LEARN);
