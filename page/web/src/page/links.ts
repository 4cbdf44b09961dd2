// Links that carry a program: what makes and reads them is loaded when somebody copies one, or comes by one.

import { later } from "./later";
import type { Carried, Kind } from "./share";

const share = later(() => import("./share"));

/** Puts a link where one can paste it from, or shows it. */
export async function copyLink(kind: Kind, parts: readonly string[]): Promise<void> {
  await (await share())?.copyLink(kind, parts);
}

/** What a fragment carries: undefined where it carries nothing, null where that is none of these. */
export async function carriedBy(fragment: string): Promise<Carried | null | undefined> {
  return fragment === "" ? undefined : (await share())?.carriedBy(fragment);
}
