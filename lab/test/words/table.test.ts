// Every text of the page says the same in both languages, and every text that the page names is there.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { TABLE } from "../../src/words/table";

const lab = process.env["LAB"] ?? "lab";
/** Words that are the same in both languages. */
const SAME: readonly string[] = ["commandRun", "commandStop", "viewLadder"];

const values = (text: string): string[] => [...text.matchAll(/\{(\w+)\}/g)].map((match) => match[1] ?? "").sort();

test("no text is without its twin", () => {
  for (const [key, [en, pt]] of Object.entries<readonly [string, string]>(TABLE)) {
    assert.ok(en.trim() && pt.trim(), key);
    assert.deepEqual(values(en), values(pt), key);
    assert.ok(en !== pt || SAME.includes(key), `${key} is English in both`);
  }
});

test("what the page names is there", () => {
  const page = join(lab, "src/page");
  const files = [join(lab, "static/index.html"), ...readdirSync(page).map((name) => join(page, name))];
  const named = files.flatMap((file) => [...readFileSync(file, "utf8").matchAll(/data-say(?:-label|-title)?"?[=:]\s*"(\w+)"/g)].map((match) => match[1] ?? ""));
  assert.ok(named.length > 30, String(named.length));
  for (const key of named) assert.ok(key in TABLE, key);
});

test("the rates that the page offers are those of Rust", () => {
  const rates = (file: string): number[] => {
    const list = /RATES(?:: \[u32; \d+\])? = \[([^\]]+)\]/.exec(readFileSync(join(lab, file), "utf8"))?.[1] ?? "";
    return list.replaceAll("_", "").split(",").map(Number).filter(Boolean);
  };
  assert.ok(rates("src/page/settings.ts").length > 5);
  assert.deepEqual(rates("src/page/settings.ts"), rates("../board/src/settings.rs"));
});

test("no text is without a use", () => {
  const folders = ["src/page", "src/words", "static"].map((folder) => join(lab, folder));
  const files = folders.flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)));
  const all = files.filter((file) => !file.endsWith("table.ts")).map((file) => readFileSync(file, "utf8")).join("\n");
  const idle = Object.keys(TABLE).filter((key) => !all.includes(`"${key}"`));
  assert.deepEqual(idle, []);
});
