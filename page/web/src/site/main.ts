// The screens of a site: all its boards, alarms, trends, panels, and who did what.

import { byId, h } from "../page/dom";
import { announce } from "../page/notes";
import { theme } from "../page/theme";
import { tongue } from "../page/tongue";
import { type SiteKey, say } from "../words/site";
import { speak, speakIn } from "../words/words";
import { Alarms, waits } from "./alarms";
import { setToken, tokenOfAddress } from "./ask";
import { Boards } from "./boards";
import { Deeds } from "./deeds";
import { Panels } from "./panels";
import { State } from "./state";
import { Trends } from "./trends";

/** A screen, which the fragment of the address names: `#panels/estufa`. */
interface Screen {
  readonly root: HTMLElement;
  /** It is on the screen now; what its name is followed by says what of it. */
  shown(rest?: string): void;
}

const TITLES = { boards: "siteBoards", alarms: "siteAlarms", trends: "siteTrends", panels: "sitePanels", deeds: "siteDeeds" } as const satisfies Readonly<Record<string, SiteKey>>;
type Name = keyof typeof TITLES;

const MAY = { watch: "mayWatch", operate: "mayOperate", engineer: "mayEngineer" } as const satisfies Readonly<Record<string, SiteKey>>;

tokenOfAddress();
const state = new State();
const screens: Readonly<Record<Name, Screen>> = {
  boards: new Boards(state),
  alarms: new Alarms(state),
  trends: new Trends(),
  panels: new Panels(state),
  deeds: new Deeds(),
};
const main = byId("screen");
const nav = byId("screens");
const told = byId("told");
const signIn = byId("sign-in");

const isName = (name: string): name is Name => name in TITLES;

/** The screen that the address names, and what of it. */
function place(): [Name, string] {
  const [name = "", rest = ""] = decodeURIComponent(location.hash.slice(1)).split("/");
  return isName(name) ? [name, rest] : ["boards", ""];
}

function show(): void {
  const [name, rest] = place();
  for (const [of, screen] of Object.entries(screens)) screen.root.hidden = of !== name;
  links();
  byId("screen-title").textContent = say(TITLES[name]);
  document.title = `${say(TITLES[name])} – unoclp`;
  screens[name].shown(rest);
}

function links(): void {
  const [here] = place();
  const waiting = state.alarms.value.filter(waits).length;
  const link = (name: Name): HTMLElement => {
    const count = name === "alarms" && waiting > 0 ? h("span", { class: "count", "aria-label": waiting === 1 ? say("alarmWaiting") : say("alarmsWaiting", { count: waiting }) }, String(waiting)) : null;
    return h("a", { href: `#${name}`, id: `to-${name}`, ...(name === here ? { "aria-current": "page" } : {}) }, say(TITLES[name]), count);
  };
  const focus = nav.contains(document.activeElement) ? document.activeElement?.id : undefined;
  nav.replaceChildren(...(Object.keys(TITLES) as Name[]).map(link));
  if (focus) byId(focus).focus();
}

/** What is wrong, or who is here. */
function tell(): void {
  const why = state.why.value;
  const isOut = why === "token" || why === "often";
  signIn.hidden = !isOut;
  main.hidden = isOut;
  nav.hidden = isOut;
  const texts: Readonly<Record<string, SiteKey>> = { wait: "siteWaiting", lost: "siteLost", often: "signInOften" };
  const text = why === "" || why === "token" ? null : say(texts[why] ?? "siteNone");
  told.hidden = text === null;
  told.textContent = text ?? "";
  const who = state.who.value;
  byId("who").textContent = who && !who.name.startsWith("$") ? say("signedAs", { name: who.name, may: say(MAY[who.may]) }) : "";
  byId("sign-out").hidden = isOut || !who || who.name === "$local";
}

function enter(): void {
  const token = h("input", { type: "password", id: "token", autocomplete: "current-password", required: true });
  const label = h("label", { for: "token" });
  const title = h("h2");
  const wrong = h("p", { class: "wrong", role: "alert" });
  const go = h("button", { type: "submit", class: "primary" });
  let tried = false;
  const words = (): void => {
    title.textContent = say("signInTitle");
    label.textContent = say("signInToken");
    go.textContent = say("signInGo");
    wrong.textContent = tried ? say(state.why.value === "often" ? "signInOften" : "signInWrong") : "";
  };
  signIn.replaceChildren(h("form", {
    class: "card sign-in",
    submit: (event) => {
      event.preventDefault();
      setToken(token.value.trim());
      token.value = "";
      void state.now().then(() => {
        tried = state.why.value !== "";
        words();
        if (!tried) {
          tried = false;
          show();
        }
      });
    },
  }, title, label, token, go, wrong));
  speak.follow(words);
}

byId("tools").append(
  h("span", { id: "who", class: "chip" }),
  h("button", { type: "button", id: "sign-out", hidden: true, "data-say": "signOut", click: () => { setToken(""); location.reload(); } }),
  theme(), tongue());
for (const [name, screen] of Object.entries(screens)) {
  screen.root.id = `of-${name}`;
  main.append(screen.root);
}
enter();
speakIn(document);
addEventListener("hashchange", () => {
  show();
  byId("screen-title").focus();
});
state.why.follow(tell);
state.who.follow(tell);
let waiting = 0;
state.alarms.follow((alarms) => {
  links();
  const now = alarms.filter(waits).length;
  if (now > waiting) announce(now === 1 ? say("alarmWaiting") : say("alarmsWaiting", { count: now }));
  waiting = now;
});
speak.follow(() => {
  tell();
  show();
});
state.begin();
document.documentElement.dataset["ready"] = "yes";
