// Firmware on its way to a board: Rust says what is sent and when; here are the line and the clock.

import type { Line } from "../line/line";
import type { Both } from "../tools/answers";
import type { Tools } from "../tools/tools";
import { say } from "../words/words";

/** Writes a firmware, of Intel hex, through the boot loader of a board; gives why it is not on it, or null. */
export async function flash(tools: Tools, line: Line, hex: string, model: string, progress: (share: number) => void): Promise<Both | null> {
  const baud = tools.ask("flash", { hex, model });
  let came: number[] = [];
  let wake = (): void => undefined;
  await line.open({ baud, parity: "none" }, {
    bytes: (bytes) => {
      for (const byte of bytes) came.push(byte);
      wake();
    },
    closed: (why) => {
      if (why === "lost") tools.ask("flashLose", { why: say("cableOut") });
      wake();
    },
  });
  try {
    for (;;) {
      const heard = came;
      came = [];
      const step = tools.ask("flashStep", { now: performance.now(), came: heard });
      if (step.over) return step.failure;
      progress(step.progress[0] / Math.max(step.progress[1], 1));
      try {
        if (step.reset) {
          await line.reset();
          came = [];
        }
        if (step.send.length > 0) await line.write(Uint8Array.from(step.send));
      } catch (error) {
        tools.ask("flashLose", { why: error instanceof Error ? error.message : String(error) });
        continue;
      }
      if (came.length > 0) continue;
      await new Promise<void>((resolve) => {
        const timer = setTimeout(resolve, Math.max(step.until - performance.now(), 0));
        wake = () => {
          clearTimeout(timer);
          resolve();
        };
      });
    }
  } finally {
    await line.close();
  }
}
