// The firmware through the page: the real boot loaders on simavr, behind the pseudo-terminal of `unoclp-uno-sim serve`.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, PATIENCE, lamp, pick, run, select, still, type, unfold } from "./harness.mjs";
import { Cable } from "./port.mjs";
import { Served } from "./served.mjs";

/** A firmware of a few pages that does nothing: it is written in a moment. @param {string} name */
const small = (name) => readFileSync(new URL(`../../../../proof/uno-sim/tests/data/${name}`, import.meta.url), "utf8");
const SMALL = small("loop.hex");
const SMALL_MEGA = small("loop-mega.hex");

/** STK500: a page follows, which is written. */
const WRITE_PAGE = 0x64;

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** A page at a board out of its box; a small firmware stands for that of each board, if so.
 * @param {string} bootLoader @param {boolean} isSmall */
async function boxed(bootLoader, isSmall) {
  const board = await Served.begin("--boot-loader", bootLoader);
  const page = await lab.open();
  const cable = await Cable.between(page, board);
  // The board at the port is in a hurry: the page's own one stands.
  await still(page);
  // The simulated board has taken its own before.
  if (isSmall) {
    await page.route(/unoclp(-nano)?\.hex$/, (route) => route.fulfill({ body: SMALL }));
    await page.route(/unoclp-mega\.hex$/, (route) => route.fulfill({ body: SMALL_MEGA }));
  }
  await pick(page, "#connect");
  await unfold(page, "#put-firmware");
  await page.locator("#put-firmware").waitFor();
  const end = async () => {
    await page.context().close();
    await board.end();
  };
  return { page, cable, end };
}

/** @param {import("playwright-core").Page} page @param {string | RegExp} text */
async function noted(page, text) {
  const note = page.locator("#notes div", { hasText: text }).last();
  await note.waitFor();
  const said = (await note.textContent()) ?? "";
  await note.getByRole("button").last().click();
  return said;
}

/** Puts the firmware on the board, and waits for a note. A busy computer may miss the second in which a boot loader waits for
 * the next page, which is told as FW-24: then one tries again.
 * @param {import("playwright-core").Page} page @param {RegExp} words @param {() => Promise<void>} [ready] before each try */
async function puts(page, words, ready) {
  let said = "";
  for (const until = Date.now() + PATIENCE; !words.test(said) && Date.now() < until;) {
    await ready?.();
    await pick(page, "#put-firmware");
    said = await noted(page, new RegExp(`FW-|${words.source}`));
  }
  assert.match(said, words);
  return said;
}

test("a board out of its box gets the firmware, runs a program live, and comes back where it was unplugged", async () => {
  const { page, cable, end } = await boxed("optiboot", false);
  const share = page.locator("#desk-about", { hasText: /^Writing the firmware: [1-9]\d? %$/ }).waitFor();
  await puts(page, /The firmware was written and verified\./);
  await share;
  await page.locator("#desk-about", { hasText: "Connected: unoclp UNO" }).waitFor();
  await run(page);
  await holding(page, 1, async () => {
    await page.locator('[data-output="1"][data-on="true"]').waitFor();
    await page.locator('.ladder.live .element.on[data-point="Q1"]').first().waitFor();
  });

  await type(page, "LD I1\nST Q3\n");
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  // A block of the upload is on its way.
  let bytes = 0;
  cable.fate = (way, byte) => {
    if (way === "to the board" && (bytes += 1) === 60) void cable.pull();
    return cable.isIn ? byte : null;
  };
  await page.click("#run");
  const lost = page.locator("#notes div", { hasText: "The connection to the board is lost" });
  await lost.waitFor();
  cable.plugIn();
  await lost.getByRole("button", { name: "Connect" }).click();
  await page.locator("#desk-about", { hasText: "Connected: unoclp UNO" }).waitFor();
  await run(page);
  await page.locator('.ladder.live .element[data-point="Q3"]').first().waitFor();
  await end();
});

