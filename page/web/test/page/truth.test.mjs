// What the page says is so: states, live values, the timing diagram; and what it keeps when its tools break down.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, PATIENCE, been, choose, lamp, pick, pictures, run, state, still, tab, type } from "./harness.mjs";
import { changesWith } from "./timing.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

/** What stands at each line of the text. @param {Page} page */
const marks = (page) => page.evaluate(() => {
  const lines = [...document.querySelectorAll(".cm-lineNumbers .cm-gutterElement")].map((one) => ({ number: Number(one.textContent), top: one.getBoundingClientRect().top }));
  const all = Object.fromEntries([...document.querySelectorAll(".cm-state .cm-gutterElement")].filter((one) => one.textContent).map((one) => {
    const { top } = one.getBoundingClientRect();
    return [lines.find((line) => line.number > 0 && Math.abs(line.top - top) < 2)?.number ?? 0, one.textContent];
  }));
  return JSON.stringify(all);
});

/** Waits until the lines show this. @param {Page} page @param {Record<number, string>} expected */
async function shows(page, expected) {
  const wanted = JSON.stringify(expected);
  const until = Date.now() + 60_000;
  let now = "";
  while (Date.now() < until) {
    now = await marks(page);
    if (now === wanted) return;
    await page.evaluate(() => new Promise((wake) => requestAnimationFrame(wake)));
  }
  assert.equal(now, wanted);
}

test("a board that holds no program is not at fault", async () => {
  for (const [locale, said] of /** @type {const} */ ([["en-US", "No program on the board yet"], ["pt-BR", "A placa ainda não tem programa"]])) {
    const page = await lab.open({ locale, viewport: { width: 1366, height: 768 } });
    await state(page, "EMPTY");
    assert.match((await page.textContent("#status")) ?? "", new RegExp(said));
    assert.equal(await page.textContent("#about-program"), "");
    await page.screenshot({ path: join(pictures, `truth-empty-${locale}.png`) });
    /** @type {string[]} */
    const states = [];
    await page.exposeFunction("noted", (/** @type {string} */ state) => void states.push(state));
    await page.evaluate(() => new MutationObserver(() => {
      // @ts-expect-error the test has put it there.
      window.noted(document.getElementById("status")?.dataset["state"]);
    }).observe(/** @type {Node} */ (document.getElementById("status")), { attributes: true }));
    await run(page);
    assert.ok(!states.includes("FAULT"), states.join());
    await page.context().close();
  }
});

test("each line of ST shows what it tests, in this scan, and nothing where it was not reached", async () => {
  const page = await lab.open();
  await type(page, `TYPE Phase : (Idle, Drain); END_TYPE
PROGRAM main
VAR go AT %IX0.0 : BOOL; stop AT %IX0.1 : BOOL; q AT %QX0.0 : BOOL; level : REAL := 50.05; state : Phase; t1 : TON; END_VAR
level := level * 1.0;
IF level < 10.0 THEN
  q := TRUE;
END_IF;
t1(IN := go, PT := T#100ms);
IF t1.Q THEN
  state := Drain;
END_IF;
IF stop THEN state := Idle; END_IF;
IF stop THEN
  state := Idle;
END_IF;
q := state = Drain;
END_PROGRAM
`, "tank.st");
  await run(page);
  await shows(page, { 4: "= 50.05", 5: "○", 8: "○", 9: "○", 12: "○", 13: "○", 16: "○" });
  await holding(page, 1, () => shows(page, { 4: "= 50.05", 5: "○", 8: "●", 9: "●", 10: "= Drain", 12: "○", 13: "○", 16: "●" }));
  await holding(page, 2, () => shows(page, { 4: "= 50.05", 5: "○", 8: "○", 9: "○", 12: "●", 13: "●", 14: "= Idle", 16: "○" }));
  await page.context().close();
});

test("where time stands, the lamps and the ladder show one instant", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nST Q1\n", "lamp.il");
  await run(page);
  await page.locator('.ladder.live .element[data-point="Q1"]').waitFor();
  const both = () => page.evaluate(() => [
    document.querySelector('[data-output="1"]')?.getAttribute("data-on") === "true",
    document.querySelector('.ladder .element[data-point="Q1"]')?.classList.contains("on"),
  ]);
  // So slow, a lamp turns seconds before the reading that tells of it.
  await page.selectOption("#speed", "0.01");
  await holding(page, 1, async () => {
    await lamp(page, 1, true);
    await page.selectOption("#speed", "0");
    const [lit, drawn] = await both();
    assert.equal(lit, drawn);
    await page.selectOption("#speed", "1");
    await page.locator('.ladder .element.on[data-point="Q1"]').waitFor();
    assert.deepEqual(await both(), [true, true]);
  });
  await page.context().close();
});

