// The page in a real Chromium: served from its folder of static files, and driven without a pause that waits for time.
// @ts-check

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "../../serve.mjs";

const here = dirname(fileURLToPath(import.meta.url));
/** Where pictures of the page go, to be looked at. */
export const pictures = join(here, "../../../../target/lab/pictures");

/** How long a state is waited for: a machine that tests much else is slow. */
export const PATIENCE = 120_000;

function browserPath() {
  const names = [process.env["CHROMIUM"], "/usr/bin/chromium-headless-shell", "/usr/bin/chromium", "/usr/bin/google-chrome"];
  const found = names.find((name) => name && existsSync(name));
  if (!found) throw new Error("no Chromium is here: install chromium-headless-shell, or name one in CHROMIUM");
  return found;
}

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe-core finds, in short; of some rules alone, where there are some. All includes that what is named is named as it is
 * shown, which axe-core calls an experiment. @param {import("playwright-core").Page} page
 * @param {string[]} rules */
export async function findings(page, rules = []) {
  if (!(await page.evaluate("'axe' in window"))) await page.evaluate(axe);
  return page.evaluate(async (rules) => {
    const only = rules.length > 0 ? { runOnly: rules } : { rules: { "label-content-name-mismatch": { enabled: true } } };
    // @ts-expect-error axe-core has put itself there.
    const { violations } = await window.axe.run(document, { resultTypes: ["violations"], ...only });
    return violations.map((/** @type {any} */ one) => `${one.id}: ${one.nodes.map((/** @type {any} */ node) => `${node.html.slice(0, 140)} ${node.failureSummary}`).join(" | ")}`);
  }, rules);
}

/** Does something to a page that is light, and again where it is dark. @param {import("playwright-core").Page} page
 * @param {(colorScheme: "light" | "dark") => Promise<void>} act */
export async function lightAndDark(page, act) {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    await page.emulateMedia({ colorScheme });
    await page.locator(`html[data-theme=${colorScheme}]`).waitFor();
    await act(colorScheme);
  }
  await page.emulateMedia({ colorScheme: "light" });
}

/** Fails where axe-core finds something, light or dark: there it looks at colours alone, for all else is the same.
 * @param {import("playwright-core").Page} page @param {string} where */
export async function clean(page, where) {
  await lightAndDark(page, async (colorScheme) => {
    assert.deepEqual(await findings(page, colorScheme === "dark" ? ["color-contrast"] : []), [], `${where}, ${colorScheme}`);
  });
}

/** A Chromium with these words. @param {string[]} words */
export function launch(words = []) {
  const root = process.getuid?.() === 0;
  return chromium.launch({ executablePath: browserPath(), args: [...words, ...(root ? ["--no-sandbox"] : [])] });
}

/** How late an answer of Rust comes at most, ms: a test that does not wait for what it names fails then. */
const LATE = Number(process.env["LATE"] ?? 0);

/** Has the answers of the worker with the tools come late, each by another time, in their order. @param {number} most ms */
function late(most) {
  const { setTimeout } = window;
  window.Worker = class extends Worker {
    /** @param {string | URL} script @param {WorkerOptions} [options] */
    constructor(script, options) {
      super(script, options);
      if (!String(script).includes("tools")) return;
      let last = 0;
      /** @param {string} kind @param {any} hear */
      this.addEventListener = (kind, hear) => super.addEventListener(kind, (event) => {
        const now = performance.now();
        last = Math.max(last, now + Math.random() * most);
        setTimeout(() => hear(event), last - now);
      });
    }
  };
}

/** A browser, the page's server, and pages that fail their test where the page throws. */
export class Lab {
  /** @param {import("playwright-core").Browser} browser @param {Awaited<ReturnType<typeof serve>>} server */
  constructor(browser, server) {
    this.browser = browser;
    this.server = server;
    /** @type {string[]} */
    this.errors = [];
  }

  static async begin() {
    return new Lab(await launch(), await serve());
  }

  /** A page in a browser that knows nothing of us yet; it is ready to run a program.
   * @param {import("playwright-core").BrowserContextOptions} options @param {string} address of another server */
  async open(options = {}, fragment = "", address = this.server.url) {
    const page = await this.other(options, {}, address + fragment);
    await page.locator("#run:enabled").waitFor();
    return page;
  }

