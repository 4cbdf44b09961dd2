// An exercise is handed in as a file: for `unoclp grade`, and for a teacher who opens it again; and what is no such file.
// @ts-check

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Lab, choose, findings, keptHere, keptText, type, pick } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** Built by the tests of the command line, which run before. */
const unoclp = fileURLToPath(new URL("../../../../target/debug/unoclp", import.meta.url));
const exercises = fileURLToPath(new URL("../../../../programs/exercises/", import.meta.url));

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Hands in the exercise that is open. @param {Page} page @param {string} name @param {string} number */
async function handIn(page, name, number = "") {
  await page.click("#hand-in");
  await page.fill("#hand-in-name", name);
  await page.fill("#hand-in-number", number);
  assert.deepEqual(await findings(page), []);
  const saving = page.waitForEvent("download");
  await page.click("#hand-in-save");
  const download = await saving;
  return { file: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

test("what is handed in says who, which exercise and what; grade finds out the rest; a teacher opens it again", async () => {
  const page = await lab.still({ acceptDownloads: true });
  await pick(page, "#exercises");
  await page.selectOption("#exercise-list", { index: 4 });
  await type(page, readFileSync(join(exercises, "05-motor.il"), "utf8"), "motor.il");
  await page.locator("#problem-count:not(.bad)").waitFor();
  const right = await handIn(page, "=Ana Júlia", "2026-17");
  assert.equal(right.file, "ana-júlia-05-motor.unoclp.json");
  const said = JSON.parse(right.text);
  assert.deepEqual(said.student, { name: "=Ana Júlia", number: "2026-17" });
  assert.equal(said.exercise.name, "05-motor");
  assert.equal(said.verdicts.passed, true);
  assert.equal(said.minutes, 1);
  // The next who sits here is asked again; the browser remembers what was written.
  await type(page, "LD I1\nST Q1\n", "wrong.il");
  await page.locator("#problem-count:not(.bad)").waitFor();
  const wrong = await handIn(page, "Bia");
  const edited = { ...JSON.parse(wrong.text), verdicts: { passed: true } };
  assert.equal(JSON.parse(wrong.text).verdicts.passed, false);
  await page.context().close();

  const folder = mkdtempSync(join(tmpdir(), "unoclp-class-"));
  writeFileSync(join(folder, right.file), right.text);
  writeFileSync(join(folder, wrong.file), JSON.stringify(edited));
  let table = "";
  try {
    table = execFileSync(unoclp, ["grade", exercises, folder, "--moodle"], { encoding: "utf8", env: { ...process.env, LC_ALL: "C" } });
  } catch (error) {
    table = /** @type {{ stdout: string }} */ (error).stdout;
  }
  rmSync(folder, { recursive: true });
  assert.match(table, /^,'=Ana Júlia,2026-17,100$/m);
  assert.match(table, /^,Bia,,\d\d?$/m);

  const teacher = await lab.still({ locale: "pt-BR" });
  await choose(teacher, right.file, Buffer.from(right.text));
  // Which exercise it is for is said: another may be open.
  await teacher.locator("#notes", { hasText: "=Ana Júlia entregou este programa para o exercício 05-motor" }).waitFor();
  assert.equal(await keptText(teacher), said.program.text);
  assert.equal(await teacher.inputValue("#name"), "motor.il");
  await teacher.context().close();
});

test("a drawing is handed in too, and is drawn again where it is opened", async () => {
  const page = await lab.emptySheet({ acceptDownloads: true });
  await page.click('.palette [data-what="contact"]');
  await page.fill("#field-point", "I1");
  await page.click(".at-element button[type=submit]");
  await page.locator('#sheet .element[data-point="I1"]').waitFor();
  await pick(page, "#exercises");
  await page.locator("#hand-in").waitFor();
  const { text } = await handIn(page, "Caio");
  await page.context().close();
  const { drawing } = JSON.parse(text);
  assert.ok(drawing.log.length > 0);
  const other = await lab.still();
  await choose(other, "caio.unoclp.json", Buffer.from(text));
  await other.locator("#notes", { hasText: "Caio handed in this program" }).waitFor();
  assert.deepEqual(JSON.parse((await keptHere(other, "drawing")) ?? "null"), drawing);
  await other.context().close();
});

test("where a fault is to be found, what was named is handed in", async () => {
  const page = await lab.still({ acceptDownloads: true });
  await pick(page, "#exercises");
  const index = await page.locator("#exercise-list optgroup[label='Find the fault'] option").first().getAttribute("value");
  await page.selectOption("#exercise-list", index);
  await page.locator("#find-name").click();
  await page.locator("#find-verdict").waitFor();
  const { text } = await handIn(page, "Davi");
  const said = JSON.parse(text);
  assert.match(said.answer, /^\w+ \w+\n$/);
  await page.context().close();
});

/** Files that are no hand-in. @type {readonly [string, string | Buffer][]} */
const BAD = [
  ["cut.unoclp.json", '{"form": "unoclp-hand-in-1", "stud'],
  ["list.unoclp.json", "[]"],
  ["null.unoclp.json", "null"],
  ["later.unoclp.json", '{"form": "unoclp-hand-in-9", "program": {"name": "a.il", "text": "LD I1"}}'],
  ["numbers.unoclp.json", '{"form": "unoclp-hand-in-1", "program": {"name": 1, "text": 2}}'],
  ["exercise.unoclp.json", "[[case]]\ntitle = 'x'\n[[part]]\n"],
];

/** What a student has handed in, and perhaps edited. @param {object} more */
const handedIn = (more) => Buffer.from(JSON.stringify({
  form: "unoclp-hand-in-1", student: { name: "Eva", number: "" }, exercise: { name: "05-motor" },
  program: { name: "motor.il", text: "LD I3\nST Q4\n" }, drawing: null, verdicts: { passed: true }, minutes: 1, ...more,
}));

for (const [locale, said, offer, unknown] of /** @type {const} */ ([
  ["en-US", "for the exercise 05-motor", "Open the exercise", "The exercise 99-none is not here"],
  ["pt-BR", "para o exercício 05-motor", "Abrir o exercício", "O exercício 99-none não está aqui"],
])) {
  test(`a hand-in of another exercise than the one that is open says which, and loses nothing, ${locale}`, async () => {
    const page = await lab.still({ locale });
    await type(page, "LD I1\nST Q1 (* mine *)\n", "mine.il");
    await pick(page, "#exercises");
    const title = page.locator("#exercise h3");
    const open = (await title.textContent()) ?? "";
    const far = await page.textContent("#exercise-progress");
    await choose(page, "eva.unoclp.json", handedIn({}));
    const note = page.locator("#notes > div", { hasText: said });
    await note.waitFor();
    assert.match(await keptText(page), /ST Q4/);
    assert.deepEqual([await title.textContent(), await page.textContent("#exercise-progress")], [open, far]);
    await note.getByRole("button", { name: offer }).click();
    await title.filter({ hasNotText: open }).waitFor();
    assert.equal(await page.locator("#exercise-list").inputValue(), "4");
    assert.match(await keptText(page), /ST Q4/);
    // One that the page does not have.
    await choose(page, "eva.unoclp.json", handedIn({ exercise: { name: "99-none" } }));
    await page.locator("#notes > div", { hasText: "99-none" }).getByRole("button", { name: offer }).click();
    await page.locator("#notes", { hasText: unknown }).waitFor();
    assert.equal(await page.locator("#exercise-list").inputValue(), "4");
    await page.locator("#notes").getByRole("button", { name: /Undo|Desfazer/ }).first().click();
    assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
    await page.context().close();
  });
}

/** Drawings that nobody has drawn: what was handed in was edited by hand. @type {readonly unknown[]} */
const EDITED = [
  { name: "motor.il", base: { name: "motor.il", text: "LD I1\nST Q1\n" }, text: "LD I3\nST Q4\n", log: [{ do: "explode" }] },
  { name: "motor.il", base: { name: "motor.il", text: "no program" }, text: "LD I3\nST Q4\n", log: [null, 7, "x"], lacks: 3 },
  { name: "motor.il", base: { name: "motor.il", text: "LD I1\nST Q1\n" }, text: "another text", log: [{ do: "undo" }], lacks: -1 },
  { name: "motor.il", base: { name: "motor.il", text: "LD I1\nST Q1\n" }, text: "LD I3\nST Q4\n", log: [] },
];

test("a hand-in whose drawing was edited by hand is drawn from its program", async () => {
  const page = await lab.other({}, { view: "draw" });
  for (const drawing of EDITED) {
    await choose(page, "edited.unoclp.json", handedIn({ drawing }));
    await page.locator('#sheet .element[data-point="Q4"]').waitFor();
    await page.locator("#problem-count.good").waitFor();
    assert.equal(await keptText(page), "LD I3\nST Q4\n");
    await pick(page, "#new-file");
    await page.locator('#sheet .element[data-point="Q4"]').waitFor({ state: "detached" });
  }
  await page.context().close();
});

for (const [index, locale] of ["en-US", "pt-BR"].entries()) {
  test(`what is no hand-in is told, and nothing is lost, ${locale}`, async () => {
    const page = await lab.still({ locale });
    await type(page, "LD I3\nST Q3 (* mine *)\n", "mine.il");
    const clear = () => page.evaluate(() => document.getElementById("notes")?.replaceChildren());
    for (const [name, text] of BAD) {
      await clear();
      await choose(page, name, Buffer.from(text));
      await page.locator("#notes", { hasText: `${name} ${index === 0 ? "is not a hand-in" : "não é uma entrega"}` }).waitFor();
      assert.match(await keptText(page), /mine/);
    }
    await clear();
    await choose(page, "large.unoclp.json", Buffer.alloc(50 << 20, " "));
    await page.locator("#notes", { hasText: index === 0 ? "larger than 1 MB" : "mais de 1 MB" }).waitFor();
    // One whose words are markup, and whose drawing is none.
    const markup = '<img src=x onerror="alert(1)">';
    const odd = { form: "unoclp-hand-in-1", student: { name: markup }, program: { name: `${markup}.il`, text: "LD I1\nST Q1\n" }, drawing: { name: 1, log: "x" } };
    await clear();
    await choose(page, "odd.unoclp.json", Buffer.from(JSON.stringify(odd)));
    await page.locator("#notes", { hasText: markup }).waitFor();
    assert.equal(await page.locator("#notes img").count(), 0);
    await page.locator("#notes").getByRole("button", { name: index === 0 ? "Undo" : "Desfazer" }).click();
    assert.match((await page.textContent(".cm-content")) ?? "", /mine/);
    await page.context().close();
  });
}
