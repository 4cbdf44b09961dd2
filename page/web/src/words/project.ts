// The texts of a project as the rest of the page says its own.

import { PROJECT } from "./projecttable";
import { sayFrom } from "./words";

export const say = sayFrom(PROJECT);
