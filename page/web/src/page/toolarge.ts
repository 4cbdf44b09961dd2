// A program that is right and does not fit: what the board and the compiler say of it is worth seeing once.

import type { Text } from "../tools/answers";

/** Instruction List of so many rungs that no UNO holds it. */
export function tooLarge(): Text {
  const rungs = Array.from({ length: 320 }, (_, index) => `LD   I${(index % 4) + 1}\nANDN M${(index % 60) + 1}\nST   M${((index + 7) % 60) + 1}\n`);
  return { name: "too-large.il", text: `(* Too large for the UNO - Grande demais para o UNO *)\n${rungs.join("")}` };
}