/** A page whose simulated board is heard late, as on a busy computer: the page's own clock runs ahead of it. */
const LATE_BOARD = `{
  const post = self.postMessage.bind(self);
  self.postMessage = (message, ...more) => void setTimeout(() => post(message, ...more), 150);
}
`;

for (const [how, late] of /** @type {const} */ ([["", false], [", though the board is heard late", true]])) test(`in the timing diagram no effect comes before its cause, and a forced input is what it is forced to${how}`, async () => {
  const page = await lab.open();
  if (late) {
    await page.context().route("**/board.js", async (route) => {
      const answer = await route.fetch();
      await route.fulfill({ response: answer, body: LATE_BOARD + (await answer.text()) });
    });
    await page.reload();
    await page.locator("#run:enabled").waitFor();
  }
  await type(page, "LD I1\nST M1\nLD M1\nST Q1\nLD I2\nTON T1, 300\nST Q2\n", "chain.il");
  await run(page);
  await holding(page, 1, async () => {
    await lamp(page, 1, true);
    await page.locator('#panel-watch tr[data-point="M1"] td:nth-child(3)', { hasText: "1" }).waitFor({ state: "attached" });
  });
  await holding(page, 2, async () => {
    await lamp(page, 2, true);
    await page.locator('#panel-watch tr[data-point="T1"] td:nth-child(3)', { hasText: "300" }).waitFor({ state: "attached" });
  });
  let first = await changesWith(page, [["I1", "1"], ["M1", "1"], ["Q1", "1"], ["I2", "1"], ["T1", "300"], ["Q2", "1"]]);
  assert.ok(first("I1", "1") <= first("M1", "1"), `I1 ${first("I1", "1")} M1 ${first("M1", "1")}`);
  assert.ok(first("M1", "1") <= first("Q1", "1"), `M1 ${first("M1", "1")} Q1 ${first("Q1", "1")}`);
  assert.ok(first("I2", "1") <= first("Q2", "1"));
  assert.ok(first("T1", "300") <= first("Q2", "1"), `T1 ${first("T1", "300")} Q2 ${first("Q2", "1")}`);
  // Forced from here on, by the table of values.
  await page.locator(".trend-tools button", { hasText: "Clear" }).click();
  await lamp(page, 1, false);
  await tab(page, "watch");
  await page.getByRole("button", { name: "I1: force to 1" }).click();
  await lamp(page, 1, true);
  await page.locator("#panel-watch tr.is-forced[data-point=I1]").waitFor();
  await tab(page, "trend");
  first = await changesWith(page, [["I1", "1"], ["M1", "1"], ["Q1", "1"]]);
  assert.ok(first("I1", "1") <= first("M1", "1"), `I1 ${first("I1", "1")} M1 ${first("M1", "1")}`);
  assert.ok(first("I1", "1") <= first("Q1", "1"), `I1 ${first("I1", "1")} Q1 ${first("Q1", "1")}`);
  await page.context().close();
});

/** A module that breaks down over a word, and says the same as before ever after. */
const BREAKS = `{
  const make = WebAssembly.instantiate;
  WebAssembly.instantiate = async (module, imports) => {
    const instance = await make(module, imports);
    const { memory, unoclp_room, unoclp_call, unoclp_answer } = instance.exports;
    let room = 0, size = 0, broken = false, last = 0;
    return { exports: {
      memory, unoclp_answer,
      unoclp_room: (bytes) => { size = bytes; return (room = unoclp_room(bytes)); },
      unoclp_call: () => {
        if (broken) return last;
        const text = new TextDecoder().decode(new Uint8Array(memory.buffer, room, size));
        if (text.includes("BREAKDOWN")) { broken = true; throw new WebAssembly.RuntimeError("unreachable"); }
        return (last = unoclp_call());
      },
    } };
  };
}
`;

/** A page whose tools break down over a word. @param {import("playwright-core").BrowserContextOptions} options */
async function breaking(options = {}) {
  const context = await lab.browser.newContext({ locale: "en-US", serviceWorkers: "block", storageState: been(lab.server.url), ...options });
  await context.route("**/tools.js", async (route) => {
    const answer = await route.fetch();
    await route.fulfill({ response: answer, body: BREAKS + (await answer.text()) });
  });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  page.on("pageerror", (error) => lab.errors.push(String(error.stack)));
  await page.goto(lab.server.url);
  await page.locator("#run:enabled").waitFor();
  await still(page);
  return page;
}

