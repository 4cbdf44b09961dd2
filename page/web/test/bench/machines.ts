// What a machine beside its simulated board, UNO or Mega, costs: how much of the board's pace, and how many drawings of it can be made in a
// second. Part of `npm run bench`; with `--json` it says so in a form that `cargo xtask bench` writes into the pages.
//
// The board runs the model solution of each machine, as in the page's worker: with the machine, which takes a step each
// simulated ms, and without, in turn, its contacts as it left them. How much longer the turns with it take than those beside
// them, and what a drawing between them takes, is the median, in time of the processor. The page draws 60 times a second.

import { readFileSync, readdirSync } from "node:fs";
import { type BoardId, firmwareName } from "../../../uno/src/boards";
import type { Machine } from "../../../uno/src/machine";
import { Session } from "../../../uno/src/session";
import { Wired } from "../../src/board/wired";
import { Tools } from "../../src/tools/tools";

/** Simulated ms of a turn, how often there is one with the machine and one without, and drawings a second. */
const TURN = 80;
const PAIRS = 150;
const SCREEN = 60;
const BLOCK = 512;
/** Says of a machine that it is wired to a Mega; the others are to a UNO. */
const FOR_MEGA = /^board = "mega"$/m;

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
  const board: BoardId = FOR_MEGA.test(text) ? "mega" : "uno";
  const made = tools.ask("check", { of: { name: `${name}.st`, text: file(`${name}.st`) }, board }).program;
  if (!made) throw new Error(name);
  const session = new Session(() => {}, () => 0);
  session.obey({ kind: "firmware", board, bytes: new Uint8Array(readFileSync(new URL(`${firmwareName(board)}.bin`, page))) });
  session.obey({ kind: "card", image: card(tools, made.code) });
  session.obey({ kind: "plug", on: true });
  const pass = (millis: number): void => {
    session.obey({ kind: "step", millis });
    while (session.turn() !== null);
  };
  const facts = tools.ask("machine", { name: `${name}.toml`, text, speak: "en", board });
  const wired = new Wired(tools, facts, () => {
    throw new Error(`${name} has broken down`);
  });
  // Somebody starts it, and it comes to work.
  session.wire(wired);
  pass(2000);
  for (const { part, value, high, what } of facts.hands.slice(0, 2)) if (what === "pressed") tools.ask("machineHand", { part, value, to: high });
  pass(3000);
  let given = 0;
  const machine: Machine = {
    inputs: wired.inputs,
    step: (levels, shares) => {
      const gives = wired.step(levels, shares);
      given = gives.closed;
      return gives;
    },
  };
  const beside = (): number => {
    session.wire(machine);
    return time(() => pass(TURN));
  };
  // The contacts stay as the machine left them: the program goes the same way.
  const alone = (): number => {
    session.wire(null);
    for (let input = 1; given >> (input - 1); input += 1) session.obey({ kind: "button", input, closed: ((given >> (input - 1)) & 1) === 1 });
    return time(() => pass(TURN));
  };
  const [without, more, drawings]: [number[], number[], number[]] = [[], [], []];
  for (let pair = 0; pair < PAIRS; pair += 1) {
    const before = pair % 2 === 0 ? alone() : 0;
    const took = beside();
    drawings.push(time(() => tools.ask("machineLook", {})));
    const other = before || alone();
    without.push(other);
    more.push(took - other);
  }
  const drawing = median(drawings);
  const pace = median(without) / (median(without) + median(more));
  return { lost: 1 - pace * (1 - SCREEN * drawing), drawing: 1000 * drawing };
}

function median(all: readonly number[]): number {
  return all.toSorted((one, other) => one - other)[all.length >> 1] ?? 0;
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
