// The texts of a chart as the rest of the page says its own.

import { CHART } from "./charttable";
import { sayFrom } from "./words";

export const say = sayFrom(CHART);
