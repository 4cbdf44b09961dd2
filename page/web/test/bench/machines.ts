// What a machine beside the simulated UNO costs: how much of the board's pace, and how many drawings of it can be made in a
// second. Part of `npm run bench`; with `--json` it says so in a form that `cargo xtask bench` writes into the pages.
//
// The board runs the model solution of each machine, as in the page's worker: with the machine, which takes a step each ms
// and is drawn each 16 ms, and without, in turn. The quickest turn of each counts, in time of the processor: many short ones, of which
// some are disturbed by nothing else on the computer.

import { readFileSync, readdirSync } from "node:fs";
import { Session } from "../../../uno/src/session";
import { Wired } from "../../src/board/wired";
import { Tools } from "../../src/tools/tools";

/** Simulated ms from one drawing to the next, how many a turn has, and how many turns there are. */
const DRAWN = 16;
const DRAWINGS = 5;
const TURNS = 60;
const BLOCK = 512;

const page = new URL("../page/", import.meta.url);
const plants = new URL("../../../programs/plants/", import.meta.url);
const file = (name: string): string => readFileSync(new URL(name, plants), "utf8");

/** Seconds of a processor that it takes. */
function time(work: () => void): number {
  const start = process.cpuUsage();
  work();
  const { user, system } = process.cpuUsage(start);
  return (user + system) / 1e6;
}

/** A card with this program. */
function card(tools: Tools, program: string): Uint8Array {
  const made = tools.ask("card", { program, state: false });
  const image = new Uint8Array(made.bytes);
  for (const [block, digits] of made.blocks) image.set(Buffer.from(digits, "hex"), block * BLOCK);
  return image;
}

/** What a machine costs: the share of the pace that is lost, and ms for a drawing, the longest of all. */
async function cost(module: WebAssembly.Module, name: string): Promise<{ lost: number; drawing: number }> {
  const tools = await Tools.of(module);
  const text = file(`${name}.toml`);
  const made = tools.ask("check", { name: `${name}.st`, text: file(`${name}.st`) }).program;
  if (!made) throw new Error(name);
  const session = new Session(() => {}, () => 0);
  session.obey({ kind: "firmware", bytes: new Uint8Array(readFileSync(new URL("unoclp.bin", page))) });
  session.obey({ kind: "card", image: card(tools, made.code) });
  session.obey({ kind: "plug", on: true });
  const pass = (millis: number): void => {
    session.obey({ kind: "step", millis });
    while (session.turn() !== null);
  };
  const facts = tools.ask("machine", { name: `${name}.toml`, text, speak: "en" });
  const wired = new Wired(tools, facts, () => {
    throw new Error(`${name} has broken down`);
  });
  // Somebody starts it, and it comes to work.
  session.wire(wired);
  pass(2000);
  for (const { part, value, high, what } of facts.hands.slice(0, 2)) if (what === "pressed") tools.ask("machineHand", { part, value, to: high });
  pass(3000);
  let [alone, beside, drawing] = [Infinity, Infinity, Infinity];
  for (let turn = 0; turn < TURNS; turn += 1) {
    session.wire(null);
    alone = Math.min(alone, time(() => {
      for (let drawn = 0; drawn < DRAWINGS; drawn += 1) pass(DRAWN);
    }));
    session.wire(wired);
    beside = Math.min(beside, time(() => {
      for (let drawn = 0; drawn < DRAWINGS; drawn += 1) {
        pass(DRAWN);
        tools.ask("machineLook", {});
      }
    }));
    // Apart: to ask for the time takes time too.
    pass(DRAWN);
    drawing = Math.min(drawing, time(() => tools.ask("machineLook", {})));
  }
  return { lost: 1 - alone / beside, drawing: 1000 * drawing };
}

const module = await WebAssembly.compile(readFileSync(new URL("unoclp-full.wasm", page)));
const names = readdirSync(plants).filter((name) => name.endsWith(".toml")).map((name) => name.replace(".toml", ""));
const rows: { name: string; lost: number; drawing: number }[] = [];
for (const name of names) rows.push({ name, ...(await cost(module, name)) });
const most = (of: "lost" | "drawing") => rows.reduce((one, other) => (other[of] > one[of] ? other : one));
const [lost, drawing] = [most("lost"), most("drawing")];
if (process.argv.includes("--json")) console.log(JSON.stringify({ lost: lost.lost, lostBy: lost.name, drawing: drawing.drawing, drawingOf: drawing.name }));
else {
  for (const row of rows) console.log(`${row.name}: ${(100 * row.lost).toFixed(1)} % of the pace, ${row.drawing.toFixed(2)} ms a drawing`);
  console.log(`the most of the pace: ${(100 * lost.lost).toFixed(1)} % (${lost.name}); the longest drawing: ${drawing.drawing.toFixed(2)} ms (${drawing.name})`);
}
