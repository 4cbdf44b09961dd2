// The screens of a site in a real Chromium: boards, alarms, trends, panels and the record, of a gateway that is made up.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, clean, pictures } from "./harness.mjs";
import { answer, gateway } from "./site.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** A page at a screen of a site. @param {ReturnType<typeof gateway>} of @param {string} screen
 * @param {import("playwright-core").BrowserContextOptions} options */
async function open(of, screen = "", options = {}) {
  const context = await lab.browser.newContext({ viewport: { width: 1366, height: 768 }, locale: "en-US", serviceWorkers: "block", ...options });
  const page = await context.newPage();
  page.on("pageerror", (error) => lab.errors.push(String(error.stack)));
  page.on("console", (message) => {
    if (message.type() === "error" && !/40[0-9]|ERR_FAILED/.test(message.text())) lab.errors.push(message.text());
  });
  await answer(page, of);
  await page.goto(`${lab.server.url}site.html${screen}`);
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  return page;
}

const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** Nothing stands beside the screen of a phone. @param {import("playwright-core").Page} page */
async function fits(page) {
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
}

test("all boards are seen with what they do, their faults and alarms", async () => {
  const of = gateway();
  const page = await open(of);
  await page.locator("#boards-up", { hasText: "Boards that answer: 2 of 3" }).waitFor();
  const card = (/** @type {string} */ name) => page.locator(`[data-board="${name}"]`);
  assert.equal(await card("estufa").locator(".status").textContent(), "RUN");
  assert.equal(await card("forno").locator(".status").textContent(), "FAULT 51");
  assert.equal(await card("bomba").locator(".status").textContent(), "No answer");
  await card("bomba").getByText("no such port").waitFor();
  await card("estufa").getByText("Forced").waitFor();
  await card("estufa").getByText("high: the greenhouse is too hot").waitFor();
  // What changes is seen.
  Object.assign(of.boards[2] ?? {}, { up: true, doing: "STOP", why: undefined, points: { Q1: 1 } });
  await card("bomba").locator(".status", { hasText: "STOP" }).waitFor();
  assert.equal(await card("forno").getByRole("link", { name: "Program and ladder: forno" }).getAttribute("href"), "./#board/forno");
  await page.fill("#find-board", "FOR");
  await card("estufa").waitFor({ state: "detached" });
  await page.fill("#find-board", "x");
  await page.getByText("No board name contains this text.").waitFor();
  await page.fill("#find-board", "");
  await clean(page, "boards");
  await page.screenshot({ path: join(pictures, "site-boards.png") });
  await page.selectOption("#speak", "pt");
  await page.locator("#boards-up", { hasText: "Placas que respondem: 3 de 3" }).waitFor();
  await card("estufa").getByText("alta: a estufa está quente demais").waitFor();
  await page.context().close();
});

test("an alarm is acknowledged, and what became of it is listed", async () => {
  const of = gateway();
  const page = await open(of, "#alarms");
  await page.locator("#to-alarms .count", { hasText: "1" }).waitFor();
  const row = page.locator("tr", { hasText: "hot" }).first();
  await row.getByText("Active").waitFor();
  await clean(page, "alarms");
  await page.screenshot({ path: join(pictures, "site-alarms.png") });
  await page.getByRole("button", { name: "Acknowledge hot" }).click();
  await row.getByText("Acknowledged").waitFor();
  await page.locator("#to-alarms .count").waitFor({ state: "detached" });
  await page.locator("#of-alarms table").last().locator("tr", { hasText: "ana" }).getByText("acknowledged").waitFor();
  // Who only watches has no button.
  of.who.may = "watch";
  Object.assign(of.alarms[0] ?? {}, { state: "active" });
  await page.reload();
  await row.getByText("Active").waitFor();
  assert.equal(await page.locator("[data-alarm]").count(), 0);
  await page.context().close();
});

