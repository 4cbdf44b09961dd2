// A teacher's own exercise and its machine: dropped, opened, carried by a link, served; and what is no machine.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, choose, findings, keptText, pick, select, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page @typedef {readonly [en: RegExp, pt: RegExp]} Said */

/** @param {string} path of a file of programs */
const file = (path) => readFileSync(new URL(`../../../../programs/${path}`, import.meta.url), "utf8");

/** A lamp that follows a button. A rule and a goal have words of their own, the others none. */
const MACHINE = `title = "Porch"
until = "5 s"
[[part]]
name = "bell"
kind = "button"
label = { en = "Bell", pt = "Campainha" }
to = "I1"
[[part]]
name = "light"
kind = "lamp"
label = { en = "Light", pt = "Luz" }
by = "Q1"
[[step]]
at = "1 s"
for = "1 s"
set = { bell = 1 }
[[never]]
when = "light.lit AND NOT bell.pressed"
for = "200 ms"
[[goal]]
each = "bell.pressed"
when = "light.lit"
within = "500 ms"
`;
const EXERCISE = `title = "A light on the porch"
plant = "porch.toml"
[names]
I1 = "bell"
Q1 = "light"
[[case]]
title = "Pressed"
step = [{ at = 0, expect = { Q1 = 0 } }, { at = 50, set = { I1 = 1 }, expect = { Q1 = 1 } }]
until = 100
`;
const RIGHT = "LD I1\nST Q1\n";
/** It stays on: no case asks. */
const WRONG = "LD I1\nOR Q1\nST Q1\n";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Drops files on the page. @param {Page} page @param {readonly (readonly [name: string, text: string])[]} files */
async function drop(page, files) {
  const data = await page.evaluateHandle((files) => {
    const transfer = new DataTransfer();
    for (const [name, text] of files) transfer.items.add(new File([text], name));
    return transfer;
  }, files);
  await page.dispatchEvent(".cm-content", "drop", { dataTransfer: data });
}

/** Both verdicts of the exercise on the porch. @param {Page} page */
async function solve(page) {
  await page.locator("#exercise h3", { hasText: "A light on the porch" }).waitFor();
  await page.locator("#machine-title", { hasText: "Porch" }).waitFor();
  await type(page, WRONG, "porch.il");
  await page.click("#exercise-check");
  await page.locator("#machine-verdict.bad", { hasText: "a rule was broken: Never: Light (" }).waitFor();
  await page.locator("#replay .cursor").waitFor({ state: "attached" });
  await type(page, RIGHT, "porch.il");
  await page.click("#exercise-check");
  await page.locator("#machine-verdict.good").waitFor();
  await page.locator("#verdict.good").waitFor();
}

test("an exercise is dropped with its machine, whose rules are sentences, and a link carries both", async () => {
  const page = await lab.still({ permissions: ["clipboard-read", "clipboard-write"] });
  const text = await keptText(page);
  // The exercise comes first: the page knows which is which.
  await drop(page, [["porch-exercise.toml", EXERCISE], ["porch.toml", MACHINE]]);
  await page.locator("#exercise h3", { hasText: "A light on the porch" }).waitFor();
  assert.equal(await keptText(page), text, "the program stays as it was");
  assert.equal(await page.locator("#exercise-list option:checked").evaluate((option) => option.closest("optgroup")?.label), "From your class");
  await page.locator("#machine-rules li", { hasText: "Never: Light (it is lit) and not Bell (it is pressed), for longer than 0.2 s" }).waitFor();
  await page.locator("#machine-rules li", { hasText: "within 0.5 s: Light (it is lit)" }).waitFor();
  await solve(page);
  assert.deepEqual(await findings(page), []);
  await select(page, "#speak", "pt");
  await page.locator("#machine-rules li", { hasText: "Nunca: Luz (" }).waitFor();
  /** @type {string[]} */
  const links = [];
  for (const button of ["#exercise-link", "#machine-link"]) {
    await page.evaluate(() => navigator.clipboard.writeText(""));
    await page.click(button);
    let link = "";
    while (!link.includes("#")) link = await page.evaluate(() => navigator.clipboard.readText());
    links.push(new URL(link).hash);
  }
  await page.context().close();
  const [exercise = "", machine = ""] = links;
  // Who opens it has never been here.
  const other = await lab.other({}, {}, lab.server.url + exercise);
  await solve(other);
  await other.evaluate((hash) => void (location.hash = hash), machine);
  await other.locator("#machine-link").waitFor();
  assert.equal(await other.evaluate(() => location.hash), "");
  await other.context().close();
});

