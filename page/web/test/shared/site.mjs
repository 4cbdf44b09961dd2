// A browser at the screens of a site, with a gateway and a board behind it: `node site.mjs ADDRESS`. The test of the command
// runs it (tools/cli/tests/serve.rs).
// @ts-check

import { Lab } from "../page/harness.mjs";

const [address = ""] = process.argv.slice(2);
const lab = await Lab.begin();
try {
  const page = await (await lab.browser.newContext({ viewport: { width: 1366, height: 768 }, locale: "en-US" })).newPage();
  page.on("pageerror", (error) => lab.errors.push(String(error.stack)));
  page.on("console", (message) => {
    if (message.type() === "error") lab.errors.push(message.text());
  });
  await page.goto(address);
  const card = page.locator('[data-board="one"]');
  await card.locator(".status", { hasText: "RUN" }).waitFor();
  // An alarm of the site is there, and goes by a hand.
  await page.click("#to-alarms");
  await page.getByRole("button", { name: "Acknowledge lit" }).click();
  await page.locator("#of-alarms td", { hasText: "$local" }).first().waitFor();
  // What the panel sets reaches the board, and the history.
  await page.click("#to-panels");
  const lamp = page.getByRole("switch", { name: "Lamp" });
  await lamp.filter({ hasText: "off" }).click();
  await lamp.filter({ hasText: "on" }).waitFor();
  await page.click("#to-trends");
  await page.locator('#of-trends [data-point="one.Q1"]').waitFor();
  await page.locator(".chart canvas").waitFor();
  await page.click("#to-deeds");
  await page.locator("#of-deeds tr", { hasText: "Q1 = 1" }).waitFor();
  // A phone that is out of its network presses no button for long.
  const phone = await lab.browser.newContext({ locale: "en-US" });
  const gone = await phone.newPage();
  await gone.goto(`${address}#panels/screens`);
  await gone.getByRole("button", { name: "Horn" }).hover();
  await gone.mouse.down();
  await gone.locator('.push[data-on="true"]').waitFor();
  await phone.setOffline(true);
  const horn = async () => (await (await fetch(new URL("api/boards", address))).json())[0].points.Q2;
  while ((await horn()) !== 0);
  await page.click("#to-alarms");
  await page.click("#to-deeds");
  await page.locator("#of-deeds tr", { hasText: "release by the gateway" }).waitFor();
  // From a board's card its own page is reached.
  await page.click("#to-boards");
  await card.getByRole("link", { name: "Program and ladder" }).click();
  await page.locator("#desk-about", { hasText: "unoclp" }).waitFor();
} finally {
  await lab.end();
}
