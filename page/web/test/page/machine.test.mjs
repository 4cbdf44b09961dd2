// A machine beside the board: driven by the unmodified firmware on the simulated UNO, and by the core; touched, judged,
// broken on purpose.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Lab, choose, clean, keptText, pick, pictures, run, select, state } from "./harness.mjs";
import { connected } from "./plugged.mjs";

const plants = fileURLToPath(new URL("../../../../programs/plants", import.meta.url));
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** @typedef {import("playwright-core").Page} Page */

/** Opens a machine of the gallery. @param {Page} page @param {RegExp} name */
async function open(page, name) {
  await take(page, name);
  await page.locator("#machine").waitFor();
}

/** The same, where it may be refused. @param {Page} page @param {RegExp} name */
async function take(page, name) {
  await pick(page, "#machines");
  await page.locator("#gallery .gallery-card", { has: page.locator("h3", { hasText: name }) }).locator("[data-machine]").click();
}

/** Presses a symbol of the machine for as long as `act` takes. @param {Page} page @param {string} part @param {() => Promise<unknown>} act */
async function hold(page, part, act) {
  await page.locator(`#machine-picture [data-part="${part}"]`).hover();
  await page.mouse.down();
  await act();
  await page.mouse.up();
}

/** @param {Page} page @param {RegExp} text @param {string} state */
const rule = (page, text, state) => page.locator(`#machine-rules li[data-state="${state}"]`, { hasText: text }).waitFor();

/** Another program. @param {Page} page @param {string} file */
const program = (page, file) => choose(page, file.split("/").at(-1) ?? "", readFileSync(join(plants, file)));

/** Waits until the machine's contact shows this at the board. @param {Page} page @param {string} part @param {boolean} is */
const pressed = (page, part, is) => page.locator(`#machine-picture [data-part="${part}"][aria-pressed="${is}"]`).waitFor();

for (const [where, board] of /** @type {const} */ ([["the simulated UNO", "uno"], ["this computer", "pc"]])) {
  test(`a program controls a machine, and a wrong one breaks it, on ${where}`, async () => {
    const page = await lab.open();
    await select(page, "#for-board", board);
    await open(page, /reversing motor/);
    await page.locator("#notes button", { hasText: "Show a program for this machine" }).click();
    await page.locator("#problem-count.good").waitFor();
    await run(page);
    assert.ok(await page.locator(".contacts").isHidden(), "the machine has buttons of its own");
    const k1 = page.locator('[data-output="1"][data-on="true"]');
    const k2 = page.locator('[data-output="2"][data-on="true"]');
    await hold(page, "forward", () => k1.waitFor());
    await hold(page, "back", () => k2.waitFor());
    assert.equal(await page.locator('#machine-rules li[data-state="broken"]').count(), 0);
    // Both contactors at once blow the fuse, and that stays.
    await program(page, "wrong/reversing-lock.st");
    await page.locator("#problem-count.good").waitFor();
    await run(page);
    await hold(page, "forward", () => k1.waitFor());
    await hold(page, "back", () => k2.waitFor());
    await page.locator('#machine-rules li[data-state="broken"]').first().waitFor();
    await page.click("#machine-reset");
    await page.locator('#machine-rules li[data-state="broken"]').first().waitFor({ state: "detached" });
    await page.click("#machine-close");
    await page.locator("#machine").waitFor({ state: "hidden" });
    assert.ok(await page.locator(".contacts").isVisible());
    await page.context().close();
  });
}

test("a board on the desk controls a machine: its outputs are read, its inputs forced", async () => {
  const page = await connected(lab);
  await open(page, /reversing motor/);
  await page.locator("#notes button", { hasText: "Show a program for this machine" }).click();
  await page.locator("#problem-count.good").waitFor();
  await run(page);
  await page.locator("#machine-age", { hasText: /every \d+ ms/ }).waitFor();
  await hold(page, "forward", () => page.locator('[data-output="1"][data-on="true"]').waitFor());
  await hold(page, "back", () => page.locator('[data-output="2"][data-on="true"]').waitFor());
  assert.equal(await page.locator('#machine-rules li[data-state="broken"]').count(), 0);
  // Closed, it lets go of the inputs.
  await page.locator(".place.is-forced [data-input]").first().waitFor({ state: "attached" });
  await page.click("#machine-close");
  await page.locator(".place.is-forced [data-input]").first().waitFor({ state: "detached" });
  // What a page cannot give to a board is said, and what is there stays.
  const text = await keptText(page);
  await take(page, /oven/);
  await page.locator("#notes", { hasText: "analogue inputs or PWM" }).waitFor();
  assert.ok(await page.locator("#machine").isHidden());
  assert.equal(await keptText(page), text);
  await page.context().close();
});

test("a machine is worked by the keyboard, speaks both languages, and fails by hand", async () => {
  const page = await lab.open();
  await open(page, /Fill, stir, drain/);
  await page.locator("#notes button", { hasText: "Show a program for this machine" }).click();
  await page.locator("#problem-count.good").waitFor();
  await run(page);
  await page.locator('#machine-picture [data-part="start"]').focus();
  await page.keyboard.down("Enter");
  await pressed(page, "start", true);
  await page.keyboard.up("Enter");
  await pressed(page, "start", false);
  await rule(page, /shows that it runs/, "met");
  await clean(page, "a machine");
  // In another language it goes on.
  await select(page, "#speak", "pt");
  await rule(page, /mostra que está em ciclo/, "met");
  await page.locator("#machine details summary").click();
  await page.locator(".machine-faults label", { hasText: /LS 2/ }).first().locator("input").check();
  for (const [width, height] of /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]])) {
    await page.setViewportSize({ width, height });
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
    await page.locator("#machine").scrollIntoViewIfNeeded();
    await page.screenshot({ path: join(pictures, `machine-${width}.png`) });
  }
  await page.context().close();
});

test("a file that is no machine is told, and nothing is lost", async () => {
  const page = await lab.open();
  const text = await keptText(page);
  await choose(page, "mine.toml", Buffer.from('title = "mine"\n[[part]]\nname = "<img src=x onerror=alert(1)>"\nkind = "rocket"\n'));
  await page.locator("#notes", { hasText: "mine.toml:" }).waitFor();
  assert.ok(await page.locator("#machine").isHidden());
  assert.equal(await page.locator("#notes img").count(), 0);
  assert.equal(await keptText(page), text);
  // One's own goes in as those of the menu do.
  await choose(page, "own.toml", readFileSync(join(plants, "motor.toml")));
  await page.locator("#machine").waitFor();
  await state(page, "EMPTY");
  assert.equal(await keptText(page), text);
  await page.context().close();
});
