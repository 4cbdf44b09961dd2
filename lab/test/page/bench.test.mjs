// The simulated board as a class sees it: card, plug, reset, faults, values; and the tutorial.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, lamp, run, state, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("a card runs its program after a reset, and shows its files", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nST Q2\n", "card.il");
  await page.locator('.ladder .element[data-point="Q2"]').waitFor();
  await page.click("#tab-card");
  await page.click("#make-card");
  await page.locator("#panel-card pre").first().waitFor();
  assert.match((await page.textContent("#panel-card")) ?? "", /PROGRAM\.TXT[^]*877902[^]*STATE\.TXT/);
  await page.click("#reset");
  await state(page, "RUN");
  await page.click("#tab-serial");
  await page.locator("#panel-serial", { hasText: "RUN" }).waitFor();
  await page.locator('[data-input="1"]').hover();
  await page.mouse.down();
  await lamp(page, 2, true);
  await page.mouse.up();
  await page.context().close();
});

test("the plug is pulled in the middle of a write, and the board says so at its next start", async () => {
  const page = await lab.open();
  await page.locator("summary").click();
  await page.click("#plug-at-write");
  await page.click("#run");
  await page.locator("#status", { hasText: "No power" }).waitFor();
  await page.locator("#plug:not(:checked)").waitFor();
  await page.click("#plug");
  await state(page, "FAULT");
  await run(page);
  await page.context().close();
});

test("the STOP switch stops, and a program too large is refused by name", async () => {
  const page = await lab.open();
  await run(page);
  await page.click("#stop-switch");
  await state(page, "STOP");
  await page.click("#stop-switch");
  await state(page, "RUN");
  await page.locator("summary").click();
  await page.click("#too-large");
  await page.locator("#problem-count.bad").waitFor();
  await page.locator("#notes").getByRole("button", { name: "Undo" }).click();
  await page.locator("#problem-count.good").waitFor();
  await page.context().close();
});

test("a knob turns an analogue input, and a register is set", async () => {
  const page = await lab.open();
  await type(page, "LD IW0\nGT 600\nST Q1\nLD MW1\nGT 5\nST Q2\n", "level.il");
  await run(page);
  await lamp(page, 1, false);
  await page.fill('[data-analogue="0"]', "900");
  await lamp(page, 1, true);
  await page.click("#tab-watch");
  const row = page.locator('tr[data-point="D1"]');
  await row.locator("input").fill("7");
  await row.getByRole("button", { name: "Set" }).click();
  await row.locator(".value", { hasText: "7" }).first().waitFor();
  await lamp(page, 2, true);
  await page.context().close();
});

test("each step of the tutorial passes its own check, and its solution the exercise", async () => {
  const page = await lab.open();
  await page.click("#lessons");
  const lesson = page.locator("#lesson");
  for (let step = 1; ; step++) {
    await lesson.locator(".chip", { hasText: `Step ${step} of` }).waitFor();
    await lesson.getByRole("button", { name: "Open this program" }).click();
    await lesson.getByRole("button", { name: "Check the step" }).click();
    await lesson.locator("#verdict.good").waitFor();
    await lesson.getByRole("button", { name: "Check the exercise" }).click();
    await lesson.locator("#verdict.bad").waitFor();
    await lesson.getByRole("button", { name: "Show a solution" }).click();
    await lesson.getByRole("button", { name: "Check the exercise" }).click();
    await lesson.locator("#verdict.good").waitFor();
    const next = lesson.getByRole("button", { name: "Next step" });
    if ((await next.count()) === 0) break;
    await next.click();
  }
  await page.context().close();
});

test("the page works without its server, once it was there", async () => {
  const page = await lab.open();
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
  await page.context().setOffline(true);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  await run(page);
  await page.context().close();
});
