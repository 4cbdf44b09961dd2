// What the gateway is asked over HTTP, and its answers (`/api/openapi.json` describes them).

import type { Both } from "../tools/answers";

export interface Board {
  readonly name: string;
  readonly up: boolean;
  readonly why?: string;
  readonly doing?: "RUN" | "STOP" | "FAULT";
  readonly fault?: number;
  readonly line?: number;
  readonly forced: boolean;
  readonly points: Readonly<Record<string, number | null>>;
}

export interface Alarm {
  readonly name: string;
  readonly state: "normal" | "active" | "acknowledged" | "gone";
  readonly severity: "low" | "medium" | "high";
  readonly text: Both;
  /** The boards whose points its condition reads. */
  readonly boards: readonly string[];
  /** ms since 1970; null: always so. */
  readonly since: number | null;
  readonly who?: string;
}

export interface AlarmPast {
  readonly at: number;
  readonly alarm: string;
  readonly change: string;
  readonly who: string | null;
}

export interface Deed {
  readonly at: number;
  readonly who: string;
  readonly from: string | null;
  readonly of: string;
  readonly what: string;
  readonly detail: string;
}

export interface Row {
  readonly at: number;
  readonly least: number | null;
  readonly most: number | null;
  readonly last: number | null;
}

export interface PointName {
  readonly board: string;
  readonly point: string;
}

export interface Named extends PointName {
  readonly bit: boolean;
  readonly writes: boolean;
}

export type Look = "lamp" | "value" | "bar" | "trend" | "button" | "switch" | "set";

export interface Item extends PointName {
  readonly show: Look;
  readonly label: Both;
  readonly unit: string;
  readonly least: number;
  readonly most: number;
  readonly at?: readonly [number, number];
  readonly size: readonly [number, number];
}

export interface Bind extends PointName {
  readonly id: string;
  readonly does: "show" | "light" | "text" | "level" | "turn";
  readonly least: number;
  readonly most: number;
}

export interface Panel {
  readonly name: string;
  readonly title: Both;
  readonly columns: number;
  readonly drawing?: string;
  readonly items: readonly Item[];
  readonly binds: readonly Bind[];
  readonly made: boolean;
}

export interface Who {
  readonly name: string;
  readonly may: "watch" | "operate" | "engineer";
}

/** Why there is no answer: the word of the gateway, else `token`, `often`, `lost`. */
export class No extends Error {
  constructor(readonly why: string) {
    super(why);
  }
}

/** The tab keeps the token where the page of a board keeps it too. */
const KEY = "board";

/** Takes a token out of the address, where it is not to be seen. */
export function tokenOfAddress(): void {
  const token = /^#key=([\w.-]+)$/.exec(location.hash)?.[1];
  if (token === undefined) return;
  setToken(token);
  history.replaceState(null, "", location.pathname);
}

export function token(): string {
  return sessionStorage.getItem(KEY) ?? "";
}

export function setToken(token: string): void {
  sessionStorage.setItem(KEY, token);
}

/** Where the page of a board is: its token goes with it behind the mark, which no server sees. */
export function pageOf(board: string): string {
  return `./#board/${board}${token() ? `=${token()}` : ""}`;
}

/** What is answered at this path; a `body` brings something. */
export async function ask<T>(path: string, body?: unknown, keepalive = false): Promise<T> {
  const answer = await fetch(path, {
    headers: token() ? { Authorization: `Bearer ${token()}` } : {},
    cache: "no-store",
    keepalive,
    ...(body === undefined ? {} : { method: "POST", body: JSON.stringify(body) }),
  }).catch(() => null);
  if (!answer) throw new No("lost");
  if (answer.ok) return (await answer.json()) as T;
  if (answer.status === 401) throw new No("token");
  if (answer.status === 429) throw new No("often");
  const told = (await answer.json().catch(() => null)) as { readonly why?: unknown } | null;
  throw new No(typeof told?.why === "string" ? told.why : "lost");
}

/** The same as a file, which a link cannot bring: it would show no token. */
export async function askFile(path: string): Promise<string> {
  const answer = await fetch(path, { headers: token() ? { Authorization: `Bearer ${token()}` } : {}, cache: "no-store" }).catch(() => null);
  if (!answer?.ok) throw new No("lost");
  return answer.text();
}

export const whyOf = (error: unknown): string => (error instanceof No ? error.why : "lost");
