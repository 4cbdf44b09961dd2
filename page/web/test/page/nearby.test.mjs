// What a newcomer needs to draw stands on the sheet itself; and the buttons of the board are of the kinds that a program says.
// @ts-check

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, choose, clean, keptText, lamp, pick, run, state, type } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

test("a student's first program runs after a few clicks", async () => {
  const context = await lab.browser.newContext({ serviceWorkers: "block", viewport: { width: 1366, height: 768 } });
  const page = await context.newPage();
  await page.goto(lab.server.url);
  let clicks = 0;
  const click = async (/** @type {string} */ what) => {
    clicks += 1;
    await page.click(what);
  };
  const write = async (/** @type {string} */ point) => {
    await page.locator("#field-point:focus").waitFor();
    await page.keyboard.type(point);
    await page.keyboard.press("Enter");
    await page.locator(".at-element").waitFor({ state: "detached" });
  };
  await state(page, "RUN");
  await click("#door-draw");
  await page.locator("#draw-hint").waitFor();
  await click('.palette [data-what="contact"]');
  await write("I1 push");
  await click('.palette [data-what="coil"]');
  await write("Q2 horn");
  await page.locator("#problem-count.good").waitFor();
  await click("#run");
  await page.locator(".place .name", { hasText: "horn" }).waitFor();
  await holding(page, 1, () => lamp(page, 2, true));
  assert.ok(clicks <= 8, String(clicks));
  assert.equal(await page.locator("#draw-hint").count(), 0);
  await context.close();
});

test("a rung, a branch, and the end of an element are at hand on the sheet", async () => {
  const page = await lab.still();
  await page.click("#view-draw");
  await page.locator('#sheet .element[data-point="I2"]').waitFor();
  assert.equal(await page.locator("#sheet .rung").count(), 1);
  await page.click("#rung-add");
  await page.locator("#sheet .rung").nth(1).waitFor();
  await page.locator('#sheet .element[data-point="I2"] .area').first().click();
  await page.locator("#at-branch").waitFor();
  await clean(page, "at the selected element");
  await page.click("#at-delete");
  await page.locator('#sheet .element[data-point="I2"]').waitFor({ state: "detached" });
  await page.click("#draw-undo");
  await page.locator('#sheet .element[data-point="I2"]').waitFor();
  // Its form opens from there too, offers what has a name, and fewer of it as one types.
  await page.locator('#sheet .element[data-point="I2"] .area').first().click();
  await page.click("#at-edit");
  assert.equal(await page.locator("[data-chip]").count(), 3);
  await page.fill("#field-point", "mo");
  await page.locator("[data-chip]").nth(1).waitFor({ state: "detached" });
  await page.click('[data-chip="motor"]');
  await page.keyboard.press("Enter");
  await page.locator('#sheet .element[data-point="I2"]').waitFor({ state: "detached" });
  assert.match(await keptText(page), /ANDN +motor/);
  await page.context().close();
});

test("a program's comment says of which kind its buttons are, and a hand may change them", async () => {
  const page = await lab.open();
  await choose(page, "kinds.il", Buffer.from("(* buttons: I2 NC, I3 switch *)\nLD I2\nST Q2\nLD I3\nST Q3\n"));
  await page.locator('.kind[data-kind="switch"]').waitFor();
  const kind = (/** @type {number} */ input) => page.locator(`.place:has([data-input="${input}"]) .kind`).getAttribute("data-kind");
  assert.deepEqual([await kind(1), await kind(2), await kind(3)], ["no", "nc", "switch"]);
  await run(page);
  await lamp(page, 2, true);
  await holding(page, 2, () => lamp(page, 2, false));
  // A switch stays where it is put.
  await page.click('[data-input="3"]');
  await lamp(page, 3, true);
  await page.click('[data-input="3"]');
  await lamp(page, 3, false);
  await page.click("#kinds");
  await page.selectOption('[data-contact="3"]', "latch");
  await lamp(page, 3, true);
  await clean(page, "kinds of buttons");
  await page.reload();
  await page.locator('.kind[data-kind="latch"]').waitFor();
  await page.context().close();
});

test("a store that is full loses nothing that is typed, and says what to do", async () => {
  const page = await lab.still();
  await page.evaluate(() => {
    let size = 1 << 20;
    while (size > 64) {
      try {
        localStorage.setItem(`fill/${Math.random()}`, "x".repeat(size));
      } catch {
        size >>= 1;
      }
    }
  });
  await type(page, `(* ${"long ".repeat(200)} *)\nLD I1\nST Q3\n`, "mine.il");
  const note = page.locator("#notes", { hasText: "storage is full" });
  await note.waitFor();
  assert.match((await page.textContent(".cm-content")) ?? "", /ST Q3/);
  // There is room again: it is kept again.
  await page.evaluate(() => {
    for (const key of Object.keys(localStorage)) if (key.startsWith("fill/")) localStorage.removeItem(key);
  });
  await type(page, "LD I2\nST Q2\n");
  await page.waitForFunction(() => Object.values(localStorage).some((text) => text.includes("ST Q2")));
  await pick(page, "#programs");
  await page.locator('[data-program="mine.il"]').waitFor();
  await page.context().close();
});