test("tools that break down are restarted, which is said; the text stays, and no old result is shown", async () => {
  const page = await breaking({ viewport: { width: 1366, height: 768 } });
  await page.locator("#problem-count.good").waitFor();
  await type(page, "(* BREAKDOWN *)\nLD I1\nST Q1\n", "mine.il");
  await page.locator("#problem-count.bad").waitFor();
  await tab(page, "problems");
  await page.locator("#panel-problems", { hasText: "was restarted. Your text is still here" }).waitFor();
  assert.match((await page.textContent(".cm-content")) ?? "", /BREAKDOWN/);
  await page.screenshot({ path: join(pictures, "truth-breakdown.png") });
  // The next text is looked at by tools that work.
  await type(page, "LD I1\nST Q3\n");
  await page.locator("#problem-count.good").waitFor();
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  assert.match((await page.textContent(".cm-content")) ?? "", /Q3/);
  await page.context().close();
});

test("a drawing goes on behind a breakdown", async () => {
  const page = await breaking();
  await page.click("#view-draw");
  await page.locator("#sheet .element").first().click();
  await page.keyboard.press("n");
  await page.locator("#draw-undo:enabled").waitFor();
  await page.keyboard.press(";");
  await page.fill("#field-comment", "BREAKDOWN");
  await page.keyboard.press("Enter");
  await page.locator(".at-element .field-wrong", { hasText: "restarted" }).waitFor();
  assert.equal(await page.inputValue("#field-comment"), "BREAKDOWN");
  await page.keyboard.press("Escape");
  // What was drawn before can be undone.
  await page.locator("#draw-undo:enabled").click();
  await page.locator("#draw-undo:disabled").waitFor();
  await page.context().close();
});

test("the conversation with the board outlives its tools too", async () => {
  const context = await lab.browser.newContext({ locale: "en-US", serviceWorkers: "block", storageState: been(lab.server.url) });
  await context.addInitScript(BREAKS);
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  page.on("pageerror", (error) => lab.errors.push(String(error.stack)));
  await page.goto(lab.server.url);
  await page.locator("#run:enabled").waitFor();
  await run(page);
  await type(page, "(* BREAKDOWN *)\nLD I1\nST Q1\n");
  await page.locator("#problem-count:not(.bad)").waitFor();
  await page.click("#run");
  await page.locator("#notes", { hasText: "was restarted. Your text is still here" }).waitFor();
  await state(page, "RUN");
  await type(page, "LDN I1\nST Q3\n");
  await run(page);
  await lamp(page, 3, true);
  await context.close();
});

test("on an address of the network, Connect says why the browser keeps ports from the page", async () => {
  const context = await lab.browser.newContext({ locale: "pt-BR", serviceWorkers: "block" });
  await context.route("http://sala.escola:8420/**", async (route) => {
    const { pathname } = new URL(route.request().url());
    await route.fulfill({ response: await route.fetch({ url: new URL(pathname.slice(1), lab.server.url).href }) });
  });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  await page.goto("http://sala.escola:8420/");
  await page.locator("#run:enabled").waitFor();
  assert.equal(await page.evaluate(() => isSecureContext), false);
  await pick(page, "#connect");
  await page.locator("#notes", { hasText: /sala\.escola:8420.*portas seriais.*dois cliques/ }).waitFor();
  await context.close();
});

test("a teacher's file of an exercise is opened as one, another check is named; neither replaces the program", async () => {
  const page = await lab.still();
  await type(page, "LD I3\nST Q3 (* mine *)\n", "mine.il");
  const toml = readFileSync(new URL("../../../../programs/exercises/05-motor.toml", import.meta.url), "utf8");
  await choose(page, "teacher.toml", Buffer.from(toml));
  await page.locator("#exercise #exercise-check").waitFor();
  await page.locator("#notes", { hasText: "This file is an exercise" }).waitFor();
  assert.equal(await page.locator("#exercise-list option").count(), 59);
  await choose(page, "broken.toml", Buffer.from("until = [\n"));
  await page.locator("#notes", { hasText: /not a program, and it cannot be opened as an exercise/ }).waitFor();
  assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
  assert.equal(await page.inputValue("#name"), "mine.il");
  await page.context().close();
});

