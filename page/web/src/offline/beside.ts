// What the page has beside it: files of its folder or, where the page is a single file, what that file holds of them.

declare global {
  /** The files that a page of one file holds, by their names: gzip as base64. `build/single.mjs` puts them there. */
  var unoclpFiles: Readonly<Record<string, string>> | undefined;
}

const held = globalThis.unoclpFiles;
/** Whether the page is a single file, with nothing beside it. */
export const isSingle = held !== undefined;

/** A file of the page. */
export async function beside(file: string): Promise<Response> {
  const packed = held?.[file];
  if (packed === undefined) return fetch(file);
  const { body } = await fetch(`data:application/gzip;base64,${packed}`);
  const type = file.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
  return new Response(body?.pipeThrough(new DecompressionStream("gzip")) ?? null, { headers: { "content-type": type } });
}

/** A worker that runs a script of the page. From the disk no browser starts one but out of the page's own memory. */
export async function worker(script: string): Promise<Worker> {
  if (!isSingle) return new Worker(script, { type: "module" });
  const text = await (await beside(script)).text();
  return new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
}

/** Puts a style sheet of the page to work, once. */
export async function dressIn(sheet: string): Promise<void> {
  if (document.querySelector(`[data-sheet="${sheet}"]`)) return;
  const style = isSingle ? document.createElement("style") : document.createElement("link");
  style.dataset["sheet"] = sheet;
  if (style instanceof HTMLLinkElement) {
    const loaded = new Promise((resolve) => style.addEventListener("load", resolve, { once: true }));
    style.rel = "stylesheet";
    style.href = sheet;
    document.head.append(style);
    await loaded;
  } else {
    style.textContent = await (await beside(sheet)).text();
    document.head.append(style);
  }
}

/** The address of the whole page as one file, which a double click opens. */
export function single(): string {
  return isSingle ? location.href.replace(/#.*$/, "") : "unoclp.html";
}
