// What the timing diagram has noted, by what it saves.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { PATIENCE } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** What a button of the diagram saves. Its buttons are made anew where its channels change: who has missed one presses the next.
 * @param {Page} page @param {string} name @returns {Promise<string>} */
export async function saved(page, name) {
  for (const until = Date.now() + PATIENCE; Date.now() < until;) {
    const download = page.waitForEvent("download", { timeout: 5_000 }).catch(() => null);
    await page.locator(".trend-tools button", { hasText: name }).click();
    const path = await (await download)?.path();
    if (path) return readFileSync(path, "utf8");
  }
  throw new Error(`${name} saves nothing`);
}

/** Its changes: for each point its times and values. @param {Page} page */
async function changes(page) {
  const [head = [], ...rest] = (await saved(page, "CSV")).trim().split("\n").map((row) => row.split(","));
  /** The first time at which a point is this. @param {string} point as the head has it @param {string} value */
  return (point, value) => Number(rest.find((row) => row[head.indexOf(point)] === value)?.[0] ?? Number.NaN);
}

/** The same, as soon as all of these are among them: a reading is noted with what follows it.
 * @param {Page} page @param {[point: string, value: string][]} all */
export async function changesWith(page, all) {
  const until = Date.now() + PATIENCE;
  for (;;) {
    const first = await changes(page);
    if (all.every(([point, value]) => !Number.isNaN(first(point, value)))) return first;
    assert.ok(Date.now() < until, `not all of ${all.join(" ")} are in the timing diagram`);
  }
}
