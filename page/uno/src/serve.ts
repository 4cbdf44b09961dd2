// The simulated board in a worker: a `Session`, its messages, and its turns.

import type { Command, Event } from "./messages";
import { Session } from "./session";

/** What a worker has around it, of which the library of a page has no type. */
export interface Scope<Told, Heard> {
  postMessage(event: Told): void;
  addEventListener(kind: "message", hear: (message: { readonly data: Heard }) => void): void;
}

/** Serves a board; `others` takes what is no command for it, and says whether it has. */
export function serve<More = never>(scope: Scope<Event, Command | More>, others: (more: Command | More) => more is More = (_): _ is More => false): Session {
  const session = new Session((event) => scope.postMessage(event), () => performance.now());
  // A timer waits for 4 ms at least; a message to oneself lets commands in between, and does not wait.
  const again = new MessageChannel();
  let called = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const call = (): void => {
    clearTimeout(timer);
    if (called) return;
    called = true;
    again.port2.postMessage(null);
  };
  again.port1.onmessage = () => {
    called = false;
    const wait = session.turn();
    if (wait === 0) call();
    else if (wait !== null) timer = setTimeout(call, wait);
  };
  scope.addEventListener("message", ({ data }) => {
    if (others(data)) return;
    session.obey(data);
    call();
  });
  return session;
}
