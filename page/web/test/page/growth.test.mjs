// A page that stays open: a live program on the simulated board, with simulated time as fast as it goes. `cargo xtask soak`
// lets it run for ten minutes of that time, by UNOCLP_PAGE_SECONDS.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, run, type } from "./harness.mjs";

const SECONDS = Number(process.env["UNOCLP_PAGE_SECONDS"] ?? 60);

/** Lamps blink, a timer runs and a register counts in each scan: everything that is drawn or noted moves. */
const BLINK = `LDN T1.Q
TON T1, 150
LD T1.Q
XOR Q1
ST Q1
LD MW1
ADD 1
ST MW1
LD IW0
ST MW2
`;

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Runs in the page, before all else: lets the board's worker go as fast as it can, and knows its time and the memory of Rust. */
function witness() {
  /** @type {any} */
  const ends = globalThis;
  ends.simulated = 0;
  ends.rust = [];
  ends.fast = () => undefined;
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (/** @type {any} */ command, /** @type {any} */ ...more) {
    if (command?.kind === "plug") {
      ends.fast = () => post.call(this, { kind: "speed", factor: Infinity });
      this.addEventListener("message", ({ data }) => {
        if (data.kind === "pace") ends.simulated = data.at;
      });
    }
    return post.call(this, command, ...more);
  };
  const { instantiate } = WebAssembly;
  WebAssembly.instantiate = /** @type {any} */ (async (/** @type {any} */ module, /** @type {any} */ imports) => {
    const instance = await instantiate(module, imports);
    ends.rust.push(/** @type {any} */ (instance).exports?.memory);
    return instance;
  });
}

/** What is kept, in bytes: by the page, by the board's worker, and what Rust has. Code that V8 has compiled does not count: it
 * compiles again and better what runs often, for minutes. @param {import("playwright-core").Page} page */
async function memory(page) {
  const here = await page.context().newCDPSession(page);
  const worker = await new Promise((found) => {
    here.on("Target.attachedToTarget", ({ sessionId, targetInfo }) => targetInfo.url.endsWith("board.js") && found(sessionId));
    void here.send("Target.setAutoAttach", { autoAttach: true, waitForDebuggerOnStart: false, flatten: false });
  });
  /** @type {Record<"page" | "board", string[]>} */
  const chunks = { page: [], board: [] };
  here.on("HeapProfiler.addHeapSnapshotChunk", ({ chunk }) => chunks.page.push(chunk));
  await here.send("HeapProfiler.takeHeapSnapshot");
  await new Promise((answered) => {
    here.on("Target.receivedMessageFromTarget", ({ sessionId, message }) => {
      const told = JSON.parse(message);
      if (sessionId !== worker) return;
      if (told.method === "HeapProfiler.addHeapSnapshotChunk") chunks.board.push(told.params.chunk);
      if (told.id === 1) answered(undefined);
    });
    const message = JSON.stringify({ id: 1, method: "HeapProfiler.takeHeapSnapshot", params: {} });
    void here.send("Target.sendMessageToTarget", { sessionId: worker, message });
  });
  await here.detach();
  const rust = await page.evaluate("rust.reduce((sum, memory) => sum + (memory?.buffer.byteLength ?? 0), 0)");
  return { page: kept(chunks.page), board: kept(chunks.board), rust: Number(rust) };
}

/** The bytes of all nodes of a snapshot but compiled code. A snapshot begins with a collection. @param {string[]} chunks */
function kept(chunks) {
  const { snapshot, nodes } = JSON.parse(chunks.join(""));
  const { node_fields, node_types } = snapshot.meta;
  const [kind, size] = [node_fields.indexOf("type"), node_fields.indexOf("self_size")];
  const code = node_types[kind].indexOf("code");
  let bytes = 0;
  for (let node = 0; node < nodes.length; node += node_fields.length) {
    if (nodes[node + kind] !== code) bytes += nodes[node + size];
  }
  return bytes;
}

test(`a page that is open for ${SECONDS} s with a live program does not grow`, async () => {
  const page = await lab.open();
  await page.addInitScript(witness);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
  await type(page, BLINK, "blink.il");
  await run(page);
  await page.locator(".ladder.live").waitFor();
  await page.evaluate("fast()");
  const until = async (/** @type {number} */ ms) => page.waitForFunction(`simulated >= ${ms}`, undefined, { timeout: 0 });
  const from = Number(await page.evaluate("simulated"));
  // What a page builds once is built in the first tenth.
  await until(from + SECONDS * 100);
  const before = await memory(page);
  await until(from + SECONDS * 1000);
  const after = await memory(page);
  console.log(`${SECONDS} s, bytes kept: ${JSON.stringify(before)}, then ${JSON.stringify(after)}`);
  for (const where of /** @type {const} */ (["page", "board", "rust"])) {
    assert.ok(before[where] > 0, where);
    assert.ok(after[where] <= before[where] * 1.05, `${where}: ${before[where]} bytes have become ${after[where]}`);
  }
  await page.context().close();
});
