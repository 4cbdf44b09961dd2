// An interrupt, in avr8js' terms.

import type { CPU } from "avr8js";

/** avr8js does not export its name for this. */
export type Interrupt = Parameters<CPU["setInterruptFlag"]>[0];
