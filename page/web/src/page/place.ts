// The places of programs in the browser's store: each has its program, its drawing, its simulated board, and how the program
// was before. A tab is in one of them, and two tabs never in the same one; a program that is opened gets a new one, so that it
// takes the place of nothing.

import { BOARDS, type BoardId } from "unoclp-uno/boards";
import { keep, kept } from "./kept";

/** Where what the EEPROM of a simulated board holds is kept. */
export const eepromOf = (id: BoardId): "eeprom" | `eeprom-${BoardId}` => (id === BOARDS[0] ? "eeprom" : `eeprom-${id}`);

/** What a place holds, each under a key of its own. */
const KINDS = ["program", "drawing", "ways", "contacts", "board", "versions", ...BOARDS.map(eepromOf)] as const;
type Kind = (typeof KINDS)[number];

/** Places that are kept; of more, those go first that hold what another holds too. */
const MOST = 200;
/** From one version of a program to the next at least, ms; so many are kept, and those of these days. */
const APART = 600_000;
const VERSIONS = 20;
const DAYS = 7;
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
/** The place whose program this page has begun to change. */
let reminded = "";
take(begin());

/** What this tab has kept; null where it has nothing. */
export function keptHere(kind: Kind): string | null {
  return kept(`${kind}/${own}`);
}

/** Keeps something for this tab; says whether it is kept. */
export function keepHere(kind: Kind, text: string): boolean {
  if (kind === "program") {
    isCopy &&= programOf(text)?.text === programOf(keptHere(kind))?.text;
    remind(text);
  }
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

/** A program in its place. */
export interface Placed extends KeptProgram {
  readonly id: string;
}

/** The place of this tab. */
export function here(): string {
  return own;
}

/** Goes to a place; a tab that is there goes on in a copy of it. */
export function moveTo(id: string): void {
  if (id === own) return;
  isCopy = false;
  take(id);
}

/** The programs of the other places, the newest first, each once. */
export function others(): Placed[] {
  const now = programOf(keptHere("program"));
  const all = places().filter(([id]) => id !== own).map(([id, program]): Placed => ({ id, ...program }));
  const isFirst = (one: KeptProgram, at: number): boolean => [now, ...all.slice(0, at)].every((other) => one.name !== other?.name || one.text !== other.text);
  return all.filter(isFirst).filter((one) => one.text.trim() !== "");
}

/** What a place holds of one kind. */
export function keptAt(id: string, kind: Kind): string | null {
  return kept(`${kind}/${id}`);
}

/** Gives the program of a place another name. */
export function rename(id: string, name: string): void {
  const program = programOf(keptAt(id, "program"));
  if (program) keep(`program/${id}`, JSON.stringify({ ...program, name }));
}

/** Has another place hold the same under a name. */
export function duplicate(id: string, name: string): void {
  const to = token();
  for (const kind of KINDS) {
    const held = keptAt(id, kind);
    if (held !== null) keep(`${kind}/${to}`, held);
  }
  rename(to, name);
}

/** Lets a place go; gives what brings it back. */
export function remove(id: string): () => void {
  const held = KINDS.map((kind) => [kind, keptAt(id, kind)] as const);
  for (const kind of [...KINDS, "claim"]) drop(`${kind}/${id}`);
  return () => {
    for (const [kind, text] of held) if (text !== null) keep(`${kind}/${id}`, text);
  };
}

/** How the program of a place was before, the newest first. */
export function versionsOf(id: string): readonly KeptProgram[] {
  try {
    const all = JSON.parse(keptAt(id, "versions") ?? "[]") as unknown;
    return Array.isArray(all) ? all.map((one) => programOf(JSON.stringify(one))).filter((one) => one !== null) : [];
  } catch {
    return [];
  }
}

/** Another text is about to take the place of what is kept: a while after the last version that becomes one. */
function remind(text: string): void {
  const before = programOf(keptHere("program"));
  if (!before || before.text.trim() === "" || before.text === programOf(text)?.text) return;
  const all = versionsOf(own);
  const [last] = all;
  const isFirst = reminded !== own;
  reminded = own;
  if (last && (last.text === before.text || (!isFirst && before.at - last.at < APART))) return;
  const isRecent = (one: KeptProgram): boolean => before.at - one.at < DAYS * 86_400_000;
  keep(`versions/${own}`, JSON.stringify([before, ...all].filter((one, at) => at < 3 || isRecent(one)).slice(0, VERSIONS)));
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
  if (before !== null && kept(`program/${before}`) !== null) return before;
  const own = copyOf(from);
  // The place of version 0.2.0 is none: what it held is here alone.
  isCopy = newest !== undefined;
  return own;
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

/** Lets places go where there are too many: copies, and then the oldest. */
function tidy(): void {
  const all = places();
  const isCopyOf = ([, one]: (typeof all)[number], at: number): boolean => all.slice(0, at).some(([, other]) => other.name === one.name && other.text === one.text);
  const copies = all.filter(isCopyOf);
  const rest = all.filter((one) => !copies.includes(one));
  for (const [id] of [...rest, ...copies].slice(MOST)) remove(id);
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
