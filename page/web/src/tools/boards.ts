// What the boards have. To be asked of Rust (`board`), as soon as it tells.

import type { BoardFacts } from "./answers";

export const UNO: BoardFacts = {
  name: "uno",
  title: "Arduino UNO",
  inputs: 8,
  ownInputs: 4,
  outputs: 4,
  analogue: 5,
  pwm: [1, 4],
  markers: 64,
  registers: 98,
  counters: 16,
  timers: 99,
  stored: 900,
  linked: 960,
  isHardware: true,
};
