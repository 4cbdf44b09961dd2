// The timing diagram: which channels are seen first, by which names, and what of them is forced. When things have happened is
// in `truth.test.mjs` and in `test/trend/`.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, lamp, pick, run, tab, type } from "./harness.mjs";
import { changesWith, saved } from "./timing.mjs";

/** @typedef {import("playwright-core").Page} Page */
/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** Two inputs and two outputs, a marker with a name, and eight without. */
const MANY = `VAR
  go AT %I1 : BOOL;
  motor AT %Q1 : BOOL;
  asked AT %M1 : BOOL;
END_VAR
LD go
ST asked
ST motor
LD I2
ST Q2
${Array.from({ length: 8 }, (_, marker) => `ST M${marker + 2}`).join("\n")}
`;

test("channels that one sees at the board or knows by name are chosen first, and go by their names in the table", async () => {
  const page = await lab.open();
  await type(page, MANY, "many.il");
  await run(page);
  const chosen = () => page.locator(".channels label").evaluateAll((labels) => labels.filter((label) => label.querySelector("input")?.checked).map((label) => label.textContent));
  await page.locator(".channels label", { hasText: "M9" }).waitFor();
  assert.deepEqual(await chosen(), ["go (I1)", "I2", "motor (Q1)", "Q2", "asked (M1)"]);
  assert.match(await saved(page, "CSV"), /^ms,go I1,I2,motor Q1,Q2,asked M1\n/);
  // What a person chooses stays, whatever runs next.
  await page.locator(".channels label", { hasText: "M9" }).click();
  await page.locator(".channels label", { hasText: "Q2" }).click();
  await type(page, MANY.replace("I2", "I3"), "many.il");
  await run(page);
  await page.locator(".channels label", { hasText: "I3" }).waitFor();
  assert.deepEqual(await chosen(), ["go (I1)", "I3", "motor (Q1)", "asked (M1)", "M9"]);
  await page.context().close();
});

test("a forced input is what it is forced to, and is marked, in the diagram and in its picture", async () => {
  for (const [locale, mark] of /** @type {const} */ ([["en-US", "go (forced)"], ["pt-BR", "go (forçado)"]])) {
    const page = await lab.open({ locale });
    await type(page, MANY, "many.il");
    await run(page);
    await tab(page, "watch");
    await page.locator('tr[data-point="I1"] button').first().click();
    await lamp(page, 1, true);
    await tab(page, "trend");
    await page.locator(".trend canvas").waitFor();
    await changesWith(page, [["go I1", "1"]]);
    await page.click("#trendBefore");
    await page.locator("#trend-reading", { hasText: `${mark} = 1` }).waitFor();
    assert.ok((await saved(page, "SVG")).includes(`>${mark}<`));
    await tab(page, "watch");
    await page.click("#release");
    await page.locator("#panel-watch tr.is-forced").waitFor({ state: "detached" });
    await tab(page, "trend");
    assert.ok(!(await saved(page, "SVG")).includes(mark));
    await page.context().close();
  }
});

test("a press before the diagram is drawn anew goes to a change, and one comes back to it", async () => {
  const page = await lab.open();
  await type(page, MANY, "many.il");
  await run(page);
  for (const _ of [1, 2]) await holding(page, 1, () => lamp(page, 1, true));
  await lamp(page, 1, false);
  await tab(page, "trend");
  await page.locator(".trend canvas").waitFor();
  await pick(page, "#pause");
  await page.locator("#pace", { hasText: "Time is stopped" }).waitFor();
  const reading = page.locator("#trend-reading");
  // The picture is still that of ten seconds.
  await page.evaluate(() => {
    const span = /** @type {HTMLSelectElement} */ (document.querySelector('[aria-label="Seconds shown"]'));
    span.value = "120";
    span.dispatchEvent(new Event("change"));
    /** @type {HTMLElement} */ (document.querySelector("#trendBefore")).click();
  });
  await reading.filter({ hasText: /^[\d.]+ s, go = 0, .*motor = 0/ }).waitFor();
  const last = (await reading.textContent()) ?? "";
  await page.click("#trendBefore");
  await reading.filter({ hasNotText: last }).waitFor();
  await page.click("#trendAfter");
  await reading.filter({ hasText: last }).waitFor();
  // Behind the last change there is none.
  await page.click("#trendAfter");
  assert.equal(await reading.textContent(), last);
  await page.context().close();
});
