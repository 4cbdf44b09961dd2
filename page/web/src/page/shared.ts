// A board behind this page, which `unoclp serve` shares: the fragment of the address says so, and holds the token. Of a site
// it says which board, too: `#board/estufa=…`.

const KEY = "board";
const NAME = "board-name";

/** What a tab has kept; a browser that forbids that knows it until a reload. */
const known = new Map<string, string>();
function keep(key: string, text: string): void {
  known.set(key, text);
  try {
    sessionStorage.setItem(key, text);
  } catch {
    // Until a reload it is known here.
  }
}
function kept(key: string): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return known.get(key) ?? null;
  }
}

/** The token for the board behind this page: empty where none is asked for, null where there is no board. A reload of the
 * page knows it still; the address does not show it. */
export function sharedToken(): string | null {
  const token = /^#board(?:\/([\w-]+))?(?:=([\w.-]*))?$/.exec(location.hash);
  if (token) {
    keep(KEY, token[2] ?? "");
    keep(NAME, token[1] ?? "");
    history.replaceState(null, "", location.pathname + location.search);
  }
  return kept(KEY);
}

/** Where the gateway is: behind the page itself. */
export function gateway(): string {
  const name = kept(NAME);
  return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/line${name ? `/${name}` : ""}`;
}
