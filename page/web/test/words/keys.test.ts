// The table of keys in docs/draw.md is that of the page, in each language: keys of elements, which Rust lists, and of what is done.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ACTIONS } from "../../src/page/draw/actions";

// npm runs the tests in the folder of the page, xtask above it.
const root = existsSync("src/page") ? "../.." : ".";
const palette = readFileSync(join(root, "tools/edit/src/palette.rs"), "utf8");
const ELEMENTS = [...palette.matchAll(/^ {4}\w+: "\w+" \w+ "(.+?)" "/gm)].map(([, key]) => (key ?? "").replace("\\\\", "\\"));
/** Keys that the page has besides: this one is in the text above the table, and that is a second one for the same. */
const BESIDES = ["?", "Ctrl+Shift+z"];
const NAMES: Readonly<Record<string, readonly string[]>> = {
  "↑": ["ArrowUp"], "↓": ["ArrowDown"], arrows: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"],
};

/** The keys of a cell: `C, K`, or `> . = # , <`. */
const elements = (cell: string): string[] => cell.split(" ").map((key) => (key.length > 1 ? key.replace(/,$/, "") : key)).filter((key) => key !== "and").map((key) => key.toLowerCase());

/** The keys of a cell: `Ctrl + X, C` is Ctrl+x and Ctrl+c. */
function actions(cell: string): string[] {
  let held = "";
  return cell.split(/, | and /).flatMap((part) => {
    const keys = part.split(" + ");
    const key = keys.pop() ?? "";
    if (keys.length > 0) held = keys.map((one) => `${one}+`).join("");
    return (NAMES[key] ?? [key.length === 1 ? key.toLowerCase() : key]).map((name) => held + name);
  });
}

for (const end of [".md", ".pt-BR.md"]) {
  test(`docs/draw${end} lists the keys of the page`, () => {
    const text = readFileSync(join(root, "docs/draw" + end), "utf8");
    const rows = text.slice(text.search(/^\| (key|tecla) \|/m)).split("\n").slice(2);
    const cells = rows.filter((row) => row.startsWith("|")).map((row) => row.split("|").slice(1, -1).map((cell) => cell.trim().replace(/\be\b/, "and").replace("setas", "arrows")));
    const first = cells.map(([cell]) => cell ?? "").filter((cell) => cell && !cell.startsWith("Shift"));
    assert.deepEqual(first.flatMap(elements).sort(), ELEMENTS.filter((key) => key).sort());
    const second = cells.flatMap((row) => (row[2] ? actions(row[2]) : []));
    assert.deepEqual([...second, ...BESIDES].sort(), ACTIONS.map(({ key }) => key).sort());
  });
}
