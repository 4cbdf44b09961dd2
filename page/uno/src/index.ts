// The one entry to the simulated UNO: what its worker is told and tells, what is wired to it, and the form of what it flashes.

export { readHex } from "./hex";
export type * from "./machine";
export { WIRINGS } from "./wiring";
export type * from "./messages";
export { type Scope, serve } from "./serve";
