// The one entry to the simulated UNO: what its worker is told and tells, and the form of what it flashes.

export { readHex } from "./hex";
export type * from "./messages";
