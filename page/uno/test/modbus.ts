// Modbus RTU frames, as far as the tests ask a board something.

/** A request to server 1, with its checksum. */
export function request(...bytes: number[]): Uint8Array {
  const frame = [1, ...bytes];
  return Uint8Array.from([...frame, ...sum(frame)]);
}

/** What stands in an answer behind server and function, if its checksum is right; `null` otherwise. */
export function answer(bytes: readonly number[]): number[] | null {
  const [low, high] = sum(bytes.slice(0, -2));
  return bytes.length > 4 && bytes.at(-2) === low && bytes.at(-1) === high ? bytes.slice(2, -2) : null;
}

function sum(bytes: readonly number[]): [number, number] {
  let crc = 0xffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? (crc >> 1) ^ 0xa001 : crc >> 1;
  }
  return [crc & 0xff, crc >> 8];
}
