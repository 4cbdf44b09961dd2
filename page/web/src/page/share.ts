// A link that carries a program in its fragment, which no server sees.

import type { Text } from "../tools/answers";

/** What is inflated at most: a link may be a bomb. */
const MOST = 1 << 20;

export async function linkOf(text: Text, page: string): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify([text.name, text.text]));
  const packed = await all(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw")), Number.POSITIVE_INFINITY);
  const digits = btoa(String.fromCharCode(...packed)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return `${page.split("#")[0] ?? ""}#p=${digits}`;
}

/** The program of a fragment: undefined where it carries none, null where what it carries is no program. */
export async function programOf(fragment: string): Promise<Text | null | undefined> {
  const digits = /^#p=(.*)$/.exec(fragment)?.[1];
  if (digits === undefined) return undefined;
  try {
    const packed = Uint8Array.from(atob(digits.replaceAll("-", "+").replaceAll("_", "/")), (one) => one.charCodeAt(0));
    const bytes = await all(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw")), MOST);
    const [name, text] = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)) as unknown[];
    return typeof name === "string" && typeof text === "string" ? { name: name.slice(0, 100), text } : null;
  } catch {
    return null;
  }
}

/** The bytes of a stream, or an error as soon as there are more than so many. */
async function all(stream: ReadableStream<Uint8Array>, most: number): Promise<Uint8Array> {
  const parts: Uint8Array[] = [];
  let length = 0;
  const reader = stream.getReader();
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    length += part.value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error("too long");
    }
    parts.push(part.value);
  }
  const bytes = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}
