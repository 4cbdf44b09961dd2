// The page in Firefox: the simulated board runs, the ladder is drawn, the program is kept. Playwright drives only a Firefox of its
// own, so puppeteer drives Debian's, by WebDriver BiDi.
// @ts-check

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import puppeteer from "puppeteer-core";
import { serve } from "../../serve.mjs";
import { PATIENCE } from "./harness.mjs";

function firefoxPath() {
  const names = [process.env["FIREFOX"], "/usr/bin/firefox-esr", "/usr/bin/firefox"];
  const found = names.find((name) => name && existsSync(name));
  if (!found) throw new Error("no Firefox is here: install firefox-esr, or name one in FIREFOX");
  return found;
}

/** @type {import("puppeteer-core").Browser} */
let browser;
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
before(async () => {
  [browser, server] = await Promise.all([puppeteer.launch({ browser: "firefox", executablePath: firefoxPath(), headless: true }), serve()]);
});
after(async () => {
  await browser.close();
  await server.end();
});

test("a first visit by Firefox runs, is changed, drawn and kept", async () => {
  const page = await browser.newPage();
  page.setDefaultTimeout(PATIENCE);
  await page.setViewport({ width: 1366, height: 768 });
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.goto(server.url);
  // It begins with a program that runs on the simulated UNO, and something to press.
  await page.waitForSelector('#status[data-state="RUN"]');
  await page.waitForSelector('#sheet .ladder.live .element[data-point="Q1"]');
  // A program of one's own takes its place.
  await page.click("#view-both");
  await page.click(".cm-content");
  await page.keyboard.down("Control");
  await page.keyboard.press("KeyA");
  await page.keyboard.up("Control");
  await page.keyboard.type("LD I1\nST Q2");
  await page.waitForSelector("#problem-count.good");
  await page.click("#run");
  await page.waitForSelector('[data-output="1"][data-on="false"]');
  await page.waitForSelector('#status[data-state="RUN"]');
  const button = await page.waitForSelector('[data-input="1"]', { visible: true });
  await button?.scrollIntoView();
  await button?.hover();
  await page.mouse.down();
  await page.waitForSelector('[data-output="2"][data-on="true"]');
  await page.mouse.up();
  await page.waitForSelector('[data-output="2"][data-on="false"]');
  // Its ladder is there, and all of it after a reload.
  await page.click("#view-draw");
  await page.waitForSelector('.ladder .element[data-point="Q2"]');
  await page.reload();
  await page.waitForSelector('.ladder .element[data-point="Q2"]');
  assert.deepEqual(errors, []);
});
