// The room that a chart has, and a body in a project: at three sizes, in both languages, with the timing open. Nothing covers a
// control.
// @ts-check

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, choose, pick, pictures, still } from "./harness.mjs";
import { SIZES } from "./newcomer.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  mkdirSync(pictures, { recursive: true });
  lab = await Lab.begin();
});
after(() => lab.end());

const CHART = readFileSync(new URL("../../../../programs/charts/cylinders.st", import.meta.url));
const FIVE = readFileSync(new URL("five.xml", import.meta.url));

/** At least so many steps of a chart in a project are in view, and a drawing there is so high, px. */
const ROOM = /** @type {const} */ ({ 1366: { steps: 3, high: 160 }, 1920: { steps: 5, high: 400 }, 390: { steps: 2, high: 150 } });

/** The controls that somebody cannot press where they stand, even after scrolling there: they are cut off, or something lies over
 * them. @param {Page} page */
const covered = (page) => page.evaluate(() => {
  const controls = [...document.querySelectorAll("#views :is(button, select, input, textarea)")];
  return controls.filter((one) => one.checkVisibility({ visibilityProperty: true })).filter((one) => {
    one.scrollIntoView({ block: "nearest", inline: "nearest" });
    // A script scrolls what a hand cannot.
    for (let up = one.parentElement; up; up = up.parentElement) {
      const { overflowX, overflowY } = getComputedStyle(up);
      if (overflowX === "hidden") up.scrollLeft = 0;
      if (overflowY === "hidden") up.scrollTop = 0;
    }
    const { left, right, top, bottom } = one.getBoundingClientRect();
    const [x, y] = [(left + right) / 2, (top + bottom) / 2];
    const places = /** @type {[number, number][]} */ ([[x, y], [left + 3, y], [right - 3, y], [x, top + 3], [x, bottom - 3]]);
    return places.some(([x, y]) => !one.contains(document.elementFromPoint(x, y)));
  }).map((one) => one.id || one.outerHTML.slice(0, 80));
});

/** How many steps of the chart are in view as a whole. @param {Page} page */
const stepsInView = (page) => page.evaluate(() => {
  const sheet = document.querySelector("#chart-sheet");
  if (!sheet) return 0;
  sheet.scrollTop = 0;
  const { top, bottom } = sheet.getBoundingClientRect();
  return [...sheet.querySelectorAll("[data-id^=s]")].filter((step) => {
    const box = step.getBoundingClientRect();
    return box.top >= top && box.bottom <= bottom;
  }).length;
});

/** Selects a part of the chart, and waits for its form. @param {Page} page @param {string} id @param {string} field */
async function take(page, id, field) {
  await page.locator(`#chart-sheet [data-id="${id}"]`).click();
  await page.locator(`#chart-sheet .selected[data-id="${id}"]`).waitFor();
  await page.locator(field).waitFor();
}

for (const [width, height] of SIZES) {
  const phone = width < 760;
  for (const locale of ["en-US", "pt-BR"]) {
    const options = { locale, viewport: { width, height }, hasTouch: phone, isMobile: phone };
    /** @param {Page} page @param {string} name */
    const picture = async (page, name) => {
      await page.evaluate(() => document.querySelector("#notes")?.replaceChildren());
      await page.screenshot({ path: join(pictures, `room-${name}-${locale}-${width}.png`) });
    };
    /** Each part's form leaves all else free. @param {Page} page @param {string} name */
    const parts = async (page, name) => {
      for (const [part, id, field] of [["step", "s1", "#chart-name"], ["transition", "t1", "#chart-condition"], ["action", "a1.0", "#chart-body"]]) {
        await take(page, id ?? "", field ?? "");
        await picture(page, `${name}-${part}`);
        assert.deepEqual(await covered(page), [], part);
      }
      const steps = await stepsInView(page);
      assert.ok(steps >= ROOM[width].steps, `${steps} steps`);
    };

    test(`a chart has room beside its ladder and in a project, ${locale}, ${width} × ${height}`, async () => {
      const page = await lab.open(options);
      await still(page);
      await choose(page, "cylinders.st", CHART);
      await page.click("#view-draw");
      await page.locator('#chart-sheet [data-id="s0"]').waitFor();
      await page.locator("#ladder svg").waitFor();
      await parts(page, "chart");
      await pick(page, "#make-project");
      await page.locator('#project-body [data-id="s0"]').waitFor();
      await parts(page, "project");
      await page.context().close();
    });

    test(`a ladder, blocks and texts have room in a project, ${locale}, ${width} × ${height}`, async () => {
      const page = await lab.open(options);
      await still(page);
      await choose(page, "five.xml", FIVE);
      await page.click("#view-draw");
      await page.locator('#project-body[data-unit="main"]').waitFor();
      for (const [unit, id] of [["Latch", "4"], ["Pair", "3"], ["Any", ""], ["Ready", ""]]) {
        await page.click(`#project-tree [data-unit="${unit}"]`);
        await page.locator(`#project-body[data-unit="${unit}"]`).waitFor();
        if (id) {
          await page.click(`#unit-sheet [data-id="${id}"]`);
          await page.locator("#unit-written").waitFor();
        }
        await picture(page, `unit-${unit}`);
        assert.deepEqual(await covered(page), [], unit);
        const high = (await page.locator(id ? "#unit-sheet" : "#unit-text").boundingBox())?.height ?? 0;
        assert.ok(high >= ROOM[width].high, `${unit}: ${high}`);
      }
      await page.context().close();
    });
  }
}

test("variables fold away, and the browser remembers it; on a phone they stand in the place of the body", async () => {
  const page = await lab.still();
  /** @param {Page} page */
  const open = async (page) => {
    await choose(page, "five.xml", FIVE);
    await page.click("#view-draw");
    await page.locator('#project-body[data-unit="main"]').waitFor();
  };
  await open(page);
  const high = async () => (await page.locator("#project-body").boundingBox())?.height ?? 0;
  const both = await high();
  await page.locator("#project-table").waitFor();
  await page.click("#project-variables");
  await page.locator("#project-table").waitFor({ state: "hidden" });
  assert.ok(await high() > both + 50);
  await page.reload();
  await page.locator('#project-body[data-unit="main"]').waitFor();
  await page.locator("#project-variables[aria-expanded=false]").waitFor();
  assert.ok(await page.locator("#project-table").isHidden());
  // Global variables have no body: there is nothing to fold.
  await page.click('#project-tree [data-unit=""]');
  await page.locator("#project-table").waitFor();
  assert.ok(await page.locator("#project-variables").isHidden());
  await page.context().close();
  const phone = await lab.still({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await open(phone);
  assert.ok(await phone.locator("#project-table").isHidden());
  await phone.tap("#project-variables");
  await phone.locator("#project-table").waitFor();
  assert.ok(await phone.locator("#project-body").isHidden());
  assert.deepEqual(await covered(phone), []);
  await phone.tap("#project-variables");
  await phone.locator("#project-body").waitFor();
  await phone.context().close();
});