test("what a teacher serves stands first in the list and in the gallery", async () => {
  const page = await lab.still();
  /** What `unoclp serve --exercises` puts before what the page has. @param {string} name @param {unknown[]} own */
  const served = (name, own) => page.route(`**/${name}`, async (route) => {
    const others = await (await route.fetch()).json();
    await route.fulfill({ json: [...own, ...others] });
  });
  const plant = { name: "porch.toml", text: MACHINE };
  await served("exercises.json", [
    { name: "own/porch", language: "st", scenario: EXERCISE, plant, isOwn: true },
    { name: "own/broken", language: "st", scenario: "until = [", isOwn: true },
  ]);
  await served("machines.json", [{ ...plant, title: { en: "Porch", pt: "Varanda" }, about: { en: "A lamp.", pt: "Uma lâmpada." }, isOwn: true }]);
  await pick(page, "#exercises");
  await page.locator("#notes", { hasText: "cannot be opened as an exercise" }).waitFor();
  assert.equal(await page.locator("#exercise-list optgroup").first().getAttribute("label"), "From your class");
  await solve(page);
  await pick(page, "#machines");
  const card = page.locator("#gallery .gallery-card").first();
  await card.locator("h3", { hasText: "Porch" }).waitFor();
  await card.locator(".gallery-far", { hasText: "1 of 1 exercises done" }).waitFor();
  await card.locator("[data-machine]").click();
  await page.locator("#machine-link").waitFor();
  await page.context().close();
});

const HEAD = 'title = "t"\n[[part]]\nname = "b"\nkind = "button"\nto = "I1"\n';
/** @param {string} more */
const part = (more) => `${HEAD}[[part]]\nname = "x"\n${more}\n`;
/** Machines that are none, and what is said of them. @type {[string, string, Said][]} */
const BAD = [
  ["a part called <script>", 'title = "t"\n[[part]]\nname = "<script>alert(1)</script>"\nkind = "button"\n', [/cannot be the name of a part/, /não serve de nome de elemento/]],
  ["no such kind", part('kind = "rocket"'), [/bad\.toml:.*`kind` cannot be/, /bad\.toml:.*`kind` não pode ser/]],
  ["an input that two switch", part('kind = "button"\nto = "I1"'), [/bad\.toml:9: b also sets I1/, /bad\.toml:9: b também comanda I1/]],
  ["an input that the board lacks", part('kind = "button"\nto = "I40"'), [/has no I40; it has I1–I8/, /não tem I40; tem I1–I8/]],
  ["a part that is not there", part('kind = "lamp"\nby = "ghost.lit"'), [/there is no part ghost; known parts: b, x/, /não existe o elemento ghost; elementos conhecidos: b, x/]],
  ["a unit that is none", part('kind = "tank"\nholds = "5 bananas"'), [/a number with a unit/, /um número com unidade/]],
  ["a circle", `${HEAD}${["x", "y"].map((name, at) => `[[part]]\nname = "${name}"\nkind = "lamp"\nby = "${["y", "x"][at]}.lit"\n`).join("")}`, [/in a loop: x → y → x/, /dependência circular entre estes elementos: x → y → x/]],
  ["10,000 parts", `title = "t"\n${Array.from({ length: 10_000 }, (_, at) => `[[part]]\nname = "a${at}"\nkind = "lamp"\nby = "Q1"\n`).join("")}`, [/more than 100/, /mais de 100/]],
  ["a rule that is no condition", `${HEAD}[[never]]\nwhen = "b.pressed := 1"\n`, [/not a condition in Structured Text/, /não é uma condição em Texto Estruturado/]],
  ["HTML that says parts", "<html><script>alert(1)</script>\n[[part]]\n</html>\n", [/not TOML/, /não é TOML/]],
];

