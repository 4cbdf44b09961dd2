// What is asked of the simulated board, request by request, as it passes from the page to the board's worker.
// @ts-check

/** 200 contacts in 50 rungs, which read inputs and write markers. */
export const CONTACTS = Array.from({ length: 50 }, (_, rung) => `LD I1\nANDN I2\nAND(\nLD I3\nOR I4\n)\nST M${1 + (rung % 64)}\n`).join("\n");

/** Runs in the page, before all else: counts the requests, and the readings that they come to. Each reading ends with the inputs. */
function witness() {
  const INPUTS = 2;
  const counted = { requests: 0, readings: 0 };
  Object.assign(globalThis, { counted });
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (/** @type {any} */ command, /** @type {any} */ ...more) {
    if (command?.kind === "serial") {
      counted.requests += 1;
      if (command.bytes[1] === INPUTS) counted.readings += 1;
    }
    return post.call(this, command, ...more);
  };
}

/** Has a page count from its next load on. @param {import("playwright-core").Page} page */
export async function count(page) {
  await page.addInitScript(witness);
  await page.reload();
  await page.locator("#run:enabled").waitFor();
}

/** What was counted so far. @param {import("playwright-core").Page} page @returns {Promise<{ requests: number, readings: number }>} */
export function counted(page) {
  return page.evaluate("({ ...counted })");
}

/** Waits for so many readings more. @param {import("playwright-core").Page} page @param {number} readings */
export async function more(page, readings) {
  const from = (await counted(page)).readings;
  await page.waitForFunction((until) => /** @type {any} */ (globalThis).counted.readings >= until, from + readings);
}
