// A browser at the page of `unoclp serve`, with a board behind it: `node visit.mjs ADDRESS watch|control`. The test of
// the command runs it (tools/cli/tests/serve.rs).
// @ts-check

import assert from "node:assert/strict";
import { Lab } from "../page/harness.mjs";

const [address = "", role = ""] = process.argv.slice(2);
const lab = await Lab.begin();
try {
  const page = await lab.open({}, "", address);
  // A token belongs neither into the history nor onto a projector.
  assert.equal(new URL(page.url()).hash, "");
  const about = page.locator("#desk-about", { hasText: role === "watch" ? "Watching" : "Connected" });
  await about.filter({ hasText: "unoclp" }).waitFor();
  await page.locator('#status[data-state="RUN"]').waitFor();
  await page.locator("#command-stop").click();
  if (role === "watch") await page.locator("#notes", { hasText: "locked" }).waitFor();
  else await page.locator('#status[data-state="STOP"]').waitFor();
  await page.reload();
  await about.filter({ hasText: "unoclp" }).waitFor();
} finally {
  await lab.end();
}
