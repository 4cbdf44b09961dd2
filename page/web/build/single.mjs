// The page as one file, which a double click opens: from the disk a browser loads neither modules, nor workers, nor anything
// by `fetch`. So the scripts are classic ones within it, and all that they load is held compressed.

import { build } from "esbuild";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

/** What the page loads besides its own script; of each other file of the folder only `site.html` knows, or a browser's cache. */
const HELD = [
  "unoclp.wasm", "unoclp-full.wasm",
  "chart.css", "draw.css", "project.css", "slow.css", "slow.json",
  "lessons.json", "exercises.json", "machines.json", "examples.json",
];

/** And the firmware of each board. */
const FIRMWARE = /^unoclp(-\w+)?\.(bin|hex)$/;

/** Writes it into the folder of a page that was built. `options` are those of its scripts, `scripts` their sources. */
export async function single(folder, name, options, scripts) {
  const { splitting, chunkNames, around, entryPoints, ...classic } = options;
  const bundled = async (source) => {
    const { outputFiles } = await build({ ...classic, bundle: true, format: "iife", write: false, entryPoints: [source] });
    return Buffer.from(outputFiles[0].contents);
  };
  const { page, ...workers } = scripts;
  const held = {};
  const hold = (file, bytes) => (held[file] = gzipSync(bytes, { level: 9 }).toString("base64"));
  const firmwares = readdirSync(folder).filter((file) => FIRMWARE.test(file));
  for (const file of [...HELD, ...firmwares]) hold(file, readFileSync(join(folder, file)));
  for (const [file, source] of Object.entries(workers)) hold(`${file}.js`, await bundled(source));

  let html = readFileSync(join(folder, "index.html"), "utf8");
  const put = (from, to) => {
    if (!html.includes(from)) throw new Error(`index.html has no ${from}, which the single file writes in another way`);
    html = html.replace(from, () => to);
  };
  const icon = readFileSync(join(folder, "icon.svg")).toString("base64");
  put('href="icon.svg"', `href="data:image/svg+xml;base64,${icon}"`);
  put('<link rel="manifest" href="manifest.webmanifest">\n', "");
  put('<link rel="stylesheet" href="page.css">', `<style>${readFileSync(join(folder, "page.css"), "utf8")}</style>`);
  put('<script src="begin.js" defer></script>\n', "");
  const script = inline((await bundled(page)).toString("utf8"));
  put("</body>", `<script>globalThis.unoclpFiles=${JSON.stringify(held)}</script>\n<script>${script}</script>\n</body>`);
  writeFileSync(join(folder, name), html);
}

/** A script as HTML may hold it: nothing in it ends it, or begins a comment. */
function inline(script) {
  return script.replace(/<(?=\/script|!--|script)/gi, "\\x3c");
}
