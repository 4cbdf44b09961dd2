// The exercises of the two other kinds, what went wrong with a machine seen again, and the gallery of machines.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, clean, findings, pick, pictures, run, select, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @param {string} path of a file of programs */
const file = (path) => readFileSync(new URL(`../../../../programs/${path}`, import.meta.url), "utf8");
/** The three screens that are looked at. */
const SCREENS = /** @type {const} */ ([[1366, 768], [1920, 1080], [390, 844]]);

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** Pictures of a state, at the three sizes; nothing scrolls sideways. @param {Page} page @param {string} name @param {string} shown */
async function shots(page, name, shown) {
  for (const [width, height] of SCREENS) {
    await page.setViewportSize({ width, height });
    await page.locator(shown).scrollIntoViewIfNeeded();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} scrolls sideways at ${width}`);
    await page.screenshot({ path: join(pictures, `${name}-${width}.png`) });
  }
  await page.setViewportSize({ width: 1440, height: 900 });
}

/** Chooses an exercise by its number in the list. @param {Page} page @param {number} number */
async function exercise(page, number) {
  await pick(page, "#exercises");
  await page.selectOption("#exercise-list", { index: number - 1 });
}

test("a fault is looked for: pressed, forced, watched, and named from lists", async () => {
  const page = await lab.open();
  await exercise(page, 52);
  assert.equal(await page.locator("#exercise-list option:checked").evaluate((option) => option.closest("optgroup")?.label), "Find the fault");
  await page.locator("#exercise h3 .chip", { hasText: "Find the fault" }).waitFor();
  await page.locator("#find-part").waitFor();
  assert.ok(await page.locator("#machine-failing").isHidden(), "no list mends it");
  assert.equal(await page.locator("#exercise-check").count(), 0);
  await page.click("#find-open");
  await run(page);
  // Pressed where it stands: a step each.
  for (const part of ["start", "stop"]) {
    await page.locator(`#machine-picture [data-part="${part}"]`).hover();
    await page.mouse.down();
    await page.locator(`#machine-picture [data-part="${part}"][aria-pressed="true"]`).waitFor();
    await page.mouse.up();
  }
  await page.locator("#find-count", { hasText: "Steps: 2 · Tries: 0" }).waitFor();
  // Forced in the ladder: a step too.
  await page.locator('.ladder.live .element[data-point="Q1"]').last().click();
  await page.locator("#find-count", { hasText: "Steps: 3 · Tries: 0" }).waitFor();
  const name = async (/** @type {string} */ part, /** @type {string} */ fault) => {
    await page.selectOption("#find-part", { label: part });
    await page.selectOption("#find-fault", { label: fault });
    await page.click("#find-name");
  };
  await name("K1", "wire broken");
  await page.locator("#find-verdict.bad", { hasText: "“K1, wire broken” is not the fault" }).waitFor();
  assert.doesNotMatch((await page.locator("#exercise-list option:checked").textContent()) ?? "", /✓/);
  await name("K1", "contacts welded");
  await page.locator("#find-verdict.good", { hasText: "Steps: 3, tries: 2" }).waitFor();
  assert.match((await page.locator("#exercise-list option:checked").textContent()) ?? "", /^52\. .* ✓$/);
  await clean(page, "find");
  await select(page, "#speak", "pt");
  await page.locator("#find-verdict.good", { hasText: "tentativas: 2" }).waitFor();
  await page.locator("#find-verdict.good", { hasText: "contatos soldados" }).waitFor();
  await page.locator("#find-part option", { hasText: "Liga" }).first().waitFor({ state: "attached" });
  await shots(page, "find", "#find");
  // Closed, the machine goes with its fault; opened again, it hides it anew.
  await page.locator("#exercise button.quiet").last().click();
  await page.locator("#machine").waitFor({ state: "hidden" });
  await pick(page, "#exercises");
  await page.locator("#find-count", { hasText: "Passos: 0 · Tentativas: 0" }).waitFor();
  await page.context().close();
});

