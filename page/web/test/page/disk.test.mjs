// The page from the disk, by a double click, with no network; and from another computer, where a browser trusts it less.
// @ts-check

import assert from "node:assert/strict";
import { copyFileSync, cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { built, serve } from "../../serve.mjs";
import { PATIENCE, keptText, lamp, launch, pick, run, state, type } from "./harness.mjs";

/** The page as a folder and as one file: as they were built, or as `cargo xtask dist --prove` hands them out. */
const FOLDER = process.env["PAGE_FOLDER"] ?? built;
const FILE = process.env["PAGE_FILE"] ?? join(built, "unoclp.html");

/** What the single file may weigh, bytes: what a mail takes. */
const MOST = 6_000_000;

/** The machine of the first visit leaves this lamp alone. */
const TEXT = "PROGRAM porta\nVAR\n  i AT %IX1 : BOOL;\n  q AT %QX4 : BOOL;\nEND_VAR\nq := NOT i;\nEND_PROGRAM\n";

/** What is kept over a reload. */
const KEPT = "LDN I1\nST Q4\n";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {string} */
let folder;
before(async () => {
  browser = await launch();
  folder = mkdtempSync(join(tmpdir(), "unoclp-disk-"));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

/** A page from the disk of somebody who has never been here, without a network; what goes wrong, and what it asks for elsewhere.
 * @param {string} file */
async function open(file) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, locale: "pt-BR", offline: true, acceptDownloads: true });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  /** @type {string[]} */
  const wrong = [];
  page.on("pageerror", (error) => wrong.push(String(error.stack)));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) wrong.push(message.text());
  });
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) wrong.push(request.url());
  });
  await page.goto(pathToFileURL(file).href);
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  return { page, wrong };
}

/** What a student does with it. @param {import("playwright-core").Page} page */
async function use(page) {
  // The first visit runs a program.
  await state(page, "RUN");
  await page.click("#view-both");
  // Another language is checked by the larger module, and its program runs on the board's own firmware.
  await type(page, TEXT, "porta.st");
  await page.locator("#tongue", { hasText: "Texto Estruturado" }).waitFor();
  await run(page);
  await lamp(page, 4, true);
  await pick(page, "#exercises");
  await page.locator("#exercise-list option").nth(40).waitFor({ state: "attached" });
  await page.locator("#exercise-check").click();
  await page.locator("#verdict").waitFor();
  await pick(page, "#lessons");
  await page.locator("#lesson h3").waitFor();
  await pick(page, "#machines");
  await page.locator("#gallery img[src^=data]").first().waitFor();
  await page.click("#gallery-close");
  await type(page, KEPT, "porta.il");
  await page.click("#view-draw");
  await page.locator("#sheet .rung").first().waitFor();
  await page.locator('style[data-sheet="draw.css"]').waitFor({ state: "attached" });
  // A board at this computer's port could be joined.
  assert.ok(await page.evaluate(() => isSecureContext && "serial" in navigator));
  await page.reload();
  await page.locator("html[data-ready=yes]").waitFor({ state: "attached" });
  assert.equal(await page.inputValue("#name"), "porta.il");
  assert.equal(await keptText(page), KEPT);
  await run(page);
  await lamp(page, 4, true);
}

test("the folder opens by a double click, without a network", async () => {
  const at = join(folder, "Sala de automação");
  mkdirSync(at);
  cpSync(FOLDER, at, { recursive: true });
  const { page, wrong } = await open(join(at, "index.html"));
  assert.match(page.url(), /Sala%20de%20automa%C3%A7%C3%A3o\/unoclp\.html$/);
  await use(page);
  assert.deepEqual(wrong, []);
  await page.context().close();
});

test("one file alone is the whole page, and small enough for a mail", async () => {
  const file = join(folder, "página da turma (1).html");
  copyFileSync(FILE, file);
  assert.ok(statSync(file).size <= MOST, `${statSync(file).size} bytes`);
  const { page, wrong } = await open(file);
  await use(page);
  assert.deepEqual(wrong, []);
  await page.context().close();
});

test("from another computer the page says what it cannot do there, and gives itself as a file", async () => {
  const server = await serve();
  const lan = await launch(["--host-resolver-rules=MAP lab.example 127.0.0.1"]);
  const address = server.url.replace("127.0.0.1", "lab.example");
  for (const [locale, said, button] of /** @type {const} */ ([
    ["en-US", /came from http:\/\/lab\.example:\d+\. Over http, a page from another computer cannot use serial ports/, "Save the page as one file"],
    ["pt-BR", /veio de http:\/\/lab\.example:\d+\. Por http, uma página de outro computador não pode usar portas seriais/, "Salvar a página em um único arquivo"],
  ])) {
    const page = await (await lan.newContext({ locale })).newPage();
    page.setDefaultTimeout(PATIENCE);
    await page.goto(address);
    await page.locator("#run:enabled").waitFor();
    assert.equal(await page.evaluate(() => isSecureContext), false);
    await pick(page, "#connect");
    await page.locator("#notes", { hasText: said }).waitFor();
    const saving = page.waitForEvent("download");
    await page.getByRole("button", { name: button }).click();
    const download = await saving;
    assert.equal(download.suggestedFilename(), "unoclp.html");
    assert.deepEqual(readFileSync(await download.path()), readFileSync(join(built, "unoclp.html")));
    await page.context().close();
  }
  await lan.close();
  await server.end();
});
