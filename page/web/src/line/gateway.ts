// The line to a board that `unoclp serve` shares (docs/remote.md): a WebSocket, on which each message is a whole frame.

import type { SerialFormat } from "unoclp-uno";
import type { Line, Listener } from "./line";

/** What the gateway says of the board and of what a visitor may do. */
export interface Shared {
  readonly role: "watch" | "control";
  /** The board's address on its line. */
  readonly address: number;
  /** The port at which it is. */
  readonly name: string;
}

export class GatewayLine implements Line {
  private socket: WebSocket | null = null;
  private listener: Listener | null = null;

  /** `told` hears what the gateway says of the board. */
  constructor(
    private readonly url: string,
    private readonly token: string,
    private readonly told: (shared: Shared) => void,
  ) {}

  /** The gateway speaks to the board in its own format. */
  async open(_format: SerialFormat, listener: Listener): Promise<void> {
    await this.close();
    const socket = new WebSocket(this.url);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    await new Promise<void>((resolve, reject) => {
      socket.onopen = () => socket.send(this.token);
      socket.onclose = ({ reason }) => reject(new Error(reason || "unoclp serve"));
      socket.onmessage = ({ data }: MessageEvent<unknown>) => {
        const shared = sharedOf(data);
        if (!shared) return;
        this.told(shared);
        resolve();
      };
    });
    this.listener = listener;
    socket.onmessage = ({ data }: MessageEvent<unknown>) => {
      if (data instanceof ArrayBuffer) listener.bytes(new Uint8Array(data));
    };
    socket.onclose = () => {
      if (this.socket !== socket) return;
      this.socket = this.listener = null;
      listener.closed("lost");
    };
  }

  async write(bytes: Uint8Array): Promise<void> {
    if (!this.socket || !this.listener) throw new Error("the line is closed");
    this.socket.send(Uint8Array.from(bytes));
  }

  /** Nobody pulls RESET from afar: a restart is a command of its own. */
  async reset(): Promise<void> {
    throw new Error("a board that is shared cannot be reset");
  }

  async close(): Promise<void> {
    const { socket, listener } = this;
    this.socket = this.listener = null;
    socket?.close();
    listener?.closed("asked");
  }
}

/** What a text of the gateway says of the board, if it does. */
function sharedOf(data: unknown): Shared | null {
  if (typeof data !== "string") return null;
  const { role, address, name } = JSON.parse(data) as Record<string, unknown>;
  if ((role !== "watch" && role !== "control") || typeof address !== "number" || typeof name !== "string") return null;
  return { role, address, name };
}
