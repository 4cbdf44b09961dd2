// Bundles what the lab is made of into target/lab: `node build.mjs [part…]`, all parts without a word.
//
// A part is a folder in target/lab with bundles in it, made of the entry points named here.

import { build } from "esbuild";
import { existsSync, readdirSync, rmSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";

const lab = dirname(fileURLToPath(import.meta.url));
const target = join(lab, "../target/lab");

/** The files below a folder of the lab whose names end so. */
function below(folder, end) {
  const names = readdirSync(join(lab, folder), { recursive: true }).map(String);
  return names.filter((name) => name.endsWith(end)).map((name) => join(folder, name));
}

// avr8js as modules: behind the accessors of its other form it runs at half the speed.
const node = { platform: "node", target: "node18", mainFields: ["module", "main"] };
const parts = {
  engine: { ...node, entryPoints: ["src/engine/main.ts"] },
  bench: { ...node, entryPoints: ["test/bench/speed.ts"] },
  test: { ...node, entryPoints: below("test", ".test.ts"), outbase: "test" },
};

const asked = process.argv.slice(2);
for (const name of asked.length > 0 ? asked : Object.keys(parts)) {
  const part = parts[name];
  if (!part) {
    console.error(`no part ${name}; there are ${Object.keys(parts).join(", ")}`);
    process.exit(2);
  }
  const outdir = join(target, name);
  rmSync(outdir, { recursive: true, force: true });
  const entryPoints = part.entryPoints.filter((entry) => existsSync(join(lab, entry)));
  await build({
    absWorkingDir: lab,
    bundle: true,
    format: "esm",
    outExtension: { ".js": ".mjs" },
    logLevel: "warning",
    sourcemap: "linked",
    outdir,
    ...part,
    entryPoints,
  });
  console.log(`${relative(process.cwd(), outdir)}: ${entryPoints.length} bundles`);
}
