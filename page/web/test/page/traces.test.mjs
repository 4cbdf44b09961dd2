// The machines in the page's own module move as they do natively: each with its model solution for ten minutes, and the same
// number for all that it is in each millisecond.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { ask, load } from "./module.mjs";

/** @param {string} path */
const file = (path) => readFileSync(new URL(`../../../../${path}`, import.meta.url), "utf8");

/** Ten minutes, ms. */
const SPAN = 600_000;

test("each machine has the trace that it has natively", async () => {
  const module = await load("unoclp-full.wasm");
  const lines = file("tools/exercise/tests/traces.txt").trim().split("\n");
  assert.equal(lines.length, 20);
  for (const line of lines) {
    const [name = "", trace] = line.split(" ");
    const request = { ask: "trace", of: { name: `${name}.st`, text: file(`programs/plants/${name}.st`), board: /^board = "(.*)"$/m.exec(file(`programs/plants/${name}.toml`))?.[1] ?? "uno" }, plant: `${name}.toml`, plantText: file(`programs/plants/${name}.toml`), ms: SPAN };
    assert.equal(ask(module, request).ok, trace, name);
  }
});
