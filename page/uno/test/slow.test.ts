// A scan in slow motion: the firmware stands where its engine fetches, and its time with it. That it stands there as the core
// does, for all programs, is shown by `proof/uno-sim/tests/it/slow.rs`.

import assert from "node:assert/strict";
import { test } from "node:test";
import { KINDS, Kind } from "../src/chip/opcodes";
import { type Standing, Slow, hold } from "../src/slow";
import { type Desk, running } from "./desk";
import { ms, newBoard, places, runningBoard } from "./fixture";

/** A desk whose board is held, and where it has stood. */
function held(program: string): { desk: Desk; slow: Slow; stood: Standing[] } {
  const desk = running(program);
  const stood: Standing[] = [];
  const slow = hold(desk.session, places(), (standing) => stood.push(standing));
  assert.ok(slow);
  return { desk, slow, stood };
}

test("element by element through a scan, while time stands", () => {
  const { desk, slow, stood } = held("motor");
  let moved = 0;
  desk.session.wire({ inputs: 0, step: () => ((moved += 1), { closed: 0, analogue: [] }) });
  const steps = slow.seams.map(({ step }) => step);
  for (let at = 0; at <= steps.length; at += 1) {
    slow.go({ to: null, through: false });
    desk.obey({ kind: "run" });
    desk.pass(100);
    const before = moved;
    desk.pass(1000);
    assert.equal(moved, before, "a machine moves while its board stands");
  }
  // The last of them is the end of the code, and then that of the scan.
  assert.deepEqual(stood.map(({ step }) => step), [...steps, null]);
  assert.deepEqual(stood.at(-1)?.left.map(({ from, to }) => [from, to]), steps.slice(1).map((step, index) => [steps[index], step - 1]));
  assert.ok(stood.at(-1)?.left.every(({ value }) => value !== null));
});

test("to here: the engine goes through scans at full speed until it comes there", () => {
  const { desk, slow, stood } = held("motor");
  const [, , third] = slow.seams;
  assert.ok(third);
  slow.go({ to: [third.step], through: true });
  desk.obey({ kind: "run" });
  desk.pass(1000);
  assert.deepEqual(stood.map(({ step }) => step), [third.step]);
  // What it did on the way is known, if not with what value.
  assert.equal(stood[0]?.left.length, 2);
  assert.equal(stood[0]?.left[0]?.value, null);
});

test("to here again and again: what is told is of this scan, and of what comes right before the stop", () => {
  const { desk, slow, stood } = held("motor");
  const last = slow.seams.length - 2;
  assert.ok(last > 5, `${last} seams`);
  for (let scan = 0; scan < 3; scan += 1) {
    slow.go({ to: [slow.seams[last]?.step ?? 0], through: true });
    desk.obey({ kind: "run" });
    desk.pass(1000);
  }
  const told = slow.seams.slice(last - 4, last).map(({ step }) => step);
  assert.deepEqual(stood.map(({ left }) => left.map(({ from }) => from)), [told, told, told]);
  assert.deepEqual(stood.map(({ pushed }) => pushed), [[], [], []]);
});

test("images stand beside pins: a button that is pressed in the middle of a scan is no input of it", () => {
  const { desk, slow, stood } = held("motor");
  slow.go({ to: null, through: false });
  desk.obey({ kind: "run" });
  desk.pass(100);
  desk.obey({ kind: "button", input: 1, closed: true });
  slow.go({ to: null, through: false });
  desk.obey({ kind: "run" });
  desk.pass(100);
  assert.deepEqual([stood[1]?.inputs, stood[1]?.closed], [0, 1]);
});

test("a board that is let go runs on, and no instruction tells of a fetch any more", () => {
  const { desk, slow } = held("motor");
  slow.go({ to: [0], through: true });
  assert.equal(KINDS[0x9409], Kind.FETCH);
  slow.release();
  desk.session.stopper = null;
  assert.equal(KINDS[0x9409], Kind.IJMP);
  desk.obey({ kind: "run" }, { kind: "button", input: 1, closed: true });
  desk.pass(1000);
  assert.equal(desk.session.board?.surroundings.outputs, 1);
});

test("a board without a program has nothing to stop at", () => {
  const { board } = newBoard();
  board.plug(true);
  board.run(ms(2000));
  assert.equal(Slow.of(board, places()), null);
});

test("seams are those of the program that the EEPROM keeps, whatever the engine has done before", () => {
  const { board } = runningBoard("motor");
  const seams = Slow.of(board, places())?.seams;
  board.run(ms(500));
  assert.deepEqual(Slow.of(board, places())?.seams, seams);
  assert.ok(seams?.every(({ step, at }, index) => index === 0 || (step > (seams[index - 1]?.step ?? 0) && at > (seams[index - 1]?.at ?? 0))));
});
