// What is known of the site at present: asked again and again while somebody looks.

import { Signal } from "../page/signal";
import { type Alarm, type Board, type Panel, type Who, ask, whyOf } from "./ask";

/** From one asking to the next, ms. */
const EVERY = 1000;

export class State {
  readonly boards = new Signal<readonly Board[]>([]);
  readonly alarms = new Signal<readonly Alarm[]>([]);
  readonly panels = new Signal<readonly Panel[]>([]);
  readonly who = new Signal<Who | null>(null);
  /** What keeps it from being known: `token`, `often`, `lost`, `none`; empty: nothing. */
  readonly why = new Signal("wait");
  private asks = false;

  /** Asks from now on. */
  begin(): void {
    void this.turn();
    document.addEventListener("visibilitychange", () => void this.turn());
  }

  /** Whether this one may write. */
  get operates(): boolean {
    return (this.who.value?.may ?? "watch") !== "watch";
  }

  /** Asks at once. */
  async now(): Promise<void> {
    try {
      if (!this.who.value) {
        const [who, panels] = [await ask<Who>("api/who"), await ask<readonly Panel[]>("api/panels")];
        this.who.value = who;
        this.panels.value = panels;
      }
      const [boards, alarms] = await Promise.all([ask<readonly Board[]>("api/boards"), ask<readonly Alarm[]>("api/alarms")]);
      this.boards.value = boards;
      this.alarms.value = alarms;
      this.why.value = "";
    } catch (error) {
      const why = whyOf(error);
      if (why === "token" || why === "often") this.who.value = null;
      this.why.value = why;
    }
  }

  /** What a point is; undefined where nobody knows. */
  valueOf(board: string, point: string): number | null | undefined {
    const of = this.boards.value.find((one) => one.name === board);
    return of?.up ? of.points[point] : undefined;
  }

  private async turn(): Promise<void> {
    if (this.asks) return;
    this.asks = true;
    while (document.visibilityState === "visible") {
      // Without a token there is nothing to ask for until somebody signs in.
      if (!["token", "often"].includes(this.why.value)) await this.now();
      await new Promise((then) => setTimeout(then, EVERY));
    }
    this.asks = false;
  }
}
