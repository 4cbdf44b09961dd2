// Serves the page that was built, or another folder of static files: `node serve.mjs [port]`; port 0 takes a free one.
// @ts-check

import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { dirname, extname, join, sep } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const built = join(dirname(fileURLToPath(import.meta.url)), "../../target/lab/page");

/** @type {Readonly<Record<string, string>>} */
const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/** Serves a folder on this computer alone; gives its address and what ends it. */
export async function serve(folder = built, port = 0) {
  const server = createServer((request, answer) => {
    let path;
    try {
      path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
    } catch {
      return void answer.writeHead(400).end();
    }
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    const is = file.startsWith(folder + sep) && existsSync(file) && statSync(file).isFile();
    if (!is) return void answer.writeHead(404).end();
    answer.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream", "cache-control": "no-cache" });
    answer.end(readFileSync(file));
  });
  await new Promise((ready, failed) => {
    server.once("error", failed);
    server.listen(port, "127.0.0.1", () => ready(undefined));
  });
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  const end = () => {
    server.closeAllConnections();
    return new Promise((done) => server.close(done));
  };
  return { url: `http://127.0.0.1:${address.port}/`, end };
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  const { url } = await serve(built, Number(process.argv[2] ?? "8420"));
  console.log(url);
}