for (const [index, locale] of ["en-US", "pt-BR"].entries()) {
  test(`what is no machine is told, runs nothing, and loses nothing, ${locale}`, async (t) => {
    const page = await lab.still({ locale });
    page.on("dialog", (dialog) => void lab.errors.push(`a dialog: ${dialog.message()}`));
    await type(page, "LD I3\nST Q3 (* mine *)\n", "mine.il");
    for (const [name, text, said] of BAD) {
      await t.test(name, async () => {
        await page.evaluate(() => document.getElementById("notes")?.replaceChildren());
        await drop(page, [["bad.toml", text]]);
        await page.locator("#notes", { hasText: said[index] ?? /never/ }).waitFor();
        assert.ok(await page.locator("#machine").isHidden());
        assert.equal(await page.locator("#notes :is(script, img)").count(), 0);
      });
    }
    // An exercise that is HTML, one whose words are, and a link that holds neither.
    await page.evaluate(() => document.getElementById("notes")?.replaceChildren());
    await choose(page, "page.toml", Buffer.from("<html><body>404</body></html>"));
    await page.locator("#notes", { hasText: index === 0 ? /cannot be opened/ : /não pode ser aberto/ }).waitFor();
    await page.evaluate(() => void (location.hash = "#x=%%%"));
    await page.locator("#notes", { hasText: index === 0 ? /contains no program/ : /não contém/ }).waitFor();
    const markup = '<img src=x onerror="alert(1)">';
    await drop(page, [["words.toml", `title = '${markup}'\ntask = '${markup}'\nhints = ['${markup}']\n[[case]]\ntitle = '${markup}'\nuntil = 5\n`]]);
    await page.locator("#exercise h3", { hasText: markup }).waitFor();
    assert.equal(await page.locator("#exercise img").count(), 0);
    const own = MACHINE.replace('"Porch"', `'${markup}'`).replaceAll('"Light"', `'${markup}'`);
    await drop(page, [["words-machine.toml", own]]);
    await page.locator("#machine-title", { hasText: markup }).waitFor();
    assert.equal(await page.locator("#machine img").count(), 0);
    assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
    // What the page has beside it is HTML: where somebody has to sign in to the network.
    for (const name of ["exercises.json", "machines.json"]) await page.route(`**/${name}`, (route) => route.fulfill({ contentType: "text/html", body: "<html></html>" }));
    await page.reload();
    await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
    await pick(page, "#exercises");
    await page.locator("#notes", { hasText: "exercises.json" }).waitFor();
    await pick(page, "#machines");
    await page.locator("#notes", { hasText: "machines.json" }).waitFor({ state: "attached" });
    assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
    await page.context().close();
  });
}

/** Files that are called as exercises are, and are none. @type {readonly (readonly [name: string, text: string])[]} */
const NONE = [
  ["empty.toml", ""],
  ["cut.toml", "title = ["],
  ["program.toml", "LD I1\nST Q1\n"],
  ["nothing.toml", "title = 'x'\n"],
  ["steps.txt", "[[case]]\nstep = 7\n"],
  ["bytes.toml", "[[case]]\0\0"],
];

for (const [locale, said] of /** @type {const} */ ([["en-US", "Your program is still here"], ["pt-BR", "programa continua aqui"]])) {
  test(`a file that is no exercise, dropped while a program and an exercise are open, is told and changes nothing, ${locale}`, async () => {
    const page = await lab.still({ locale });
    await pick(page, "#exercises");
    await type(page, "LD I3\nST Q3 (* mine *)\n", "mine.il");
    await page.locator("#exercise h3").waitFor();
    const shown = () => page.evaluate(() => [document.querySelector("#exercise h3")?.textContent, document.querySelectorAll("#exercise-list option").length, document.querySelector("#exercise-progress")?.textContent]);
    const before = await shown();
    for (const one of NONE) {
      await page.evaluate(() => document.getElementById("notes")?.replaceChildren());
      await drop(page, [one]);
      await page.locator("#notes", { hasText: said }).waitFor();
      assert.deepEqual(await shown(), before, one[0]);
      assert.match(await keptText(page), /mine/, one[0]);
    }
    await page.context().close();
  });
}

test("a teacher's own machine of the menu is solved as any", async () => {
  const page = await lab.still();
  await choose(page, "motor-mine.toml", Buffer.from(file("plants/motor.toml")));
  await page.locator("#machine-link").waitFor();
  await type(page, file("plants/motor.st"), "motor.st");
  await page.locator("#problem-count:not(.bad)").waitFor();
  await page.click("#machine-judge");
  await page.locator("#machine-judged-verdict.good").waitFor();
  await page.context().close();
});
