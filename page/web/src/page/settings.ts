// The settings of the board: what it keeps for its next start, and its lock.

import type { Settings } from "../tools/answers";
import { ADDRESSES, RATES } from "../tools/numbers";
import { Refusal } from "../tools/tools";
import type { Key } from "../words/later";
import { say } from "../words/later";
import { speak, told, translate } from "../words/words";
import type { Bench } from "./bench";
import { h } from "./dom";
import { reveal } from "./reveal";
import { type Way, same } from "./ways";

const PARITIES = ["parityNone", "parityEven", "parityOdd"] as const;
/** The bits of the lock, from bit 0 on. */
const LOCKS = ["lockUpload", "lockSettings", "lockCommands", "lockWriting"] as const;

export class SettingsTab {
  private readonly address = h("input", { type: "number", min: ADDRESSES[0], max: ADDRESSES[1], id: "set-address" });
  private readonly rate = h("select", { id: "set-rate" }, ...RATES.map((rate) => h("option", { value: rate }, String(rate))));
  private readonly parity = h("select", { id: "set-parity" }, ...PARITIES.map((key, value) => h("option", { value, "data-say": key })));
  private readonly direction = h("input", { type: "checkbox", role: "switch", id: "set-direction" });
  private readonly locks = LOCKS.map((key) => h("input", { type: "checkbox", id: `set-${key}` }));
  private readonly lock = h("fieldset", { class: "row" }, h("legend", { "data-say": "lock" }),
    ...this.locks.map((box, bit) => h("label", { class: "row" }, box, h("span", { "data-say": LOCKS[bit] ?? "lock" }))));
  private readonly about = h("p", { class: "note", id: "settings-about" });
  private readonly said = h("p", { id: "settings-said", role: "status" });
  private readonly keep = h("button", { type: "submit", class: "primary", id: "settings-keep" });
  private readonly restart = h("button", { type: "button", id: "settings-restart", "data-say": "settingsRestart", click: () => void this.restarts() });

  private reads = false;

  constructor(
    private readonly bench: Bench,
    private readonly panel: HTMLElement,
  ) {
    const switches = h("label", { class: "switch" }, this.direction, h("span", { "data-say": "direction" }));
    // What a board does not take is named by Rust, in the language of the page.
    const form = h("form", { class: "settings", novalidate: true },
      this.about,
      h("div", { class: "row" }, field("address", this.address), field("rate", this.rate), field("parity", this.parity), switches),
      this.lock,
      h("div", { class: "row" }, this.keep, this.restart, this.said), h("p", { class: "note", "data-say": "settingsHint" }));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.submit();
    });
    panel.append(form);
    translate(panel);
    bench.settings.follow((settings) => {
      if (settings) this.fill(settings);
      this.show();
    });
    bench.seen.follow(() => void this.read());
    bench.identity.follow(() => this.show());
    bench.lost.follow(() => this.show());
    speak.follow(() => this.show());
  }

  /** Asks the board for them, while somebody looks. */
  async read(): Promise<void> {
    const { bench } = this;
    if (this.reads || this.panel.hidden || !bench.seen.value || bench.settings.value) return;
    this.reads = true;
    await bench.ask({ do: "settings" });
    this.reads = false;
  }

  /** With a board the form is what it keeps; without one it is how to find it. */
  private show(): void {
    const { settings, way } = this.bench;
    const there = settings.value !== null;
    // Found, and about to be read.
    this.keep.disabled = !there && this.bench.identity.value !== null;
    if (!there && !this.panel.contains(document.activeElement)) this.fill(way);
    for (const one of [this.lock, this.restart, this.direction.parentElement]) if (one) one.hidden = !there;
    this.lock.hidden = settings.value?.lock == null;
    this.keep.textContent = say(there ? "settingsKeep" : "settingsFind");
    const parity = say(PARITIES[way.parity] ?? "parityNone");
    const key: Key = !settings.value ? "settingsSeek" : same(settings.value, way) ? "settingsOf" : "settingsNext";
    this.about.textContent = this.keep.disabled ? "" : say(key, { ...way, parity });
  }

  private fill(settings: Way & Partial<Settings>): void {
    this.address.value = String(settings.address);
    this.rate.value = String(settings.rate);
    this.parity.value = String(settings.parity);
    this.direction.checked = settings.direction ?? false;
    this.locks.forEach((box, bit) => {
      box.checked = box.disabled = (((settings.lock ?? 0) >> bit) & 1) !== 0;
    });
  }

  private async submit(): Promise<void> {
    const { bench } = this;
    const way = { address: Number(this.address.value), rate: Number(this.rate.value), parity: Number(this.parity.value) };
    const old = bench.settings.value;
    if (!old) {
      this.tell("", false);
      return bench.speak(way);
    }
    const lock = old.lock === null ? null : this.locks.reduce((bits, box, bit) => bits | (Number(box.checked) << bit), 0);
    await this.order({ do: "settle", settings: { ...way, direction: this.direction.checked, lock } });
  }

  private async restarts(): Promise<void> {
    if (await this.order({ do: "restart" })) this.bench.begun();
  }

  private async order(order: Parameters<Bench["order"]>[0]): Promise<boolean> {
    try {
      const said = await this.bench.order(order);
      this.tell(said ? told(said) : "", false);
      return true;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      this.tell(told(error.both), true);
      return false;
    }
  }

  private tell(text: string, isBad: boolean): void {
    this.said.textContent = text;
    this.said.classList.toggle("bad", isBad);
    reveal(this.said);
  }
}

function field(key: Key, input: HTMLElement): HTMLElement {
  return h("label", { class: "field" }, h("span", { "data-say": key }), input);
}
