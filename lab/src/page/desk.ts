// The UNO on the desk: which board the page speaks to.

import { PortLine } from "../line/port";
import { say } from "../words/words";
import type { Bench } from "./bench";
import { h } from "./dom";
import { icon } from "./icons";
import { note } from "./notes";

/** The control that changes from the simulated board to one on the desk and back. */
export function desk(bench: Bench): HTMLElement {
  const text = h("span");
  const connect = h("button", { type: "button", id: "connect" }, icon("usb"), text);
  const about = h("p", { class: "note" });
  const show = (): void => {
    const there = bench.where.value === "desk";
    text.textContent = say(there ? "disconnect" : "connect");
    text.dataset["say"] = there ? "disconnect" : "connect";
    const identity = bench.identity.value;
    about.textContent = there && identity ? say("connected", { identity }) : "";
  };
  bench.where.follow(show);
  bench.identity.follow(show);
  const join = async (): Promise<void> => {
    const { serial } = navigator as { serial?: Serial };
    if (!serial) return note(say("noSerial"));
    let port: SerialPort;
    try {
      port = await serial.requestPort();
    } catch {
      // Nobody was chosen.
      return;
    }
    port.addEventListener("disconnect", () => {
      if (bench.where.value === "desk") note(say("portLost"));
    });
    try {
      await bench.connect("desk", new PortLine(port), true);
    } catch (error) {
      note(say("portBusy", { why: error instanceof Error ? error.message : String(error) }));
      await leave();
    }
  };
  const leave = async (): Promise<void> => {
    if (bench.power.value) await bench.connect("simulated", bench.simulated.line, false);
    else {
      await bench.disconnect();
      bench.where.value = "simulated";
    }
  };
  connect.addEventListener("click", () => void (bench.where.value === "desk" ? leave() : join()));
  return h("div", { class: "row" }, connect, about);
}
