// What a visitor waits for: the bytes of the first view, and the firmware that is among them.
// @ts-check

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { built } from "../../serve.mjs";
import { Lab } from "./harness.mjs";

/** What the first view may weigh, compressed as servers do, in bytes. */
const MOST = 520_000;

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("the first view weighs no more than 520 KB compressed, with the firmware in it", async () => {
  const context = await lab.browser.newContext({ serviceWorkers: "block" });
  const page = await context.newPage();
  /** @type {import("playwright-core").Request[]} */
  const requests = [];
  context.on("requestfinished", (request) => void requests.push(request));
  await page.goto(lab.server.url);
  await page.locator("#run:enabled").waitFor();
  // The page says itself when it is ready; what it asks for after that is no part of the first view.
  const ready = await page.evaluate(() => performance.timeOrigin + (performance.getEntriesByName("ready")[0]?.startTime ?? Infinity));
  const asked = requests.filter((request) => request.timing().startTime <= ready);
  const first = [...new Set(asked.map((request) => new URL(request.url()).pathname.slice(1) || "index.html"))];
  const weights = first.map((file) => /** @type {const} */ ([gzipSync(readFileSync(join(built, file)), { level: 9 }).length, file]));
  const sum = weights.reduce((sum, [bytes]) => sum + bytes, 0);
  const told = weights.sort(([a], [b]) => b - a).map(([bytes, file]) => `${file} ${bytes}`).join(", ");
  for (const file of ["index.html", "page.js", "tools.js", "board.js", "unoclp.wasm", "unoclp.bin"]) assert.ok(first.includes(file), `${file}: ${told}`);
  assert.ok(sum <= MOST, `${sum} bytes: ${told}`);
  await context.close();
});

test("the page's firmware is the tested hex, byte by byte", () => {
  const firmware = fileURLToPath(new URL("../../../../firmware/", import.meta.url));
  const hex = readFileSync(join(firmware, "unoclp-uno.hex"), "utf8");
  const bytes = readFileSync(join(built, "unoclp.bin"));
  let at = 0;
  for (const [, length = "", address = "", data = ""] of hex.matchAll(/^:(..)(....)00(.*)..\s*$/gm)) {
    assert.equal(parseInt(address, 16), at, "the hex has no gap");
    assert.equal(data, bytes.subarray(at, at + parseInt(length, 16)).toString("hex").toUpperCase());
    at += parseInt(length, 16);
  }
  assert.equal(at, bytes.length);
});
