// The worker that checks, draws and lists while somebody types.

import type { Wrong } from "./answers";
import { Died, NeedsMore, Refusal, Tools } from "./tools";

/** What the page asks: a module first, then requests. */
export type Asked =
  | { readonly module: WebAssembly.Module }
  | { readonly id: number; readonly what: string; readonly request: unknown };
/** What is answered. */
export type Answered = { readonly id: number; readonly ok?: unknown; readonly error?: Wrong; readonly more?: true; readonly died?: true };

let tools: Promise<Tools> | null = null;

addEventListener("message", async ({ data }: MessageEvent<Asked>) => {
  if ("module" in data) {
    tools = Tools.of(data.module);
    return;
  }
  const { id, what, request } = data;
  const answer = (answered: Answered): void => postMessage(answered);
  try {
    if (!tools) throw new Error("no module");
    answer({ id, ok: (await tools).ask(what as "check", request as never) });
  } catch (error) {
    if (error instanceof NeedsMore) return answer({ id, more: true });
    if (error instanceof Died) {
      tools = tools?.then((dead) => dead.anew()) ?? null;
      return answer({ id, died: true });
    }
    const both = error instanceof Refusal ? error.both : { en: String(error), pt: String(error) };
    answer({ id, error: both });
  }
});
