// What is read of the simulated board is put among what its pins have done: no effect before its cause.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Moments } from "../../src/page/moments";

/** Readings at 100, 150 and 200 ms, and pins in between: when is what has changed in the last of them? */
function moment(...turns: readonly (readonly [number, "input" | "output"])[]): number {
  const moments = new Moments();
  for (const [at, what] of turns.filter(([at]) => at <= 150)) moments.turned(at, what);
  moments.read(100);
  moments.read(150);
  for (const [at, what] of turns.filter(([at]) => at > 150)) moments.turned(at, what);
  return moments.read(200);
}

test("what an input has brought about comes with it", () => {
  assert.equal(moment([170, "input"]), 170);
  assert.equal(moment([120, "input"], [170, "input"]), 170);
});

test("what has brought an output about comes before it", () => {
  assert.equal(moment([180, "output"]), 180);
  assert.equal(moment([180, "output"], [190, "output"]), 180);
  // It may have changed before the reading in between was over.
  assert.equal(moment([140, "output"]), 140);
});

test("between an input and its output", () => {
  assert.equal(moment([170, "input"], [172, "output"]), 170);
  assert.equal(moment([155, "input"], [157, "output"], [170, "input"], [172, "output"]), 170);
});

test("pins told late, in any order, count by their time", () => {
  assert.equal(moment([172, "output"], [170, "input"]), 170);
});

test("a pin that is told after a reading is new, though the reading's time was later", () => {
  const moments = new Moments();
  moments.turned(20, "input");
  for (const at of [100, 150, 160]) moments.read(at);
  moments.turned(149, "output");
  assert.equal(moments.read(170), 149);
  // Once alone.
  for (const at of [180, 190]) moments.read(at);
  assert.equal(moments.read(200), 200);
});

test("without pins it is when it was read", () => {
  assert.equal(moment(), 200);
  assert.equal(moment([20, "input"]), 200);
});
