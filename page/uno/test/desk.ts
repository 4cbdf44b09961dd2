// A session on the desk of a test: commands in, events out, and a clock that the test turns.

import assert from "node:assert/strict";
import type { Command, Event } from "../src/messages";
import { Session } from "../src/session";
import { card, firmwareBytes } from "./fixture";

type Of<Kind extends Event["kind"]> = Extract<Event, { kind: Kind }>;

/** A session, its events, and a clock that a test turns. */
export class Desk {
  events: Event[] = [];
  now = 0;
  /** What each look at the clock takes, ms: a slow machine has more. */
  look = 0;
  readonly session = new Session((event) => this.events.push(event), () => (this.now += this.look));

  obey(...commands: Command[]): void {
    for (const command of commands) this.session.obey(command);
  }

  /** Lets so much real time pass, as a worker does. */
  pass(millis: number): void {
    for (const end = this.now + millis; this.now < end; ) {
      const wait = this.session.turn();
      if (wait === null) return;
      this.now += Math.max(wait, 0.001);
    }
  }

  of<Kind extends Event["kind"]>(kind: Kind): Of<Kind>[] {
    return this.events.filter((event): event is Of<Kind> => event.kind === kind);
  }

  text(): string {
    return this.of("serial").map(({ bytes }) => String.fromCharCode(...bytes)).join("");
  }
}

/** One with this program, when it scans. */
export function running(program: string): Desk {
  const desk = new Desk();
  desk.obey(
    { kind: "firmware", board: "uno", bytes: firmwareBytes() },
    { kind: "card", image: card(program) },
    { kind: "plug", on: true },
    { kind: "run" },
  );
  desk.pass(1000);
  assert.match(desk.text(), /RUN\r\n$/);
  return desk;
}
