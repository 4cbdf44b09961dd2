// Three who come here walk through the page, at three sizes and in both languages: a student, a teacher, an engineer.
// @ts-check

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { fingers, holding, mouse } from "./hands.mjs";
import { Lab, choose, keptText, lamp, pick, run, state, tab, type } from "./harness.mjs";
import { CONTROLS, SIZES, asked, clicked, inView, newcomer, stands } from "./newcomer.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** Built by the tests of the command line, which run before. */
const unoclp = fileURLToPath(new URL("../../../../target/debug/unoclp", import.meta.url));

/** Clicks to the first running program of one's own, at most. */
const CLICKS = 8;
/** The sheet is as high as this, px; on a phone buttons, lamps and keys of the phone share its screen. */
const SHEET = 350;

/** What each language calls what is asked for by its words. */
const WORDS = /** @type {const} */ ({
  "en-US": { by: "Ana handed in this program", clipboard: "clipboard" },
  "pt-BR": { by: "Ana entregou este programa", clipboard: "foi copiado" },
});

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Draws by keys: what begins with = is typed, with _ for a blank. @param {Page} page @param {string} presses */
async function draw(page, presses) {
  await page.focus("#sheet");
  for (const press of presses.split(" ")) {
    if (press.startsWith("=")) {
      await page.locator("#field-point:focus").waitFor();
      await page.keyboard.insertText(press.slice(1).replaceAll("_", " "));
    } else {
      await page.keyboard.press(press);
      if (press === "Enter") await page.locator("#sheet:focus").waitFor();
    }
  }
}

/** What is saved by doing this. @param {Page} page @param {() => Promise<void>} act */
async function saved(page, act) {
  const saving = page.waitForEvent("download");
  await act();
  const download = await saving;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

/** On a phone one of its three pages. @param {Page} page @param {"program" | "machine" | "drawer"} name */
async function turnTo(page, name) {
  if (await page.locator(`#page-${name}`).isVisible()) await page.click(`#page-${name}`);
}

/** Nothing lies beside the screen, the sheet has its height, nothing was said or moved. @param {Page} page @param {readonly string[]} said @param {boolean} phone */
async function holds(page, said, phone) {
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "the page scrolls sideways");
  const box = await page.locator("#sheet").boundingBox();
  if (box && !phone) assert.ok(box.height >= SHEET, `the sheet has ${box.height} px`);
  await stands(page);
  assert.deepEqual(said, []);
}

/** Exercises by their place in the list, and what solves them, drawn. */
const SOLVED = /** @type {const} */ ([
  [0, "c =I1 Enter l =Q1 Enter Shift+Enter k =I1 Enter l =Q2 Enter"],
  [1, "c =I1 Enter c =I2 Enter c =I3 Enter l =Q1 Enter"],
  [2, "c =I1 Enter k =I4 Enter l =Q1 Enter ArrowLeft ArrowLeft Shift+C =I2 Enter Shift+C =I3 Enter"],
]);

