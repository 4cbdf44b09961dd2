// Files in and out: whatever is opened, nothing that was there is lost.
// @ts-check

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { holding } from "./hands.mjs";
import { Lab, choose, lamp, pick, run } from "./harness.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** What a click downloads. @param {import("playwright-core").Page} page @param {() => Promise<void>} click */
async function downloaded(page, click) {
  const download = page.waitForEvent("download");
  await click();
  const file = await download;
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

test("a file is opened in its language and encoding", async () => {
  const page = await lab.still();
  await choose(page, "latin.il", Buffer.from("(* memória *)\nLD I1\nST Q3\n", "latin1"));
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  assert.match((await page.textContent(".cm-content")) ?? "", /memória/);
  assert.equal(await page.inputValue("#name"), "latin.il");
  await page.context().close();
});

test("a project of OpenPLC Editor is opened, shown as ladder, and runs", async () => {
  const page = await lab.open();
  await choose(page, "plc.xml", readFileSync(new URL("plc.xml", import.meta.url)));
  await page.locator('.ladder .element[data-point="Q4"]').waitFor();
  assert.equal(await page.inputValue("#name"), "plc.xml");
  await page.locator(".ladder text.name", { hasText: "pump" }).first().waitFor();
  await run(page);
  await holding(page, 1, () => lamp(page, 4, true));
  await lamp(page, 4, false);
  await page.context().close();
});

test("a program that no ladder of a project can hold is exported as a list", async () => {
  const page = await lab.still({ locale: "pt-BR" });
  await choose(page, "08-parking.txt", readFileSync(new URL("../../../../programs/tutorial/08-parking.txt", import.meta.url)));
  await page.locator('.ladder .element[data-point="Q3"]').waitFor();
  const saved = page.waitForEvent("download");
  await pick(page, "#save-project");
  assert.match(readFileSync(await (await saved).path(), "utf8"), /<IL>/);
  await page.context().close();
});

test("a report of several pages is saved page by page, each rung on one", async () => {
  const page = await lab.still({ locale: "pt-BR" });
  const rungs = Array.from({ length: 30 }, (_, at) => `LD I${(at % 4) + 1}\nST M${at + 1}\n`);
  await choose(page, "many.il", Buffer.from(rungs.join("")));
  await page.locator('.ladder .element[data-point="M30"]').waitFor();
  /** @type {import("playwright-core").Download[]} */
  const came = [];
  page.on("download", (download) => came.push(download));
  await page.click("#menu-fileMenu");
  await page.getByRole("button", { name: "Salvar páginas para um relatório", exact: true }).click();
  const last = /** @type {const} */ (["many-1.svg", "many-2.svg", "many-3.svg", "many-4.svg"]);
  while (came.length < last.length) await page.waitForEvent("download");
  assert.deepEqual(came.map((download) => download.suggestedFilename()), last);
  const shown = await (await lab.browser.newContext()).newPage();
  let rung = 0;
  for (const download of came) {
    const text = readFileSync(await download.path(), "utf8");
    assert.match(text, /^<svg [^>]*297mm/);
    const drawn = await shown.evaluate((text) => {
      document.body.innerHTML = text;
      const paper = /** @type {SVGSVGElement} */ (document.querySelector("svg")).getBoundingClientRect();
      return [...document.querySelectorAll(".rung")].map((one) => {
        const at = one.getBoundingClientRect();
        return { rung: Number(one.getAttribute("data-rung")), within: at.left >= paper.left && at.top >= paper.top && at.right <= paper.right && at.bottom <= paper.bottom };
      });
    }, text);
    for (const one of drawn) assert.deepEqual(one, { rung: (rung += 1), within: true });
  }
  assert.equal(rung, 30);
  await shown.context().close();
  await page.context().close();
});

test("a file that is dropped on the page is opened", async () => {
  const page = await lab.still();
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(["LD I2\nST Q4\n"], "dropped.il"));
    return transfer;
  });
  await page.dispatchEvent(".cm-content", "drop", { dataTransfer: data });
  await page.locator('.ladder .element[data-point="Q4"]').waitFor();
  assert.equal(await page.inputValue("#name"), "dropped.il");
  await page.context().close();
});

test("the program, its code, its ladder and the timing diagram are saved", async () => {
  const page = await lab.open();
  const save = async (/** @type {string} */ entry) =>
    downloaded(page, async () => {
      await page.click("#menu-fileMenu");
      await page.getByRole("button", { name: entry, exact: true }).click();
    });
  const program = await save("Save");
  assert.equal(program.name, "seal-in.il");
  assert.match(program.text, /ANDN stop/);
  assert.match((await save("Save PROGRAM.TXT")).text, /877901/);
  assert.match((await save("Save the ladder as SVG")).text, /^<svg[^]*start/);
  const paper = await save("Save pages for a report");
  assert.match(paper.text, /^<svg [^>]*279.4mm[^]*start[^]*Page 1 of 1/);
  assert.equal(paper.name, "seal-in-1.svg");
  const project = await save("Export as PLCopen XML");
  assert.equal(project.name, "seal-in.xml");
  assert.match(project.text, /<project [^]*<coil [^]*motor/);
  assert.equal((await save("Save a card image")).name, "card.img");
  await run(page);
  await holding(page, 1, () => lamp(page, 1, true));
  await lamp(page, 1, true);
  const csv = await downloaded(page, () => page.getByRole("button", { name: "Export CSV" }).click());
  assert.match(csv.text, /^ms,start I1,stop I2,motor Q1\n[^]*,1,0,1\n/);
  const svg = await downloaded(page, () => page.getByRole("button", { name: "Export SVG" }).click());
  assert.match(svg.text, /^<svg[^]*motor/);
  await page.context().close();
});
