// The firmware as the flash holds it, and as Intel hex has it. Of that, as far as a firmware needs it: data, end, and where data above 64 KB begin.

const ERASED = 0xff;

/** The words of a flash of this length that begins with these bytes; `null` where they do not fit, or there are none. */
export function flashOf(bytes: Uint8Array, length: number): Uint16Array | null {
  if (bytes.length === 0 || bytes.length > length) return null;
  const flash = new Uint8Array(length).fill(ERASED);
  flash.set(bytes);
  return new Uint16Array(flash.buffer);
}

/** The words of a flash of so many bytes; `null` where the text is no Intel hex, a checksum is wrong, or something does not fit. */
export function readHex(text: string, length: number): Uint16Array | null {
  let base = 0;
  const flash = new Uint8Array(length).fill(ERASED);
  for (const line of text.split(/\r?\n/)) {
    if (line === "") continue;
    const record = readRecord(line);
    if (!record) return null;
    const { kind, address, data } = record;
    if (kind === 1) return new Uint16Array(flash.buffer);
    if (kind !== 0) {
      const [high = 0, low = 0] = data;
      // Where the program starts says nothing but 0.
      if (kind === 2) base = ((high << 8) | low) << 4;
      else if (kind === 4) base = ((high << 8) | low) * 0x1_0000;
      else if (data.some((byte) => byte !== 0)) return null;
      continue;
    }
    if (base + address + data.length > length) return null;
    flash.set(data, base + address);
  }
  return null;
}

interface HexRecord {
  readonly kind: number;
  readonly address: number;
  readonly data: Uint8Array;
}

/** `:LLAAAATT` and the data, and a byte that makes the sum of all 0. */
function readRecord(line: string): HexRecord | null {
  if (!/^:([0-9A-Fa-f]{2}){5,}$/.test(line)) return null;
  const bytes = Uint8Array.from({ length: (line.length - 1) / 2 }, (_, at) => parseInt(line.slice(1 + 2 * at, 3 + 2 * at), 16));
  const [length = 0, high = 0, low = 0, kind = 0] = bytes;
  const sum = bytes.reduce((sum, byte) => (sum + byte) & 0xff, 0);
  if (bytes.length !== length + 5 || sum !== 0 || kind > 5) return null;
  return { kind, address: (high << 8) | low, data: bytes.subarray(4, 4 + length) };
}
