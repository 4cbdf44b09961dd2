// The hands by which a page is used: a mouse, fingers on a small screen, the keyboard alone.
// @ts-check

/** @typedef {import("playwright-core").Page} Page @typedef {import("playwright-core").Locator} Locator */

/** What a person does, by any hand.
 * @typedef {object} Hand
 * @property {string} name
 * @property {import("playwright-core").BrowserContextOptions} options of the browser
 * @property {(page: Page, what: string | Locator) => Promise<void>} press presses a button, a box, a tab
 * @property {(page: Page, what: string | Locator, value: string) => Promise<void>} choose takes an entry of a list
 * @property {(page: Page, what: string, text: string) => Promise<void>} write replaces what stands in a field
 * @property {(page: Page, input: number) => Promise<void>} hold holds the button of an input
 * @property {(page: Page, input: number) => Promise<void>} release lets it go
 * @property {(page: Page, what: string, share: number) => Promise<void>} turn turns a knob to 0 or 1
 */

export const EDITOR = ".cm-content";

/** @param {Page} page @param {string | Locator} what */
const at = (page, what) => (typeof what === "string" ? page.locator(what) : what).first();

/** Replaces the text of what has the focus. @param {Page} page @param {string} what @param {string} text */
async function replace(page, what, text) {
  await page.keyboard.press("Control+A");
  await page.keyboard.insertText(text);
  if (what !== EDITOR) await page.keyboard.press("Enter");
}

/** @param {Page} page @param {string} what @param {number} share */
async function end(page, what, share) {
  const box = await at(page, what).boundingBox();
  return { x: share > 0.5 ? (box?.width ?? 0) - 1 : 1, y: (box?.height ?? 0) / 2 };
}

/** @type {Hand} */
export const mouse = {
  name: "mouse",
  options: {},
  press: (page, what) => at(page, what).click(),
  choose: async (page, what, value) => void (await at(page, what).selectOption(value)),
  async write(page, what, text) {
    await at(page, what).click();
    await replace(page, what, text);
  },
  async hold(page, input) {
    await page.locator(`[data-input="${input}"]`).hover();
    await page.mouse.down();
  },
  release: (page) => page.mouse.up(),
  turn: async (page, what, share) => at(page, what).click({ position: await end(page, what, share) }),
};

/** What sends touches and many keys to a page. @type {WeakMap<Page, Promise<import("playwright-core").CDPSession>>} */
const sessions = new WeakMap();

/** @param {Page} page */
function sessionOf(page) {
  // One finger stays with one session.
  const session = sessions.get(page) ?? page.context().newCDPSession(page);
  sessions.set(page, session);
  return session;
}

/** A finger on a point of the window. @param {Page} page @param {"touchStart" | "touchMove" | "touchEnd"} type */
export async function touch(page, type, x = 0, y = 0) {
  const session = await sessionOf(page);
  await session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
}

/** @type {Hand} */
export const fingers = {
  name: "touch",
  options: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
  press: (page, what) => at(page, what).tap(),
  choose: mouse.choose,
  async write(page, what, text) {
    await at(page, what).tap();
    await replace(page, what, text);
  },
  async hold(page, input) {
    const button = page.locator(`[data-input="${input}"]`);
    await button.scrollIntoViewIfNeeded();
    const box = await button.boundingBox();
    if (!box) throw new Error(`no button ${input}`);
    await touch(page, "touchStart", box.x + box.width / 2, box.y + box.height / 2);
  },
  release: (page) => touch(page, "touchEnd"),
  turn: async (page, what, share) => at(page, what).tap({ position: await end(page, what, share) }),
};

/** Stops of the Tab key that a page may have. */
const STOPS = 200;

/** Presses the Tab key so many times, and asks the page nothing meanwhile. @param {Page} page @param {boolean} back @param {number} times */
async function tabs(page, back, times) {
  const session = await sessionOf(page);
  const key = { key: "Tab", code: "Tab", windowsVirtualKeyCode: 9, modifiers: back ? 8 : 0 };
  const sent = Array.from({ length: times }, () => [session.send("Input.dispatchKeyEvent", { type: "rawKeyDown", ...key }), session.send("Input.dispatchKeyEvent", { type: "keyUp", ...key })]);
  await Promise.all(sent.flat());
}

