// A program that is right and does not fit: what the board and the compiler say of it is worth seeing once.

import type { BoardFacts, Text } from "../tools/answers";

/** Bytes that each of its rungs takes in the stored form, at least. */
const RUNG = 3;

/** Instruction List of so many rungs that this board does not hold it. */
export function tooLarge({ name, inputs, markers, stored }: BoardFacts): Text {
  const rungs = Array.from({ length: Math.ceil(stored / RUNG) }, (_, index) => {
    const marker = (further: number): number => ((index + further) % markers) + 1;
    return `LD   I${(index % inputs) + 1}\nANDN M${marker(0)}\nST   M${marker(7)}\n`;
  });
  return { name: "too-large.il", text: `(* Too large for the ${name} - Grande demais para o ${name} *)\n${rungs.join("")}` };
}
