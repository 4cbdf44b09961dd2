// Reading the program back that a board keeps. One whose checksum the browser knows comes as it was written, with its names;
// any other as numeric code. It opens as a program of its own.

import type { Stored, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say, told } from "../words/words";
import type { Bench } from "./bench";
import { note } from "./notes";
import { type OnBoard, isSame } from "./onboard";
import { others } from "./place";

/** Reads it, and opens it. */
export async function fetchProgram(bench: Bench, onBoard: OnBoard, tools: RemoteTools, here: Text, open: (text: Text) => void): Promise<void> {
  const { seen: { value: seen } } = bench;
  if (!seen) return note(() => say("fetchedNone"));
  const known = onBoard.candidate(seen.kept) ?? (await among(others(), seen.kept, tools));
  if (known && known.text === here.text) return note(() => say("fetchedHere"));
  try {
    const text = known ?? { name: "PROGRAM.TXT", text: await bench.fetch() };
    open({ name: text.name, text: text.text });
    note(() => (known ? say("fetchedKnown", { name: known.name }) : say("fetched")));
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    note(() => told(error.both));
  }
}

/** The one of these programs that a board keeps so. */
async function among(programs: readonly Text[], stored: Stored, tools: RemoteTools): Promise<Text | null> {
  for (const { name, text } of programs) {
    try {
      const { program } = await tools.ask("check", { of: { name, text } });
      if (program && isSame(program.kept, stored)) return { name, text };
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
    }
  }
  return null;
}