  /** A page in a browser that has kept this; its board need not answer.
   * @param {import("playwright-core").BrowserContextOptions} options @param {Readonly<Record<string, string>>} kept */
  async other(options = {}, kept = {}, address = this.server.url) {
    // Without a network nobody is here, and to keep the page for that takes half a second.
    const usual = /** @type {const} */ ({ viewport: { width: 1440, height: 900 }, locale: "en-US", serviceWorkers: "block" });
    const context = await this.browser.newContext({ ...usual, storageState: been(address, kept), ...options });
    if (LATE > 0) await context.addInitScript(late, LATE);
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE);
    page.on("pageerror", (error) => this.errors.push(String(error.stack)));
    page.on("console", (message) => {
      if (message.type() === "error") this.errors.push(message.text());
    });
    await page.goto(address);
    await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
    return page;
  }

  /** A page for what needs no board: its time stands. @param {import("playwright-core").BrowserContextOptions} options */
  async still(options = {}) {
    const page = await this.other(options);
    await still(page);
    return page;
  }

  /** A page with an empty sheet; its board is ready, and its time stands until a program is run.
   * @param {import("playwright-core").BrowserContextOptions} options */
  async emptySheet(options = {}) {
    const page = await this.open(options);
    await still(page);
    await pick(page, "#new-file");
    await page.click("#view-draw");
    await page.locator("#sheet .rung").first().waitFor();
    return page;
  }

  /** Ends; fails where a page has thrown. */
  async end() {
    await this.browser.close();
    await this.server.end();
    if (this.errors.length > 0) throw new Error(this.errors.join("\n"));
  }
}

/** The menu that has a row, by the row: as the page has told it. @type {Map<string, string>} */
const menus = new Map();

/** The menu that has a row. One that nobody has asked for is looked for in all of them. @param {import("playwright-core").Page} page
 * @param {string} row */
async function menuOf(page, row) {
  if (!menus.has(row)) {
    // A page that is being loaded again has none yet.
    await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
    const found = await page.waitForFunction((row) => [...document.querySelectorAll(".menu > button")].find((one) => {
      const button = /** @type {HTMLButtonElement} */ (one);
      const isShut = button.getAttribute("aria-expanded") === "false";
      if (isShut) button.click();
      const has = button.nextElementSibling?.querySelector(row);
      if (isShut) button.click();
      return has;
    })?.id, row);
    menus.set(row, `#${await found.jsonValue()}`);
  }
  return menus.get(row) ?? "";
}

/** Opens the menu that has this row. @param {import("playwright-core").Page} page @param {string} row @param {import("./hands.mjs").Hand} [hand] */
export async function unfold(page, row, hand) {
  const menu = await menuOf(page, row);
  if ((await page.getAttribute(menu, "aria-expanded")) === "true") return;
  if (hand) await hand.press(page, menu);
  else await page.click(menu);
}

/** Does what a row of a menu does. @param {import("playwright-core").Page} page @param {string} row @param {import("./hands.mjs").Hand} [hand] */
export async function pick(page, row, hand) {
  await unfold(page, row, hand);
  if (hand) await hand.press(page, row);
  else await page.click(row);
}

/** Takes an entry of a list that stands in a menu. @param {import("playwright-core").Page} page @param {string} row @param {string} value
 * @param {import("./hands.mjs").Hand} [hand] */
export async function select(page, row, value, hand) {
  await unfold(page, row, hand);
  if (hand) await hand.choose(page, row, value);
  else await page.selectOption(row, value);
  await page.keyboard.press("Escape");
}

/** Shows a tab of the drawer: by its button, or by the menu that opens it. @param {import("playwright-core").Page} page
 * @param {string} name @param {import("./hands.mjs").Hand} [hand] */
export async function tab(page, name, hand) {
  const rows = /** @type {Readonly<Record<string, string>>} */ ({ settings: "#open-settings", card: "#open-card-tab", serial: "#open-serial" });
  if ((await page.getAttribute(`#tab-${name}`, "aria-selected")) === "true") return;
  if (rows[name]) await pick(page, rows[name], hand);
  else if (hand) await hand.press(page, `#tab-${name}`);
  else await page.click(`#tab-${name}`);
}

