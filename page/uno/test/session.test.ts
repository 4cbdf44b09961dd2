// The session: commands in, events out.

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Command } from "../src/messages";
import { Desk, running } from "./desk";
import { firmwareBytes } from "./fixture";
import { answer, request } from "./modbus";

test("a board is plugged in, runs, and tells what is seen", () => {
  const desk = running("motor");
  const kinds = desk.events.map(({ kind }) => kind).filter((kind) => kind !== "pins");
  assert.deepEqual(kinds.slice(0, 3), ["ready", "power", "reset"]);
  desk.events = [];
  desk.obey({ kind: "button", input: 4, closed: true });
  desk.pass(100);
  const shown = desk.of("pins");
  assert.deepEqual(shown.at(-1)?.pins, { outputs: [0, 0, 0, 1], led: 1, closed: 8 });
  const edges = shown.flatMap((event) => event.edges);
  assert.deepEqual(edges.map(({ output, high }) => [output, high]), [[4, true]]);
  const [edge] = edges;
  assert.ok(edge && edge.at > 990 && edge.at < 1020, `${edge?.at}`);
});

test("the speed is what is asked for, and told as it was", () => {
  const desk = running("motor");
  for (const factor of [0.1, 0.01, 1]) {
    desk.obey({ kind: "speed", factor });
    desk.pass(250);
    desk.events = [];
    desk.pass(1000);
    const paces = desk.of("pace");
    assert.ok(paces.length >= 3);
    for (const pace of paces) {
      assert.equal(pace.asked, factor);
      assert.ok(Math.abs(pace.factor / factor - 1) < 0.1, `${pace.factor} of ${factor}`);
    }
  }
});

test("a machine that is too slow is told so", () => {
  const desk = running("motor");
  desk.look = 1;
  desk.pass(500);
  desk.events = [];
  desk.pass(1000);
  const paces = desk.of("pace");
  assert.ok(paces.length >= 3);
  for (const { factor, asked } of paces) assert.ok(asked === 1 && factor > 0.2 && factor < 0.6, `${factor}`);
});

test("a client that asks the board is answered in the same turn, and time goes no faster by it", () => {
  const desk = running("motor");
  desk.pass(250);
  desk.events = [];
  const began = desk.now;
  const first = request(2, 0, 0, 0, 8);
  let last = 0;
  for (let asked = 0; asked < 100; asked += 1) {
    desk.events = desk.of("pace");
    desk.obey({ kind: "serial", bytes: first });
    desk.session.turn();
    const [told] = desk.of("serial");
    assert.ok(told && answer([...told.bytes]), `request ${asked}`);
    // Every 10 ms, which is more than an exchange takes; so nobody is ever ahead by more than one.
    desk.now += 10;
    assert.ok(told.at > last);
    last = told.at;
  }
  const real = desk.now - began;
  assert.ok(Math.abs(real - 1000) < 1);
  const paces = desk.of("pace");
  assert.ok(paces.length >= 3);
  for (const { factor } of paces) assert.ok(Math.abs(factor - 1) < 0.02, `${factor}`);
  // Who asks on and on without a pause waits for real time.
  for (let asked = 0; asked < 20; asked += 1) {
    desk.obey({ kind: "serial", bytes: first });
    desk.session.turn();
  }
  assert.ok(desk.of("serial").every(({ at }) => at < last + 30));
});

test("a client that asks for more than may be simulated ahead is answered soon, and not a whole turn later", () => {
  const desk = running("motor");
  desk.pass(250);
  const wait = (): number => {
    desk.obey({ kind: "serial", bytes: request(2, 0, 0, 0, 8) });
    return desk.session.turn() ?? Infinity;
  };
  desk.events = [];
  assert.ok(wait() > 10);
  assert.equal(desk.of("serial").length, 1);
  // Real time stands, so this is ahead of it.
  let soon = Infinity;
  for (let asked = 0; asked < 4 && soon > 4; asked += 1) soon = wait();
  assert.ok(soon <= 4, `${soon}`);
  // An answer that never comes is not waited for.
  desk.pass(100);
  assert.ok((desk.session.turn() ?? 0) > 10);
});

test("who asks for the time is told that of now, not that of the last turn", () => {
  const desk = running("motor");
  desk.events = [];
  desk.obey({ kind: "time" });
  desk.now += 10;
  desk.obey({ kind: "time" });
  const [before, now] = desk.of("time").map(({ at }) => at);
  assert.ok(before !== undefined && now !== undefined && Math.abs(now - before - 10) < 1, `${before}, ${now}`);
  desk.obey({ kind: "pause" });
  desk.now += 10;
  desk.obey({ kind: "time" });
  assert.ok(Math.abs((desk.of("time").at(-1)?.at ?? 0) - now) < 1);
});

test("time stands while it is paused, and goes on by steps", () => {
  const desk = running("motor");
  desk.obey({ kind: "pause" });
  const stood = desk.of("paused").at(-1)?.at ?? -1;
  assert.ok(stood > 990);
  desk.events = [];
  assert.equal(desk.session.turn(), null);
  desk.obey({ kind: "button", input: 4, closed: true });
  assert.equal(desk.of("pins").at(-1)?.pins.closed, 8);
  desk.obey({ kind: "step", millis: 25 });
  desk.pass(100);
  const [paused] = desk.of("paused");
  assert.ok(paused && Math.abs(paused.at - stood - 25) < 0.1, `${paused?.at} behind ${stood}`);
  assert.ok((desk.of("pins").at(-1)?.pins.outputs[3] ?? 0) > 0.9);
  assert.equal(desk.session.turn(), null);
});

