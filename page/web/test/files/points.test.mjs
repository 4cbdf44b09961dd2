// How many points there are is the board's to say: the page's TypeScript has none of the UNO's numbers.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";

const SOURCES = new URL("../../src/", import.meta.url);
/** The simulated UNO itself, and what the suite runs it by. */
const UNO = /^(board|engine)\//;

/** Numbers of points, as they were written before. */
const OLD = [
  ["a comparison", /(?:[<>]=?|[!=]==)\s*[48]\b(?!\s*<<)/],
  ["a number of points handed on", /\b(?:show|offer|upTo)\([^)]*\b[48]\b/],
  ["a choice of two numbers of points", /\?\s*[48]\s*:\s*[48]\b/],
  ["a remainder", /%\s*(?:4|8|60|64)\b/],
  ["a list of points", /\[(?:0, )?1, 2, 3\b/],
  ["a list of lamps", /\[0, 0, 0, 0\]/],
  ["a pattern of points", /\[IQ[A-Z]*\]\\d(?!\+)|\[[01]-[3478]\]/],
  ["a number of buttons in words", /\b[48] (?:buttons|botões|lamps|inputs|outputs|entradas|saídas|LEDs)\b|1 (?:to|a) 8\b/],
];

/** @param {string} text what is found in it, by line @param {string} file */
function found(text, file = "") {
  return text.split("\n").flatMap((line, at) => OLD.filter(([, old]) => /** @type {RegExp} */ (old).test(line)).map(([what]) => `${file}:${at + 1}: ${what}: ${line.trim()}`));
}

test("the page asks the board how many points it has", () => {
  const names = readdirSync(SOURCES, { recursive: true }).map(String).filter((name) => name.endsWith(".ts") && !UNO.test(name));
  assert.ok(names.length > 50, `${names.length} sources`);
  assert.deepEqual(names.flatMap((name) => found(readFileSync(new URL(name, SOURCES), "utf8"), name)), []);
});

test("what was written before is found", () => {
  for (const line of [
    "for (let input = 1; input <= 8; input++) {",
    "if (inputs.some((input) => input > 4)) this.show(8);",
    "this.show(4);",
    "this.buttons.show(all ? 8 : 4);",
    "const match = /^(?:Digit|Numpad)([1-8])$/.exec(event.code);",
    "if (!seen || !/^[IQ]\\d$/.test(point)) return;",
    "[1, 2, 3, 4, 5, 6, 7, 8].filter((n) => n)",
    "this.lamps.light([0, 1, 2, 3].map((bit) => bit));",
    "this.lamps.light(pins?.outputs ?? [0, 0, 0, 0]);",
    "`LD   I${(index % 4) + 1}\\n`",
    "`ANDN M${(index % 60) + 1}\\n`",
    'moreButtons: ["8 buttons", "8 botões"],',
    'buttonsHint: ["keys 1 to 8", "teclas 1 a 8"],',
  ]) assert.notDeepEqual(found(line), [], line);
  for (const line of ["tabSize.of(4)", "const LARGEST = 8 << 20;", "base - 4", "new Uint8Array(8)"]) assert.deepEqual(found(line), [], line);
});
