// A link that carries a program, an exercise or a machine in its fragment, which no server sees.

import { say } from "../words/later";
import { note } from "./notes";

/** What is inflated at most: a link may be a bomb. */
const MOST = 1 << 20;

/** What a link carries, each with its name and text: a program, with its drawing behind it where that is
 * unfinished; an exercise with its machine behind it; a machine. */
export type Kind = "p" | "x" | "m";
export interface Carried {
  readonly kind: Kind;
  readonly parts: readonly string[];
}

export async function linkOf(kind: Kind, parts: readonly string[], page: string): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify(parts));
  const packed = await all(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate-raw")), Number.POSITIVE_INFINITY);
  const digits = btoa(String.fromCharCode(...packed)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  return `${page.split("#")[0] ?? ""}#${kind}=${digits}`;
}

/** Puts a link where one can paste it from, or shows it. */
export async function copyLink(kind: Kind, parts: readonly string[]): Promise<void> {
  const link = await linkOf(kind, parts, location.href);
  try {
    await navigator.clipboard.writeText(link);
    const key = location.protocol === "file:" ? "sharedDisk" : kind === "p" ? "shared" : "sharedOther";
    note(() => say(key));
  } catch {
    prompt(say("sharedShown"), link);
  }
}

/** What a fragment carries: undefined where it carries nothing, null where that is none of these. */
export async function carriedBy(fragment: string): Promise<Carried | null | undefined> {
  const [, kind, digits] = /^#([pxm])=(.*)$/.exec(fragment) ?? [];
  if (kind === undefined || digits === undefined) return undefined;
  try {
    const packed = Uint8Array.from(atob(digits.replaceAll("-", "+").replaceAll("_", "/")), (one) => one.charCodeAt(0));
    const bytes = await all(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw")), MOST);
    const parts = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)) as unknown;
    const isRight = Array.isArray(parts) && parts.length >= 2 && parts.every((part) => typeof part === "string");
    return isRight ? { kind: kind as Kind, parts: (parts as string[]).map((part, at) => (at % 2 === 0 ? part.slice(0, 100) : part)) } : null;
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
