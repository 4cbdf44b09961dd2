// The line to a board at a port of this computer (WebSerial).

import type { SerialFormat } from "unoclp-uno";
import type { Line, Listener } from "./line";

const PULSE = 120;

export class PortLine implements Line {
  private listener: Listener | null = null;
  private reader: ReadableStreamDefaultReader<Uint8Array> | null = null;
  private reading: Promise<void> = Promise.resolve();
  private writing: Promise<void> = Promise.resolve();
  private pulsing: Promise<void> = Promise.resolve();

  constructor(private readonly port: SerialPort) {}

  async open(format: SerialFormat, listener: Listener): Promise<void> {
    if (this.listener) await this.shut();
    await this.port.open({ baudRate: format.baud, parity: format.parity, bufferSize: 4096 });
    this.listener = listener;
    this.reading = this.read();
  }

  write(bytes: Uint8Array): Promise<void> {
    const { writable } = this.port;
    if (!this.listener || !writable) return Promise.reject(new Error("the line is closed"));
    const write = async (): Promise<void> => {
      const writer = writable.getWriter();
      try {
        await writer.write(bytes);
      } finally {
        writer.releaseLock();
      }
    };
    this.writing = this.writing.then(write, write);
    return this.writing;
  }

  /** Pulls DTR and RTS, as the tools of Arduino do. Nobody closes the port meanwhile: the end of the pulse would reset the
   * board that somebody else speaks to by then. */
  reset(): Promise<void> {
    this.pulsing = this.pulse();
    return this.pulsing;
  }

  private async pulse(): Promise<void> {
    await this.port.setSignals({ dataTerminalReady: false, requestToSend: false });
    await new Promise((resolve) => setTimeout(resolve, PULSE));
    await this.port.setSignals({ dataTerminalReady: true, requestToSend: true });
  }

  async close(): Promise<void> {
    const listener = this.listener;
    await this.shut();
    listener?.closed("asked");
  }

  private async shut(): Promise<void> {
    if (!this.listener) return;
    this.listener = null;
    await this.reader?.cancel().catch(() => undefined);
    await this.reading;
    await this.writing.catch(() => undefined);
    await this.pulsing.catch(() => undefined);
    await this.port.close().catch(() => undefined);
  }

  /** Passes on what comes until the line is closed. What a port calls an error of a byte is passed over. */
  private async read(): Promise<void> {
    while (this.listener && this.port.readable) {
      this.reader = this.port.readable.getReader();
      try {
        for (let part = await this.reader.read(); !part.done; part = await this.reader.read()) this.listener?.bytes(part.value);
      } catch {
        // A framing error leaves a new stream behind; a board that is unplugged leaves none.
      } finally {
        this.reader.releaseLock();
        this.reader = null;
      }
    }
    const listener = this.listener;
    this.listener = null;
    if (listener) {
      await this.port.close().catch(() => undefined);
      listener.closed("lost");
    }
  }
}
