// A program that is shown live: how many requests a reading takes.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, run, type } from "./harness.mjs";
import { CONTACTS, count, counted, more } from "./readings.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Outputs, markers, state and inputs; and every third one, a part of what hardly changes. */
const MOST = 4 + 1 / 3;
const READINGS = 90;

test("a reading of a program of 200 contacts takes four requests, and every third one more", async () => {
  const page = await lab.open();
  await count(page);
  await type(page, CONTACTS, "contacts.il");
  await run(page);
  // The first reads everything.
  await more(page, 3);
  const before = await counted(page);
  await more(page, READINGS);
  const after = await counted(page);
  const [requests, readings] = [after.requests - before.requests, after.readings - before.readings];
  assert.ok(requests / readings <= MOST + 0.1, `${requests} requests for ${readings} readings`);
  assert.ok(requests / readings >= 4, `${requests} requests for ${readings} readings`);
});
