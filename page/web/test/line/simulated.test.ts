// The line to the simulated board.

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Event } from "unoclp-uno";
import { running } from "../../../uno/test/desk";
import { answer, request } from "../../../uno/test/modbus";
import { SimulatedLine } from "../../src/line/simulated";

test("a line to the board carries bytes both ways, and a closed one none", async () => {
  const desk = running("motor");
  let hear: (message: { readonly data: Event }) => void = () => {};
  const line = new SimulatedLine({
    postMessage: (command) => desk.obey(command),
    addEventListener: (_, heard) => {
      hear = heard;
    },
  });
  const deliver = (millis: number): void => {
    desk.events = [];
    desk.pass(millis);
    for (const event of desk.events) hear({ data: event });
  };
  const came: number[] = [];
  const closed: string[] = [];
  const listener = { bytes: (bytes: Uint8Array) => came.push(...bytes), closed: (why: string) => closed.push(why) };
  await line.open({ baud: 115_200, parity: "none" }, listener);
  await line.write(request(2, 0, 0, 0, 8));
  deliver(50);
  assert.deepEqual(answer(came), [1, 0]);

  await line.reset();
  deliver(1000);
  assert.match(String.fromCharCode(...came), /RUN\r\n$/);

  await line.close();
  await line.close();
  assert.deepEqual(closed, ["asked"]);
  await assert.rejects(line.write(request(2, 0, 0, 0, 8)));
});
