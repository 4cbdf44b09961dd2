// Somebody who has never been here: a browser that knows nothing of us, and what is counted of what they see.
// @ts-check

import assert from "node:assert/strict";

/** @typedef {import("playwright-core").Page} Page */

/** The sizes that the page is held to: a school's, a large one, a phone. */
export const SIZES = /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]]);
/** Controls that a newcomer sees at first, at most. */
export const CONTROLS = 25;
/** How far what is seen may be moved without being asked to, as browsers count it. */
const SHIFT = 0.02;

/** A page in a browser of a newcomer, which counts clicks and what is shifted, and collects what the console says.
 * @param {import("./harness.mjs").Lab} lab @param {import("playwright-core").BrowserContextOptions} options */
export async function newcomer(lab, options, fragment = "") {
  const context = await lab.browser.newContext({ serviceWorkers: "block", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  /** @type {string[]} */
  const said = [];
  page.on("console", (message) => void (/Service Worker/.test(message.text()) || said.push(message.text())));
  page.on("pageerror", (error) => void said.push(String(error.stack)));
  await page.addInitScript(() => {
    const counted = Object.assign(window, { counted: { shift: 0, clicks: 0 } }).counted;
    // Cumulative layout shift: the worst of the spells of at most 5 s whose moves follow one another within 1 s.
    let [spell, began, last] = [0, 0, 0];
    new PerformanceObserver((list) => {
      for (const one of list.getEntries()) {
        const { hadRecentInput, value, startTime } = /** @type {any} */ (one);
        if (hadRecentInput) continue;
        if (startTime - last > 1000 || startTime - began > 5000) [spell, began] = [0, startTime];
        [spell, last] = [spell + value, startTime];
        counted.shift = Math.max(counted.shift, spell);
      }
    }).observe({ type: "layout-shift", buffered: true });
    addEventListener("pointerdown", () => void (counted.clicks += 1), { capture: true });
  });
  await page.goto(lab.server.url + fragment);
  return { page, said };
}

/** How often somebody has clicked, or touched the screen. @param {Page} page */
export const clicked = (page) => /** @type {Promise<number>} */ (page.evaluate("counted.clicks"));

/** Fails where what is seen was moved without being asked to. @param {Page} page */
export async function stands(page) {
  const shift = /** @type {number} */ (await page.evaluate("counted.shift"));
  assert.ok(shift < SHIFT, `layout shift ${shift}`);
}

/** What was moved is what somebody has asked for, a column that opens: a browser forgives that for half a second alone, and a slow
 * machine takes longer to load it. @param {Page} page */
export const asked = (page) => page.evaluate("void (counted.shift = 0)");

/** The controls that are in view. @param {Page} page */
export const inView = (page) => page.evaluate(() => [...document.querySelectorAll("button, select, input, a, summary, [role=tab]")].filter((one) => {
  const { left, right, top, bottom, width } = one.getBoundingClientRect();
  return one.checkVisibility({ visibilityProperty: true }) && width > 1 && bottom > 0 && top < innerHeight && right > 0 && left < innerWidth;
}).map((one) => one.id || one.getAttribute("aria-label") || one.textContent));
