// The npm packages that a bundle is made of, for NOTICE and the licences beside what is handed out.

import { readFileSync } from "node:fs";
import { join } from "node:path";

/** The folder of the package that a file is of, below the lab; `undefined` for a file of our own. */
function folderOf(file) {
  const found = /^(.*node_modules\/(?:@[^/]+\/)?[^/]+)\//.exec(file);
  return found?.[1];
}

/** Name, version, licence and folder of each package of which esbuild has put a byte into an output. */
export function packages(metafile, lab) {
  const folders = new Set();
  for (const { inputs } of Object.values(metafile.outputs)) {
    for (const [file, { bytesInOutput }] of Object.entries(inputs)) {
      const folder = folderOf(file);
      if (folder && bytesInOutput > 0) folders.add(folder);
    }
  }
  return [...folders].sort().map((folder) => {
    const { name, version, license } = JSON.parse(readFileSync(join(lab, folder, "package.json"), "utf8"));
    return { name, version, licence: license, folder };
  });
}
