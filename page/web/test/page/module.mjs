// The modules of Rust that the page loads, called as the page calls them, without a browser.
// @ts-check

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { built } from "../../serve.mjs";

/** A module, and how it is asked: bytes in, text out; and how its machine goes on.
 * @param {string} file */
export async function load(file) {
  const { instance } = await WebAssembly.instantiate(readFileSync(join(built, file)), {});
  const rust = /** @type {any} */ (instance.exports);
  const call = (/** @type {Uint8Array} */ request) => {
    const room = rust.unoclp_room(request.length);
    new Uint8Array(rust.memory.buffer, room, request.length).set(request);
    const length = rust.unoclp_call();
    return new TextDecoder("utf-8", { fatal: true }).decode(new Uint8Array(rust.memory.buffer, rust.unoclp_answer(), length));
  };
  const step = (/** @type {number} */ levels, /** @type {number[]} */ shares, /** @type {number} */ ms) => {
    new Uint8Array(rust.memory.buffer, rust.unoclp_shares() + 1, shares.length).set(shares);
    return /** @type {number} */ (rust.unoclp_step(levels, ms));
  };
  return Object.assign(call, { step });
}

/** @typedef {Awaited<ReturnType<typeof load>>} Call */
/** Asks; the text that something is asked of, `of`, is given first, as the page does. @param {Call} call @param {any} request */
export function ask(call, request) {
  const answer = (/** @type {unknown} */ asked) => JSON.parse(call(new TextEncoder().encode(JSON.stringify(asked))));
  const { of, ...rest } = request;
  return answer(of ? { ...rest, version: answer({ ask: "text", board: rest.board, ...of }).ok } : rest);
}

/** Numbers below a limit, always the same ones (mulberry32). @param {number} seed */
export function random(seed) {
  return (/** @type {number} */ limit) => {
    seed = (seed + 0x6d2b79f5) | 0;
    let mixed = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return Math.floor((((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32) * limit);
  };
}
