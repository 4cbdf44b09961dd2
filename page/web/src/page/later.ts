// Parts of the page that are loaded when somebody first needs them.

import { say } from "../words/words";
import { note } from "./notes";

/** What gives a part; where it cannot be loaded this is told, and the next who needs it tries again. */
export function later<T>(load: () => Promise<T>): () => Promise<T | null> {
  let part: Promise<T | null> | null = null;
  return () => {
    part ??= load().catch((error: unknown) => {
      part = null;
      note(() => say("loadFailed", { why: error instanceof Error ? error.message : String(error) }));
      return null;
    });
    return part;
  };
}
