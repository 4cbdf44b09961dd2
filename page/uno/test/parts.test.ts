// Small parts: contacts, lamps, the pace of time, Intel hex.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Agenda } from "../src/agenda";
import { Contacts } from "../src/contacts";
import { ATMEGA2560, ATMEGA328P } from "../src/chip/model";
import { readHex } from "../src/hex";
import { Lamp } from "../src/lamp";
import { Pace } from "../src/pace";
import { firmwareHex, ms } from "./fixture";

/** The moments at which a contact changed, and to what. */
function moved(bouncing: boolean, steps: readonly (readonly [number, boolean])[]): [number, number][] {
  const agenda = new Agenda();
  const seen: [number, number][] = [];
  let now = 0;
  const contacts = new Contacts(agenda, () => seen.push([now, contacts.closed]));
  contacts.bouncing = bouncing;
  for (const [at, pressed] of [...steps, [ms(100), null] as const]) {
    for (; agenda.next <= at; agenda.do(now)) now = agenda.next;
    now = at;
    if (pressed !== null) contacts.press(2, pressed, now);
  }
  return seen;
}

test("a contact closes at once, and opens at once", () => {
  assert.deepEqual(moved(false, [[0, true], [ms(20), false], [ms(30), false]]), [[0, 4], [ms(20), 0]]);
});

test("a contact that bounces opens and closes for up to 6 ms, and then is as it was left", () => {
  const seen = moved(true, [[0, true], [ms(20), false]]);
  const closing = seen.filter(([at]) => at < ms(20));
  const opening = seen.filter(([at]) => at >= ms(20));
  for (const [part, last, since] of [[closing, 4, 0], [opening, 0, ms(20)]] as const) {
    assert.ok(part.length >= 4, `${part.length} bounces`);
    assert.equal(part.at(-1)?.[1], last);
    assert.ok((part.at(-1)?.[0] ?? Infinity) <= since + ms(6));
    // Not just once, and not only to one side.
    assert.ok(part.some(([, closed]) => closed !== last));
  }
});

test("a contact that is let go while it bounces ends open", () => {
  const seen = moved(true, [[0, true], [ms(1), false]]);
  assert.equal(seen.at(-1)?.[1], 0);
  assert.ok((seen.at(-1)?.[0] ?? Infinity) <= ms(7));
});

test("a lamp is as bright as the share of time that it was lit", () => {
  const lamp = new Lamp();
  assert.equal(lamp.take(0), 0);
  lamp.set(1, 100);
  lamp.set(0, 125);
  assert.equal(lamp.take(200), 0.125);
  lamp.set(1, 300);
  assert.equal(lamp.take(400), 0.5);
  assert.equal(lamp.take(500), 1);
  // No time has passed: as it stands.
  assert.equal(lamp.take(500), 1);
  lamp.set(0, 500);
  lamp.flicker(50);
  assert.equal(lamp.take(600), 0.25);
});

test("simulated time follows real time at the factor that is asked for", () => {
  for (const factor of [1, 0.1, 0.01]) {
    const pace = new Pace();
    pace.start(1000, factor);
    let simulated = 0;
    for (let now = 1016; now <= 2000; now += 16) {
      const due = pace.due(now);
      simulated += due;
      pace.pay(due);
    }
    assert.ok(Math.abs(simulated - 992 * factor) < 1e-6, `${factor}: ${simulated}`);
  }
});

test("a simulation that is too slow says how fast it was, and never hurries to catch up for long", () => {
  const pace = new Pace();
  pace.start(0, 1);
  const told = [];
  for (let now = 20; now <= 1000; now += 20) {
    assert.ok(pace.due(now) <= 100);
    // At most 12 ms in 20.
    pace.pay(Math.min(12, pace.due(now)));
    told.push(pace.measure(now));
  }
  const measured = told.filter((one) => one !== null);
  assert.equal(measured.length, 3);
  for (const { factor, asked } of measured) {
    assert.equal(asked, 1);
    assert.ok(Math.abs(factor - 0.6) < 0.01, `${factor}`);
  }
});

test("as fast as it goes has no end", () => {
  const pace = new Pace();
  pace.start(0, Infinity);
  assert.equal(pace.due(1), Infinity);
  pace.pay(500);
  assert.deepEqual(pace.measure(250), { factor: 2, asked: Infinity });
});

const LENGTH = ATMEGA328P.flash;

test("the firmware's hex is read to the byte, and nothing else passes", () => {
  const flash = readHex(firmwareHex(), LENGTH);
  assert.ok(flash);
  // A jump to the start: the first instruction of a program for this chip.
  assert.equal(((flash[0] ?? 0) & 0xfe0e) === 0x940c || ((flash[0] ?? 0) & 0xf000) === 0xc000, true);

  const words = readHex(":0400000001020304F2\r\n:00000001FF\r\n", LENGTH);
  assert.deepEqual([...(words?.subarray(0, 3) ?? [])], [0x0201, 0x0403, 0xffff]);
  const far = readHex(":020000021000EC\n:0100000001FE\n:00000001FF\n", ATMEGA2560.flash);
  assert.equal(far?.[0x8000], 0xff01);
  for (const wrong of [
    "",
    "no hex",
    ":0400000001020304F2\n",
    ":0400000001020304F3\n:00000001FF\n",
    ":0500000001020304F2\n:00000001FF\n",
    ":047FFE000102030475\n:00000001FF\n",
    ":020000021000EC\n:0100000001FE\n:00000001FF\n",
    "x".repeat(1_000_000),
  ]) {
    assert.equal(readHex(wrong, LENGTH), null, wrong.slice(0, 40));
  }
});