/** A phone is at the page of this area. @param {import("playwright-core").Page} page @param {string} area */
export const turned = (page, area) => page.waitForFunction((area) => Math.abs(document.querySelector(area)?.getBoundingClientRect().left ?? 99) < 2, area);

/** Replaces the program in the editor, as somebody does who types.
 * @param {import("playwright-core").Page} page @param {string} text */
export async function type(page, text, name = "") {
  if (name) {
    await page.fill("#name", name);
    await page.press("#name", "Enter");
  }
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText(text);
}

/** Waits until the program has this. @param {import("playwright-core").Page} page @param {string} text */
export async function has(page, text) {
  await page.waitForFunction((text) => JSON.parse(localStorage.getItem(`program/${sessionStorage.getItem("place")}`) ?? "{}").text?.includes(text), text);
}

/** Has the time of the simulated board stand: it takes half a processor. Running a program lets it go on.
 * @param {import("playwright-core").Page} page */
export async function still(page) {
  await page.evaluate(() => /** @type {HTMLElement | null} */ (document.querySelector('#pause:has([data-say="pause"])'))?.click());
}

/** Files that a browser opens: it reads them from the disk, for it is slow to be told bytes. */
const files = mkdtempSync(join(tmpdir(), "unoclp-page-"));
process.once("exit", () => rmSync(files, { recursive: true, force: true }));

/** Gives a file to the page that this act asks for. @param {import("playwright-core").Page} page @param {() => Promise<void>} act
 * @param {string} name @param {Buffer} bytes */
export async function give(page, act, name, bytes) {
  const file = join(files, name);
  writeFileSync(file, bytes);
  const chooser = page.waitForEvent("filechooser");
  await act();
  await (await chooser).setFiles(file);
}

/** Opens a file by the menu. @param {import("playwright-core").Page} page @param {string} name @param {Buffer} bytes */
export async function choose(page, name, bytes) {
  await give(page, async () => {
    await page.click("#menu-fileMenu");
    await page.click("#open-file");
  }, name, bytes);
}

/** Puts the program on the board, by the button, and waits until it runs: one that ran before is no longer spoken of.
 * @param {import("playwright-core").Page} page */
export async function run(page) {
  await page.locator("#problem-count:not(.bad)").waitFor();
  await page.click("#run");
  await page.locator('#status[data-state="RUN"]:has(#about-program:empty)').waitFor();
}

/** What the browser has kept for the tab of this page. @param {import("playwright-core").Page} page @param {string} kind */
export function keptHere(page, kind) {
  return page.evaluate((kind) => localStorage.getItem(`${kind}/${sessionStorage.getItem("place")}`), kind);
}

/** The text of its program. @param {import("playwright-core").Page} page */
export async function keptText(page) {
  return JSON.parse((await keptHere(page, "program")) ?? "{}").text;
}

/** Waits until the board is in this state. @param {import("playwright-core").Page} page @param {string} name */
export async function state(page, name) {
  await page.locator(`#status[data-state="${name}"]`).waitFor();
}

/** Waits until a lamp is lit or dark. @param {import("playwright-core").Page} page @param {number} output @param {boolean} on */
export async function lamp(page, output, on) {
  await page.locator(`[data-output="${output}"][data-on="${on}"]`).waitFor();
}

/** What a user has chosen to see who has been here before: text and ladder, the board's own switches, the timing, the palette. */
const SEEN = { greeted: "yes", view: "both", cards: "hardware faults", drawer: "trend", palette: "open" };

/** The store of a browser whose user has been at this address before: a first visit begins otherwise. @param {string} address
 * @param {Readonly<Record<string, string>>} kept what it has kept besides */
export function been(address, kept = {}) {
  const localStorage = Object.entries({ ...SEEN, ...kept }).map(([name, value]) => ({ name, value }));
  return { cookies: [], origins: [{ origin: new URL(address).origin, localStorage }] };
}
