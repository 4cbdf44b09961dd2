// The program: typed, checked, drawn, run.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, keptText, lamp, run, state, tab, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("a problem is underlined, listed, and led to", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nSTT Q1\n");
  await page.locator("#problem-count.bad").waitFor();
  await page.locator(".cm-lintRange-error").waitFor();
  assert.equal(await page.locator(".cm-lintRange-error").first().textContent(), "STT");
  await page.click("#problem-count");
  const problem = page.locator(".problems button").first();
  assert.match((await problem.textContent()) ?? "", /IL-\d+.*line 2/);
  await problem.click();
  assert.ok(await page.evaluate(() => document.activeElement?.classList.contains("cm-content")));
  // Run leads to the problems, and nothing is uploaded.
  await tab(page, "trend");
  await page.click("#run");
  assert.equal(await page.getAttribute("#tab-problems", "aria-selected"), "true");
  await page.context().close();
});

test("the points of another PLC get a place, and the text comes back", async () => {
  const page = await lab.open();
  const other = "VAR a AT %QX1.3 : BOOL; END_VAR\na := %IX2.0;\n";
  await type(page, other, "other.st");
  await page.locator("#problem-count.bad").waitFor();
  await page.click("#problem-count");
  await page.click("#adapt");
  await page.locator("#problem-count.good").waitFor();
  assert.match(await keptText(page), /%QX1\.3 -> %QX0\.0[^]*a AT %QX0\.0[^]*a := %IX0\.0;/);
  await page.locator("#notes button", { hasText: "Undo" }).click();
  await page.locator("#problem-count.bad").waitFor();
  assert.equal(await keptText(page), other);
  // What finds none is told.
  await type(page, Array.from({ length: 5 }, (_, bit) => `%QX1.${bit} := TRUE;`).join("\n"));
  await page.locator("#adapt").click();
  await page.locator("#notes", { hasText: "no free point left for %QX1.4" }).waitFor();
  await page.context().close();
});

test("seal-in runs on the simulated board by mouse", async () => {
  const page = await lab.open();
  await run(page);
  await lamp(page, 1, false);
  await holding(page, 1, () => lamp(page, 1, true));
  // The ladder is live: power comes by the seal-in contact, no longer by the button.
  await page.locator('.ladder.live .element.on[data-point="Q1"]').first().waitFor();
  await page.locator('.ladder.live .element[data-point="I1"]:not(.on)').waitFor();
  await page.locator(".cm-powered", { hasText: "OR   motor" }).waitFor();
  await lamp(page, 1, true);
  await holding(page, 2, () => lamp(page, 1, false));
  await page.context().close();
});

test("seal-in runs by the keyboard alone", async () => {
  const page = await lab.open();
  await page.keyboard.press("Control+Enter");
  await state(page, "RUN");
  // Keys work as soon as nothing is typed into.
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
  await page.keyboard.down("1");
  await lamp(page, 1, true);
  await page.keyboard.up("1");
  await page.locator('[data-input="1"][aria-pressed="false"]').waitFor();
  await lamp(page, 1, true);
  // Shift latches.
  await page.keyboard.press("Shift+2");
  await page.locator('[data-input="2"].latched').waitFor();
  await lamp(page, 1, false);
  await page.keyboard.press("Shift+2");
  // A button that has the focus is pressed by space.
  await page.focus('[data-input="1"]');
  await page.keyboard.down(" ");
  await lamp(page, 1, true);
  await page.keyboard.up(" ");
  await page.context().close();
});

test("nothing typed is lost by a reload", async () => {
  const page = await lab.still();
  await type(page, "LD I3\nST Q3\n", "mine.il");
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  assert.equal(await page.inputValue("#name"), "mine.il");
  assert.match((await page.textContent(".cm-content")) ?? "", /LD I3/);
  await page.context().close();
});

test("a program in a typed language runs, live", async () => {
  const page = await lab.open();
  const text = "VAR\n  count : DINT;\n  go AT %IX1 : BOOL;\n  lamp AT %QX1 : BOOL;\nEND_VAR\nIF go THEN count := count + 1; END_IF;\nlamp := count > 100;\n";
  await type(page, text, "count.st");
  await page.locator("#tongue", { hasText: "Structured Text" }).waitFor();
  await page.locator('.ladder .element[data-point="Q1"]').first().waitFor();
  await run(page);
  await lamp(page, 1, false);
  await holding(page, 1, () => lamp(page, 1, true));
  await page.locator(".ladder.live").waitFor();
  await page.context().close();
});

test("each keystroke in 300 lines changes the problems", async () => {
  const page = await lab.still();
  const rungs = Array.from({ length: 75 }, (_, index) => `LD I${(index % 4) + 1}\nANDN M${(index % 60) + 1}\nOR I3\nST M${((index + 7) % 60) + 1}\n`);
  await type(page, rungs.join(""));
  await page.locator("#problem-count").waitFor();
  const took = [];
  for (let time = 0; time < 10; time++) {
    took.push(await page.evaluate(async () => {
      const content = /** @type {HTMLElement} */ (document.querySelector(".cm-content"));
      content.focus();
      const count = document.querySelector("#problem-count");
      const before = count?.textContent;
      const begun = performance.now();
      document.execCommand("insertText", false, "?");
      while (count?.textContent === before) await new Promise((next) => requestAnimationFrame(next));
      return performance.now() - begun;
    }));
    await page.keyboard.press("Enter");
  }
  took.sort((one, other) => one - other);
  console.log(`keystroke to problems: ${took.map((ms) => ms.toFixed(0)).join(" ")} ms`);
  await page.context().close();
});