test("trends are drawn over minutes and months, and read at a cursor", async () => {
  const page = await open(gateway(), "#trends/estufa.temperature");
  await page.locator(".chart canvas").waitFor();
  await page.locator('[data-point="estufa.target"]').check();
  const rows = page.locator("#of-trends tbody tr");
  await rows.nth(1).waitFor();
  // To the left of the middle the cursor tells a value of each.
  const over = page.locator(".u-over");
  const box = await over.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 3, box.y + box.height / 2);
  await page.locator("#of-trends th", { hasText: ":" }).first().waitFor();
  assert.match((await rows.first().locator("td").nth(1).textContent()) ?? "", /^\d/);
  await clean(page, "trends");
  await page.screenshot({ path: join(pictures, "site-trends.png") });
  const asked = page.waitForRequest((request) => {
    const query = new URL(request.url()).searchParams;
    return Number(query.get("to")) - Number(query.get("from")) === 30 * 86_400_000;
  });
  await page.selectOption("#trend-span", { label: "30 days" });
  const query = new URL((await asked).url()).searchParams;
  // A row for each part of the screen, however long the time is.
  assert.equal(query.get("step"), `${(30 * 86_400_000) / 600}ms`);
  await page.click("#trend-earlier");
  assert.equal(await page.getAttribute("#trend-now", "aria-pressed"), "false");
  await page.click("#trend-now");
  assert.equal(await page.getAttribute("#trend-now", "aria-pressed"), "true");
  await page.context().close();
});

test("a panel shows what points are, and sets what it may", async () => {
  const of = gateway();
  const page = await open(of, "#panels/estufa");
  const item = (/** @type {string} */ show) => page.locator(`.item[data-show="${show}"]`);
  await item("lamp").locator('.lamp[data-on="true"]').waitFor();
  await item("value").getByText("21.5 °C").waitFor();
  await item("trend").locator("canvas").waitFor();
  // The drawing moves, and has nothing that runs or loads.
  const height = () => page.locator(".panel-drawing #tank").getAttribute("height");
  assert.equal(await height(), "20");
  await page.locator(".panel-drawing #fan.lit").waitFor();
  assert.equal(await page.locator(".panel-drawing #number").textContent(), "25");
  assert.equal(await page.locator(".panel-drawing :is(script, foreignObject, image, a, #linked)").count(), 0);
  assert.equal(await page.evaluate(() => "broken" in window), false);
  await clean(page, "panel");
  await page.screenshot({ path: join(pictures, "site-panel.png"), fullPage: true });
  await page.getByRole("switch", { name: "Heater" }).click();
  await page.locator('[role="switch"][aria-checked="true"]').waitFor();
  const set = item("set").locator("input");
  await set.fill("41");
  await set.press("Enter");
  await page.getByText("Enter a number from 5 to 40.").first().waitFor();
  await set.fill("30,5");
  await set.press("Enter");
  await item("set").getByText("30.5 °C").waitFor();
  const push = page.getByRole("button", { name: "Start" });
  await push.hover();
  await page.mouse.down();
  await page.locator('.push[data-on="true"]').waitFor();
  await page.mouse.up();
  await page.locator('.push[data-on="false"]').waitFor();
  await push.focus();
  await page.keyboard.down("Enter");
  await page.locator('.push[data-on="true"]').waitFor();
  await page.keyboard.up("Enter");
  await page.locator('.push[data-on="false"]').waitFor();
  const told = of.written.map(({ point, value }) => [point, value]);
  assert.deepEqual(told, [["heater", 1], ["target", 30.5], ["start", 1], ["start", 0], ["start", 1], ["start", 0]]);
  // A board that is away shows no old value as if it were one.
  Object.assign(of.boards[0] ?? {}, { up: false });
  await item("value").getByText("not known").waitFor();
  of.who.may = "watch";
  await page.reload();
  await page.locator(".push:disabled").waitFor();
  await page.context().close();
});

