// Every function of the page by every hand: mouse, touch at 390 × 844, the keyboard alone. One page for each hand; a step
// leaves the board in RUN and nothing held.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { EDITOR, HANDS } from "./hands.mjs";
import { Lab, findings, lamp, pick, select, state, still, tab } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page @typedef {import("./hands.mjs").Hand} Hand */

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Counts presses of button 1, adds 1 to D1 with each scan, compares a knob; the lamp 4 follows button 3. */
const PROGRAM = "LD I1\nCTU C1, I2, 1000\nLD D1\nADD 1\nST D1\nLD IW0\nGT 900\nST Q1\nLD I3\nST Q4\n";

/** @param {Page} page @param {string} text */
const noted = (page, text) => page.locator("#notes", { hasText: text }).waitFor();

/** @param {Page} page @param {string} point */
async function value(page, point) {
  return Number.parseInt((await page.textContent(`tr[data-point="${point}"] .value`)) ?? "", 10);
}

/** What is saved by doing this. @param {Page} page @param {() => Promise<void>} act */
async function saved(page, act) {
  const download = page.waitForEvent("download");
  await act();
  const file = await download;
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "latin1") };
}

/** @param {Page} page @param {() => Promise<void>} act @param {string} name @param {Buffer} buffer */
async function opened(page, act, name, buffer) {
  const chooser = page.waitForEvent("filechooser");
  await act();
  await (await chooser).setFiles({ name, mimeType: "text/plain", buffer });
}

/** @param {Page} page @param {string} name */
const named = (page, name) => page.getByRole("button", { name, exact: true });

