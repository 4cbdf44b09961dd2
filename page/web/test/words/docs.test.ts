// What the pages about the page call a control is what the page calls it, in each language.

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { CHART } from "../../src/words/charttable";
import { DRAW } from "../../src/words/drawtable";
import { LATER } from "../../src/words/latertable";
import { LEARN } from "../../src/words/learntable";
import { SLOW } from "../../src/words/slowtable";
import { PROJECT } from "../../src/words/projecttable";
import { TABLE } from "../../src/words/table";

// npm runs the tests in the folder of the page, xtask above it.
const docs = existsSync("src/page") ? "../../docs" : "docs";
const rows = Object.values({ ...TABLE, ...LATER, ...CHART, ...PROJECT, ...DRAW, ...LEARN, ...SLOW });
/** What stands emphasised without being a control. */
const PROSE = ["The port cannot be opened", "Não foi possível abrir a porta"];

for (const [language, end] of [[0, ".md"], [1, ".pt-BR.md"]] as const) {
  // Of a text with numbers in it a page names the words before them.
  const words = new Set(rows.flatMap((row) => [row[language], (row[language].split("{")[0] ?? "").trim()]));
  for (const page of ["lab", "draw", "sfc", "projects", "exercises", "teachers"]) {
    test(`each control that ${page}${end} names is one of the page`, () => {
      const text = readFileSync(join(docs, page + end), "utf8").replace(/```[^]*?```|`[^`]*`/g, "");
      const named = [...text.matchAll(/(?<![*\w])\*((?:\+ )?\p{Lu}[^*\[]*?)\*(?![*\w])/gu)].map(([, name]) => (name ?? "").replace(/\s+/g, " ").replace(/^\+ /, ""));
      assert.ok(named.length > 3);
      assert.deepEqual(named.filter((name) => !words.has(name) && !words.has(`+ ${name}`) && !PROSE.includes(name)), []);
    });
  }
}
