// The worker that runs the simulated board: a `Session`, its messages, and its turns.

import type { Command, Event } from "./messages";
import { Session } from "./session";

/** What a worker has around it, of which the library of a page has no type. */
interface Scope {
  postMessage(event: Event): void;
  addEventListener(kind: "message", hear: (message: { readonly data: Command }) => void): void;
}

const scope = self as unknown as Scope;
const session = new Session((event) => scope.postMessage(event), () => performance.now());

// A timer waits for 4 ms at least; a message to oneself lets commands in between, and does not wait.
const again = new MessageChannel();
let called = false;
let timer: ReturnType<typeof setTimeout> | undefined;

function call(): void {
  clearTimeout(timer);
  if (called) return;
  called = true;
  again.port2.postMessage(null);
}

again.port1.onmessage = () => {
  called = false;
  const wait = session.turn();
  if (wait === 0) call();
  else if (wait !== null) timer = setTimeout(call, wait);
};
scope.addEventListener("message", ({ data }) => {
  session.obey(data);
  call();
});
