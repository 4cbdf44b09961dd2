// The very modules that the page loads, called as the page calls them, without a browser: what they answer, and that no
// request traps.
// @ts-check

import assert from "node:assert/strict";
import { test } from "node:test";
import { readFileSync } from "node:fs";
import { ask, load, random } from "./module.mjs";

const IL = { name: "a.il", text: "LD I1\nTON T1, 20\nST Q1\n" };
/** The program that the page begins with, which the smaller module knows. */
const FIRST = { name: "a.il", text: readFileSync(new URL("../../../bridge/start/seal-in.il", import.meta.url), "utf8") };
const ST = { name: "a.st", text: "PROGRAM p VAR q AT %QX1 : BOOL; END_VAR q := TRUE; END_PROGRAM" };
const GOOD = [
  { ask: "board" },
  { ask: "board", board: "nano" },
  { ask: "text", ...IL },
  { ask: "text", ...FIRST },
  { ask: "text", ...ST },
  { ask: "text", name: "P.TXT", text: "0\n787600\n827301\n877901\n" },
  { ask: "check", version: 1 },
  { ask: "check", version: 4 },
  { ask: "check", version: 2 },
  { ask: "ladder", version: 2, width: 64, speak: "en" },
  { ask: "check", version: 3 },
  { ask: "ladder", version: 1, width: 64, speak: "pt" },
  { ask: "list", version: 1, width: 64, speak: "en", as: "numeric" },
  { ask: "list", version: 1, width: 64, speak: "en", as: "xml" },
  { ask: "pages", version: 1, width: 64, speak: "pt", letter: false },
  { ask: "exercise", version: 1, title: "x", scenario: "until = 5" },
  { ask: "card", program: "0\n787600\n", state: true },
  { ask: "read", blocks: [[0, "00ff"]], name: "STATE.TXT" },
  { ask: "open", version: 1, reset: false, rate: 9600 },
  { ask: "step", board: 1, now: 12.5, came: [1, 43, 14] },
  { ask: "order", board: 1, order: { do: "upload", version: 1, stay: true } },
  { ask: "order", board: 1, order: { do: "upload", version: 2, stay: true } },
  { ask: "order", board: 1, order: { do: "watch", version: 3 } },
  { ask: "order", board: 1, order: { do: "set", point: "D1", value: -7 } },
  { ask: "order", board: 1, order: { do: "flash", hex: ":00000001FF", model: "uno" } },
  { ask: "lose", board: 1, why: "gone" },
  { ask: "close", board: 1 },
];
const ODD = [null, true, -1, 0.5, 1e300, 2 ** 53, "", "é😀", [], {}, [[0, "zz"], 7], "(".repeat(500)];

/** Something odd in the place of a part, wherever that is. @param {any} value @param {(limit: number) => number} below @returns {any} */
function changed(value, below) {
  const keys = value && typeof value === "object" ? Object.keys(value) : [];
  const key = keys[below(keys.length)];
  if (key === undefined || below(8) === 0) return ODD[below(ODD.length)];
  const copy = Array.isArray(value) ? [...value] : { ...value };
  if (below(5) === 0) delete copy[key];
  else copy[key] = changed(copy[key], below);
  return copy;
}

for (const file of ["unoclp.wasm", "unoclp-full.wasm"]) {
  const isFull = file === "unoclp-full.wasm";

  test(`${file} checks, draws and speaks to a board`, async () => {
    const call = await load(file);
    const { ok: uno } = ask(call, { ask: "board" });
    assert.deepEqual([uno.name, uno.inputs, uno.outputs, uno.shared.length], ["UNO", 8, 4, 4]);
    const { ok } = ask(call, { ask: "check", of: FIRST });
    assert.equal(ok.language, "il");
    assert.match(ok.program.code, /877901/);
    assert.deepEqual(ok.colours.slice(0, 6), [0, 63, 0, 1, 3, 4]);
    assert.match(ask(call, { ask: "ladder", of: FIRST, width: 64, speak: "pt" }).ok.svg, /Degrau 1/);
    const wrong = ask(call, { ask: "check", of: { name: "P.TXT", text: "0\n787601\n" } }).ok;
    assert.notEqual(wrong.problems[0].message.en, wrong.problems[0].message.pt);
    const board = ask(call, { ask: "open", version: null, reset: false }).ok;
    // It waits, and asks who is there (Modbus, read device identification).
    let step = { send: [], until: 0 };
    while (step.send.length === 0) step = ask(call, { ask: "step", board, now: step.until, came: [] }).ok;
    assert.deepEqual(step.send.slice(0, 4), [1, 43, 14, 1]);
    if (isFull) {
      const { ok: timed } = ask(call, { ask: "check", of: IL });
      assert.match(timed.program.code, /847978/);
      assert.deepEqual(timed.colours.slice(0, 6), [0, 2, 4, 1, 2, 2]);
      assert.match(ask(call, { ask: "ladder", of: IL, width: 64, speak: "pt" }).ok.svg, /Degrau 1/);
      const misspelt = ask(call, { ask: "check", of: { name: "a.il", text: "LDD I1" } }).ok;
      assert.notEqual(misspelt.problems[0].message.en, misspelt.problems[0].message.pt);
    }
    // What is compiled takes the module that has everything, and the smaller one says so.
    for (const [text, language] of /** @type {const} */ ([[IL, "il"], [ST, "st"]])) {
      const compiled = ask(call, { ask: "check", of: text });
      assert.deepEqual(isFull ? compiled.ok.language : compiled, isFull ? language : { more: true });
    }
    assert.ok(ask(call, { ask: "none" }).error.pt);
  });

  test(`${file} answers whatever is asked`, async () => {
    const call = await load(file);
    const below = random(17);
    /** @param {Uint8Array} request */
    const isAnswered = (request) => {
      const [key, ...more] = Object.keys(JSON.parse(call(request)));
      assert.ok(key === "ok" || key === "error" || key === "more");
      assert.deepEqual(more, []);
    };
    const encoder = new TextEncoder();
    for (const good of GOOD) isAnswered(encoder.encode(JSON.stringify(good)));
    for (let round = 0; round < 3000; round++) {
      let request = /** @type {unknown} */ (GOOD[below(GOOD.length)]);
      for (let changes = below(4); changes > 0; changes--) request = changed(request, below);
      const bytes = encoder.encode(JSON.stringify(request) ?? "");
      if (below(3) === 0 && bytes.length > 0) bytes[below(bytes.length)] = below(256);
      isAnswered(below(6) === 0 ? bytes.subarray(0, below(bytes.length)) : bytes);
      isAnswered(Uint8Array.from({ length: below(40) }, () => below(256)));
    }
  });
}