test("a Mega out of its box gets its firmware, and runs a program with its far points", async () => {
  const { page, end } = await boxed("mega", false);
  await select(page, "#model", "mega");
  await puts(page, /The firmware was written and verified\./);
  await page.locator("#desk-about", { hasText: "Connected: unoclp Mega" }).waitFor();
  await select(page, "#for-board", "mega");
  await type(page, "LD I24\nST Q16\n");
  await page.locator("#problem-count.good").waitFor();
  await run(page);
  await lamp(page, 16, false);
  await holding(page, 24, () => lamp(page, 16, true));
  await lamp(page, 16, false);
  await end();
});

test("what goes wrong on the way is told with what to do, and the next try works", async () => {
  const { page, cable, end } = await boxed("optiboot", true);
  // From the byte on that stands first, counted from the first page that is written: a busy computer asks more often before.
  // To the page four pages are answered by four bytes each; then they are read back.
  /** @type {[number, "to the board" | "to the page", (byte: number) => number | null, RegExp, RegExp][]} */
  const troubles = [
    [200, "to the board", () => null, /FW-24: .*check the cable and try again.*no firmware now/, /FW-24: .*tente de novo.*sem firmware/],
    [40, "to the page", (byte) => byte ^ 0x10, /FW-25: .*then try again/, /FW-25: .*tente de novo/],
    [200, "to the board", () => (void cable.pull(), null), /FW-27: .*plug the board in again/, /FW-27: .*reconecte a placa e tente de novo/],
  ];
  for (const [from, where, what, english, portuguese] of troubles) {
    for (const [speak, words, closed, done] of /** @type {const} */ ([
      ["en", english, "The connection to the board is lost", /written and verified/],
      ["pt", portuguese, "A conexão com a placa caiu", /gravado e conferido/],
    ])) {
      await select(page, "#speak", speak);
      const isIn = async () => {
        if (!cable.isIn) await noted(page, closed);
        cable.plugIn();
        if ((await page.locator("#connect [data-say=disconnect]").count()) === 0) await pick(page, "#connect");
      };
      await puts(page, words, async () => {
        await isIn();
        let left = from;
        let writes = false;
        cable.fate = (way, byte) => {
          writes ||= way === "to the board" && byte === WRITE_PAGE;
          return writes && way === where && left-- <= 0 ? what(byte) : byte;
        };
      });
      await puts(page, done, isIn);
    }
  }
  await end();
});

test("a Nano of before 2018 is another choice, which the page names where the first does not answer", async () => {
  const { page, end } = await boxed("old", true);
  await pick(page, "#put-firmware");
  assert.match(await noted(page, "FW-2"), /FW-2[12]: .*nano-old/);
  await page.locator("#put-firmware:enabled").waitFor({ state: "attached" });
  await select(page, "#model", "nano-old");
  await puts(page, /written and verified/);
  // What was written does not speak.
  await page.locator("#desk-about", { hasNotText: "%" }).waitFor({ state: "attached" });
  await end();
});

for (const { box, own, other, signature } of [
  { box: "mega", own: "mega", other: "uno", signature: "1E 98 01" },
  { box: "optiboot", own: "uno", other: "mega", signature: "1E 95 0F" },
]) {
  test(`the firmware for ${other} is refused by the signature of a board of the kind ${own}, and its own goes on`, async () => {
    const { page, end } = await boxed(box, true);
    for (const [speak, runs, kept] of /** @type {const} */ ([
      ["en", "this firmware does not run on that board", "The board still has its old firmware"],
      ["pt", "este firmware não roda nessa placa", "A placa ainda tem o firmware antigo"],
    ])) {
      await select(page, "#speak", speak);
      await select(page, "#model", other);
      const said = await puts(page, /FW-23/);
      for (const part of [signature, runs, kept]) assert.ok(said.includes(part), said);
    }
    await select(page, "#model", own);
    await puts(page, /gravado e conferido/);
    await end();
  });
}
