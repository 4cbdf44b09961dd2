// Twenty states of the page, compared with how they were when somebody looked at them: by blocks, so that the letters of another
// machine are no difference, and a part that is gone, moved or of another colour is one. `npm run states` makes the pictures anew.
// @ts-check

import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Lab, pictures } from "./harness.mjs";
import { newcomer } from "./newcomer.mjs";
import { STATES, reach } from "./states.mjs";

/** @typedef {import("playwright-core").Page} Page */

const folder = fileURLToPath(new URL("states/", import.meta.url));
/** Whether the pictures are made anew. */
const isNew = process.env["STATES"] === "new";
/** A picture is kept at this share of its size. */
const SHARE = 1 / 7;
/** A side of a block of a kept picture, pixels; how far the mean of a block may be off, of 255; how many blocks may be. */
const BLOCK = 4;
const OFF = 16;
const MOST = 0.025;

/** @type {Lab} */
let lab;
/** What makes pictures small, and compares them. @type {Page} */
let bench;
before(async () => {
  for (const path of [pictures, folder]) mkdirSync(path, { recursive: true });
  lab = await Lab.begin();
  bench = await (await lab.browser.newContext()).newPage();
});
after(() => lab.end());

/** A picture, made small. @param {Buffer} png */
async function small(png) {
  const url = await bench.evaluate(async ([data, share]) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [Math.round(image.width * share), Math.round(image.height * share)];
    const context = canvas.getContext("2d");
    if (!context) throw new Error("no canvas");
    context.imageSmoothingQuality = "high";
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL("image/png");
  }, /** @type {const} */ ([png.toString("base64"), SHARE]));
  return Buffer.from(url.split(",")[1] ?? "", "base64");
}

/** Which share of the blocks of two small pictures differs. @param {Buffer} one @param {Buffer} other */
function difference(one, other) {
  return bench.evaluate(async ([pictures, block, off]) => {
    const all = await Promise.all(pictures.map(async (data) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const canvas = new OffscreenCanvas(Math.ceil(image.width / block), Math.ceil(image.height / block));
      const whole = new OffscreenCanvas(image.width, image.height).getContext("2d");
      if (!whole) throw new Error("no canvas");
      whole.drawImage(image, 0, 0);
      const { data: pixels } = whole.getImageData(0, 0, image.width, image.height);
      const means = Array.from({ length: canvas.width * canvas.height * 3 }, () => 0);
      const counts = Array.from({ length: canvas.width * canvas.height }, () => 0);
      for (let y = 0; y < image.height; y += 1) for (let x = 0; x < image.width; x += 1) {
        const at = Math.floor(y / block) * canvas.width + Math.floor(x / block);
        counts[at] = (counts[at] ?? 0) + 1;
        for (let colour = 0; colour < 3; colour += 1) means[at * 3 + colour] = (means[at * 3 + colour] ?? 0) + (pixels[(y * image.width + x) * 4 + colour] ?? 0);
      }
      return { size: `${image.width} × ${image.height}`, means, counts };
    }));
    const [one, other] = all;
    if (!one || !other || one.size !== other.size) return 1;
    const isOff = (/** @type {number} */ at) => [0, 1, 2].some((colour) => Math.abs((one.means[at * 3 + colour] ?? 0) - (other.means[at * 3 + colour] ?? 0)) > off * (one.counts[at] ?? 1));
    return one.counts.filter((_, at) => isOff(at)).length / one.counts.length;
  }, /** @type {const} */ ([[one.toString("base64"), other.toString("base64")], BLOCK, OFF]));
}

/** What is written on a screen is as large as this, CSS pixels. */
const LEAST = 12;

/** What is in view and smaller, by its text and size: of a drawing as it is shown. A picture of a machine is a picture.
 * @param {Page} page */
const tiny = (page) => page.evaluate((least) => [...document.querySelectorAll("body *:not(.machine-picture *, script, style, option)")].flatMap((one) => {
  const text = [...one.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE).map((node) => node.textContent).join("").trim();
  const { left, right, top, bottom, width } = one.getBoundingClientRect();
  if (text === "" || width < 2 || !one.checkVisibility({ visibilityProperty: true }) || right < 0 || left > innerWidth || bottom < 0 || top > innerHeight) return [];
  const scale = one instanceof SVGGraphicsElement ? (one.getScreenCTM()?.a ?? 1) : 1;
  const size = parseFloat(getComputedStyle(one).fontSize) * scale;
  return size < least - 0.05 ? [`${text.slice(0, 30)}: ${size.toFixed(1)} px`] : [];
}), LEAST);

for (const state of STATES) {
  test(`the page looks as it did: ${state.name}`, async () => {
    const page = state.kept ? await lab.other(state.options, state.kept) : (await newcomer(lab, state.options)).page;
    await reach(page, state);
    assert.deepEqual(await tiny(page), []);
    const png = await page.screenshot({ animations: "disabled", caret: "hide", path: join(pictures, `state-${state.name}.png`) });
    await page.context().close();
    const now = await small(png);
    const file = join(folder, `${state.name}.png`);
    if (isNew) return writeFileSync(file, now);
    assert.ok(existsSync(file), "npm run states makes it");
    const off = await difference(readFileSync(file), now);
    assert.ok(off <= MOST, `${(100 * off).toFixed(1)} % of the blocks differ: look at target/lab/pictures/state-${state.name}.png, and run \`npm run states\` if it is as it shall be`);
  });
}

test("states are told apart by what is compared", async () => {
  const all = STATES.map(({ name }) => ({ name, png: readFileSync(join(folder, `${name}.png`)) }));
  for (const [index, one] of all.entries()) {
    assert.equal(await difference(one.png, one.png), 0);
    for (const other of all.slice(index + 1)) assert.ok((await difference(one.png, other.png)) > MOST, `${one.name} looks like ${other.name}`);
  }
});
