// NOTICE names what the page contains of others.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = new URL("../", import.meta.url.slice(0, import.meta.url.lastIndexOf("/lab/") + 1));

function text(file: string): string {
  return readFileSync(fileURLToPath(new URL(file, root)), "utf8");
}

interface Lock {
  readonly packages: Readonly<Record<string, { readonly license?: string; readonly dev?: boolean }>>;
}

test("NOTICE names each package that the page may contain, with its licence, and no other", () => {
  const lock = JSON.parse(text("lab/package-lock.json")) as Lock;
  const needed = Object.entries(lock.packages)
    .filter(([path, { dev }]) => path !== "" && !dev)
    .map(([path, { license }]) => `${path.replace("node_modules/", "")} (${license})`)
    // They hold nothing but types.
    .filter((line) => !/^(@types\/|csstype )/.test(line));
  const named = text("NOTICE").split("\n").filter((line) => /^\S+ \((MIT|BSD-3-Clause)\)$/.test(line));
  assert.deepEqual(named.sort(), needed.sort());
});
