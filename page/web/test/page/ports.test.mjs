// Ports that are no board of ours: busy, nonsense, another device, no WebSerial. Each has words, and a way on.
// @ts-check

import { after, before, test } from "node:test";
import { Lab, lamp, pick, run, select, still, unfold } from "./harness.mjs";
import { Cable } from "./port.mjs";

/** @type {Lab} */
let lab;
before(async () => {
  lab = await Lab.begin();
});
after(() => lab.end());

/** A device that answers each request so. @param {number[]} answer */
function device(answer) {
  return {
    /** @type {(bytes: number[]) => void} */
    hear: () => undefined,
    open: () => undefined,
    reset: () => undefined,
    send() {
      this.hear(answer);
    },
  };
}

/** Function 43 is none of its functions. */
const FOREIGN = [1, 0xab, 1, 0x9e, 0xf0];
const NONSENSE = [0x55, 0xaa, 0x00, 0xff, 0x13, 0x37, 0x42];

test("a port that is busy is told, and opens once it is free", async () => {
  for (const [locale, busy, connected] of /** @type {const} */ ([
    ["en-US", "close other programs that use its port", "does not answer"],
    ["pt-BR", "feche outros programas que usam a porta", "não responde"],
  ])) {
    const page = await lab.open({ locale });
    const cable = await Cable.between(page, device([]));
    cable.isBusy = true;
    await pick(page, "#connect");
    await page.locator("#notes", { hasText: busy }).waitFor();
    // The simulated board is there still.
    await page.locator("#hardware").waitFor();
    await run(page);
    await lamp(page, 1, false);
    cable.isBusy = false;
    await pick(page, "#connect");
    await unfold(page, "#put-firmware");
    await page.locator("#put-firmware").waitFor();
    await page.locator("#status", { hasText: connected }).waitFor();
    await page.context().close();
  }
});

for (const [what, answer, english, portuguese] of /** @type {const} */ ([
  ["a device that is not unoclp", FOREIGN, "does not run unoclp", "não roda o unoclp"],
  ["a board that answers nonsense", NONSENSE, "are unreadable", "são ilegíveis"],
])) {
  test(`${what} is told, and offered the firmware`, async () => {
    const page = await lab.open();
    await Cable.between(page, device([...answer]));
    await still(page);
    await pick(page, "#connect");
    await page.locator("#status", { hasText: english }).waitFor();
    await select(page, "#speak", "pt");
    await page.locator("#status", { hasText: portuguese }).waitFor();
    await select(page, "#speak", "en");
    const offer = page.locator("#notes div", { hasText: english });
    await offer.getByRole("button", { name: "Install the firmware" }).click();
    // No boot loader is there; that is told too, and the line is spoken to again.
    await page.locator("#notes", { hasText: /FW-2[12]/ }).waitFor();
    await page.locator("#put-firmware:enabled").waitFor({ state: "attached" });
    await pick(page, "#connect");
    await page.locator("#hardware").waitFor();
    await page.context().close();
  });
}
