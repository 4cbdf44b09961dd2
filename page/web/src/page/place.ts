// The place of this tab in the browser's store: its program, its drawing, its simulated board. Two tabs never have the
// same one; a link gets a new one, so that it takes the place of nothing.

import { keep, kept } from "./kept";

/** What a place holds, each under a key of its own. */
const KINDS = ["program", "drawing", "eeprom", "ways", "contacts", "board"] as const;
type Kind = (typeof KINDS)[number];

/** Places that are kept; the oldest go first. */
const MOST = 24;
const OWN = "place";

/** A program as a place keeps it. */
export interface KeptProgram {
  readonly name: string;
  readonly text: string;
  /** When it was written, ms since 1970. */
  readonly at: number;
}

const moves: (() => void)[] = [];
let own = "";
/** Whether it holds no more than another place does: a link may take it. */
let isCopy = false;
take(begin());

/** What this tab has kept; null where it has nothing. */
export function keptHere(kind: Kind): string | null {
  return kept(`${kind}/${own}`);
}

/** Keeps something for this tab; says whether it is kept. */
export function keepHere(kind: Kind, text: string): boolean {
  if (kind === "program") isCopy &&= programOf(text)?.text === programOf(keptHere(kind))?.text;
  return keep(`${kind}/${own}`, text);
}

/** Goes on in a new place, and leaves the one before with all that it holds. */
export function moveOn(): void {
  if (!isCopy) take(copyOf(keptHere));
}

/** Has it called when this tab goes on in a new place because another tab has taken its own. */
export function whenMoved(then: () => void): void {
  moves.push(then);
}

/** The programs of the other places, the newest first, each once. */
export function others(): KeptProgram[] {
  const here = programOf(keptHere("program"));
  const all = places().filter(([id]) => id !== own).map(([, program]) => program);
  const isFirst = (one: KeptProgram, at: number): boolean => [here, ...all.slice(0, at)].every((other) => one.name !== other?.name || one.text !== other.text);
  return all.filter(isFirst).filter((one) => one.text.trim() !== "");
}

/** A program as it was kept; null for anything else. */
export function programOf(text: string | null): KeptProgram | null {
  try {
    const { name, text: program, at } = JSON.parse(text ?? "{}") as Partial<KeptProgram>;
    return typeof name === "string" && typeof program === "string" ? { name, text: program, at: Number(at) || 0 } : null;
  } catch {
    return null;
  }
}

/** The place that this tab had before a reload, or one that begins as the newest there is. */
function begin(): string {
  const before = session();
  const newest = places()[0]?.[0];
  // Version 0.2.0 had one place for all.
  const from = newest === undefined ? (kind: Kind) => kept(kind) : (kind: Kind) => kept(`${kind}/${newest}`);
  listen();
  return before !== null && kept(`program/${before}`) !== null ? before : copyOf(from);
}

/** A new place that holds the same. */
function copyOf(from: (kind: Kind) => string | null): string {
  const id = token();
  isCopy = true;
  for (const kind of KINDS) {
    const held = from(kind);
    if (held !== null) keep(`${kind}/${id}`, held);
  }
  tidy();
  return id;
}

/** Tells all tabs that this place is taken: one that was duplicated has the place of the other. */
function take(id: string): void {
  own = id;
  keep(`claim/${id}`, token());
  remember();
}

function listen(): void {
  addEventListener("storage", ({ key }) => {
    if (key !== `claim/${own}`) return;
    take(copyOf(keptHere));
    for (const then of moves) then();
  });
  // A page that comes back as it was may have left its tab to another place meanwhile.
  addEventListener("pageshow", remember);
}

/** All places with a program, the newest first. */
function places(): (readonly [string, KeptProgram])[] {
  const all: (readonly [string, KeptProgram])[] = [];
  for (const key of keys()) {
    const id = /^program\/(.+)$/.exec(key)?.[1];
    const program = id === undefined ? null : programOf(kept(key));
    if (id !== undefined && program) all.push([id, program]);
  }
  return all.sort(([, one], [, other]) => other.at - one.at);
}

/** Lets the oldest places go. */
function tidy(): void {
  for (const [id] of places().slice(MOST)) {
    for (const kind of [...KINDS, "claim"]) drop(`${kind}/${id}`);
  }
}

function token(): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

function keys(): string[] {
  try {
    return Object.keys(localStorage);
  } catch {
    return [];
  }
}

function drop(key: string): void {
  try {
    localStorage.removeItem(key);
  } catch {
    // What cannot be kept need not go.
  }
}

function session(): string | null {
  try {
    return sessionStorage.getItem(OWN);
  } catch {
    return null;
  }
}

function remember(): void {
  try {
    sessionStorage.setItem(OWN, own);
  } catch {
    // Then a reload begins as the newest place does.
  }
}
