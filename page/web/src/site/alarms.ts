// Alarms: how each stands, that one is acknowledged, and what became of them.

import { h } from "../page/dom";
import { announce } from "../page/notes";
import { type SiteKey, say } from "../words/site";
import { speak } from "../words/words";
import { type Alarm, type AlarmPast, No, ask, whyOf } from "./ask";
import type { State } from "./state";
import { saves, table } from "./table";
import { moment, refused } from "./told";

const STATES = { normal: "alarmNormal", active: "alarmActive", acknowledged: "alarmKnown", gone: "alarmGone" } as const satisfies Readonly<Record<string, SiteKey>>;
const CHANGES: Readonly<Record<string, SiteKey>> = { came: "alarmCame", gone: "alarmWent", acknowledged: "alarmTaken" };
const SEVERITIES = { low: "severityLow", medium: "severityMedium", high: "severityHigh" } as const satisfies Readonly<Record<string, SiteKey>>;

/** Whether somebody should acknowledge it. */
export const waits = (alarm: Alarm): boolean => alarm.state === "active" || alarm.state === "gone";

export const severityOf = (severity: Alarm["severity"]): string => say(SEVERITIES[severity]);

export class Alarms {
  readonly root = h("div");
  private readonly now = h("div");
  private readonly before = h("div");
  private drawn = "";

  constructor(private readonly state: State) {
    this.root.append(this.now, this.before);
    state.alarms.follow(() => this.draw());
    speak.follow(() => {
      this.drawn = "";
      this.draw();
    });
  }

  shown(): void {
    this.drawn = "";
    this.draw();
  }

  private draw(): void {
    const alarms = this.state.alarms.value;
    const drawn = JSON.stringify(alarms);
    if (this.root.hidden || drawn === this.drawn) return;
    this.drawn = drawn;
    // Those that want somebody stand first, the worst before others.
    const rank = (alarm: Alarm): number => (waits(alarm) ? 0 : alarm.state === "acknowledged" ? 10 : 20) + ["high", "medium", "low"].indexOf(alarm.severity);
    const sorted = [...alarms].sort((one, other) => rank(one) - rank(other));
    const rows = sorted.map((alarm) => [
      h("span", {}, h("strong", {}, alarm.text[speak.value]), h("br"), h("code", {}, alarm.name)),
      h("span", { class: "alarm-state", "data-state": alarm.state }, say(STATES[alarm.state])),
      h("span", { class: "alarm-mark", "data-severity": alarm.severity }, severityOf(alarm.severity)),
      moment(alarm.since),
      alarm.who ?? "–",
      waits(alarm) && this.state.operates
        ? h("button", { type: "button", class: "primary", "data-alarm": alarm.name, "aria-label": say("alarmOf", { name: alarm.name }), click: () => void this.acknowledge(alarm) }, say("alarmAcknowledge"))
        : null,
    ]);
    const heads = [say("columnAlarm"), say("columnState"), say("columnSeverity"), say("columnSince"), say("columnWho"), say("alarmAcknowledge")];
    this.now.replaceChildren(h("h3", {}, say("alarmNow")), alarms.length > 0 ? table(say("alarmNow"), heads, rows) : h("p", { class: "empty" }, say("alarmsNone")));
    void this.past();
  }

  private async acknowledge(alarm: Alarm): Promise<void> {
    try {
      await ask("api/alarms/acknowledge", { alarm: alarm.name });
      announce(`${alarm.name}: ${say("alarmTaken")}`);
    } catch (error) {
      refused(whyOf(error));
    }
    await this.state.now();
    this.root.querySelector<HTMLElement>("button")?.focus();
  }

  private async past(): Promise<void> {
    try {
      const past = await ask<readonly AlarmPast[]>("api/alarms/history?most=200");
      const rows = [...past].reverse().map((row) => [moment(row.at), row.alarm, say(CHANGES[row.change] ?? "alarmCame"), row.who ?? "–"]);
      const heads = [say("columnWhen"), say("columnAlarm"), say("columnWhat"), say("columnWho")];
      this.before.replaceChildren(h("h3", {}, say("alarmBefore")), h("p", { class: "row" }, saves("api/alarms/history.csv", "alarms.csv")),
        rows.length > 0 ? table(say("alarmBefore"), heads, rows) : h("p", { class: "empty" }, say("recordEmpty")));
    } catch (error) {
      // Without a record nothing is told; what is busy is asked with the next change.
      if (!(error instanceof No)) throw error;
    }
  }
}
