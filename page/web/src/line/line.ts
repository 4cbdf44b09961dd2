// The line to a board: bytes out, bytes in. What is at its other end, a simulated board or a port, nobody else knows.

import type { SerialFormat } from "unoclp-uno";

/** Why a line is closed: asked for, or what the system said. */
export type Closed = "asked" | "lost";

/** Who listens to a line. */
export interface Listener {
  /** Bytes that have come, in order. */
  bytes(bytes: Uint8Array): void;
  /** The line is closed, and will not speak again until it is opened. */
  closed(why: Closed): void;
}

export interface Line {
  /** Opens it, or throws an `Error` with what the system said. Opened a second time it takes the new format. */
  open(format: SerialFormat, listener: Listener): Promise<void>;
  /** Sends bytes in order; done as soon as they are on their way. Throws if the line is closed. */
  write(bytes: Uint8Array): Promise<void>;
  /** Pulls RESET, as the button of the board does. */
  reset(): Promise<void>;
  /** Closes it; nothing happens if it is. */
  close(): Promise<void>;
}