test("a program is written again in another language, the given one beside", async () => {
  const page = await lab.still();
  await exercise(page, 55);
  await page.locator("#given .ladder [data-point=\"Q2\"]").first().waitFor();
  await page.locator("#given", { hasText: "Write the program in Structured Text." }).waitFor();
  const check = async (/** @type {string} */ path) => {
    await type(page, file(path), path.split("/").at(-1) ?? "");
    await page.click("#exercise-check");
  };
  // The same text is no answer.
  await type(page, "LD I1\nOR Q1\nAND I2\nST Q1\n", "same.il");
  await page.click("#exercise-check");
  await page.locator("#verdict.bad", { hasText: "asks for a program in `st`" }).waitFor();
  await check("exercises/write/wrong/01-into-text.st");
  await page.locator("#verdict.bad").waitFor();
  await check("exercises/write/01-into-text.st");
  await page.locator("#verdict.good").waitFor();
  assert.deepEqual(await findings(page), []);
  await shots(page, "write", "#given");
  await page.selectOption("#exercise-list", { index: 55 });
  await page.locator("#given pre", { hasText: "PROGRAM voting" }).waitFor();
  await page.click("#exercise-begin");
  assert.equal(await page.inputValue("#name"), "02-into-ladder.il");
  await check("exercises/write/02-into-ladder.il");
  await page.locator("#verdict.good").waitFor();
  await select(page, "#speak", "pt");
  await page.locator("#given", { hasText: "Escreva o programa em Lista de Instruções." }).waitFor();
  await page.context().close();
});

/** Whether all of the replay is on the screen, and nothing hides it. @param {Page} page @param {string} around what scrolls it */
const seen = (page, around) => page.waitForFunction((around) => {
  const box = document.querySelector(around)?.getBoundingClientRect();
  if (!box) return false;
  const [top, bottom] = [Math.max(box.top, 0), Math.min(box.bottom, innerHeight)];
  const parts = ["#replay-picture", "#replay-play", "#replay .diagram"].map((part) => document.querySelector(part)?.getBoundingClientRect());
  return parts.every((part) => part && part.height > 0 && part.top >= top - 1 && part.bottom <= bottom + 1);
}, around);

test("what went wrong with a machine is seen again from two seconds before, with its timing diagram", async () => {
  const page = await lab.still({ viewport: { width: 1366, height: 768 } });
  await exercise(page, 28);
  await type(page, file("plants/wrong/belts-stop.st"), "belts-stop.st");
  await page.click("#exercise-check");
  await page.locator("#machine-verdict.bad", { hasText: "at 47 s" }).waitFor();
  await seen(page, "#exercise");
  const diagram = page.locator("#replay .diagram svg");
  const name = diagram.getByText("I1", { exact: false }).first();
  await name.waitFor();
  // It is as large as it is read; of many lanes the others are scrolled to.
  assert.ok(await name.evaluate((text) => (/** @type {SVGTextElement} */ (text).getScreenCTM()?.a ?? 0) >= 0.95));
  // By the keyboard to its beginning, which is two seconds before.
  await page.focus("#replay-time");
  await page.keyboard.press("Home");
  await page.locator("#replay output", { hasText: "45.00 s" }).waitFor();
  const picture = () => page.locator("#replay-picture").evaluate((scene) => scene.shadowRoot?.innerHTML);
  const first = await picture();
  const cursor = page.locator("#replay .cursor");
  assert.equal(await cursor.getAttribute("transform"), "translate(0 0)");
  await page.keyboard.press("End");
  await page.locator("#replay output", { hasText: "47.48 s" }).waitFor();
  assert.notEqual(await picture(), first);
  assert.notEqual(await cursor.getAttribute("transform"), "translate(0 0)");
  // Home stops it at the first picture too, where the slider stands at its beginning already.
  await page.locator("#replay-time").evaluate(async (time) => {
    document.getElementById("replay-play")?.click();
    time.dispatchEvent(new KeyboardEvent("keydown", { key: "Home" }));
    for (let frame = 0; frame < 30; frame++) await new Promise((next) => requestAnimationFrame(next));
  });
  assert.equal(await cursor.getAttribute("transform"), "translate(0 0)");
  // Played again it begins at its first picture, and ends at its last.
  await page.click("#replay-play");
  await page.locator("#replay output", { hasText: "47.48 s" }).waitFor();
  await clean(page, "replay");
  await shots(page, "replay", "#replay");
  await select(page, "#speak", "pt");
  await page.locator("#replay figcaption", { hasText: "dois segundos antes" }).waitFor();
  await page.locator("#replay output", { hasText: "," }).waitFor();
  // A program that does well leaves nothing to be seen.
  await type(page, file("exercises/28-reverse-stop.il"), "28.il");
  await page.click("#exercise-check");
  await page.locator("#machine-verdict.good").waitFor();
  assert.equal(await page.locator("#replay").count(), 0);
  await page.context().close();
});

