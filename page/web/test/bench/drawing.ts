// What the module of the page takes for a step of drawing, with 100 rungs on the sheet: `npm run bench`.
//
// A cursor that moves has the whole document checked, and nothing drawn; an element that comes has it checked, compiled
// and drawn. Both with the way of the request and of the answer. The quickest of many counts.

import { readFileSync } from "node:fs";
import type { Act } from "../../src/tools/answers";
import { Tools } from "../../src/tools/tools";

const RUNGS = 100;
const ROUNDS = 60;
const AROUND = { width: 80, speak: "en" } as const;

const rung = (number: number): string => `LD I1\nANDN I2\nAND(\nLD I3\nOR I4\n)\nST M${1 + (number % 64)}\n`;
const text = Array.from({ length: RUNGS }, (_, number) => rung(number)).join("\n");

/** Milliseconds of the quickest round of two steps that lead back to where they began, by the step. */
function quickest(tools: Tools, forth: Act, back: Act): number {
  let least = Infinity;
  for (let round = 0; round < ROUNDS; round += 1) {
    for (const act of [forth, back]) {
      const start = performance.now();
      tools.ask("edit", { act, ...AROUND });
      least = Math.min(least, performance.now() - start);
    }
  }
  return least;
}

const file = new URL("../page/unoclp-full.wasm", import.meta.url);
const tools = await Tools.of(await WebAssembly.compile(readFileSync(file)));
tools.ask("draw", { base: { name: "bench.il", text }, log: [], ...AROUND });
const check = quickest(tools, { do: "move", to: "down" }, { do: "move", to: "up" });
const edit = quickest(tools, { do: "insert", what: "contact", place: "behind" }, { do: "undo" });
console.log(`${RUNGS} rungs, the cursor moves, all is checked: ${check.toFixed(1)} ms`);
console.log(`${RUNGS} rungs, a contact comes, all is checked, compiled and drawn: ${edit.toFixed(1)} ms`);
