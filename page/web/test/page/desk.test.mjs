// The UNO on the desk: WebSerial, with the port replaced by a second simulated board.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, pick, run, type } from "./harness.mjs";
import { connected } from "./plugged.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("a board at a port is found, takes a program, is live, and is lost", async () => {
  const page = await connected(lab);
  await run(page);
  // A button of the page forces the input of the board, and says so.
  await holding(page, 1, async () => {
    await page.locator('.place.is-forced [data-input="1"]').waitFor();
    await page.locator('[data-output="1"][data-on="true"]').waitFor();
  });
  await page.locator('.place:not(.is-forced) [data-input="1"]').waitFor();
  await page.locator('.ladder.live .element.on[data-point="Q1"]').first().waitFor();
  await page.evaluate("port.pull()");
  await page.locator("#notes", { hasText: "The connection to the board is lost" }).waitFor();
  // The way back is the simulated board.
  await pick(page, "#connect");
  await page.locator("#hardware").waitFor();
  await page.context().close();
});

test("a program in a typed language goes to a board at a port without a reset, and the line stays open", async () => {
  const page = await connected(lab);
  await type(page, "PROGRAM p\nVAR on AT %IX1 : BOOL; lamp AT %QX2 : BOOL; END_VAR\nlamp := on;\nEND_PROGRAM\n", "lamp.st");
  await page.locator(".ladder .element[data-point=Q2]").waitFor();
  // The name of the board would vanish with the conversation, and come back with the next.
  await page.evaluate(() => {
    const about = document.querySelector("#desk-about");
    const names = Object.assign(window, { names: [about?.textContent] }).names;
    new MutationObserver(() => names.push(about?.textContent)).observe(about ?? document, { childList: true, characterData: true, subtree: true });
  });
  await run(page);
  await holding(page, 1, () => page.locator('[data-output="2"][data-on="true"]').waitFor());
  await page.locator(".ladder.live").waitFor();
  assert.deepEqual(await page.evaluate("port.did"), ["open"]);
  const names = new Set(/** @type {string[]} */ (await page.evaluate("names")));
  assert.equal(names.size, 1, [...names].join(" | "));
  await page.context().close();
});

test("a browser without WebSerial says which have it", async () => {
  const page = await lab.open();
  await page.evaluate(() => Object.defineProperty(navigator, "serial", { value: undefined, configurable: true }));
  await pick(page, "#connect");
  await page.locator("#notes", { hasText: "Use Chrome, Edge or Opera" }).waitFor();
  assert.ok(await page.isVisible("#hardware"));
  await page.context().close();
});