test("what the EEPROM holds is told, and given back to another session", () => {
  const desk = running("memory");
  desk.obey({ kind: "button", input: 1, closed: true });
  desk.pass(300);
  const bytes = desk.of("eeprom").at(-1)?.bytes;
  assert.ok(bytes);

  const next = new Desk();
  next.obey(
    { kind: "firmware", board: "uno", bytes: firmwareBytes() },
    { kind: "eeprom", bytes },
    { kind: "plug", on: true },
    { kind: "run" },
  );
  next.pass(1000);
  assert.match(next.text(), /the program that was stored runs/);
  assert.equal(next.of("pins").at(-1)?.pins.outputs[0], 1);
});

test("a block that the board has written is told", () => {
  const desk = running("motor");
  desk.events = [];
  desk.obey({ kind: "button", input: 4, closed: true });
  desk.pass(2500);
  const blocks = desk.of("card");
  assert.ok(blocks.length >= 1);
  assert.match(new TextDecoder().decode(blocks.at(-1)?.bytes), /^unoclp state[^]*outputs 01-04: . . . 1/);
});

test("the plug is pulled in the middle of a write", () => {
  const desk = running("memory");
  desk.obey({ kind: "plug-at-write", armed: true }, { kind: "button", input: 1, closed: true });
  desk.pass(500);
  assert.deepEqual(desk.of("power").map(({ on }) => on), [true, false]);
  assert.deepEqual(desk.of("pins").at(-1)?.pins.outputs, [0, 0, 0, 0]);
  desk.obey({ kind: "plug", on: true });
  desk.pass(1000);
  assert.deepEqual(desk.of("reset").map(({ cause }) => cause), ["power", "power"]);
  assert.match(desk.text(), /RUN\r\n$/);
});

test("a second firmware keeps what the EEPROM holds", () => {
  const desk = running("memory");
  desk.obey({ kind: "card", image: null }, { kind: "firmware", board: "uno", bytes: firmwareBytes() }, { kind: "plug", on: true });
  desk.events = [];
  desk.pass(1000);
  assert.match(desk.text(), /the program that was stored runs/);
});

test("commands that make no sense are told as trouble, and change nothing", () => {
  const desk = new Desk();
  const troubles: [Command, string][] = [
    [{ kind: "plug", on: true }, "no-firmware"],
    [{ kind: "eeprom", bytes: new Uint8Array(1024) }, "bad-eeprom"],
    [{ kind: "firmware", board: "uno", bytes: new Uint8Array(40_000) }, "bad-firmware"],
    [{ kind: "card", image: new Uint8Array(100) }, "bad-card"],
    [{ kind: "card", image: new Uint8Array(0) }, "bad-card"],
    [{ kind: "speed", factor: 0 }, "bad-value"],
    [{ kind: "speed", factor: NaN }, "bad-value"],
    [{ kind: "step", millis: Infinity }, "bad-value"],
    [{ kind: "button", input: 0, closed: true }, "bad-value"],
    [{ kind: "button", input: 9, closed: true }, "bad-value"],
    [{ kind: "analogue", input: 5, to: "open" }, "bad-value"],
    [{ kind: "analogue", input: 0, to: { millivolts: 5001 } }, "bad-value"],
    [{ kind: "analogue", input: 0, to: { reading: 1024 } }, "bad-value"],
    [{ kind: "line", format: { baud: 1, parity: "none" } }, "bad-value"],
  ];
  for (const [command, trouble] of troubles) {
    desk.events = [];
    desk.obey(command);
    assert.deepEqual(desk.events, [{ kind: "trouble", trouble }], JSON.stringify(command));
  }
  desk.obey({ kind: "firmware", board: "uno", bytes: firmwareBytes() }, { kind: "plug", on: true });
  desk.events = [];
  desk.obey({ kind: "eeprom", bytes: new Uint8Array(1024) });
  assert.deepEqual(desk.of("trouble"), [{ kind: "trouble", trouble: "bad-eeprom" }]);
});

test("a program that does what is not simulated ends with the plug pulled, and with words", () => {
  const desk = new Desk();
  // ldi r16, 1; sts TCCR0A, r16 (a mode that counts up and down); sts TCCR0B, r16; rjmp to itself.
  const words = "01E0" + "0093" + "4400" + "0093" + "4500" + "FFCF";
  const bytes = Uint8Array.from(words.match(/../g) ?? [], (byte) => parseInt(byte, 16));
  desk.obey({ kind: "firmware", board: "uno", bytes }, { kind: "plug", on: true }, { kind: "run" });
  desk.pass(100);
  assert.deepEqual(desk.of("trouble"), [{ kind: "trouble", trouble: "broken" }]);
  assert.deepEqual(desk.of("power").map(({ on }) => on), [true, false]);
  assert.equal(desk.session.turn(), null);
});

test("a machine moves once each simulated millisecond, drives its contacts, and sees what the board does", () => {
  const desk = running("motor");
  const seen: number[] = [];
  desk.session.wire({
    inputs: 0b1000,
    step: (levels, shares) => {
      assert.equal(shares.length, 4);
      seen.push(levels);
      // The overload relay at input 04, from the 100th millisecond on.
      return { closed: seen.length >= 100 ? 0b1111 : 0b0111, analogue: [[4, 512]] };
    },
  });
  desk.events = [];
  desk.pass(1000);
  assert.ok(Math.abs(seen.length - 1000) < 20, `${seen.length}`);
  // Only input 04 is its own; the others are the buttons' still.
  assert.equal(desk.of("pins").at(-1)?.pins.closed, 0b1000);
  assert.equal(seen.at(99), 0);
  assert.equal(seen.at(-1), 0b1000);
  // Without it, its contacts are open.
  desk.session.wire(null);
  desk.pass(100);
  assert.equal(desk.of("pins").at(-1)?.pins.closed, 0);
  assert.ok(Math.abs(seen.length - 1000) < 20);
});
