// Who goes through a scan slowly: the firmware on the simulated board, or this computer.

import type { BoardId, Event } from "unoclp-uno";
import type { Go, Places, Standing } from "unoclp-uno/slow";
import type { OfSlow } from "../../board/messages";
import { beside } from "../../offline/beside";
import type { Live, Stood, Text } from "../../tools/answers";
import type { RemoteTools } from "../../tools/remote";
import { Refusal } from "../../tools/tools";
import type { Bench } from "../bench";

/** Between two asks of a scan that has not come to its stop, ms. */
const AGAIN = 16;

export interface Stepper {
  /** Goes on to where this says. */
  go(go: Go): void;
  /** Lets the board run on. */
  release(): void;
}

/** Takes hold of the board at hand, which runs this text; `stood` hears where it stands. `null` where it keeps no program. */
export async function stepper(bench: Bench, tools: RemoteTools, text: Text, stood: (now: Stood) => void): Promise<Stepper | null> {
  return bench.where.value === "core" ? ofCore(bench, stood) : ofBoard(bench, tools, text, stood);
}

/** Where the firmwares of the simulated boards have what slow motion asks of them. */
const places = async (): Promise<Readonly<Record<BoardId, Places>>> => (await (await beside("slow.json")).json()) as Readonly<Record<BoardId, Places>>;

async function ofBoard(bench: Bench, tools: RemoteTools, text: Text, stood: (now: Stood) => void): Promise<Stepper | null> {
  const own = (await places())[bench.simulated.id];
  let held: (is: boolean) => void = () => undefined;
  const isHeld = new Promise<boolean>((resolve) => (held = resolve));
  let latest: Standing | null = null;
  const hear = (event: Event | OfSlow): void => {
    if (event.kind === "slow-held") held(event.is);
    if (event.kind !== "slow-stood") return;
    const { standing } = event;
    latest = standing;
    const { left, ...now } = standing;
    const trail = left.map(({ from, to, acc, value, inputs, outputs }) => [from, to, acc, value, inputs, outputs] as const);
    // One that came later has been told.
    const tell = (live: Live | null): void => {
      if (latest === standing) stood({ ...now, live });
    };
    void tools.ask("slow", { of: text, left: trail }).then(tell, (error: unknown) => {
      if (!(error instanceof Refusal)) throw error;
      tell(null);
    });
  };
  const { events } = bench as { events: Set<(event: Event | OfSlow) => void> };
  events.add(hear);
  bench.simulated.slowly({ kind: "slow-hold", places: own });
  if (!(await isHeld)) {
    events.delete(hear);
    return null;
  }
  return {
    go: (go) => {
      bench.simulated.slowly({ kind: "slow-go", go });
      bench.simulated.tell({ kind: "run" });
    },
    release: () => {
      events.delete(hear);
      bench.simulated.slowly({ kind: "slow-end" });
    },
  };
}

function ofCore(bench: Bench, stood: (now: Stood) => void): Stepper {
  let turn = 0;
  const ask = (go: Go, mine: number): void => {
    if (mine !== turn) return;
    const now = bench.slowly(go);
    if (now) stood(now);
    else setTimeout(() => ask(go, mine), AGAIN);
  };
  return { go: (go) => ask(go, (turn += 1)), release: () => void (turn += 1) };
}