test("the timing diagram outlives a program with fewer points", async () => {
  const page = await lab.open();
  await type(page, "LD I1\nST Q1\nLD I2\nST Q2\nLD I3\nST M3\nLD M3\nST Q3\n", "many.il");
  await run(page);
  await page.locator(".trend canvas").waitFor();
  await page.locator(".trend .u-over").hover();
  // The chart is that of before while a key already asks for more of it.
  await page.evaluate(() => {
    const step = /** @type {HTMLElement} */ (document.querySelector("#trendBefore"));
    new MutationObserver(() => /** @type {HTMLElement} */ (document.querySelector("#trendBefore") ?? step).click())
      .observe(/** @type {Node} */ (document.querySelector(".channels")), { childList: true });
  });
  await holding(page, 1, () => lamp(page, 1, true));
  await page.click("#trendBefore");
  await type(page, "LD I1\nST Q1\n");
  await run(page);
  await page.locator(".channels label").nth(2).waitFor({ state: "detached" });
  await page.locator(".trend .u-over").hover();
  await page.click("#trendBefore");
  await page.context().close();
});

test("in Portuguese people read a decimal comma, and the editor's panels are in Portuguese", async () => {
  const page = await lab.open({ locale: "pt-BR", viewport: { width: 1366, height: 768 } });
  await type(page, "VAR go AT %IX0.0 : BOOL; x : REAL; END_VAR\nIF go THEN x := 0.5; ELSE x := 0.25; END_IF;\nx := x * 1.0;\n", "half.st");
  await run(page);
  await tab(page, "watch");
  await holding(page, 1, () => page.locator("#panel-watch tr .value", { hasText: "0,5" }).first().waitFor());
  await page.locator("#panel-watch tr .value", { hasText: "0,25" }).first().waitFor();
  await tab(page, "trend");
  await page.locator(".trend canvas").waitFor();
  // The change before is that to 0.25.
  await page.click("#trendBefore");
  await page.locator("#trend-reading", { hasText: /x = 0,\d/ }).waitFor();
  assert.doesNotMatch((await page.textContent("#trend-reading")) ?? "", /\d\.\d/);
  await page.locator(".cm-content").click();
  await page.keyboard.press("Control+f");
  const panel = page.locator(".cm-search");
  await panel.waitFor();
  assert.equal(await panel.locator("input[name=search]").getAttribute("placeholder"), "Localizar");
  const texts = (await panel.locator("button, label").allTextContents()).map((text) => text.trim());
  for (const english of ["next", "previous", "all", "match case", "replace", "regexp", "by word"]) assert.ok(!texts.includes(english), texts.join());
  assert.notEqual(await panel.locator("button[name=next]").evaluate((one) => getComputedStyle(one).borderRadius), "1px");
  await page.screenshot({ path: join(pictures, "truth-find.png") });
  await page.setViewportSize({ width: 390, height: 844 });
  await page.screenshot({ path: join(pictures, "truth-find-phone.png") });
  await page.context().close();
});

test("the menu of the drawing opens where one clicks, and New keeps the focus", async () => {
  const page = await lab.still({ viewport: { width: 1366, height: 768 } });
  await page.click("#view-draw");
  const contact = page.locator('#sheet .element[data-point="I2"]');
  const box = await contact.boundingBox();
  if (!box) throw new Error("no contact");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.click(x, y, { button: "right" });
  const list = page.locator("#menu-drawEdit + div");
  await list.waitFor();
  const at = await list.boundingBox();
  assert.ok(at && Math.abs(at.x - x) < 30 && at.y + at.height <= 768 && at.y <= y + 30, JSON.stringify({ at, x, y }));
  await page.locator('#sheet .element.selected[data-point="I2"]').waitFor();
  await page.screenshot({ path: join(pictures, "truth-menu.png") });
  await page.keyboard.press("Escape");
  await page.click("#menu-drawEdit");
  assert.ok(((await list.boundingBox())?.y ?? 999) < 300, "at its button again");
  await page.keyboard.press("Escape");
  for (const view of ["draw", "text"]) {
    await page.click(`#view-${view}`);
    await page.click("#menu-fileMenu");
    await page.locator(".menu button", { hasText: /^New$/ }).click();
    const where = view === "draw" ? "#sheet" : ".cm-content";
    await page.locator(`${where}:focus`).waitFor();
  }
  await page.context().close();
});
