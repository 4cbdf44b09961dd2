// The entry to slow motion, which is loaded when somebody wants it.

import type { Session } from "../session";
import type { Places } from "./linked";
import { Slow, type Standing } from "./slow";

export { type Places, placesOf } from "./linked";
export { type Go, type Left, Slow, type Standing } from "./slow";

/** Takes hold of the board of a session: `tell` hears where it stands, and its time stands with it. Gives what lets it go on;
 * `null` where it keeps no program. */
export function hold(session: Session, places: Places, tell: (standing: Standing) => void): Slow | null {
  const slow = session.board && Slow.of(session.board, places);
  if (!slow) return null;
  session.stopper = (cycles) => {
    const standing = slow.run(cycles);
    if (standing) tell(standing);
    return standing !== null;
  };
  return slow;
}
