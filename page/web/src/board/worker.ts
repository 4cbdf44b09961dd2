// The worker of the page's board: the simulated UNO, and the machine that is wired to it. Both have one time.

import { type Command, type Event, type Scope, serve } from "unoclp-uno";
import { Refusal, Tools } from "../tools/tools";
import type { Slow } from "unoclp-uno/slow";
import type { ForMachine, ForSlow, OfMachine, OfSlow } from "./messages";
import { Wired } from "./wired";

const scope = self as unknown as Scope<Event | OfMachine | OfSlow, Command | ForMachine | ForSlow>;
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

let slow: Slow | null = null;

async function slowly(asked: ForSlow): Promise<void> {
  if (asked.kind === "slow-go") return slow?.go(asked.go);
  slow?.release();
  slow = session.stopper = null;
  if (asked.kind === "slow-end") return;
  const { hold } = await import("unoclp-uno/slow");
  slow = hold(session, asked.places, (standing) => scope.postMessage({ kind: "slow-stood", standing }));
  scope.postMessage({ kind: "slow-held", is: slow !== null });
}

const session = serve(scope, (data: Command | ForMachine | ForSlow): data is ForMachine | ForSlow => {
  if (data.kind === "machine-module") tools = Tools.of(data.module);
  else if (data.kind === "machine-ask") void answer(data.id, data.what, data.request);
  else if (data.kind === "slow-hold" || data.kind === "slow-go" || data.kind === "slow-end") void slowly(data);
  else return false;
  return true;
});
