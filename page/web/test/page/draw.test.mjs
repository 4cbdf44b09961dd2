// Programs that are drawn from an empty page: by keyboard alone, by mouse, by touch.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fingers, holding, mouse, touch } from "./hands.mjs";
import { Lab, clean, keptText, lamp, lightAndDark, pick, pictures, run, select, still, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** What the three programs compile to. */
const SEAL_IN = [0, 827301, 40, 827901, 41, -827302, 877901];
const TON_CHAIN = [0, 827301, 847978, 400, 7901, 787600, 828401, 847978, 200, 7902];
const COUNTER = [0, 827301, 67848501, 5, 787600, 827302, 67846801, 5, 787600, 76686701, 716900, 3, 877901];

/** The codes of what is drawn, as the page shows them. @param {Page} page */
async function codes(page) {
  await pick(page, "#draw-texts");
  await page.selectOption("#texts select", "numeric");
  const text = page.locator("#texts pre", { hasText: /^(\/.*\n)*0\n/ });
  await text.waitFor();
  const lines = ((await text.textContent()) ?? "").split("\n");
  await page.locator("#texts header button").click();
  return lines.map((line) => line.split("/")[0]?.trim()).filter(Boolean).map(Number);
}

/** Presses keys in turn; what begins with = is typed. @param {Page} page @param {string} presses separated by blanks */
async function keys(page, presses) {
  for (const press of presses.split(" ")) {
    if (press.startsWith("=")) await page.keyboard.insertText(press.slice(1).replaceAll("_", " "));
    else {
      await page.keyboard.press(press);
      if (press === "Enter") await page.locator("#sheet:focus").waitFor();
      else if (/^(Shift\+)?[a-z.]$/i.test(press)) await page.locator(".at-element").waitFor();
    }
  }
}

/** Undoes all, after a reload, and says what is left. @param {Page} page */
async function undone(page) {
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  await still(page);
  await page.locator("#sheet .element").first().waitFor();
  await page.focus("#sheet");
  for (let left = 100; left > 0 && (await page.isEnabled("#draw-undo")); left--) {
    const before = await page.locator("#sheet svg").innerHTML();
    await page.keyboard.press("Control+z");
    await page.waitForFunction((before) => document.querySelector("#sheet svg")?.innerHTML !== before || document.querySelector("#draw-undo:disabled"), before);
  }
  await page.locator("#draw-undo:disabled").waitFor();
  return { elements: await page.locator("#sheet .element").count(), text: await keptText(page) };
}

/** What the seal-in does on the board. @param {Page} page */
async function sealsIn(page, hand = mouse) {
  await run(page);
  await holding(page, 1, () => lamp(page, 1, true), hand);
  await page.locator('#sheet .ladder.live .element.on[data-point="Q1"]').first().waitFor();
  await page.screenshot({ path: join(pictures, `draw-seal-in-${hand.name}.png`) });
  await holding(page, 2, () => lamp(page, 1, false), hand);
}

/** What the chain of timers does on the board. @param {Page} page */
async function chains(page) {
  await run(page);
  await page.keyboard.press("Escape");
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement)?.blur());
  await page.keyboard.press("Shift+1");
  await lamp(page, 1, true);
  await lamp(page, 2, true);
}

/** What the counter does on the board. @param {Page} page */
async function counts(page) {
  await run(page);
  for (let time = 0; time < 3; time++) {
    // Shorter than a scan nothing is counted: the drawing says when the board has seen it.
    await holding(page, 1, () => page.locator('#sheet .ladder.live .element.on[data-point="I1"]').waitFor());
    await page.locator('#sheet .ladder.live .element:not(.on)[data-point="I1"]').waitFor();
  }
  await lamp(page, 1, true);
  await holding(page, 2, () => lamp(page, 1, false));
}

