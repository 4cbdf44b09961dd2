// Twenty states of the page that are looked at: each has its size and the way to it.
// @ts-check

import { choose, pick, run, state, tab, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {object} State
 * @property {string} name
 * @property {import("playwright-core").BrowserContextOptions} options
 * @property {Readonly<Record<string, string>> | null} kept what the browser has kept; null: nobody has been here
 * @property {(page: Page) => Promise<unknown>} go */

const SCHOOL = { viewport: { width: 1366, height: 768 }, locale: "en-US" };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, locale: "pt-BR" };
const ALONE = { view: "draw", cards: "", drawer: "" };

const TANK = `PROGRAM main
VAR go AT %IX0.0 : BOOL; pump AT %QX0.0 : BOOL; level : REAL := 2.5; full : BOOL; END_VAR
IF go THEN
  level := 7.5;
END_IF;
full := level > 5.0;
pump := go AND NOT full;
END_PROGRAM
`;

/** Takes the notes away. @param {Page} page */
const quiet = (page) => page.evaluate(() => document.getElementById("notes")?.replaceChildren());

/** Has the time of the board stand, by the speed in the bar. @param {Page} page */
const stand = (page) => page.evaluate(() => {
  const speed = /** @type {HTMLSelectElement | null} */ (document.querySelector("#speed"));
  if (!speed || speed.value === "0") return;
  speed.value = "0";
  speed.dispatchEvent(new Event("change"));
});

/** The program of the editor runs, and its time stands. @param {Page} page */
async function ran(page) {
  await page.locator("#run:enabled").waitFor();
  await run(page);
  await page.locator("#notes > div").first().waitFor();
  await page.locator(".ladder.live, .cm-state").first().waitFor({ state: "attached" });
}

/** @param {string} name @param {State["go"]} go @param {Partial<State>} more @returns {State} */
const at = (name, go, more = {}) => ({ name, options: SCHOOL, kept: ALONE, go, ...more });

/** @type {readonly State[]} */
export const STATES = [
  at("first", (page) => state(page, "RUN"), { kept: null }),
  at("first-phone", (page) => state(page, "RUN"), { kept: null, options: PHONE }),
  at("sheet-empty", (page) => pick(page, "#new-file")),
  at("sheet-form", async (page) => {
    await page.locator('#sheet .element[data-point="I2"] .area').first().click();
    await page.click("#at-edit");
  }),
  at("both-live", async (page) => {
    await ran(page);
    await page.keyboard.press("Escape");
    await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
    await page.keyboard.press("Shift+1");
    await page.locator('.ladder .element.on[data-point="Q1"]').first().waitFor();
  }, { kept: { ...ALONE, view: "both" } }),
  at("both-dark", ran, { kept: { ...ALONE, view: "both", theme: "dark", drawer: "trend" } }),
  at("text-values", async (page) => {
    await type(page, TANK, "tank.st");
    await page.locator("#problem-count.good").waitFor();
    await ran(page);
  }, { kept: { ...ALONE, view: "text" } }),
  at("exercise", async (page) => {
    await pick(page, "#exercises");
    await page.locator("#exercise-check").waitFor();
  }),
  at("exercise-failed", async (page) => {
    await pick(page, "#exercises");
    await page.click("#exercise-check");
    await page.locator("#exercise .diagram svg").waitFor();
  }),
  at("exercise-phone", async (page) => {
    await pick(page, "#exercises");
    await page.locator("#exercise-check").waitFor();
  }, { options: PHONE }),
  at("machines", async (page) => {
    await pick(page, "#machines");
    await page.locator("#gallery .gallery-card").nth(7).waitFor();
    await page.waitForFunction(() => [...document.querySelectorAll("img")].every((one) => one.getBoundingClientRect().top > innerHeight || (one.src !== "" && one.complete)));
  }),
  at("machine", async (page) => {
    await pick(page, "#machines");
    await page.locator("#gallery [data-machine]").first().click();
    await page.locator("#machine-picture svg").waitFor();
  }),
  at("machine-phone", async (page) => {
    await page.locator("#run:enabled").waitFor();
    await page.click("#page-machine");
  }, { options: PHONE }),
  at("examples", async (page) => {
    await pick(page, "#examples");
    await page.locator("dialog img, dialog svg").nth(3).waitFor();
  }),
  at("tutorial", async (page) => {
    await pick(page, "#lessons");
    await page.locator("#lesson h3").waitFor();
    // The sheet is drawn again for the room that is left.
    await page.waitForFunction(() => (/** @type {SVGSVGElement | null} */ (document.querySelector("#sheet svg"))?.getScreenCTM()?.a ?? 0) > 0.9);
  }),
  at("programs", async (page) => {
    await pick(page, "#new-file");
    await pick(page, "#programs");
    await page.locator("#programs-list [data-program]").nth(1).waitFor();
  }),
  at("values-forced", async (page) => {
    await ran(page);
    await tab(page, "watch");
    await page.locator('tr[data-point="I1"] button').first().click();
    await page.locator("tr.is-forced").waitFor();
  }, { kept: { ...ALONE, drawer: "watch" } }),
  at("problems", async (page) => {
    await choose(page, "wrong.il", Buffer.from("LD I1\nSTT Q1\nLD I99\n"));
    await page.locator("#problem-count.bad").waitFor();
    await page.click("#problem-count");
  }, { kept: { ...ALONE, view: "both" } }),
  at("settings", async (page) => {
    await page.locator("#run:enabled").waitFor();
    await tab(page, "settings");
    await page.locator("#settings-restart").waitFor();
  }),
  at("menu", async (page) => {
    await page.locator("#run:enabled").waitFor();
    await page.click("#menu-boardMenu");
  }, { options: { ...SCHOOL, locale: "pt-BR" } }),
];

/** Brings a page into a state in which nothing moves any more. @param {Page} page @param {State} state */
export async function reach(page, { go }) {
  await page.locator("#sheet .rung:visible, .cm-content:visible").first().waitFor();
  await go(page);
  await stand(page);
  await page.locator('#speed option[value="0"]:checked').waitFor({ state: "attached" });
  await quiet(page);
  // How fast the computer is, is no state of the page.
  await page.addStyleTag({ content: "#pace { visibility: hidden }" });
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.fonts.ready);
}