test("the gallery has a picture of each machine, its exercises, and how far one is", async () => {
  const page = await lab.still();
  await page.focus("#menu-learnMenu");
  await page.keyboard.press("Enter");
  await page.focus("#machines");
  await page.keyboard.press("Enter");
  const cards = page.locator("#gallery .gallery-card");
  await page.waitForFunction(() => {
    const all = [...document.querySelectorAll("#gallery img")];
    return all.length === 20 && all.every((image) => image instanceof HTMLImageElement && image.complete && image.naturalWidth > 0);
  });
  const belts = cards.filter({ has: page.locator("h3", { hasText: "Three belts" }) });
  await belts.locator(".gallery-far", { hasText: "0 of 3 exercises done" }).waitFor();
  // Each exercise with a machine stands beside one.
  const listed = await page.locator("#gallery [data-exercise]").count();
  assert.ok(listed >= 39, String(listed));
  await clean(page, "gallery");
  await shots(page, "gallery", "#gallery-title");
  await page.keyboard.press("Escape");
  await page.locator("#gallery").waitFor({ state: "hidden" });
  await pick(page, "#machines");
  await belts.locator('[data-exercise="28-reverse-stop"]').click();
  await page.locator("#exercise h3", { hasText: "Start from the end" }).waitFor();
  await page.locator("#machine").waitFor();
  await type(page, file("exercises/28-reverse-stop.il"), "28.il");
  await page.click("#exercise-check");
  await page.locator("#verdict.good").waitFor();
  await select(page, "#speak", "pt");
  await pick(page, "#machines");
  await cards.filter({ has: page.locator("h3", { hasText: "Três esteiras" }) }).locator(".gallery-far", { hasText: "1 de 3 exercícios feitos" }).waitFor();
  await page.context().close();
});

test("without an exercise a program is judged by the machine's own course", async () => {
  const page = await lab.still();
  await pick(page, "#machines");
  await page.locator('#gallery [data-machine="reversing.toml"]').click();
  await page.locator("#machine").waitFor();
  const judge = async (/** @type {string} */ path) => {
    await type(page, file(path), path.split("/").at(-1) ?? "");
    await page.locator("#problem-count:not(.bad)").waitFor();
    await page.click("#machine-judge");
  };
  await judge("plants/reversing.st");
  await page.locator("#machine-judged-verdict.good").waitFor();
  await judge("plants/wrong/reversing-lock.st");
  await page.locator("#machine-judged-verdict.bad", { hasText: "a rule was broken" }).waitFor();
  await page.locator("#machine-judged #replay svg .cursor").waitFor({ state: "attached" });
  await page.setViewportSize({ width: 1366, height: 768 });
  await page.click("#machine-judge");
  await seen(page, "#board");
  assert.deepEqual(await findings(page), []);
  await page.context().close();
});
