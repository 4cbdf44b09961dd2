// What was handed in, opened again: its program and its drawing, for the teacher or for whoever goes on with it.

import type { Text } from "../tools/answers";
import { say } from "../words/learn";
import { type Work, isDrawing } from "./document";
import { note } from "./notes";

/** What `form` says in such a file. */
export const FORM = "unoclp-hand-in-1";

/** The program of such a file; null where it is none, which is told. Its exercise, which may be another than the one that is
 * open, is offered. */
export function handedIn({ name: file, text }: Text, choose: (exercise: string) => void): (Text & Partial<Work>) | null {
  try {
    const { form, student, exercise, program, drawing } = JSON.parse(text) as Partial<Record<string, { name?: unknown; text?: unknown }>>;
    if (String(form) === FORM && typeof program?.name === "string" && typeof program.text === "string") {
      const name = String(exercise?.name ?? "?");
      note(() => say("handedIn", { name: String(student?.name ?? ""), exercise: name }), { text: () => say("handedInOpen"), take: () => choose(name) });
      return { name: program.name, text: program.text, drawing: isDrawing(drawing) ? drawing : null };
    }
  } catch {
    // Told below.
  }
  note(() => say("handedInNone", { file }));
  return null;
}