test("a panel is edited and saved as a file", async () => {
  const of = gateway();
  const page = await open(of, "#panels/forno");
  await page.getByText("made from the board's names").waitFor();
  await page.click("#panel-edit");
  await page.selectOption("#edit-point", { label: "estufa.target" });
  await page.click("#edit-add");
  const rows = page.locator(".edit-items li");
  await rows.nth(2).waitFor();
  await rows.nth(2).getByLabel("Show as").selectOption("set");
  await rows.nth(2).getByLabel("Label (English)").fill('The "target"');
  await rows.nth(2).getByLabel("Label (Portuguese)").fill("O alvo");
  await rows.nth(2).getByLabel("Maximum").fill("40,5");
  await page.keyboard.press("Tab");
  await page.getByRole("button", { name: "Remove Q1" }).click();
  await page.getByRole("button", { name: /Move The "target" up/ }).click();
  await page.locator(".edit-preview .item").first().getByText('The "target"').waitFor();
  await clean(page, "editor");
  await page.screenshot({ path: join(pictures, "site-edit.png"), fullPage: true });
  const saved = page.waitForEvent("download");
  await page.click("#edit-save");
  const file = await saved;
  assert.equal(file.suggestedFilename(), "forno.panel.toml");
  const expected = `title = "forno"\ncolumns = 4\n
[[item]]\nshow = "set"\npoint = "estufa.target"\nlabel = { en = "The \\"target\\"", pt = "O alvo" }\nleast = 0\nmost = 40.5\nsize = [1, 1]\n
[[item]]\nshow = "value"\npoint = "forno.A0"\nlabel = "A0"\nleast = 0\nmost = 100\nsize = [1, 1]\n`;
  assert.equal(readFileSync(await file.path(), "utf8"), expected);
  await page.click("#edit-back");
  await page.locator("#panel-edit").waitFor();
  await page.context().close();
});

test("the record says who did what, and is saved", async () => {
  const page = await open(gateway(), "#deeds");
  const first = page.locator("#of-deeds tbody tr").first();
  await first.getByText("target = 25").waitFor();
  assert.match((await first.textContent()) ?? "", /ana.*write/);
  await clean(page, "record");
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as CSV" }).click();
  assert.equal((await saved).suggestedFilename(), "deeds.csv");
  await page.context().close();
});

test("a token is asked for once, and told when it is wrong", async () => {
  const of = gateway();
  const context = await lab.browser.newContext({ viewport: { width: 1366, height: 768 }, locale: "pt-BR", serviceWorkers: "block" });
  const page = await context.newPage();
  await answer(page, of, "ana.secret");
  await page.goto(`${lab.server.url}site.html`);
  await page.fill("#token", "ana.wrong");
  await page.keyboard.press("Enter");
  await page.getByText("Este token não é válido.").waitFor();
  await clean(page, "sign in");
  await page.fill("#token", "ana.secret");
  await page.keyboard.press("Enter");
  await page.locator('[data-board="estufa"]').waitFor();
  await page.locator("#who", { hasText: "ana: opera" }).waitFor();
  // The way to a board takes it along, where no server sees it.
  assert.equal(await page.locator('[data-board="forno"] a').last().getAttribute("href"), "./#board/forno=ana.secret");
  await page.reload();
  await page.locator('[data-board="estufa"]').waitFor();
  await page.click("#sign-out");
  await page.locator("#token").waitFor();
  await page.goto("about:blank");
  await page.goto(`${lab.server.url}site.html#key=ana.secret`);
  await page.locator('[data-board="estufa"]').waitFor();
  assert.equal(new URL(page.url()).hash, "");
  await context.close();
});

test("what is lost is said, and comes back", async () => {
  const page = await open(gateway());
  await page.locator('[data-board="estufa"]').waitFor();
  const lost = page.getByText("The gateway does not answer. These values may be old.");
  await page.route("**/api/boards", (route) => route.abort());
  await lost.waitFor();
  await page.unroute("**/api/boards");
  await lost.waitFor({ state: "hidden" });
  await page.context().close();
});

test("a phone has all of it", async () => {
  const page = await open(gateway(), "", phone);
  for (const [name, seen] of [["boards", '[data-board="estufa"]'], ["alarms", "[data-alarm]"], ["trends", ".chart canvas"], ["panels", ".item"], ["deeds", "#of-deeds tbody tr"]]) {
    await page.locator(`#to-${name}`).click();
    await page.locator(seen ?? "").first().waitFor();
    await fits(page);
    await clean(page, `${name} on a phone`);
    await page.screenshot({ path: join(pictures, `site-${name}-phone.png`) });
  }
  await page.context().close();
});
