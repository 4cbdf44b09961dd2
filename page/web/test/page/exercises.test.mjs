// The exercises: chosen, solved and checked, by keyboard, in both languages.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fingers } from "./hands.mjs";
import { Lab, findings, pick, select, type } from "./harness.mjs";

/** @param {string} name of a program of programs/exercises */
const program = (name) => readFileSync(new URL(`../../../../programs/exercises/${name}`, import.meta.url), "utf8");

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("an exercise shows its task and hints, and the first failing case as a timing diagram", async () => {
  const page = await lab.still();
  await page.focus("#menu-learnMenu");
  await page.keyboard.press("Enter");
  await page.focus("#exercises");
  await page.keyboard.press("Enter");
  const exercise = page.locator("#exercise");
  await page.locator("#exercise-list:focus").waitFor();
  await page.keyboard.type("5.");
  await exercise.locator("h3", { hasText: "A motor starts and stops" }).waitFor();
  assert.match((await exercise.locator(".task").textContent()) ?? "", /stop wins/);
  assert.match((await exercise.locator(".names").textContent()) ?? "", /I2 stop \(NC\)/);
  for (const [hints, key] of [[1, "Enter"], [2, " "]]) {
    await page.focus("#exercise-hint");
    await page.keyboard.press(String(key));
    await exercise.locator(`.hints li:nth-child(${hints})`).waitFor();
  }
  assert.equal(await page.locator("#exercise-hint").count(), 0, "no hint is left");

  const check = async (/** @type {string} */ name) => {
    await type(page, program(name), "05-motor.il");
    await page.focus("#exercise-check");
    await page.keyboard.press("Enter");
  };
  await check("wrong/05-motor.il");
  await exercise.locator("#verdict.bad", { hasText: "At 400 ms, Q1 is 0; it should be 1." }).waitFor();
  // What went wrong with the machine plays beneath, with a diagram of its own.
  const diagram = exercise.locator(".diagram:not(#replay .diagram) svg");
  for (const text of ["Start and let go", "I1 start", "Q1 motor", "expected", "actual"]) await diagram.getByText(text, { exact: true }).first().waitFor();

  // Of a hidden case nothing is seen but its title.
  await check("wrong/05-motor-2.il");
  await exercise.locator("#verdict.bad", { hasText: "Stop wins" }).waitFor();
  assert.equal(await diagram.count(), 0);

  await select(page, "#speak", "pt");
  await exercise.locator("#verdict.bad", { hasText: "A parada vence" }).waitFor();
  await exercise.locator("h3", { hasText: "Partida e parada de um motor" }).waitFor();
  await check("wrong/05-motor.il");
  await diagram.getByText("esperado", { exact: true }).first().waitFor();
  await check("05-motor.il");
  await exercise.locator("#verdict.good").waitFor();
  assert.match((await page.locator("#exercise-list option:checked").textContent()) ?? "", /✓/);

  await page.reload();
  await pick(page, "#exercises");
  await exercise.locator("h3", { hasText: "Partida e parada de um motor" }).waitFor();
  assert.match((await page.locator("#exercise-list option:checked").textContent()) ?? "", /^5\. .* ✓$/);
  await page.context().close();
});

test("an exercise with a machine has two verdicts, and its machine stands beside the board", async () => {
  const page = await lab.still();
  await pick(page, "#exercises");
  await page.selectOption("#exercise-list", { index: 27 });
  await page.locator("#machine").waitFor();
  const check = async (/** @type {string} */ name) => {
    await type(page, program(name), name.split("/").at(-1) ?? "");
    await page.click("#exercise-check");
  };
  await check("28-reverse-stop.il");
  await page.locator("#verdict.good").waitFor();
  await page.locator("#machine-verdict.good").waitFor();
  await check("../plants/wrong/belts-stop.st");
  await page.locator("#machine-verdict.bad", { hasText: "at 47 s a goal was missed" }).waitFor();
  await page.locator("#verdict.bad").waitFor();
  await select(page, "#speak", "pt");
  await page.locator("#machine-verdict.bad", { hasText: "uma meta não foi atingida" }).waitFor();
  assert.deepEqual(await findings(page), []);
  // One without a machine takes it away again.
  await page.selectOption("#exercise-list", { index: 0 });
  await page.locator("#machine").waitFor({ state: "hidden" });
  await page.context().close();
});

test("on a phone the timing diagram fits and stays readable, and axe-core finds nothing", async () => {
  const page = await lab.still({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await pick(page, "#exercises", fingers);
  await page.selectOption("#exercise-list", { index: 5 });
  await page.tap("#exercise-check");
  const diagram = page.locator("#exercise .diagram:not(#replay .diagram)");
  await diagram.locator("svg").waitFor();
  // Drawn for the width that there is: nothing is cut, and nothing smaller than elsewhere.
  assert.ok(await diagram.evaluate((it) => it.scrollWidth <= it.clientWidth));
  assert.ok(await diagram.evaluate((it) => [...it.querySelectorAll("text")].every((text) => text.getBoundingClientRect().height >= 12)));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(await findings(page), []);
  await page.context().close();
});
