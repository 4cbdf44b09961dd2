// The settings of the board: read, changed, refused by name, used from its next start on; and the way back.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, findings, keptHere, run, state, tab } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Opens the tab, and waits until the board has told. @param {import("playwright-core").Page} page */
async function settings(page) {
  await tab(page, "settings");
  await page.locator("#settings-restart").waitFor();
}

/** Keeps what stands in the form, and waits for what is said of it.
 * @param {import("playwright-core").Page} page @param {RegExp} said */
async function keep(page, said) {
  await page.click("#settings-keep");
  await page.locator("#settings-said", { hasText: said }).waitFor();
}

for (const { locale, refused, next, speaks, restarts } of [
  { locale: "en-US", refused: /address 300 is not valid; a board has an address from 1 to 247/, next: /stored these settings and uses them after its next start/, speaks: /still uses address 1, 115200 baud, no parity/, restarts: "#reset" },
  { locale: "pt-BR", refused: /o endereço 300 não é válido; uma placa tem um endereço de 1 a 247/, next: /guardou esses ajustes e passa a usá-los na próxima partida/, speaks: /ainda usa o endereço 1, 115200 baud, sem paridade/, restarts: "#settings-restart" },
]) {
  test(`settings are read, refused by name, kept, and used from the next start on, ${locale}`, async () => {
    const page = await lab.open({ locale });
    await run(page);
    await settings(page);
    assert.deepEqual(await findings(page), []);
    const values = () => Promise.all(["#set-address", "#set-rate", "#set-parity"].map((field) => page.inputValue(field)));
    assert.deepEqual(await values(), ["1", "115200", "0"]);
    await page.fill("#set-address", "300");
    await keep(page, refused);
    await page.fill("#set-address", "17");
    await page.selectOption("#set-rate", "38400");
    await page.selectOption("#set-parity", "1");
    await keep(page, next);
    await page.locator("#settings-about", { hasText: speaks }).waitFor();
    // It was stopped for that, and runs again.
    await state(page, "RUN");
    await page.click(restarts);
    await page.locator("#settings-about:not(:empty)").filter({ hasNotText: speaks }).waitFor();
    await page.locator("#settings-restart").waitFor();
    assert.deepEqual(await values(), ["17", "38400", "1"]);
    await state(page, "RUN");
    // The page knows it still after a reload.
    await page.reload();
    await state(page, "RUN");
    await page.context().close();
  });
}

test("a lock holds at once, only grows, and is lifted at the board alone", async () => {
  const page = await lab.open();
  await run(page);
  await settings(page);
  await page.check("#set-lockWriting");
  await page.check("#set-lockSettings");
  await keep(page, /the board keeps these settings/);
  await page.locator("#set-lockWriting:disabled").waitFor();
  await page.fill("#set-address", "2");
  await keep(page, /settings of the board are locked/);
  await tab(page, "watch");
  await page.locator('tr[data-point="Q1"]').getByRole("button", { name: "force to 1" }).click();
  await page.locator("#notes", { hasText: "locked" }).waitFor();
  // A5 and the inputs 01 to 04 to ground, and a reset.
  await page.click("#stop-switch");
  await page.click("#latch");
  for (const input of [1, 2, 3, 4]) await page.click(`[data-input="${input}"]`);
  await page.click("#reset");
  await page.locator("#serial-text", { hasText: /STOP\s*$/ }).waitFor({ state: "attached" });
  await settings(page);
  await page.locator("#set-lockWriting:enabled").waitFor();
  await keep(page, /the board keeps these settings/);
  await page.context().close();
});

test("a board that is set otherwise is sought as a person says", async () => {
  const page = await lab.open();
  await settings(page);
  await page.fill("#set-address", "9");
  await keep(page, /next start/);
  // Another browser does not know it.
  const eeprom = await keptHere(page, "eeprom");
  await page.context().close();
  const other = await lab.other({}, { eeprom: eeprom ?? "" });
  await tab(other, "settings");
  await other.locator("#settings-about", { hasText: "No board answers at address 1" }).waitFor();
  assert.deepEqual(await findings(other), []);
  await other.fill("#set-address", "9");
  await other.click("#settings-keep");
  await other.locator("#settings-restart").waitFor();
  assert.equal(await other.inputValue("#set-address"), "9");
  await other.context().close();
});
