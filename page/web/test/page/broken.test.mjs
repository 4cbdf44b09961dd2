// Each of the twenty machines in Chromium: opened from the gallery, solved by its model solution, and each of its rules
// seen broken, by the slip of a programmer or a part that fails.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, findings, has, pick, run, state, turned, type } from "./harness.mjs";

/** @typedef {import("playwright-core").Page} Page */

/** How a rule of a machine breaks: `slip` changes its model solution, from … to …; the machine's own script shows that, or
 * else the machine beside the board, where another rule breaks before (`live`), or a part has to fail (`fails`).
 * @typedef {{ plant: string, breaks: string, slip: [string, string][], live?: boolean, fails?: [string, string] }} Slip */

const plants = new URL("../../../../programs/plants/", import.meta.url);
/** @param {string} name */
const file = (name) => readFileSync(new URL(name, plants), "utf8");
const MACHINES = readdirSync(plants).filter((name) => name.endsWith(".toml")).map((name) => name.replace(".toml", ""));
/** @type {Slip[]} */
const SLIPS = JSON.parse(file("wrong/slips.json"));

/** The program with its slip. @param {Slip} slip */
function slipped({ plant, slip, breaks }) {
  return slip.reduce((text, [from, to]) => {
    assert.ok(text.includes(from), `${plant}, ${breaks}: ${from}`);
    return text.replace(from, () => to);
  }, file(`${plant}.st`));
}

/** What breaks the rules of a machine, by its own script: programs, and the rule that each breaks first. @param {string} plant */
function wrong(plant) {
  const files = readdirSync(new URL("wrong/", plants)).filter((name) => name.endsWith(".st") && name.replace(/-[^-]+$/, "") === plant);
  const typical = files.map((name) => ({ text: file(`wrong/${name}`), breaks: /Breaks: (.*) \*\)/.exec(file(`wrong/${name}`))?.[1] ?? "" }));
  return [...typical, ...SLIPS.filter((slip) => slip.plant === plant && !slip.live && !slip.fails).map((slip) => ({ text: slipped(slip), breaks: slip.breaks }))];
}

const WIRED = /^board = "mega"$/m;
/** The pages that simulate a Mega by now. */
const larger = new WeakSet();

/** Opens a machine from the gallery. @param {Page} page @param {string} plant */
async function open(page, plant) {
  await pick(page, "#machines");
  await page.locator(`#gallery [data-machine="${plant}.toml"]`).click();
  await page.locator("#machine").waitFor();
  // One that is wired to a board with more points offers that, until it is chosen.
  const other = page.locator("#machine-board");
  if (WIRED.test(file(`${plant}.toml`)) && !larger.has(page)) {
    await other.click();
    larger.add(page);
  }
  await other.waitFor({ state: "hidden" });
}

/** @param {Page} page @param {string} rule */
const broken = (page, rule) => page.locator('#machine-rules li[data-state="broken"]', { hasText: rule }).waitFor();

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("each machine is solved by its model solution, and each of its rules is seen broken", async () => {
  assert.equal(MACHINES.length, 20);
  // What takes a while beside the board goes on meanwhile.
  const [slow, ...others] = SLIPS.filter((slip) => slip.live);
  assert.ok(slow && others.length === 0);
  const beside = await lab.open();
  await type(beside, slipped(slow), "slow.st");
  await open(beside, slow.plant);
  await run(beside);
  const slowly = broken(beside, slow.breaks).then(() => beside.context().close());

  // What goes wrong is not played again: that takes a processor while the next is judged.
  const page = await lab.still({ reducedMotion: "reduce" });
  // Nor is each program drawn.
  await page.click("#view-text");
  for (const plant of MACHINES) {
    await open(page, plant);
    const all = wrong(plant);
    const named = new Set([...all, ...SLIPS.filter((slip) => slip.plant === plant)].map(({ breaks }) => breaks));
    // Each rule is broken by one of them. Those of the machine before go away.
    await page.waitForFunction((named) => {
      // What runs from before may have broken one by now.
      const rules = [...document.querySelectorAll("#machine-rules li")].map((rule) => (rule.textContent ?? "").replace(/ – broken after .*$/, ""));
      return rules.sort().join("; ") === named;
    }, [...named].sort().join("; "));
    const judge = async (/** @type {string} */ text) => {
      await type(page, text, `${plant}.st`);
      // The text before had no problems either.
      await has(page, text);
      await page.locator("#problem-count:not(.bad)").waitFor();
      await page.click("#machine-judge");
    };
    await judge(file(`${plant}.st`));
    await page.locator("#machine-judged-verdict.good").waitFor();
    for (const { text, breaks } of all) {
      await judge(text);
      await page.locator("#machine-judged-verdict.bad", { hasText: breaks }).waitFor();
    }
    assert.deepEqual(await findings(page), [], plant);
  }
  await page.context().close();
  await slowly;
});

test("a part that fails breaks a rule that no program breaks first", async () => {
  const page = await lab.open();
  const failing = SLIPS.filter((slip) => slip.fails);
  assert.ok(failing.length > 2);
  for (const { plant, breaks, fails: [part, fault] = ["", ""] } of failing) {
    await open(page, plant);
    await page.locator("#machine details summary").click();
    const box = page.locator(".machine-faults label", { hasText: new RegExp(`^${part}: ${fault}$`, "i") }).locator("input");
    await box.check();
    await broken(page, breaks);
    // It stays until the machine is as it was.
    await page.click("#machine-reset");
    await page.locator('#machine-rules li[data-state="broken"]').first().waitFor({ state: "detached" });
    assert.equal(await box.isChecked(), false);
    await page.locator("#machine details summary").click();
  }
  await page.context().close();
});

test("on a phone the machine stands first on its page, and works by finger", async () => {
  const page = await lab.open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await type(page, file("motor.st"), "motor.st");
  await open(page, "motor");
  await run(page);
  await page.tap("#page-machine");
  await turned(page, "#board");
  const [machine = NaN, pace = NaN] = await page.evaluate(() => ["#machine", "#pace"].map((one) => document.querySelector(one)?.getBoundingClientRect().top ?? NaN));
  assert.ok(machine < pace && machine < 200, `${machine}, ${pace}`);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const start = page.locator('#machine-picture [data-part="start"]');
  // Shorter than a scan, and all the same the contactor closes.
  await start.tap();
  await page.locator('[data-output="1"][data-on="true"]').waitFor({ state: "attached" });
  await state(page, "RUN");
  await page.context().close();
});