test("seal-in with a branch, by the keyboard alone", async () => {
  const page = await lab.emptySheet();
  await page.focus("#sheet");
  await keys(page, "c =I1_start Enter k =I2_stop Enter l =Q1_motor Enter ArrowLeft ArrowLeft Shift+C =motor Enter");
  assert.deepEqual(await codes(page), SEAL_IN);
  await page.locator("#live", { hasText: "contact Q1, normally open motor, rung 1" }).waitFor({ state: "attached" });
  await sealsIn(page);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

test("a chain of timers, by the keyboard alone", async () => {
  const page = await lab.emptySheet();
  await page.focus("#sheet");
  await keys(page, "c =I1 Enter o =Q1 Tab Tab =400 Enter Shift+Enter");
  await page.locator('#sheet .rung[data-rung="2"]').waitFor();
  await keys(page, "c =T1 Enter o =Q2 Tab Tab =200 Enter");
  assert.deepEqual(await codes(page), TON_CHAIN);
  await chains(page);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

test("an up-down counter with a comparison, by the keyboard alone", async () => {
  const page = await lab.emptySheet();
  await page.focus("#sheet");
  await keys(page, "c =I1 Enter u =C1 Tab Tab =5 Enter Shift+Enter");
  await page.locator('#sheet .rung[data-rung="2"]').waitFor();
  await keys(page, "c =I2 Enter i =C1 Tab Tab =5 Enter Shift+Enter");
  await page.locator('#sheet .rung[data-rung="3"]').waitFor();
  await keys(page, ". =C1 Tab =3 Enter l =Q1 Enter");
  assert.deepEqual(await codes(page), COUNTER);
  await counts(page);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

/** Fills the form that is open. @param {Page} page @param {Record<string, string>} fields */
async function fill(page, fields) {
  for (const [key, value] of Object.entries(fields)) await page.fill(`#field-${key}`, value);
  await page.click(".at-element button[type=submit]");
  await page.locator(".at-element").waitFor({ state: "detached" });
}

/** Inserts by a click on the palette. @param {Page} page @param {string} what @param {Record<string, string>} fields */
async function place(page, what, fields) {
  await page.click(`.palette [data-what="${what}"]`);
  await fill(page, fields);
}

/** Where the first of these is: brought into view and measured at once, for the sheet may be drawn again between the two.
 * @param {Page} page @param {string} selector @returns {Promise<{ x: number, y: number, width: number, height: number }>} */
async function boxOf(page, selector) {
  const box = await page.waitForFunction((selector) => {
    const found = document.querySelector(selector);
    found?.scrollIntoView({ block: "nearest", inline: "nearest" });
    const { x, y, width, height } = found?.getBoundingClientRect() ?? new DOMRect();
    return width > 0 && { x, y, width, height };
  }, selector);
  return /** @type {Promise<any>} */ (box.jsonValue());
}

/** Drags an element of the palette onto the sheet. @param {Page} page @param {string} what @param {string} onto
 * @param {[number, number]} at of its size @param {string} picture */
async function drag(page, what, onto, at, picture = "") {
  const box = await boxOf(page, onto);
  await page.locator(`.palette [data-what="${what}"]`).hover();
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * at[0], box.y + box.height * at[1], { steps: 4 });
  await page.locator(".places .near").waitFor();
  if (picture) await page.screenshot({ path: join(pictures, picture) });
  await page.mouse.up();
}

test("seal-in with a branch, by mouse: dragged onto places that light up", async () => {
  const page = await lab.emptySheet();
  const element = (/** @type {string} */ point) => `#sheet .element[data-point="${point}"] .area`;
  await drag(page, "contact", "#sheet .rung", [0.3, 0.8]);
  await fill(page, { point: "I1", name: "start" });
  await drag(page, "coil", element("I1"), [1.1, 0.4]);
  await fill(page, { point: "Q1", name: "motor" });
  await drag(page, "contact", element("I1"), [0.5, 0.9], "draw-drag.png");
  await fill(page, { point: "motor" });
  // The coil is the one with arcs.
  const coil = '#sheet .element[data-point="Q1"]:has(path[d*="A11"]) .area';
  await drag(page, "closed", coil, [-0.05, 0.4]);
  await fill(page, { point: "I2", name: "stop" });
  assert.deepEqual(await codes(page), SEAL_IN);
  await run(page);
  await holding(page, 1, () => lamp(page, 1, true));
  // A click forces where one operates.
  await pick(page, "#operate");
  await page.locator('#sheet .element[data-point="I2"]').click();
  await lamp(page, 1, false);
  await page.locator('#sheet .element.forced[data-point="I2"]').waitFor();
  await page.locator('#sheet .element[data-point="I2"]').click();
  await page.locator('#sheet .element[data-point="I2"]').click();
  await pick(page, "#operate");
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

/** A new rung behind the last, by the menu. @param {Page} page @param {number} rung */
async function below(page, rung) {
  await page.click("#menu-drawEdit");
  await page.locator(".draw-bar .menu button", { hasText: "New rung below" }).click();
  await page.locator(`#sheet .rung[data-rung="${rung}"]`).waitFor();
}

test("a chain of timers, by mouse", async () => {
  const page = await lab.emptySheet();
  await place(page, "contact", { point: "I1" });
  await place(page, "ton", { point: "Q1", line0: "400" });
  await below(page, 2);
  await place(page, "contact", { point: "T1" });
  await place(page, "ton", { point: "Q2", line0: "200" });
  // What these codes do on the board is seen above.
  assert.deepEqual(await codes(page), TON_CHAIN);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

test("an up-down counter with a comparison, by mouse", async () => {
  const page = await lab.emptySheet();
  await place(page, "contact", { point: "I1" });
  await place(page, "ctu", { point: "C1", line0: "5" });
  await below(page, 2);
  await place(page, "contact", { point: "I2" });
  await place(page, "ctd", { point: "C1", line0: "5" });
  await below(page, 3);
  await place(page, "ge", { left: "C1", operand: "3" });
  await place(page, "coil", { point: "Q1" });
  assert.deepEqual(await codes(page), COUNTER);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

test("seal-in with a branch, by a finger at 390 × 844", async () => {
  const page = await lab.emptySheet({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
  const tap = async (/** @type {string} */ what, /** @type {string} */ point) => {
    await page.locator(`.palette [data-what="${what}"]`).tap();
    await page.fill("#field-point", point);
    await page.locator(".at-element button[type=submit]").tap();
    await page.locator(".at-element").waitFor({ state: "detached" });
  };
  await tap("contact", "I1");
  await tap("closed", "I2");
  await tap("coil", "Q1");
  await page.locator('#sheet .element[data-point="I1"] .area').tap();
  await page.locator('#sheet .element.selected[data-point="I1"]').waitFor();
  await page.locator("#draw-where").tap();
  await tap("contact", "Q1");
  await page.locator("#sheet").scrollIntoViewIfNeeded();
  await page.screenshot({ path: join(pictures, "draw-phone.png") });
  assert.deepEqual(await codes(page), SEAL_IN);
  await sealsIn(page, fingers);
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

for (const [device, width, height] of /** @type {[string, number, number][]} */ ([["a tablet", 1180, 820], ["a phone", 390, 844]])) {
  test(`elements are carried by a finger onto places that light up, on ${device}`, async () => {
    const page = await lab.emptySheet({ viewport: { width, height }, hasTouch: true, isMobile: true });
    const carry = async (/** @type {string} */ what, /** @type {string} */ onto, /** @type {[number, number]} */ [across, down], /** @type {string} */ point) => {
      const to = await boxOf(page, onto);
      const from = await boxOf(page, `.palette [data-what="${what}"]`);
      const [x, y] = [from.x + from.width / 2, from.y + from.height / 2];
      const [toX, toY] = [to.x + to.width * across, to.y + to.height * down];
      await touch(page, "touchStart", x, y);
      for (const share of [0.1, 0.4, 0.7, 1]) await touch(page, "touchMove", x + (toX - x) * share, y + (toY - y) * share);
      await page.locator(".places .near").waitFor();
      await touch(page, "touchEnd");
      await page.fill("#field-point", point);
      await page.keyboard.press("Enter");
      await page.locator(".at-element").waitFor({ state: "detached" });
    };
    const first = '#sheet .element[data-point="I1"] .area';
    await carry("contact", "#sheet .rung", [0.3, 0.8], "I1");
    await carry("coil", first, [1.1, 0.4], "Q1");
    await carry("closed", first, [0.98, 0.4], "I2");
    await carry("contact", first, [0.5, 0.9], "Q1");
    assert.deepEqual(await codes(page), SEAL_IN);
    await page.context().close();
  });
}

test("elements and rungs are copied, moved, found and named", async () => {
  const page = await lab.emptySheet();
  await page.focus("#sheet");
  const settled = (/** @type {string} */ selector) => page.locator(selector).first().waitFor();
  await keys(page, "c =I1_start Enter l =Q1 Enter");
  // A comment, and a name from the table.
  await page.keyboard.press(";");
  await page.fill("#field-comment", "The pump");
  await keys(page, "Enter");
  await page.locator("#sheet .heading", { hasText: "Rung 1: The pump" }).waitFor();
  await pick(page, "#draw-symbols");
  await page.fill("#symbol-point", "Q1");
  await page.fill("#symbol-name", "pump");
  await page.fill("#symbol-comment", "on the roof");
  await page.keyboard.press("Enter");
  await page.locator('#symbols tr[data-point="Q1"]').waitFor();
  await page.locator("#symbols header button").click();
  assert.match(await keptText(page), /\(\* The pump \*\)\nLD {4}start\nST {4}pump/);
  // The contact goes to another rung by the clipboard, and becomes a closed one.
  await page.locator('#sheet .element[data-point="I1"] .area').click();
  await settled('#sheet .element.selected[data-point="I1"]');
  await page.keyboard.press("Control+c");
  await page.keyboard.press("Shift+Enter");
  await settled('#sheet .rung[data-rung="2"]');
  await page.keyboard.press("Control+v");
  await page.keyboard.press("n");
  await settled('#sheet .rung[data-rung="2"] .element[data-point="I1"]');
  await keys(page, "l =Q2 Enter");
  assert.deepEqual(await codes(page), [0, 827301, 877901, 787600, -827301, 877902]);
  await page.focus("#sheet");
  await page.keyboard.press("Alt+ArrowUp");
  await settled('#sheet .rung[data-rung="1"] .element[data-point="Q2"]');
  assert.deepEqual(await codes(page), [0, -827301, 877902, 787600, 827301, 877901]);
  // What is selected is dragged to another place.
  const from = await boxOf(page, '#sheet .rung[data-rung="2"] .element[data-point="I1"] .area');
  const to = await boxOf(page, '#sheet .element[data-point="Q2"] .area');
  await page.mouse.move(from.x + from.width / 2, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move(to.x - 4, to.y + to.height * 0.4, { steps: 4 });
  await settled(".places .near");
  await page.mouse.up();
  await page.locator('#sheet .rung[data-rung="2"] .element[data-point="I1"]').waitFor({ state: "detached" });
  assert.deepEqual(await codes(page), [0, -827301, 827301, 877902, 787600, 877901]);
  await pick(page, "#draw-find");
  await page.fill("#find-words", "roof");
  await page.keyboard.press("Enter");
  await settled('#sheet .element.selected[data-point="Q1"]');
  assert.deepEqual(await undone(page), { elements: 0, text: "" });
  await page.context().close();
});

test("axe-core finds nothing on the drawing screen, light and dark", async () => {
  const page = await lab.emptySheet({ locale: "pt-BR" });
  const shot = (/** @type {string} */ name) => lightAndDark(page, async (colorScheme) => {
    await page.screenshot({ path: join(pictures, `${name}-${colorScheme}.png`) });
  });
  await place(page, "contact", { point: "I1", name: "liga" });
  await page.click('.palette [data-what="ton"]');
  await clean(page, "the form");
  await page.keyboard.press("Escape");
  // Its preset is missing: what is wrong is said.
  await page.locator("#mistakes .error").first().waitFor();
  await clean(page, "a mistake");
  await shot("draw");
  await pick(page, "#draw-symbols");
  await clean(page, "the names");
  await page.locator("#symbols header button").click();
  await page.focus("#sheet");
  await page.keyboard.press("?");
  await page.locator("dialog#keys").waitFor();
  await clean(page, "the keys");
  await shot("draw-keys");
  await page.context().close();
});

test("a text that a hand has changed is drawn, and undo takes it back", async () => {
  const page = await lab.still();
  await page.click("#view-draw");
  await page.locator('#sheet .element[data-point="Q1"]').first().waitFor();
  const before = await keptText(page);
  await page.click("#view-both");
  await type(page, "LD I3\nST Q3\n");
  await page.locator('#ladder .element[data-point="Q3"]').waitFor();
  await page.click("#view-draw");
  await page.locator('#sheet .element[data-point="Q3"]').waitFor();
  await page.click("#draw-undo");
  await page.locator('#sheet .element[data-point="Q3"]').waitFor({ state: "detached" });
  await page.locator('#sheet .element[data-point="Q1"]').first().waitFor();
  assert.equal(await keptText(page), before);
  await page.context().close();
});

test("a program of another language is shown, and a copy of it is drawn", async () => {
  const page = await lab.still();
  await type(page, "VAR\n  go AT %IX1 : BOOL;\n  lamp AT %QX1 : BOOL;\nEND_VAR\nlamp := go;\n", "count.st");
  await page.locator("#tongue", { hasText: "Structured Text" }).waitFor();
  await page.click("#view-draw");
  await page.locator("#draw-copy").waitFor();
  await page.focus("#sheet");
  await page.keyboard.press("Delete");
  await page.locator('#sheet .element[data-point="Q1"]').first().waitFor();
  await page.click("#draw-copy");
  await page.locator("#draw-banner").waitFor({ state: "hidden" });
  assert.equal(await page.inputValue("#name"), "count.il");
  await page.context().close();
});

for (const [locale, width, name] of /** @type {const} */ ([["en-US", "612", "Name:"], ["pt-BR", "59[45]", "Nome:"]])) {
  test(`a drawing is printed on whole pages, no rung on two, ${locale}`, async () => {
    const page = await lab.still({ locale });
    const rungs = Array.from({ length: 30 }, (_, at) => `LD I${(at % 4) + 1}\nST M${at + 1}\n`);
    await type(page, `(* Thirty rungs *)\n${rungs.join("")}`, "thirty.il");
    await page.click("#view-draw");
    await page.locator('#sheet .element[data-point="M30"]').waitFor();
    await page.evaluate(() => {
      window.print = () => undefined;
    });
    await pick(page, "#draw-print");
    const sheets = page.locator("#printed > svg");
    await sheets.first().waitFor({ state: "attached" });
    assert.equal(await page.locator("#printed .rung").count(), 30);
    assert.match((await sheets.first().textContent()) ?? "", new RegExp(`Thirty rungs[^]*${name}`));
    const count = await sheets.count();
    await page.emulateMedia({ media: "print" });
    await page.setViewportSize({ width: 816, height: 1056 });
    await page.screenshot({ path: join(pictures, `draw-print-${locale}.png`) });
    const pdf = (await page.pdf({ preferCSSPageSize: true, printBackground: true })).toString("latin1");
    assert.equal(pdf.match(/\/Type \/Page\b/g)?.length, count, "a page for each sheet");
    assert.match(pdf, new RegExp(`/MediaBox \\[0 0 ${width}`));
    // The browser says when it has printed.
    assert.equal(await page.locator("#printed").count(), 0);
    await page.context().close();
  });
}

for (const [locale, end, names] of /** @type {const} */ ([
  ["en-US", "png", ["start", "stop"]],
  ["pt-BR", "pt-BR.png", ["liga", "desliga"]],
])) {
  test(`the pictures of docs/draw.md: draw-*.${end}`, async () => {
    const page = await lab.emptySheet({ locale, viewport: { width: 1200, height: 720 } });
    const shot = async (/** @type {string} */ name, /** @type {string} */ of) => {
      const picture = await page.locator(of).screenshot({ path: join(pictures, `${name}.${end}`) });
      assert.ok(picture.length <= 200_000, `${picture.length} bytes`);
    };
    await place(page, "contact", { point: `I1 ${names[0]}` });
    await place(page, "closed", { point: `I2 ${names[1]}` });
    await place(page, "coil", { point: "Q1 motor" });
    await shot("draw-rung", ".program");
    const box = await boxOf(page, '#sheet .element[data-point="I1"] .area');
    await page.locator('.palette [data-what="contact"]').hover();
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.9, { steps: 4 });
    await page.locator(".places .near").waitFor();
    await shot("draw-places", ".program");
    await page.mouse.up();
    await fill(page, { point: "motor" });
    assert.deepEqual(await codes(page), SEAL_IN);
    await run(page);
    await page.locator('[data-input="1"]').hover();
    await page.mouse.down();
    await lamp(page, 1, true);
    await page.locator('#sheet .ladder.live .element.on[data-point="Q1"]').first().waitFor();
    await shot("draw-run", "main");
    await page.mouse.up();
    await page.context().close();
  });
}

test("what a drawing would lose of a text is told before the first change, and a copy keeps the text", async () => {
  const TYPED = "VAR\n    n : ARRAY[1..3] OF INT;\nEND_VAR\n\nLD n[1]\nGT 5\nST Q1\n";
  const page = await lab.still();
  await type(page, TYPED, "mine.il");
  await page.click("#view-draw");
  const banner = page.locator("#draw-banner");
  await banner.filter({ hasText: "remove this from the text: declarations of types, blocks and arrays" }).waitFor();
  // What is drawn is seen, and no key changes it.
  await page.locator("#sheet .element").first().waitFor();
  await page.focus("#sheet");
  await page.keyboard.press("ArrowRight");
  await page.locator("#sheet .element.selected").waitFor();
  await page.keyboard.press("Delete");
  await page.keyboard.press("ArrowDown");
  assert.equal(await keptText(page), TYPED);
  await select(page, "#speak", "pt");
  await banner.filter({ hasText: "apagam isto do texto: declarações de tipos" }).waitFor();
  await select(page, "#speak", "en");
  await page.click("#draw-copy");
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.getElementById("name")).value === "mine-copy.il");
  await banner.waitFor({ state: "hidden" });
  await page.focus("#sheet");
  await keys(page, "c =I1 Enter");
  assert.match(await keptText(page), /827301/);
  // The text is where it was.
  await page.locator("#notes button", { hasText: "Undo" }).click();
  await page.waitForFunction(() => /** @type {HTMLInputElement} */ (document.getElementById("name")).value === "mine.il");
  assert.equal(await keptText(page), TYPED);
  await page.context().close();
});

test("a person who lets a drawing rewrite a text gets it back by undo", async () => {
  const COMMENTED = "LD I1 (* start *)\nANDN I2 (* stop *)\nST Q1\n";
  const page = await lab.still();
  await type(page, COMMENTED, "mine.il");
  await page.click("#view-draw");
  await page.locator("#draw-banner", { hasText: "2 lines of comments, such as “start”" }).waitFor();
  await page.click("#draw-agree");
  await page.locator("#draw-banner").waitFor({ state: "hidden" });
  await page.focus("#sheet");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("n");
  await page.locator("#draw-undo:enabled").waitFor();
  await page.waitForFunction((text) => document.querySelector(".cm-content")?.textContent !== text.replaceAll("\n", ""), COMMENTED);
  assert.doesNotMatch(await keptText(page), /start/);
  await page.keyboard.press("Control+z");
  await page.locator("#draw-undo:disabled").waitFor();
  assert.equal(await keptText(page), COMMENTED);
  assert.ok(await page.isHidden("#draw-banner"));
  await page.context().close();
});
