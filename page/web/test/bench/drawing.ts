// What the module of the page takes for a key, in a drawing of 100 rungs and in a text of 300 lines: `npm run bench`.
//
// A cursor that moves makes nothing. A contact that turns from open to closed has the document emitted, compiled and drawn
// once; what the page asks of its text then is known. A key in a text has that compiled, and its problems told. Each with
// the way of the request and of the answer. The quickest of many counts.

import { readFileSync } from "node:fs";
import type { Act, Text } from "../../src/tools/answers";
import { Tools } from "../../src/tools/tools";

const RUNGS = 100;
const LINES = 300;
const ROUNDS = 60;
const AROUND = { name: "bench.il", width: 80, speak: "en" } as const;

const rung = (number: number): string => `LD I1\nANDN I2\nAND(\nLD I3\nOR I4\n)\nST M${1 + (number % 64)}\n`;
const text = Array.from({ length: RUNGS }, (_, number) => rung(number)).join("\n");

/** Milliseconds of the quickest of many rounds. */
function quickest(work: (round: number) => void): number {
  let least = Infinity;
  for (let round = 0; round < ROUNDS; round += 1) {
    const start = performance.now();
    work(round);
    least = Math.min(least, performance.now() - start);
  }
  return least;
}

const file = new URL("../page/unoclp-full.wasm", import.meta.url);
const tools = await Tools.of(await WebAssembly.compile(readFileSync(file)));
const edit = (act: Act): Text => {
  const drawn = tools.ask("edit", { act, ...AROUND });
  return { name: AROUND.name, text: drawn.text ?? "" };
};
tools.ask("draw", { base: { name: AROUND.name, text }, log: [], ...AROUND });
edit({ do: "move", to: "right" });
const tell = (what: string, ms: number): void => console.log(`${what}: ${ms.toFixed(1)} ms`);
tell(`${RUNGS} rungs, the cursor moves`, quickest((round) => void edit({ do: "move", to: round % 2 ? "up" : "down" })));
let now = edit({ do: "toggle" });
tell(`${RUNGS} rungs, a contact is turned, compiled and drawn`, quickest(() => {
  now = edit({ do: "toggle" });
}));
tell(`${RUNGS} rungs, its text is checked`, quickest(() => void tools.ask("check", { of: now })));

const statements = Array.from({ length: LINES - 24 }, (_, number) => `  v${number % 20} := v${(number + 3) % 20} + ${number % 7};\n`);
const st = ["PROGRAM p\nVAR\n", ...Array.from({ length: 20 }, (_, number) => `  v${number} : INT;\n`), "END_VAR\n", ...statements, "END_PROGRAM\n"].join("");
const il = text.split("\n").slice(0, LINES).join("\n");
for (const [name, text] of [["a.st", st], ["a.il", il]] as const) {
  // Another text each time: nothing of it is known.
  tell(`${LINES} lines of ${name}, a key, problems told`, quickest((round) => void tools.ask("check", { of: { name, text: `${text}${" ".repeat(round + 1)}` } })));
}

// A chart of 40 steps: its text after a key, and how it is drawn then.
const STEPS = 40;
const steps = Array.from({ length: STEPS }, (_, number) => `${number ? "" : "INITIAL_"}STEP S${number}: q(N); END_STEP\nTRANSITION FROM S${number} TO S${(number + 1) % STEPS} := i; END_TRANSITION\n`);
const chart = { name: "chart.st", text: `PROGRAM p\nVAR i AT %IX1 : BOOL; q AT %QX1 : BOOL; END_VAR\n${steps.join("")}END_PROGRAM\n` };
tell(`a chart of ${STEPS} steps, a condition is written and drawn`, quickest((round) => {
  chart.text = tools.ask("chart", { of: chart, chart: 0, at: "t7", what: "condition", say: round % 2 ? "i" : "NOT i" }).text ?? "";
}));
tell(`a chart of ${STEPS} steps, the next step and its action`, quickest(() => void tools.ask("chart", { of: chart, chart: 0, at: "s7", what: "act" })));

// A project of 20 units, as it opens.
const UNITS = 20;
const five = readFileSync("test/page/five.xml", "utf8");
const block = /<pou name="Latch"[^]*?<\/pou>/.exec(five)?.[0] ?? "";
const more = Array.from({ length: UNITS - 5 }, (_, number) => block.replace("Latch", `Latch${number}`)).join("");
const project = five.replace("</pous>", `${more}</pous>`);
tell(`a project of ${UNITS} units opens: checked, its units, the body of one`, quickest((round) => {
  const of = { name: "plc.xml", text: `${project}${" ".repeat(round)}` };
  if (tools.ask("project", { of }).units.length !== UNITS || !tools.ask("check", { of }).program) throw new Error("it is another project");
  tools.ask("unit", { of, unit: "Latch3" });
}));
