// Programs from the disk and back.

import type { Text } from "../tools/answers";
import { LANGUAGES } from "../tools/languages";
import { say } from "../words/words";
import { h } from "./dom";
import { note } from "./notes";

const LONGEST = 1 << 20;
/** What a person may pick: programs, scenarios and machines. */
const PICKED = [...Object.values(LANGUAGES).map(({ end }) => end), ".toml", ".json", "text/plain"].join();

/** The text of a file; null where it is none, which is told. */
export async function read(file: File): Promise<Text | null> {
  if (file.size > LONGEST) {
    note(() => say("fileTooLarge"));
    return null;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  const text = decode(bytes);
  if (text === null) note(() => say("fileNoText"));
  return text === null ? null : { name: file.name, text };
}

/** Whether a file is a machine: it lists parts. */
export function isMachine({ text }: Text): boolean {
  return /^\s*\[\[part\]\]/m.test(text);
}

/** Whether a file is what a student has handed in. */
export function isHandIn({ name }: Text): boolean {
  return /\.unoclp\.json$/i.test(name);
}

/** Whether a file says how a program is checked: an exercise or a scenario, and no program. */
export function isScenario({ name, text }: Text): boolean {
  return /\.toml$/i.test(name) || /^\s*\[\[?(case|step|expect)\b/m.test(text);
}

/** UTF-8, UTF-16 where its mark says so, else Latin-1; null for bytes that no text has. */
function decode(bytes: Uint8Array): string | null {
  const wide = bytes[0] === 0xff && bytes[1] === 0xfe ? "utf-16le" : bytes[0] === 0xfe && bytes[1] === 0xff ? "utf-16be" : null;
  if (wide) return new TextDecoder(wide).decode(bytes);
  if (bytes.includes(0)) return null;
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("latin1").decode(bytes);
  }
}

/** Lets a person pick files. */
export function pick(take: (files: readonly File[]) => void, accept = PICKED): void {
  const input = h("input", { type: "file", accept, multiple: true });
  input.addEventListener("change", () => take([...(input.files ?? [])]));
  input.click();
}

export function download(name: string, content: string | Uint8Array, type = "text/plain"): void {
  const blob = new Blob([content as BlobPart], { type });
  const link = h("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Opens what is dropped anywhere on the page. */
export function takeDrops(cover: HTMLElement, take: (files: readonly File[]) => void): void {
  let depth = 0;
  const show = (by: number): void => {
    depth = Math.max(0, depth + by);
    cover.hidden = depth === 0;
  };
  addEventListener("dragenter", (event) => {
    if (event.dataTransfer?.types.includes("Files")) show(1);
  });
  addEventListener("dragleave", () => show(-1));
  addEventListener("dragover", (event) => {
    if (event.dataTransfer?.types.includes("Files")) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    const files = [...(event.dataTransfer?.files ?? [])];
    depth = 0;
    cover.hidden = true;
    if (files.length === 0) return;
    event.preventDefault();
    take(files);
  }, { capture: true });
}
