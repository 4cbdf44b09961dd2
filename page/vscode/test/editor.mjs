// The extension in a real Visual Studio Code: code-server, and Chromium before it. It is installed from its file, starts
// `unoclp lsp`, shows a problem, and completes a name. README.md says how to run it.

import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../../..");
const { chromium } = createRequire(join(root, "page/web/"))("playwright-core");

/** Line 4 has a mistake; line 3 is completed. */
const PROGRAM = `PROGRAM motor
VAR start AT %IX1 : BOOL; contactor AT %QX1 : BOOL; END_VAR
contactor := start;
contactor := nobody;
END_PROGRAM
`;

const [server, program = join(root, "target/debug/unoclp")] = process.argv.slice(2);
if (!server) throw new Error("which code-server? Its folder is the first argument");

const folder = mkdtempSync(join(tmpdir(), "unoclp-vscode-"));
const places = ["--user-data-dir", join(folder, "user"), "--extensions-dir", join(folder, "extensions")];
const code = [join(server, "out/node/entry.js"), ...places];
const work = join(folder, "work");
for (const path of [work, join(folder, "user/User")]) mkdirSync(path, { recursive: true });
writeFileSync(join(folder, "user/User/settings.json"), JSON.stringify({ "unoclp.command": resolve(program), "security.workspace.trust.enabled": false }));
writeFileSync(join(work, "motor.st"), PROGRAM);

/** A port that is free. @returns {Promise<number>} */
const free = () => new Promise((done) => {
  const listening = createServer().listen(0, "127.0.0.1", () => {
    const { port } = listening.address();
    listening.close(() => done(port));
  });
});

let child;
let browser;
try {
  const installed = spawnSync(process.execPath, [...code, "--install-extension", join(root, "target/unoclp.vsix")], { encoding: "utf8" });
  assert.match(installed.stdout, /unoclp.*successfully installed/, installed.stdout + installed.stderr);

  const port = await free();
  child = spawn(process.execPath, [...code, "--auth", "none", "--bind-addr", `127.0.0.1:${port}`, "--disable-telemetry", "--disable-update-check", work]);
  await new Promise((done, failed) => {
    child.stdout.on("data", (said) => String(said).includes("HTTP server listening") && done());
    child.on("exit", () => failed(new Error("code-server ended")));
  });

  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium-headless-shell", args: ["--no-sandbox"] });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(180_000);
  await page.goto(`http://127.0.0.1:${port}/?folder=${work}`);
  await page.locator(".explorer-viewlet .monaco-list-row", { hasText: "motor.st" }).dblclick();
  await page.locator(".view-line", { hasText: "nobody" }).waitFor();
  // The program has been started, and says what is wrong.
  await page.locator(".squiggly-error").first().waitFor();
  await page.keyboard.press("Control+Shift+M");
  const problem = page.locator(".markers-panel-container .monaco-list-row", { hasText: "nobody" }).last();
  await problem.waitFor();
  console.log("problem:", (await problem.innerText()).replaceAll(/\s+/g, " "));
  // A new line, two letters of a name, and the rest of it.
  await page.locator(".view-line", { hasText: "start;" }).last().click();
  await page.keyboard.press("End");
  await page.keyboard.type("\ncontactor := sta");
  await page.keyboard.press("Control+Space");
  const offer = page.locator(".suggest-widget.visible .monaco-list-row", { hasText: "start" }).first();
  await offer.waitFor();
  console.log("completion:", (await offer.innerText()).replaceAll(/\s+/g, " "));
  if (process.env.PICTURE) await page.screenshot({ path: process.env.PICTURE });
  await page.keyboard.press("Enter");
  await page.locator(".view-line", { hasText: "contactor := start" }).nth(1).waitFor();
  console.log("installed, started, told, completed");
} finally {
  await browser?.close();
  child?.kill();
  rmSync(folder, { recursive: true, force: true });
}