/** Goes somewhere by Tab and Shift+Tab alone, the way that it lies. @param {Page} page @param {string | Locator} what */
async function reach(page, what) {
  const target = at(page, what);
  await target.waitFor();
  for (let stop = 0; stop < STOPS; stop++) {
    const { there, edits, isBehind, sure } = await target.evaluate((element) => {
      const now = document.activeElement;
      const isBehind = Boolean(now && element.compareDocumentPosition(now) & Node.DOCUMENT_POSITION_FOLLOWING);
      // Stops on the way of which there is no doubt, up to an editor, where Tab means something else.
      const follows = (/** @type {Element} */ one, /** @type {Element | null} */ other) => Boolean(other && one.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING);
      const isBetween = (/** @type {Element} */ one) => (isBehind ? follows(element, one) && follows(one, now) : follows(now ?? element, one) && follows(one, element));
      const stops = [...document.querySelectorAll(".cm-editor, button:enabled, select:enabled, input:enabled:not([type=radio]), a[href]")].filter(isBetween);
      if (isBehind) stops.reverse();
      const editor = stops.findIndex((one) => one.matches(".cm-editor"));
      const sure = (editor < 0 ? stops : stops.slice(0, editor)).filter((one) => /** @type {HTMLElement} */ (one).tabIndex >= 0 && !one.closest("[inert]") && one.checkVisibility({ visibilityProperty: true }));
      return { there: element === now, edits: now?.closest(".cm-editor") !== null, isBehind, sure: now === document.body ? 0 : sure.length };
    });
    if (there) return;
    // Within the editor Tab indents, until Escape has left it.
    if (edits) await page.keyboard.press("Escape");
    await tabs(page, isBehind, edits ? 1 : Math.max(1, sure));
  }
  throw new Error(`Tab does not lead to ${target}`);
}

/** Goes on by an arrow until this has the focus. @param {Page} page @param {string | Locator} what @param {string} arrow */
async function arrow(page, what, arrow) {
  const target = at(page, what);
  for (let step = 0; step < STOPS; step++) {
    if (await target.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press(arrow);
  }
  throw new Error(`${arrow} does not lead to ${target}`);
}

/** @type {Hand} */
export const keyboard = {
  name: "keyboard",
  options: {},
  async press(page, what) {
    const target = at(page, what);
    await target.waitFor();
    const role = await target.evaluate((element) => (element.closest(".menu > div") ? "entry" : element.getAttribute("role") ?? element.getAttribute("type")));
    if (role === "tab") {
      await reach(page, "[role=tab][aria-selected=true]");
      return arrow(page, what, "ArrowRight");
    }
    if (role === "entry") await arrow(page, what, "ArrowDown");
    else await reach(page, what);
    await page.keyboard.press(role === "switch" || role === "checkbox" ? " " : "Enter");
  },
  async choose(page, what, value) {
    await reach(page, what);
    const list = at(page, what);
    await page.keyboard.press("Home");
    for (let step = 0; (await list.inputValue()) !== value; step++) {
      if (step > STOPS) throw new Error(`no entry ${value}`);
      await page.keyboard.press("ArrowDown");
    }
  },
  async write(page, what, text) {
    await reach(page, what);
    await replace(page, what, text);
  },
  async hold(page, input) {
    await reach(page, `[data-input="${input}"]`);
    await page.keyboard.down(" ");
  },
  release: (page) => page.keyboard.up(" "),
  async turn(page, what, share) {
    await reach(page, what);
    await page.keyboard.press(share > 0.5 ? "End" : "Home");
  },
};

/** All of them. */
export const HANDS = [mouse, fingers, keyboard];

/** Holds the button of an input. @param {Page} page @param {number} input @param {() => Promise<void>} meanwhile */
export async function holding(page, input, meanwhile, hand = mouse) {
  await hand.hold(page, input);
  await meanwhile();
  await hand.release(page, input);
}
