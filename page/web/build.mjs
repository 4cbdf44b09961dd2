// Bundles the page into target/lab: `node build.mjs [part…]`, all parts without a word. `node build.mjs --packages` writes
// no bundle, and says of which npm packages the page consists.

import { build, transform } from "esbuild";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { createHash } from "node:crypto";
import { examples, exercises, lessons, machines } from "./build/lessons.mjs";
import { packages } from "./build/packages.mjs";
import { single } from "./build/single.mjs";
import { below, bundle, bundleAll, node } from "../bundle.mjs";

const lab = dirname(fileURLToPath(import.meta.url));
const target = join(lab, "../../target/lab");

const browser = { platform: "browser", target: "es2022", minify: true, mainFields: ["module", "main"], outExtension: { ".js": ".js" } };
const parts = {
  page: {
    ...browser,
    entryPoints: [
      { in: "src/page/main.ts", out: "page" },
      { in: "src/tools/worker.ts", out: "tools" },
      { in: "src/board/worker.ts", out: "board" },
      { in: "src/site/main.ts", out: "site" },
    ],
    splitting: true,
    chunkNames: "part-[hash]",
    loader: { ".css": "text", ".il": "text", ".st": "text" },
    around,
  },
  bench: { ...node, entryPoints: below(lab, "test/bench", ".ts") },
  test: { ...node, entryPoints: below(lab, "test", ".test.ts"), outbase: "test" },
};

/** The file that was built, or the one that the repository has. */
function found(...files) {
  const file = files.map((file) => join(lab, "../..", file)).find(existsSync);
  if (!file) throw new Error(`none of ${files.join(", ")} is there; \`cargo xtask lab\` builds it`);
  return file;
}

/** What a module of the simulated board exports. */
async function ofUno(module) {
  const { outputFiles } = await build({ absWorkingDir: lab, bundle: true, format: "esm", write: false, entryPoints: [`../uno/src/${module}.ts`] });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString("base64")}`);
}

/** The firmware of each board as hex; of those that are simulated as the bytes that the flash holds too, since compressed they
 * are two thirds of the text, and where each has what slow motion asks of it, by its map. */
async function firmwares(outdir) {
  const { WIRINGS, readHex } = await ofUno("index");
  const { BOARDS, firmwareName } = await ofUno("boards");
  const { placesOf } = await ofUno("slow/index");
  const folder = join(lab, "../../firmware");
  for (const file of readdirSync(folder).filter((name) => name.endsWith(".hex"))) cpSync(join(folder, file), join(outdir, file.replace("-uno", "")));
  const slow = {};
  for (const board of BOARDS) {
    const file = `firmware/unoclp-${board}`;
    const words = readHex(readFileSync(found(`${file}.hex`), "utf8"), WIRINGS[board].chip.flash);
    if (!words) throw new Error(`${file}.hex is no Intel hex for this chip`);
    const bytes = new Uint8Array(words.buffer);
    writeFileSync(join(outdir, `${firmwareName(board)}.bin`), bytes.subarray(0, bytes.findLastIndex((byte) => byte !== 0xff) + 1));
    slow[board] = placesOf(readFileSync(found(`${file}.symbols`), "utf8"));
  }
  writeFileSync(join(outdir, "slow.json"), JSON.stringify(slow));
}

/** What the page loads besides its bundles, and the list by which it works without a network. */
async function around(outdir) {
  mkdirSync(outdir, { recursive: true });
  cpSync(join(lab, "static"), outdir, { recursive: true });
  const uplot = readFileSync(createRequire(import.meta.url).resolve("uplot/dist/uPlot.min.css"), "utf8");
  const css = await transform(readFileSync(join(lab, "static/page.css"), "utf8") + uplot, { loader: "css", minify: true });
  writeFileSync(join(outdir, "page.css"), css.code);
  for (const module of ["unoclp.wasm", "unoclp-full.wasm"]) cpSync(found(join("target/lab", module)), join(outdir, module));
  await firmwares(outdir);
  const root = join(lab, "../..");
  writeFileSync(join(outdir, "lessons.json"), JSON.stringify(lessons(root)));
  writeFileSync(join(outdir, "exercises.json"), JSON.stringify(exercises(root)));
  writeFileSync(join(outdir, "machines.json"), JSON.stringify(machines(root)));
  writeFileSync(join(outdir, "examples.json"), JSON.stringify(examples(root)));
  const files = readdirSync(outdir).filter((name) => !name.endsWith(".map") && name !== "sw.js");
  const sum = createHash("sha256");
  for (const file of files) sum.update(file).update(readFileSync(join(outdir, file)));
  const define = { FILES: JSON.stringify(["./", ...files]), VERSION: JSON.stringify(sum.digest("hex").slice(0, 12)) };
  await build({ ...browser, absWorkingDir: lab, bundle: true, format: "iife", define, entryPoints: ["src/offline/sw.ts"], outfile: join(outdir, "sw.js") });
  await single(outdir, "unoclp.html", { ...parts.page, absWorkingDir: lab }, { page: "src/page/main.ts", tools: "src/tools/worker.ts", board: "src/board/worker.ts" });
}

const asked = process.argv.slice(2);
if (asked[0] === "--packages") {
  const { metafile } = await bundle(lab, parts.page, join(target, "page"), { metafile: true, write: false });
  console.log(JSON.stringify(packages(metafile, lab)));
  process.exit();
}
await bundleAll(lab, target, parts, asked);
