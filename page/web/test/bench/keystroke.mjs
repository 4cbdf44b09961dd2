// From a key to the underlined problem, in a text of 300 lines in a real Chromium: `npm run bench`. The median of many counts.
// @ts-check

import { Lab, type } from "../page/harness.mjs";

const LINES = 300;
const KEYS = 30;

const il = Array.from({ length: LINES / 3 }, (_, number) => `LD I${1 + (number % 8)}\nST M${1 + (number % 64)}\n`).join("\n");
const statements = Array.from({ length: LINES - 24 }, (_, number) => `v${number % 20} := v${(number + 3) % 20} + ${number % 7};`);
const st = `PROGRAM p\nVAR\n${Array.from({ length: 20 }, (_, number) => `v${number} : INT;\n`).join("")}END_VAR\n${statements.join("\n")}\nEND_PROGRAM\n`;

/** Runs in the page: notes how long after a key the underlined problems come or go. */
function witness() {
  /** @type {any} */
  const ends = globalThis;
  ends.took = [];
  let pressed = 0;
  let were = 0;
  addEventListener("keydown", () => {
    pressed = performance.now();
  }, true);
  const look = () => {
    const are = document.querySelectorAll(".cm-lintRange-error").length;
    if (are !== were) ends.took.push(performance.now() - pressed);
    were = are;
  };
  new MutationObserver(look).observe(/** @type {Element} */ (document.querySelector(".cm-content")), { subtree: true, childList: true, attributes: true });
}

const lab = await Lab.begin();
for (const [name, text] of [["a.il", il], ["a.st", st]]) {
  const page = await lab.still();
  await type(page, /** @type {string} */ (text), name);
  await page.click("#view-text");
  await page.locator("#problem-count").waitFor();
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+Home");
  await page.evaluate(witness);
  for (let key = 0; key < KEYS; key += 1) {
    await page.keyboard.press(key % 2 ? "Backspace" : "?");
    await page.waitForFunction((count) => /** @type {any} */ (globalThis).took.length > count, key);
  }
  /** @type {number[]} */
  const took = await page.evaluate("took");
  const sorted = took.sort((a, b) => a - b);
  console.log(`${LINES} lines of ${name}, from a key to the underlined problem: ${sorted[Math.floor(sorted.length / 2)]?.toFixed(1)} ms, at most ${sorted.at(-1)?.toFixed(1)} ms`);
}
await lab.end();
