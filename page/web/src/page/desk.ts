// The board on the desk: which board the page speaks to, and firmware for it.

import { MODELS } from "unoclp-uno/boards";
import type { Shared } from "../line/gateway";
import type { Line } from "../line/line";
import { beside, single } from "../offline/beside";
import type { Both } from "../tools/answers";
import { Refusal } from "../tools/tools";
import { say, told } from "../words/words";
import type { Bench } from "./bench";
import { h } from "./dom";
import { icon } from "./icons";
import { later } from "./later";
import { announce, note } from "./notes";
import { gateway, sharedToken } from "./shared";

/** What speaks to a board at a port, or behind this page: only who has one needs it. */
const portLine = later(async () => (await import("../line/port")).PortLine);
const gatewayLine = later(async () => (await import("../line/gateway")).GatewayLine);

export class Desk {
  /** What a menu has of it. */
  readonly rows: readonly HTMLElement[];
  private readonly text = h("span");
  /** Which board answers. */
  readonly about = h("p", { class: "note card", id: "desk-about" });
  private readonly model = h("select", { id: "model", "data-say-label": "boardKind" }, ...MODELS.map(({ name, title }) => h("option", { value: name }, title)));
  private readonly put = h("button", { type: "button", id: "put-firmware", click: () => void this.flash() }, icon("bolt"), h("span", { "data-say": "putFirmware" }));
  private readonly kind: HTMLElement;
  private port: SerialPort | null = null;
  private offered = false;
  /** The board behind this page, where there is one: then it is the one that is joined. */
  private readonly token = sharedToken();
  private shared: Shared | null = null;

  constructor(private readonly bench: Bench) {
    const connect = h("button", { type: "button", id: "connect", click: () => void (bench.where.value === "desk" ? this.leave() : this.join()) }, icon("usb"), this.text);
    this.kind = h("label", { class: "menu-field" }, h("span", { "data-say": "boardKind" }), this.model);
    this.rows = [connect, this.kind, this.put];
    bench.where.follow(() => this.show());
    bench.identity.follow(() => this.show());
    bench.flashing.follow((share) => {
      if (share === null) return;
      this.about.hidden = false;
      this.about.textContent = say("flashing", { percent: Math.round(share * 100) });
    });
    bench.lost.follow((why) => this.offer(why));
    if (this.token !== null) void this.join();
  }

  private show(): void {
    const there = this.bench.where.value === "desk";
    const key = there ? "disconnect" : "connect";
    this.text.textContent = say(key);
    this.text.dataset["say"] = key;
    // Firmware goes through the port alone.
    this.kind.hidden = this.put.hidden = !there || this.token !== null;
    const identity = this.bench.identity.value;
    const what = this.shared ? `${identity ?? ""} (${this.shared.name})` : identity;
    const said = this.shared?.role === "watch" ? "watching" : "connected";
    this.about.textContent = there && identity ? say(said, { identity: what ?? "" }) : "";
    this.about.hidden = this.about.textContent === "";
  }

  /** What is at the port is no board of ours: it may be one without the firmware. Said once for each time it is opened. */
  private offer(why: Both | null): void {
    const { bench } = this;
    if (!why || this.offered || !this.port || bench.where.value !== "desk" || bench.identity.value) return;
    this.offered = true;
    note(() => `${told(why)}. ${say("offerFirmware")}`, { text: () => say("putFirmware"), take: () => void this.flash() });
  }

  /** Lets a person choose a port, and speaks to what is there. */
  private async join(): Promise<void> {
    if (this.token !== null) {
      const Line = await gatewayLine();
      return Line ? this.speak(new Line(gateway(), this.token, (shared) => (this.shared = shared))) : undefined;
    }
    const { serial } = navigator as { serial?: Serial };
    if (!serial && isSecureContext) return note(() => say("noSerial"));
    if (!serial) return note(() => say("noSecure", { host: location.host }), { text: () => say("savePage"), take: savePage });
    try {
      this.port = await serial.requestPort();
    } catch {
      // Nothing was chosen.
      return;
    }
    await this.speakAt(this.port);
  }

  private async speakAt(port: SerialPort): Promise<void> {
    const Line = await portLine();
    if (Line) await this.speak(new Line(port));
  }

  private async speak(line: Line): Promise<void> {
    const again = { text: () => say("connect"), take: () => void this.join() };
    const lost = (): void => note(() => say(this.token === null ? "portLost" : "sharedLost"), again);
    this.offered = false;
    try {
      await this.bench.connect("desk", line, this.token === null, lost);
    } catch (error) {
      note(() => say(this.token === null ? "portBusy" : "sharedClosed", { why: error instanceof Error ? error.message : String(error) }));
      await this.leave();
    }
  }

  private async leave(): Promise<void> {
    this.port = null;
    await this.bench.useSimulated();
  }

  /** Puts the firmware on the board at the port, and speaks to it then. */
  private async flash(): Promise<void> {
    const model = MODELS.find(({ name }) => name === this.model.value) ?? MODELS[0];
    if (!this.port || this.put.disabled) return;
    this.put.disabled = true;
    try {
      const hex = await (await beside(model.file)).text();
      if (!this.bench.isOpen) await this.speakAt(this.port);
      await this.bench.flash(hex, model.name);
      this.say(() => say("flashed"));
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      const { both } = error;
      this.say(() => told(both));
    } finally {
      this.show();
      this.put.disabled = false;
    }
  }

  private say(what: () => string): void {
    note(what);
    announce(what());
  }
}

/** Gives the whole page to a person, to be opened from the disk. */
function savePage(): void {
  h("a", { href: single(), download: "unoclp.html" }).click();
}
