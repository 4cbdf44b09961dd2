// The worker of the page's board: the simulated UNO, and the machine that is wired to it. Both have one time.

import { type Command, type Event, type Scope, serve } from "unoclp-uno";
import { Refusal, Tools } from "../tools/tools";
import type { ForMachine, OfMachine } from "./messages";
import { Wired } from "./wired";

const scope = self as unknown as Scope<Event | OfMachine, Command | ForMachine>;
let tools: Promise<Tools> | null = null;

async function answer(id: number, what: string, request: unknown): Promise<void> {
  const told = (answered: Omit<OfMachine, "kind" | "id">): void => scope.postMessage({ kind: "machine-answer", id, ...answered });
  try {
    if (!tools) return told({});
    const rust = await tools;
    const ok = rust.ask(what as "machine", request as never);
    if (what === "machine") session.wire(new Wired(rust, ok, () => session.wire(null)));
    if (what === "machineClose") session.wire(null);
    told({ ok });
  } catch (error) {
    if (error instanceof Refusal) return told({ error: error.both });
    session.wire(null);
    tools = tools?.then((dead) => dead.anew()) ?? null;
    told({});
  }
}

const session = serve(scope, (data: Command | ForMachine): data is ForMachine => {
  if (data.kind === "machine-module") tools = Tools.of(data.module);
  else if (data.kind === "machine-ask") void answer(data.id, data.what, data.request);
  else return false;
  return true;
});