/** @type {[string, (page: Page, hand: Hand) => Promise<void>][]} */
const STEPS = [
  ["a program is written, named and run", async (page, hand) => {
    await hand.write(page, "#name", "all.il");
    await hand.write(page, EDITOR, PROGRAM);
    await page.locator('.ladder .element[data-point="Q4"]').waitFor();
    await hand.press(page, "#run");
    await state(page, "RUN");
  }],
  ["a button is held, and latched", async (page, hand) => {
    await hand.hold(page, 3);
    await lamp(page, 4, true);
    await hand.release(page, 3);
    await lamp(page, 4, false);
    await hand.press(page, "#latch");
    await hand.press(page, '[data-input="3"]');
    await lamp(page, 4, true);
    await page.locator('[data-input="3"].latched').waitFor();
    await hand.press(page, '[data-input="3"]');
    await lamp(page, 4, false);
    await hand.press(page, "#latch");
  }],
  ["all buttons are shown", async (page, hand) => {
    await pick(page, "#all-buttons", hand);
    await page.locator('[data-input="8"]').waitFor();
    await pick(page, "#all-buttons", hand);
    await page.locator('[data-input="8"]').waitFor({ state: "hidden" });
  }],
  ["a knob is turned", async (page, hand) => {
    await hand.turn(page, '[data-analogue="0"]', 1);
    await lamp(page, 1, true);
    await hand.turn(page, '[data-analogue="0"]', 0);
    await lamp(page, 1, false);
  }],
  ["time stands, goes on, goes at 1/10 and 1/100", async (page, hand) => {
    await pick(page, "#pause", hand);
    await page.locator("#pace", { hasText: "Time is stopped" }).waitFor();
    await pick(page, "#pause", hand);
    for (const [speed, pace] of /** @type {const} */ ([["0.1", /^0\.(1|0[5-9])\d* × real time/], ["0.01", /^0\.0[01]\d* × real time/], ["1", /^(1|0\.[89])\d* ×/]])) {
      await hand.choose(page, "#speed", speed);
      await page.locator("#pace", { hasText: pace }).waitFor();
    }
  }],
  ["single scans are made, one at a time", async (page, hand) => {
    await tab(page, "watch", hand);
    // In RUN it stops the board, and goes on from where the program is.
    await page.waitForFunction(() => Number.parseInt(document.querySelector('tr[data-point="D1"] .value')?.textContent ?? "", 10) > 0);
    const ran = await value(page, "D1");
    await pick(page, "#scan", hand);
    await state(page, "STOP");
    assert.ok((await value(page, "D1")) >= ran);
    // From the beginning again.
    await pick(page, "#command-run", hand);
    await state(page, "RUN");
    await hand.press(page, "#command-stop");
    await page.waitForFunction(() => document.querySelector('tr[data-point="D1"] .value')?.textContent === "0");
    await pick(page, "#scan", hand);
    await page.waitForFunction(() => Number.parseInt(document.querySelector('tr[data-point="D1"] .value')?.textContent ?? "", 10) > 0);
    const before = await value(page, "D1");
    await pick(page, "#scan", hand);
    await page.waitForFunction((more) => document.querySelector('tr[data-point="D1"] .value')?.textContent === String(more), before + 1);
    await pick(page, "#command-run", hand);
    await state(page, "RUN");
  }],
  ["STOP and RUN by command, by switch, by reset and plug", async (page, hand) => {
    await hand.press(page, "#command-stop");
    await state(page, "STOP");
    await pick(page, "#command-run", hand);
    await state(page, "RUN");
    await hand.press(page, "#stop-switch");
    await state(page, "STOP");
    await hand.press(page, "#stop-switch");
    await state(page, "RUN");
    await hand.press(page, "#plug");
    await page.locator("#status", { hasText: "No power" }).waitFor();
    await hand.press(page, "#plug");
    await state(page, "RUN");
    await tab(page, "serial", hand);
    await hand.press(page, "#reset");
    await page.locator("#serial-text", { hasText: /unoclp[^]*RUN[^]*unoclp[^]*RUN/ }).waitFor();
    await state(page, "RUN");
  }],
  ["an input is forced and let go, a register set", async (page, hand) => {
    await tab(page, "watch", hand);
    const row = page.locator('tr[data-point="I3"]');
    await hand.press(page, row.getByRole("button", { name: "force to 1" }));
    await page.locator('tr[data-point="I3"].is-forced').waitFor();
    await lamp(page, 4, true);
    await page.locator('.ladder .element.forced[data-point="I3"]').waitFor();
    await hand.press(page, row.getByRole("button", { name: "release" }));
    await lamp(page, 4, false);
    await hand.press(page, row.getByRole("button", { name: "force to 0" }));
    await page.locator('tr[data-point="I3"].is-forced').waitFor();
    await hand.press(page, "#release");
    await page.locator('tr[data-point="I3"]:not(.is-forced)').waitFor();
    await hand.write(page, 'tr[data-point="D1"] input', "1000000");
    await page.locator('tr[data-point="D1"] .value', { hasText: /^1\d{6}/ }).waitFor();
  }],
  ["a contact bounces, and is counted more than once", async (page, hand) => {
    await hand.press(page, "#bouncing");
    const before = await value(page, "C1");
    const presses = 3;
    for (let press = 0; press < presses; press++) {
      await hand.hold(page, 1);
      await page.locator('[data-input="1"][aria-pressed="true"]').waitFor();
      await hand.release(page, 1);
    }
    await page.waitForFunction((most) => Number(document.querySelector('tr[data-point="C1"] .value')?.textContent) > most, before + presses);
    await hand.press(page, "#bouncing");
  }],
  ["a card is made, pulled out, and put in again", async (page, hand) => {
    await tab(page, "card", hand);
    await hand.press(page, "#make-card");
    await page.locator("#panel-card pre").first().waitFor();
    await hand.press(page, "#reset");
    await state(page, "RUN");
    await hand.press(page, "#pull-card");
    await page.locator("#panel-card", { hasText: "The slot is empty" }).waitFor();
    await page.locator("#card-in:not(:checked)").waitFor();
    // Without a card it runs what its EEPROM keeps.
    await hand.press(page, "#reset");
    await state(page, "RUN");
    await hand.press(page, "#card-in");
    await page.locator("#panel-card", { hasText: "PROGRAM.TXT" }).waitFor();
    await hand.press(page, "#card-in");
  }],
  ["the timing diagram is read, zoomed, and exported", async (page, hand) => {
    await tab(page, "trend", hand);
    await hand.choose(page, '[aria-label="Seconds shown"]', "120");
    await hand.press(page, "#trendBefore");
    const reading = page.locator("#trend-reading");
    await reading.filter({ hasText: /^\d+\.\d{3} s, .*I3 = [01]/ }).waitFor();
    await page.locator("#follow[aria-pressed=false]").waitFor();
    const first = await reading.textContent();
    await hand.press(page, "#trendBefore");
    await reading.filter({ hasNotText: first ?? "" }).waitFor();
    await hand.press(page, "#trendAfter");
    await reading.filter({ hasText: first ?? "" }).waitFor();
    const shown = () => page.evaluate(() => document.querySelector(".trend canvas")?.toDataURL());
    const before = await shown();
    await hand.press(page, "#zoomIn");
    assert.notEqual(await shown(), before);
    await hand.press(page, "#zoomOut");
    await hand.press(page, page.locator(".channels input").first());
    await reading.filter({ hasNotText: "I1 =" }).waitFor();
    const csv = await saved(page, () => hand.press(page, named(page, "Export CSV")));
    assert.match(csv.text, /^ms,I2,I3/);
    assert.match((await saved(page, () => hand.press(page, named(page, "Export SVG")))).text, /^<svg/);
    await hand.press(page, "#follow");
    await page.locator("#follow[aria-pressed=true]").waitFor();
    await hand.press(page, named(page, "Clear"));
  }],
  ["files are opened and saved", async (page, hand) => {
    // Until a program is run again, no step needs the board.
    await still(page);
    const entry = (/** @type {string} */ name) => async () => {
      await hand.press(page, "#menu-fileMenu");
      await hand.press(page, named(page, name));
    };
    await opened(page, entry("Open…"), "mine.il", Buffer.from("LD I2\nST Q2\n"));
    await page.locator('.ladder .element[data-point="Q2"]').waitFor();
    await hand.press(page, page.locator("#notes").getByRole("button", { name: "Undo" }));
    await page.locator('.ladder .element[data-point="Q4"]').waitFor();
    assert.deepEqual(await saved(page, entry("Save")), { name: "all.il", text: PROGRAM });
    assert.match((await saved(page, entry("Save PROGRAM.TXT"))).text, /787600/);
    const image = await saved(page, entry("Save a card image"));
    await tab(page, "card", hand);
    await opened(page, () => hand.press(page, "#open-card"), "card.img", Buffer.from(image.text, "latin1"));
    await page.locator("#panel-card pre", { hasText: "787600" }).first().waitFor();
    await hand.press(page, "#card-in");
    await pick(page, "#examples", hand);
    await hand.press(page, page.getByRole("button", { name: "stairs.il" }));
    await page.locator("#notes").getByRole("button", { name: "Undo" }).waitFor();
    assert.equal(await page.inputValue("#name"), "stairs.il");
    await hand.press(page, page.locator("#notes").getByRole("button", { name: "Undo" }));
  }],
  ["a link is shared, and opened", async (page, hand) => {
    await pick(page, "#share", hand);
    await noted(page, "clipboard");
    const link = await page.evaluate(() => navigator.clipboard.readText());
    await hand.write(page, EDITOR, "LD I1\nST Q1\n");
    await page.evaluate((hash) => void (location.hash = hash), new URL(link).hash);
    await noted(page, "comes from a link");
    assert.match((await page.textContent(".cm-content")) ?? "", /CTU C1/);
  }],
  ["problems are listed and led to", async (page, hand) => {
    await hand.press(page, named(page, "Text"));
    await hand.write(page, EDITOR, "LD I1\nSTT Q1\n");
    await page.locator("#problem-count.bad").waitFor();
    await tab(page, "problems", hand);
    await hand.press(page, page.locator(".problems button"));
    await page.locator(".cm-content:focus").waitFor();
    await hand.press(page, named(page, "Both"));
    await hand.write(page, EDITOR, PROGRAM);
    await page.locator("#problem-count.good").waitFor();
  }],
  ["a fault of the board: the plug goes in the middle of a write", async (page, hand) => {
    // What is the same in the EEPROM is not written.
    await hand.write(page, EDITOR, PROGRAM.replace("900", "800"));
    await page.locator("#problem-count.good").waitFor();
    await hand.press(page, "#plug-at-write");
    await hand.press(page, "#run");
    await page.locator("#status", { hasText: "No power" }).waitFor();
    await hand.press(page, "#plug");
    // What was cut off is no program: a fault, or none that was there before.
    await page.locator("#status:is([data-state=FAULT], [data-state=EMPTY])").waitFor();
    await hand.press(page, "#run");
    await state(page, "RUN");
  }],
  ["a program too large is refused, and undone", async (page, hand) => {
    await hand.press(page, "#too-large");
    await page.locator("#problem-count.bad").waitFor();
    await hand.press(page, page.locator("#notes").getByRole("button", { name: "Undo" }));
    await page.locator("#problem-count.good").waitFor();
  }],
  ["a step of the tutorial is read, done, and left", async (page, hand) => {
    await pick(page, "#lessons", hand);
    for (const name of ["Open this program", "Check the step", "Show a solution", "Check the exercise", "Next step", "Previous step"]) await hand.press(page, named(page, name));
    await page.locator("#lesson .chip", { hasText: "Step 1 of" }).waitFor();
    await hand.press(page, page.locator("#lesson").getByRole("button", { name: "Close" }));
    await page.locator("#lesson").waitFor({ state: "hidden" });
  }],
  ["settings are kept", async (page, hand) => {
    await tab(page, "settings", hand);
    await page.locator("#settings-restart").waitFor();
    await hand.choose(page, "#set-rate", "57600");
    await hand.press(page, "#set-direction");
    await hand.press(page, "#settings-keep");
    await page.locator("#settings-said", { hasText: "next start" }).waitFor();
    await hand.press(page, "#settings-restart");
    await page.locator("#settings-about", { hasText: "Stored settings" }).waitFor();
    await state(page, "RUN");
  }],
  ["the ladder is enlarged, the page made dark, and spoken in Portuguese", async (page, hand) => {
    await still(page);
    const width = async () => Number(await page.getAttribute("#ladder svg", "width"));
    const before = await width();
    await hand.press(page, named(page, "Larger"));
    assert.ok((await width()) > before);
    await pick(page, "#theme", hand);
    assert.equal(await page.getAttribute("html", "data-theme"), "dark");
    assert.deepEqual(await findings(page), []);
    await select(page, "#speak", "pt", hand);
    await page.locator("#run", { hasText: "Executar" }).waitFor();
  }],
];

for (const hand of HANDS) {
  test(`by ${hand.name}`, async (t) => {
    const page = await lab.open({ permissions: ["clipboard-read", "clipboard-write"], ...hand.options });
    for (const [name, step] of STEPS) await t.test(`${name}, by ${hand.name}`, () => step(page, hand));
    await page.context().close();
  });
}
