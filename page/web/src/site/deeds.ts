// The record: who did what.

import { h } from "../page/dom";
import { type SiteKey, say } from "../words/site";
import { speak } from "../words/words";
import { type Deed, No, ask } from "./ask";
import { saves, table } from "./table";
import { moment } from "./told";

const WHAT: Readonly<Record<string, SiteKey>> = {
  run: "deedRun",
  stop: "deedStop",
  "single scan": "deedScan",
  restart: "deedRestart",
  force: "deedForce",
  write: "deedWrite",
  release: "deedRelease",
  settings: "deedSettings",
  upload: "deedUpload",
  acknowledge: "deedAcknowledge",
};

export class Deeds {
  readonly root = h("div");

  constructor() {
    speak.follow(() => void this.draw());
  }

  shown(): void {
    void this.draw();
  }

  private async draw(): Promise<void> {
    if (this.root.hidden) return;
    try {
      const deeds = await ask<readonly Deed[]>("api/deeds?most=500");
      const word = (what: string): string => {
        const key = WHAT[what];
        return key ? say(key) : what;
      };
      const rows = [...deeds].reverse().map((deed) => [moment(deed.at), deed.who, deed.of, word(deed.what), deed.detail, deed.from ?? "–"]);
      const heads = [say("columnWhen"), say("columnWho"), say("columnOf"), say("columnWhat"), say("columnDetail"), say("columnFrom")];
      this.root.replaceChildren(h("p", { class: "row" }, saves("api/deeds.csv", "deeds.csv")),
        rows.length > 0 ? table(say("deedsTable"), heads, rows) : h("p", { class: "empty" }, say("recordEmpty")));
    } catch (error) {
      if (!(error instanceof No)) throw error;
      this.root.replaceChildren(h("p", { class: "empty" }, say(error.why === "no record" ? "recordNone" : "whyOther")));
    }
  }
}