/** @param {Page} page @param {readonly string[]} said @param {typeof WORDS[keyof typeof WORDS]} words @param {boolean} phone */
async function student(page, said, words, phone) {
  const hand = phone ? fingers : mouse;
  await state(page, "RUN");
  const seen = await inView(page);
  const notes = await page.locator("#notes button").count();
  assert.ok(seen.length - notes <= CONTROLS, `${seen.length - notes} controls: ${seen.join(", ")}`);
  // A first program of their own.
  await page.click("#door-draw");
  for (const [what, point] of [["contact", "I1 push"], ["coil", "Q2 horn"]]) {
    await page.click(`.palette [data-what="${what}"]`);
    await page.locator("#field-point:focus").waitFor();
    await page.keyboard.type(point ?? "");
    await page.keyboard.press("Enter");
    await page.locator(".at-element").waitFor({ state: "detached" });
  }
  await page.locator("#problem-count.good").waitFor();
  await page.click("#run");
  await page.locator(".place .name", { hasText: "horn" }).waitFor({ state: "attached" });
  const clicks = await clicked(page);
  assert.ok(clicks <= CLICKS, `${clicks} clicks`);
  await holding(page, 1, () => lamp(page, 2, true), hand);
  await holds(page, said, phone);
  // A motor that seals in, with a stop and an overload that are normally closed.
  await pick(page, "#new-file");
  await draw(page, "c =I1_start Enter c =I2_stop Enter c =I3_overload Enter l =Q1_motor Enter ArrowLeft ArrowLeft ArrowLeft Shift+C =motor Enter");
  await page.click("#kinds");
  for (const input of [2, 3]) await page.selectOption(`[data-contact="${input}"]`, "nc");
  await page.click("#kinds");
  await run(page);
  await lamp(page, 1, false);
  for (const input of [2, 3]) {
    await holding(page, 1, () => lamp(page, 1, true), hand);
    await holding(page, input, () => lamp(page, 1, false), hand);
  }
  await page.fill("#name", "motor.il");
  await page.press("#name", "Enter");
  const file = await saved(page, () => pick(page, "#save-file"));
  assert.equal(file.name, "motor.il");
  const motor = await keptText(page);
  assert.equal(file.text, motor);
  await pick(page, "#share");
  await page.locator("#notes", { hasText: words.clipboard }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  // Three exercises, by drawing.
  await stands(page);
  await pick(page, "#exercises");
  await page.locator("#exercise-begin").waitFor();
  await asked(page);
  for (const [index, presses] of SOLVED) {
    await page.selectOption("#exercise-list", { index });
    await page.click("#exercise-begin");
    await page.locator("#sheet .element").first().waitFor({ state: "detached" });
    await draw(page, presses);
    await page.click("#exercise-check");
    await page.locator("#verdict.good").waitFor();
    // The machine of each stands beside it.
    await asked(page);
  }
  await page.locator("#exercise", { hasText: /3 (of|de) \d+/ }).waitFor();
  await page.click("#hand-in");
  await page.fill("#hand-in-name", "Ana");
  const handed = await saved(page, () => page.click("#hand-in-save"));
  assert.equal(JSON.parse(handed.text).verdicts.passed, true);
  // What was saved opens again, and so does the link, for somebody else.
  await choose(page, file.name, Buffer.from(file.text));
  await page.waitForFunction((name) => /** @type {HTMLInputElement | null} */ (document.querySelector("#name"))?.value === name, file.name);
  assert.equal(await keptText(page), motor);
  await holds(page, said, phone);
  const other = await newcomer(lab, {}, new URL(link).hash);
  await other.page.locator('#sheet .element[data-point="I3"]').waitFor();
  await other.page.context().close();
}

const EXERCISE = `title = { en = "A lamp in the hall", pt = "Uma lâmpada no corredor" }
[names]
I1 = "bell"
Q1 = "light"
[[case]]
title = "Pressed"
step = [{ at = 0, expect = { Q1 = 0 } }, { at = 50, set = { I1 = 1 }, expect = { Q1 = 1 } }]
until = 100
`;

/** @param {Page} page @param {readonly string[]} said @param {typeof WORDS[keyof typeof WORDS]} words @param {boolean} phone */
async function teacher(page, said, words, phone) {
  await state(page, "RUN");
  await choose(page, "hall.toml", Buffer.from(EXERCISE));
  await stands(page);
  await page.locator("#exercise h3", { hasText: /A lamp in the hall|Uma lâmpada no corredor/ }).waitFor();
  await asked(page);
  await page.click("#exercise-link");
  await page.locator("#notes", { hasText: words.clipboard }).waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await holds(page, said, phone);
  // The class: each has the link, solves it, or does not, and hands in.
  const folder = mkdtempSync(join(tmpdir(), "unoclp-walk-"));
  const [exercises, class_] = ["exercises", "class"].map((name) => join(folder, name));
  for (const path of [exercises, class_]) execFileSync("mkdir", [path ?? ""]);
  writeFileSync(join(exercises ?? "", "hall.toml"), EXERCISE);
  let first = "";
  for (const [who, program] of [["Ana", "LD I1\nST Q1\n"], ["Bia", "LDN I1\nST Q1\n"]]) {
    const own = await newcomer(lab, { acceptDownloads: true }, new URL(link).hash);
    await own.page.locator("#exercise-check").waitFor();
    await own.page.click("#view-both");
    await type(own.page, program ?? "", "hall.il");
    await own.page.locator("#problem-count.good").waitFor();
    await own.page.click("#hand-in");
    await own.page.fill("#hand-in-name", who ?? "");
    const handed = await saved(own.page, () => own.page.click("#hand-in-save"));
    writeFileSync(join(class_ ?? "", handed.name), handed.text);
    first ||= handed.text;
    assert.deepEqual(own.said, []);
    await own.page.context().close();
  }
  // The grades, and the report.
  const report = join(folder, "report.html");
  let table = "";
  try {
    table = execFileSync(unoclp, ["grade", exercises ?? "", class_ ?? "", "--html", report], { encoding: "utf8", env: { ...process.env, LC_ALL: "C" } });
  } catch (error) {
    table = /** @type {{ stdout: string }} */ (error).stdout;
  }
  assert.match(table, /Ana/);
  const html = readFileSync(report, "utf8");
  for (const what of ["Ana", "Bia", "<svg"]) assert.ok(html.includes(what), what);
  rmSync(folder, { recursive: true });
  // One of them is looked at again.
  await choose(page, "ana.unoclp.json", Buffer.from(first));
  await page.locator("#notes", { hasText: words.by }).waitFor();
  assert.match(await keptText(page), /LD I1/);
  await holds(page, said, phone);
}

const TANK = `TYPE Phase : (Idle, Fill, Drain); END_TYPE
FUNCTION_BLOCK Mean
VAR_INPUT x : REAL; END_VAR
VAR_OUTPUT y : REAL; END_VAR
VAR last : ARRAY[0..1] OF REAL; END_VAR
last[1] := last[0];
last[0] := x;
y := (last[0] + last[1]) / 2.0;
END_FUNCTION_BLOCK
PROGRAM main
VAR go AT %IX0.0 : BOOL; pump AT %QX0.0 : BOOL; phase : Phase; level : REAL := 2.5; m : Mean; END_VAR
m(x := level);
CASE phase OF
  Idle: IF go THEN phase := Fill; END_IF;
  Fill: level := 7.5;
END_CASE;
pump := m.y > 5.0;
END_PROGRAM
`;

/** @param {Page} page @param {readonly string[]} said @param {typeof WORDS[keyof typeof WORDS]} words @param {boolean} phone */
async function engineer(page, said, words, phone) {
  const hand = phone ? fingers : mouse;
  await state(page, "RUN");
  await page.click("#view-text");
  await type(page, TANK, "tank.st");
  await page.locator("#problem-count.good").waitFor();
  await run(page);
  // Values stand at the lines that were reached, and are those of the program.
  const at = (/** @type {string} */ value) => page.locator(".cm-state .cm-gutterElement", { hasText: value }).first().waitFor({ state: "attached" });
  await lamp(page, 1, false);
  await at("= 2");
  await holding(page, 1, () => lamp(page, 1, true), hand);
  await at("= 7");
  await turnTo(page, "drawer");
  await tab(page, "watch");
  await page.locator("#panel-watch tr", { hasText: "level" }).locator(".value", { hasText: /7[.,]5/ }).waitFor();
  await tab(page, "trend");
  await page.locator(".trend canvas").waitFor();
  const csv = await saved(page, () => page.locator(".trend-tools button", { hasText: "CSV" }).click());
  const [head = "", ...rows] = csv.text.trim().split("\n");
  assert.match(head, /^ms,go I1,pump Q1,/);
  assert.ok(rows.length > 2, csv.text);
  // The cause is there before its effect.
  const when = (/** @type {number} */ column) => Number(rows.find((row) => row.split(",")[column] === "1")?.split(",")[0]);
  assert.ok(when(1) <= when(2), `go ${when(1)}, pump ${when(2)}`);
  await turnTo(page, "program");
  // What no ladder holds goes out as a list in PLCopen XML; a ladder goes out as one, and comes back.
  const tank = await saved(page, () => pick(page, "#save-project"));
  assert.match(tank.text, /<project[^]*<ST>/);
  await type(page, "LD I1\nOR Q1\nANDN I2\nST Q1\n", "motor.il");
  await page.locator("#problem-count.good").waitFor();
  const xml = await saved(page, () => pick(page, "#save-project"));
  assert.equal(xml.name, "motor.xml");
  assert.match(xml.text, /<project[^]*<LD>/);
  await choose(page, "motor.xml", Buffer.from(xml.text));
  await page.locator("#tongue", { hasText: "PLCopen XML" }).waitFor({ state: "attached" });
  await page.locator("#problem-count.good").waitFor();
  await holds(page, said, phone);
}

for (const [width, height] of SIZES) {
  for (const locale of /** @type {const} */ (["en-US", "pt-BR"])) {
    for (const walk of [student, teacher, engineer]) {
      test(`the ${walk.name} walks, ${locale}, ${width} × ${height}`, async () => {
        const phone = width < 760;
        const { page, said } = await newcomer(lab, {
          locale, viewport: { width, height }, hasTouch: phone, isMobile: phone, acceptDownloads: true, permissions: ["clipboard-read", "clipboard-write"],
        });
        // One that failed would take a processor from those behind it.
        try {
          await walk(page, said, WORDS[locale], phone);
        } finally {
          await page.context().close();
        }
      });
    }
  }
}
