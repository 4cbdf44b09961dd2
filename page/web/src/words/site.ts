// The texts of the screens of a site as the rest of the page says its own.

import { SITE } from "./sitetable";
import { sayFrom } from "./words";

export type SiteKey = keyof typeof SITE;
export const say = sayFrom(SITE);
