// Lists that the page has beside it: exercises, machines.

import { beside } from "../offline/beside";
import { say } from "../words/words";
import { note } from "./notes";

/** The list of a file of the page; null where what comes is none, which is told. */
export async function fetched<T>(file: string): Promise<readonly T[] | null> {
  try {
    const answer = await beside(file);
    const list = (await answer.json()) as unknown;
    if (Array.isArray(list)) return list as readonly T[];
  } catch {
    // Told below.
  }
  note(() => say("fileBroken", { file }));
  return null;
}
