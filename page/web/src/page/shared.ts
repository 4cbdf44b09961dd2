// A board behind this page, which `unoclp serve` shares: the fragment of the address says so, and holds the token. Of a site
// it says which board, too: `#board/estufa=…`.

const KEY = "board";
const NAME = "board-name";

/** The token for the board behind this page: empty where none is asked for, null where there is no board. A reload of the
 * page knows it still; the address does not show it. */
export function sharedToken(): string | null {
  const token = /^#board(?:\/([\w-]+))?(?:=([\w.-]*))?$/.exec(location.hash);
  if (token) {
    sessionStorage.setItem(KEY, token[2] ?? "");
    sessionStorage.setItem(NAME, token[1] ?? "");
    history.replaceState(null, "", location.pathname + location.search);
  }
  return sessionStorage.getItem(KEY);
}

/** Where the gateway is: behind the page itself. */
export function gateway(): string {
  const name = sessionStorage.getItem(NAME);
  return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/line${name ? `/${name}` : ""}`;
}
