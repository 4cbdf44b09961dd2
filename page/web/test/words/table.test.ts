// Every text of the page says the same in both languages, and every text that the page names is there.

import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { CHART } from "../../src/words/charttable";
import { DRAW } from "../../src/words/drawtable";
import { EDITOR } from "../../src/words/editortable";
import { LATER } from "../../src/words/latertable";
import { LEARN } from "../../src/words/learntable";
import { PROJECT } from "../../src/words/projecttable";
import { SITE } from "../../src/words/sitetable";
import { SLOW } from "../../src/words/slowtable";
import { TABLE } from "../../src/words/table";

/** That of the page, and those of its parts that are loaded later. */
const ALL: Readonly<Record<string, readonly [string, string]>> = { ...TABLE, ...LATER, ...CHART, ...PROJECT, ...DRAW, ...LEARN, ...SITE, ...SLOW };

/** The files of a folder and of those in it. */
const below = (folder: string): string[] => readdirSync(folder, { recursive: true }).map(String).filter((name) => /\.\w+$/.test(name)).map((name) => join(folder, name));

// npm runs the tests in the folder of the lab, xtask above it.
const lab = existsSync("src/page") ? "." : "page/web";
/** Words that are the same in both languages. */
const SAME: readonly string[] = ["panelTaken", "viewDraw", "ok", "alarmNormal"];

const values = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1] ?? "").sort();

test("no table takes the words of another", () => {
  const keys = [TABLE, LATER, CHART, PROJECT, DRAW, LEARN, SITE, SLOW].flatMap((table) => Object.keys(table));
  assert.deepEqual(keys.filter((key, at) => keys.indexOf(key) !== at), []);
});

test("no text is without its twin", () => {
  for (const [key, [en, pt]] of Object.entries(ALL)) {
    assert.ok(en.trim() && pt.trim(), key);
    assert.deepEqual(values(en), values(pt), key);
    assert.ok(en !== pt || SAME.includes(key), `${key} is English in both`);
  }
});

test("the editor's own panels speak both languages", () => {
  for (const [phrase, [en, pt]] of Object.entries(EDITOR)) {
    assert.ok(en.trim() && pt.trim() && String(en) !== pt, phrase);
    assert.equal(en.includes("$"), pt.includes("$"), phrase);
  }
});

test("what the page names is there", () => {
  const folders = ["src/page", "src/site"].flatMap((folder) => below(join(lab, folder)));
  const files = [join(lab, "static/index.html"), join(lab, "static/site.html"), ...folders];
  const named = files.flatMap((file) => [...readFileSync(file, "utf8").matchAll(/data-say(?:-label|-title)?"?[=:]\s*"(\w+)"/g)].map((match) => match[1] ?? ""));
  assert.ok(named.length > 30, String(named.length));
  for (const key of named) assert.ok(key in ALL, key);
});

test("no text is without a use", () => {
  const folders = ["src/page", "src/site", "src/words", "static"].map((folder) => join(lab, folder));
  const tables = ["", "later", "chart", "project", "draw", "learn", "site", "slow"].map((part) => join(lab, `src/words/${part}table.ts`));
  const all = folders.flatMap(below).filter((file) => !tables.includes(file)).map((file) => readFileSync(file, "utf8")).join("\n");
  const idle = Object.keys(ALL).filter((key) => !all.includes(`"${key}"`));
  assert.deepEqual(idle, []);
});
