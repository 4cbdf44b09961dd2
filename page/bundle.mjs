// Bundles the parts of a room into a folder of target. A part is a folder there with bundles in it, made of the entry
// points that it names, and of what it puts around them.

import { build } from "esbuild";
import { existsSync, readdirSync, rmSync } from "node:fs";
import { join, relative } from "node:path";

/** For Node. avr8js as modules: behind the accessors of its other form it runs at half the speed. */
export const node = { platform: "node", target: "node18", mainFields: ["module", "main"] };

/** The files below a folder of the room whose names end so. */
export function below(room, folder, end) {
  const names = readdirSync(join(room, folder), { recursive: true }).map(String);
  return names.filter((name) => name.endsWith(end)).map((name) => join(folder, name));
}

/** Bundles a part; `more` are further options of esbuild. */
export function bundle(room, part, outdir, more) {
  const { around, ...options } = part;
  return build({
    absWorkingDir: room,
    bundle: true,
    format: "esm",
    outExtension: { ".js": ".mjs" },
    logLevel: "warning",
    sourcemap: "linked",
    outdir,
    ...options,
    ...more,
  });
}

/** Bundles the parts that are asked for, all of them without a word. */
export async function bundleAll(room, target, parts, asked) {
  for (const name of asked.length > 0 ? asked : Object.keys(parts)) {
    const part = parts[name];
    if (!part) {
      console.error(`no part ${name}; there are ${Object.keys(parts).join(", ")}`);
      process.exit(2);
    }
    const outdir = join(target, name);
    rmSync(outdir, { recursive: true, force: true });
    const entryPoints = part.entryPoints.filter((entry) => existsSync(join(room, entry.in ?? entry)));
    await bundle(room, part, outdir, { entryPoints });
    await part.around?.(outdir);
    console.log(`${relative(process.cwd(), outdir)}: ${entryPoints.length} bundles`);
  }
}
