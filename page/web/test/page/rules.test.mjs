// Each machine in the page's own module: its model solution does well to the end, a typical mistake is told, and what must
// never be is seen broken by mischief. Some of it is done in Chromium too (machine.test.mjs, kinds.test.mjs).
// @ts-check

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { ask, load, random } from "./module.mjs";

const plants = new URL("../../../../programs/plants/", import.meta.url);
/** @param {string} name */
const file = (name) => readFileSync(new URL(name, plants), "utf8");
const MACHINES = readdirSync(plants).filter((name) => name.endsWith(".toml")).map((name) => name.replace(".toml", ""));

/** What a machine says of a program. @param {Awaited<ReturnType<typeof load>>} call @param {string} machine @param {string} program */
function trial(call, machine, program) {
  const { ok, error } = ask(call, { ask: "trial", of: { name: "p.st", text: file(program), board: /^board = "(.*)"$/m.exec(file(`${machine}.toml`))?.[1] ?? "uno" }, plant: `${machine}.toml`, plantText: file(`${machine}.toml`) });
  assert.ok(ok, `${program}: ${JSON.stringify(error)}`);
  return ok;
}

test("each machine is solved by its model solution, and a typical mistake is told with its time", async () => {
  const call = await load("unoclp-full.wasm");
  assert.equal(MACHINES.length, 20);
  const wrong = readdirSync(new URL("wrong/", plants));
  for (const machine of MACHINES) {
    assert.deepEqual(trial(call, machine, `${machine}.st`), { passed: true, why: null, at: null }, machine);
    const own = wrong.filter((name) => name.replace(/-[^-]+$/, "") === machine);
    assert.ok(own.length > 0, machine);
    for (const name of own.slice(0, 1)) {
      const { passed, why, at } = trial(call, machine, `wrong/${name}`);
      assert.ok(!passed && at > 0 && why.en && why.pt !== why.en, name);
    }
  }
});

/** Each outputs that stand for a while, hands that press and turn, parts that fail: until all that must never be has been.
 * @param {Awaited<ReturnType<typeof load>>} call @param {string} machine @param {number} turns */
function mischief(call, machine, turns) {
  const below = random(1);
  const { ok } = ask(call, { ask: "machine", name: `${machine}.toml`, text: file(`${machine}.toml`), speak: "en" });
  const nevers = [...file(`${machine}.toml`).matchAll(/^\[\[never\]\]/gm)].length;
  const outputs = Math.max(4, ...ok.uses[2]);
  /** @type {Set<number>} */
  const broken = new Set();
  for (let turn = 0; turn < turns && broken.size < nevers; turn++) {
    if (turn % 200 === 0) ask(call, { ask: "machineReset" });
    // Not every machine has something to press.
    const hand = ok.hands[below(ok.hands.length)];
    if (hand) ask(call, { ask: "machineHand", part: hand.part, value: hand.value, to: below(2) === 0 ? hand.low : hand.high });
    if (below(10) === 0) {
      const [part, fault] = ok.faults[below(ok.faults.length)];
      ask(call, { ask: "machineFault", part, fault, is: below(2) === 0 });
    }
    const shares = Array.from({ length: outputs }, () => below(2) * 255);
    // Now and then nothing is driven, and for long.
    const levels = below(4) === 0 ? 0 : below(2 ** outputs);
    for (let times = below(12) === 0 ? 60 : 1 + below(8); times > 0; times--) call.step(levels, shares, 250);
    for (const [rule] of ask(call, { ask: "machineLook" }).ok.broken) broken.add(rule);
  }
  return ok.rules.slice(0, nevers).map((/** @type {{en: string}} */ rule) => rule.en).filter((/** @type {string} */ _, /** @type {number} */ rule) => !broken.has(rule));
}

test("what must never be is seen broken, by mischief", async () => {
  const call = await load("unoclp-full.wasm");
  for (const machine of MACHINES) assert.deepEqual(mischief(call, machine, 4000), [], machine);
});
