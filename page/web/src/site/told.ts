// How moments, values and refusals are told.

import { note } from "../page/notes";
import { decimal } from "../page/numbers";
import { type SiteKey, say } from "../words/site";
import { speak } from "../words/words";
import type { Item } from "./ask";

const locale = (): string => (speak.value === "pt" ? "pt-BR" : "en-GB");

/** A moment, ms since 1970: the day too, unless it is today. */
export function moment(at: number | null): string {
  if (at === null) return "–";
  const date = new Date(at);
  const isToday = date.toDateString() === new Date().toDateString();
  return date.toLocaleString(locale(), isToday ? { timeStyle: "medium" } : { dateStyle: "short", timeStyle: "medium" });
}

/** A value; one that is not known has words of its own. */
export function value(of: number | null | undefined, unit = ""): string {
  if (of === null || of === undefined) return say("pointUnknown");
  return unit ? `${decimal(of)} ${unit}` : decimal(of);
}

/** What stands beside an item. */
export const labelOf = (item: Item): string => item.label[speak.value] || item.point;

const WHY: Readonly<Record<string, SiteKey>> = {
  "not allowed": "whyRole",
  controlled: "whyControlled",
  "other program": "whyProgram",
  away: "whyAway",
  "no value": "whyValue",
  "not on a panel": "whyPanel",
  "nothing to acknowledge": "whyNothing",
  token: "signInWrong",
  often: "signInOften",
};

/** Says why something was not done. */
export function refused(why: string): void {
  note(() => say(WHY[why] ?? "whyOther"));
}
