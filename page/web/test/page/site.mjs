// A gateway of a site, as a browser sees it: its answers, made up.
// @ts-check

const HOUR = 3_600_000;
const text = (/** @type {string} */ en, pt = en) => ({ en, pt });

/** @param {string} show @param {string} point @param {object} more */
const item = (show, point, more = {}) => ({ show, board: "estufa", point, label: text(point), unit: "", least: 0, most: 100, size: show === "trend" ? [2, 2] : [1, 1], ...more });

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 60" onload="window.broken = true">
  <script>window.broken = true</script><foreignObject><p xmlns="http://www.w3.org/1999/xhtml">no</p></foreignObject>
  <image href="https://example.invalid/x.png"/><a href="javascript:window.broken = true"><rect id="linked" width="5" height="5"/></a>
  <rect id="tank" x="10" y="10" width="30" height="40" fill="#0b6b63"/><circle id="fan" cx="90" cy="30" r="18" fill="none" stroke="currentColor"/>
  <text id="number" x="130" y="36">?</text></svg>`;

/** The answers of a gateway with two boards; what is written changes them. */
export function gateway() {
  const now = Date.now();
  const boards = [
    { name: "estufa", up: true, doing: "RUN", forced: true, points: { fan: 1, heater: 0, target: 25, temperature: 21.5, start: 0 } },
    { name: "forno", up: true, doing: "FAULT", fault: 51, forced: false, points: { Q1: 0, A0: 512 } },
    { name: "bomba", up: false, why: "/dev/ttyUSB0: no such port", forced: false, points: { Q1: null } },
  ];
  const alarms = [
    { name: "hot", state: "active", severity: "high", text: text("the greenhouse is too hot", "a estufa está quente demais"), boards: ["estufa"], since: now - HOUR },
    { name: "forno-away", state: "normal", severity: "low", text: text("the oven does not answer", "o forno não responde"), boards: ["forno"], since: null },
  ];
  const panels = [
    {
      name: "estufa", title: text("Greenhouse", "Estufa"), columns: 4, made: false, drawing: DRAWING,
      items: [
        item("lamp", "fan", { label: text("Fan", "Ventilador") }), item("switch", "heater", { label: text("Heater", "Aquecedor") }),
        item("button", "start", { label: text("Start", "Partida") }), item("value", "temperature", { unit: "°C" }),
        item("set", "target", { least: 5, most: 40, unit: "°C", label: text("Target", "Alvo") }), item("bar", "temperature", { unit: "°C", most: 50 }), item("trend", "temperature"),
      ],
      binds: [
        { id: "tank", board: "estufa", point: "temperature", does: "level", least: 0, most: 43 },
        { id: "fan", board: "estufa", point: "fan", does: "light", least: 0, most: 100 },
        { id: "number", board: "estufa", point: "target", does: "text", least: 0, most: 100 },
      ],
    },
    { name: "forno", title: text("forno"), columns: 4, made: true, items: [{ ...item("lamp", "Q1"), board: "forno" }, { ...item("value", "A0"), board: "forno" }], binds: [] },
  ];
  const names = Object.keys(boards[0]?.points ?? {}).map((point) => ({ board: "estufa", point, bit: ["fan", "heater", "start"].includes(point), writes: point !== "temperature" }));
  return {
    who: { name: "ana", may: "operate" },
    boards, alarms, panels, names,
    /** @type {{ board: string, point: string, value: number }[]} */
    written: [],
    /** @type {{ at: number, alarm: string, change: string, state: string, who: string | null }[]} */
    past: [{ at: now - HOUR, alarm: "hot", change: "came", state: "active", who: null }],
    deeds: [
      { at: now - 2 * HOUR, who: "rui", from: "10.0.0.7", of: "estufa", what: "upload", detail: "" },
      { at: now - 90_000, who: "ana", from: "10.0.0.8", of: "estufa", what: "write", detail: "target = 25" },
    ],
  };
}

/** What a point was: a wave, of which each change is a row.
 * @param {URLSearchParams} query */
function rows(query) {
  const [from, to] = [Number(query.get("from")), Number(query.get("to"))];
  const step = (to - from) / 120;
  return Array.from({ length: 120 }, (_, at) => {
    const last = 20 + 8 * Math.sin(at / 12) + (query.get("point")?.length ?? 0);
    return { at: Math.round(from + at * step), least: last - 1, most: last + 1, last };
  });
}

/** Answers a page in place of a gateway. @param {import("playwright-core").Page | import("playwright-core").BrowserContext} page
 * @param {ReturnType<typeof gateway>} of @param {string} token that is asked for; none: nobody is asked */
export async function answer(page, of, token = "") {
  await page.route("**/api/**", async (route) => {
    const request = route.request();
    const url = new URL(request.url());
    const json = (/** @type {unknown} */ body, status = 200) => route.fulfill({ status, contentType: "application/json", body: JSON.stringify(body) });
    if (token && request.headers()["authorization"] !== `Bearer ${token}`) return json({}, 401);
    switch (url.pathname) {
      case "/api/who": return json(of.who);
      case "/api/boards": return json(of.boards);
      case "/api/alarms": return json(of.alarms);
      case "/api/panels": return json(of.panels);
      case "/api/names": return json(of.names);
      case "/api/points": return json(of.names.map(({ board, point }) => ({ board, point })));
      case "/api/history": return json({ board: "", point: "", rows: rows(url.searchParams), more: false });
      case "/api/alarms/history": return json(of.past);
      case "/api/deeds": return json(of.deeds);
      case "/api/deeds.csv": return route.fulfill({ contentType: "text/csv", body: "at,who\n1,ana\n" });
      case "/api/alarms/acknowledge": {
        const { alarm } = request.postDataJSON();
        const found = of.alarms.find((one) => one.name === alarm);
        if (found?.state !== "active") return json({ why: "nothing to acknowledge" }, 409);
        Object.assign(found, { state: "acknowledged", who: of.who.name });
        of.past.push({ at: Date.now(), alarm, change: "acknowledged", state: "acknowledged", who: of.who.name });
        return json({ state: "acknowledged" });
      }
      case "/api/write": {
        const set = request.postDataJSON();
        if (of.who.may === "watch") return json({ why: "not allowed" }, 403);
        of.written.push(set);
        const board = of.boards.find((one) => one.name === set.board);
        if (board) Object.assign(board.points, { [set.point]: set.value });
        return json({ value: set.value });
      }
      default: return route.fulfill({ status: 404, body: "404" });
    }
  });
}
