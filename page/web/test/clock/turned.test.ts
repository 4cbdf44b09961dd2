// Whoever waits by the clock of the simulated board waits by its speed of now, not by that of before, and by its own time, not
// by what the page takes it for.

import assert from "node:assert/strict";
import { mock, test } from "node:test";
import type { Event } from "unoclp-uno";
import type { Line } from "../../src/line/line";
import type { BoardWorker } from "../../src/line/simulated";
import type { Tools } from "../../src/tools/tools";

// The place of a tab listens to its window.
Object.assign(globalThis, { addEventListener: () => undefined });

test("a wait goes on at the speed to which a board has come meanwhile, and is over when the board says so", async () => {
  mock.timers.enable({ apis: ["setTimeout"] });
  let real = 0;
  mock.method(performance, "now", () => real);
  const pass = (ms: number): void => {
    real += ms;
    mock.timers.tick(ms);
  };
  const { SimulatedBoard } = await import("../../src/page/simulated");
  const { Conversation } = await import("../../src/page/conversation");

  let tell = (_: Event): void => undefined;
  /** The time of the board, when it is asked. */
  let at = 0;
  const worker: BoardWorker = {
    postMessage: ({ kind }) => void (kind === "time" && tell({ kind: "time", at })),
    addEventListener: (_, hear) => {
      tell = (event) => hear({ data: event });
    },
  };
  const board = new SimulatedBoard(worker, () => undefined);
  board.tell({ kind: "run" });
  tell({ kind: "power", on: true });

  /** Tools that want 1000 ms of the board's time to pass between steps. */
  const steps: number[] = [];
  const ask = (what: string, request: { now: number }): unknown => {
    if (what === "step") steps.push(request.now);
    return what === "step" ? { rate: 115_200, parity: 0, reset: false, send: [], until: (steps.length > 1 ? 9e9 : 0) + 1000, news: [] } : 1;
  };
  const line = { open: async () => undefined, write: async () => undefined, reset: async () => undefined, close: async () => undefined } satisfies Line;
  const nothing = (): void => undefined;
  tell({ kind: "pace", at: 0, factor: 0.1, asked: 1 });
  const talk = await Conversation.open({ ask } as unknown as Tools, { of: null, reset: false }, line, { baud: 115_200, parity: "none" },
    board, { news: nothing, bytes: nothing, lost: nothing, cause: () => "", died: nothing });
  assert.equal(steps.length, 1);
  // At a tenth of real time it would be 10 s; after one of them the board goes at full speed.
  pass(1000);
  tell({ kind: "pace", at: 100, factor: 1, asked: 1 });
  pass(899);
  assert.equal(steps.length, 1);
  // The page takes it for 1000; the board has come to 700 only, and an answer may still be on its way.
  at = 700;
  pass(1);
  await Promise.resolve();
  assert.deepEqual(steps.slice(1), [700]);
  // And nobody waits by it any more once the conversation is over.
  await talk.close();
  assert.equal(board.turned.size, 0);
  mock.timers.reset();
  mock.restoreAll();
});
