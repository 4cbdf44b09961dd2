// The texts of the screens of a site as the rest of the page says its own.

import { SITE } from "./sitetable";
import { type Plain, sayFrom } from "./words";

export type SiteKey = Plain<typeof SITE>;
export const say = sayFrom(SITE);
