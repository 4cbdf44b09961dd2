// What helps one write a text, by keyboard, by mouse and by finger.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, clean, keptText, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

const TEXT = `PROGRAM main
VAR
  start AT %IX1 : BOOL;
  lamp AT %QX1 : BOOL;
  pause : TON;
END_VAR
pause(IN := start, PT := T#2s);
lamp := pause.Q;
END_PROGRAM
`;

/** Puts the cursor on a word of the text, by the keyboard of a person who finds it.
 * @param {import("playwright-core").Page} page
 * @param {string} line what the line begins with
 * @param {number} right how many characters further */
async function stand(page, line, right = 0) {
  await page.locator(".cm-line", { hasText: line }).first().click({ position: { x: 2, y: 8 } });
  await page.keyboard.press("Home");
  for (let step = 0; step < right; step += 1) await page.keyboard.press("ArrowRight");
}

async function begin() {
  const page = await lab.open();
  await type(page, TEXT, "main.st");
  await page.locator("#problem-count.good").waitFor();
  // The help is loaded when the page is ready.
  await page.locator(".text-menu button").first().waitFor();
  return page;
}

test("members are offered as one types, and taken by the keyboard", async () => {
  const page = await begin();
  await stand(page, "END_PROGRAM");
  await page.keyboard.type("lamp := pause.");
  await page.waitForFunction(() => [...document.querySelectorAll(".cm-completionLabel")].map(({ textContent }) => textContent).join() === "IN,PT,Q,ET");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.keyboard.type(";");
  await page.keyboard.press("Enter");
  assert.match(await keptText(page), /lamp := pause\.Q;\nEND_PROGRAM/);
  await page.context().close();
});

test("a name gives way to another, by F2 and by the menu", async () => {
  const page = await begin();
  await stand(page, "lamp := pause", 2);
  await page.keyboard.press("F2");
  await page.locator(".rename input").fill("light");
  await clean(page, ".text-menu");
  await page.keyboard.press("Enter");
  await page.locator(".cm-line", { hasText: "light := pause.Q;" }).waitFor();
  assert.match(await keptText(page), /light AT %QX1 : BOOL;/);
  // What cannot be a name is told, and nothing changes.
  await stand(page, "light := pause", 2);
  await page.locator(".text-menu button").first().click();
  await page.click("#assist-rename");
  await page.locator(".rename input").fill("WHILE");
  await page.locator(".rename button").click();
  await page.locator("#notes", { hasText: "WHILE" }).waitFor();
  assert.match(await keptText(page), /light := pause\.Q;/);
  await page.context().close();
});

test("its declaration, its uses, and what it stands for", async () => {
  const page = await begin();
  await stand(page, "lamp := pause", 10);
  await page.keyboard.press("Shift+F12");
  const uses = page.locator(".text-menu .at-point button");
  await uses.first().waitFor();
  assert.equal(await uses.count(), 3);
  await page.keyboard.press("Escape");
  await stand(page, "lamp := pause", 10);
  await page.keyboard.press("F12");
  await page.locator(".cm-activeLine", { hasText: "pause : TON" }).waitFor();
  await page.locator(".cm-line", { hasText: "start AT" }).hover({ position: { x: 30, y: 8 } });
  await page.locator(".meant", { hasText: "start AT %IX1 : BOOL" }).waitFor();
  await page.context().close();
});

test("a text is formed, and a mistake fixed", async () => {
  const page = await begin();
  await type(page, TEXT.replace("lamp := pause.Q;", "   lamp:=pausa.Q ;"), "main.st");
  await page.locator("#problem-count.bad").waitFor();
  await stand(page, "lamp:=", 4);
  await page.keyboard.press("Control+.");
  await page.locator(".text-menu .at-point button", { hasText: "pause" }).click();
  await page.locator("#problem-count.good").waitFor();
  await page.keyboard.press("Shift+Alt+F");
  await page.locator(".cm-line", { hasText: /^lamp := pause\.Q;$/ }).waitFor();
  assert.equal(await keptText(page), TEXT);
  await page.context().close();
});

test("a finger that stays opens the menu", async () => {
  const page = await begin();
  await page.locator(".cm-line", { hasText: "lamp := pause" }).dispatchEvent("contextmenu", { clientX: 200, clientY: 300, bubbles: true });
  await page.locator("#assist-format").waitFor();
  assert.equal(await page.locator(".text-menu .at-point button").count(), 6);
  await page.context().close();
});
