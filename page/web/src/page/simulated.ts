// The simulated board: its worker, what it keeps in the browser, and its clock.

import type { BoardId, Command, Event } from "unoclp-uno";
import type { ForSlow } from "../board/messages";
import { type BoardWorker, SimulatedLine } from "../line/simulated";
import type { Clock } from "./conversation";
import { eepromOf, keepHere, keptHere } from "./place";

export class SimulatedBoard implements Clock {
  readonly line: SimulatedLine;
  readonly turned = new Set<() => void>();
  /** Simulated ms since the power came, and when that was known. */
  private at = 0;
  private known = performance.now();
  private runs = false;
  private pace = 1;
  private latest = 0;
  private spokeAt = 0;
  hasPower = false;
  /** Which board it is. */
  id: BoardId = "uno";
  /** Who has asked for the time. */
  private readonly asking: (() => void)[] = [];

  constructor(
    private readonly worker: BoardWorker,
    hear: (event: Event) => void,
  ) {
    this.line = new SimulatedLine(worker);
    worker.addEventListener("message", ({ data }) => {
      this.turning(() => this.note(data));
      hear(data);
    });
  }

  tell(command: Command): void {
    this.turning(() => {
      if (command.kind === "speed") {
        this.settle(this.now());
        this.pace = Math.min(command.factor, 1);
      }
      if (command.kind === "run") this.settle(this.now(), true);
      if (command.kind === "pause") this.settle(this.now(), false);
    });
    this.worker.postMessage(command);
  }

  /** Has its worker hold it in the middle of scans, or no longer. */
  slowly(message: ForSlow): void {
    // Only the page's own worker knows of it.
    (this.worker as unknown as { postMessage(message: ForSlow): void }).postMessage(message);
  }

  /** Tells who waits by this clock, where it goes at another speed after this. */
  private turning(act: () => void): void {
    const before = this.factor();
    act();
    if (this.factor() !== before) for (const hear of [...this.turned]) hear();
  }

  /** It is this board from now on, with its firmware, what its EEPROM was, and power. */
  start(id: BoardId, bytes: Uint8Array): void {
    this.id = id;
    this.tell({ kind: "firmware", board: id, bytes });
    const eeprom = bytesOf(keptHere(eepromOf(id)));
    if (eeprom) this.tell({ kind: "eeprom", bytes: eeprom });
    this.tell({ kind: "plug", on: true });
    this.tell({ kind: "run" });
  }

  now(): number {
    const passed = this.runs ? (performance.now() - this.known) * this.pace : 0;
    this.latest = Math.max(this.latest, this.at + passed);
    return this.latest;
  }

  /** When it last spoke on its line, ms: what it said is no newer, and what it says next is no older. */
  spoke(): number {
    return this.spokeAt;
  }

  factor(): number {
    return this.runs && this.hasPower ? this.pace : 0;
  }

  ask(): Promise<void> {
    return new Promise((told) => {
      this.asking.push(told);
      this.worker.postMessage({ kind: "time" });
    });
  }

  private settle(at: number, runs = this.runs): void {
    this.at = at;
    this.known = performance.now();
    this.runs = runs;
  }

  private note(event: Event): void {
    if (event.kind === "power") {
      this.hasPower = event.on;
      this.latest = 0;
      this.spokeAt = 0;
      this.settle(0);
    }
    if (event.kind === "serial") this.spokeAt = event.at;
    if (event.kind === "pace") this.pace = event.factor > 0 ? event.factor : this.pace;
    if (event.kind === "paused") this.settle(event.at, false);
    else if ("at" in event) this.settle(event.at);
    if (event.kind === "time") this.asking.shift()?.();
    // A browser that keeps nothing begins with an empty EEPROM.
    if (event.kind === "eeprom") keepHere(eepromOf(this.id), btoa(String.fromCharCode(...event.bytes)));
  }
}

function bytesOf(text: string | null): Uint8Array | null {
  if (!text) return null;
  try {
    return Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
  } catch {
    return null;
  }
}
