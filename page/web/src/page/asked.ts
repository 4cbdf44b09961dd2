// What Rust answers, or refuses.

import { Refusal } from "../tools/tools";
import { told } from "../words/words";
import { note } from "./notes";

/** Does something with an answer, or tells why there is none. */
export async function asked<T>(answer: Promise<T>, then: (told: T) => void): Promise<void> {
  try {
    then(await answer);
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    note(() => told(error.both));
  }
}
