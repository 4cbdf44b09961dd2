// Bundles the simulated UNO for Node into target/uno: `node build.mjs [part…]`, all parts without a word.

import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { below, bundleAll, node } from "../bundle.mjs";

const room = dirname(fileURLToPath(import.meta.url));
const parts = {
  engine: { ...node, entryPoints: ["src/engine/main.ts"] },
  bench: { ...node, entryPoints: below(room, "test/bench", ".ts") },
  test: { ...node, entryPoints: below(room, "test", ".test.ts"), outbase: "test" },
};

await bundleAll(room, join(room, "../../target/uno"), parts, process.argv.slice(2));
