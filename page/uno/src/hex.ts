// The firmware as the flash holds it, and as Intel hex has it. Of that, as far as a firmware for this chip needs it: data, end, and segments of 0.

/** Bytes of the flash. */
export const FLASH_LEN = 32 * 1024;
const ERASED = 0xff;

/** The words of a flash that begins with these bytes; `null` where they do not fit, or there are none. */
export function flashOf(bytes: Uint8Array): Uint16Array | null {
  if (bytes.length === 0 || bytes.length > FLASH_LEN) return null;
  const flash = new Uint8Array(FLASH_LEN).fill(ERASED);
  flash.set(bytes);
  return new Uint16Array(flash.buffer);
}

/** The words of the flash; `null` where the text is no Intel hex, a check sum is wrong, or something does not fit. */
export function readHex(text: string): Uint16Array | null {
  const flash = new Uint8Array(FLASH_LEN).fill(ERASED);
  for (const line of text.split(/\r?\n/)) {
    if (line === "") continue;
    const record = readRecord(line);
    if (!record) return null;
    const { kind, address, data } = record;
    if (kind === 1) return new Uint16Array(flash.buffer);
    // An address above 64 KB, or where the program starts: neither says anything but 0 for this chip.
    if (kind !== 0) {
      if (data.some((byte) => byte !== 0)) return null;
      continue;
    }
    if (address + data.length > FLASH_LEN) return null;
    flash.set(data, address);
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
