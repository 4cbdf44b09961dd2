// Characters on the line, and the chip's port with its buffers and errors.

import { CPU } from "avr8js";
import assert from "node:assert/strict";
import { test } from "node:test";
import { ATMEGA328P } from "../src/chip/model";
import { UBRRL, UCSRA, UCSRB, UCSRC, UDR } from "../src/chip/registers";
import { Usart } from "../src/chip/usart";
import { type Setting, lengthOf, read, settingOf } from "../src/serial";

const FAST: Setting = settingOf({ baud: 115_200, parity: "none" });
const EVEN: Setting = settingOf({ baud: 19_200, parity: "even" });
const ODD: Setting = settingOf({ baud: 19_200, parity: "odd" });
const ALL = Array.from({ length: 256 }, (_, byte) => byte);

test("a receiver of the same form reads what was sent, also at a rate that is 2 % off", () => {
  for (const setting of [FAST, EVEN, ODD]) {
    for (const factor of [0.98, 1, 1.02]) {
      const by = { ...setting, bit: setting.bit * factor };
      for (const byte of ALL) assert.deepEqual(read(byte, setting, by), { byte, framing: false, parity: false });
    }
  }
});

test("a receiver of the other parity finds each byte damaged", () => {
  for (const byte of ALL) assert.deepEqual(read(byte, EVEN, ODD), { byte, framing: false, parity: true });
});

test("a receiver of another rate misreads most bytes", () => {
  const by = settingOf({ baud: 38_400, parity: "none" });
  const right = ALL.filter((byte) => read(byte, FAST, by).byte === byte);
  assert.ok(right.length < 10, `${right.length} bytes came right`);
});

const RXEN = 1 << 4;
const TXEN = 1 << 3;
const [RXC, TXC, UDRE, FE, DOR, UPE] = [1 << 7, 1 << 6, 1 << 5, 1 << 4, 1 << 3, 1 << 2];

/** A port at 115200 baud 8N1, with receiver and transmitter on. */
function port(): { cpu: CPU; usart: Usart; sent: number[]; status: () => number; pass: (cycles: number) => void } {
  const cpu = new CPU(new Uint16Array(64), ATMEGA328P.ramLen);
  const sent: number[] = [];
  const usart = new Usart(cpu, ATMEGA328P.received, (byte) => sent.push(byte));
  cpu.writeData(UCSRA, 2);
  cpu.writeData(UBRRL, 16);
  cpu.writeData(UCSRB, RXEN | TXEN);
  const pass = (cycles: number): void => {
    for (let n = 0; n < cycles; n += 1) {
      cpu.cycles += 1;
      cpu.tick();
    }
  };
  return { cpu, usart, sent, status: () => cpu.readData(UCSRA) & ~2, pass };
}

function good(byte: number): { byte: number; framing: boolean; parity: boolean } {
  return { byte, framing: false, parity: false };
}

test("the port holds three bytes, and tells that it has lost one", () => {
  const { cpu, usart, status } = port();
  for (const byte of [1, 2, 3, 4]) usart.receive(good(byte));
  const seen = [];
  while (status() & RXC) seen.push([status() & DOR, cpu.readData(UDR)]);
  assert.deepEqual(seen, [[0, 1], [0, 2], [DOR, 4]]);
  assert.equal(cpu.readData(UDR), 0);
});

test("errors belong to the byte that is read next", () => {
  const { cpu, usart, status } = port();
  usart.receive({ byte: 1, framing: true, parity: false });
  usart.receive({ byte: 2, framing: false, parity: true });
  usart.receive(good(3));
  const seen = [];
  while (status() & RXC) seen.push([status() & (FE | UPE), cpu.readData(UDR)]);
  assert.deepEqual(seen, [[FE, 1], [UPE, 2], [0, 3]]);
});

test("a receiver that is off hears nothing, and forgets what it held", () => {
  const { cpu, usart, status } = port();
  usart.receive(good(1));
  cpu.writeData(UCSRB, TXEN);
  usart.receive(good(2));
  assert.equal(status() & RXC, 0);
  cpu.writeData(UCSRB, RXEN | TXEN);
  assert.equal(status() & RXC, 0);
});

test("a byte goes out as its stop bit ends, with room for one behind it", () => {
  const { cpu, sent, status, pass } = port();
  const length = lengthOf({ bit: 17 * 8, parity: "none" });
  assert.equal(status(), UDRE);
  cpu.writeData(UDR, 0x41);
  assert.equal(status(), UDRE);
  cpu.writeData(UDR, 0x42);
  assert.equal(status(), 0);
  // No room: it is lost.
  cpu.writeData(UDR, 0x43);
  pass(length - 1);
  assert.deepEqual(sent, []);
  pass(1);
  assert.deepEqual(sent, [0x41]);
  assert.equal(status(), UDRE);
  pass(length);
  assert.deepEqual(sent, [0x41, 0x42]);
  assert.equal(status(), UDRE | TXC);
  cpu.writeData(UCSRA, TXC | 2);
  assert.equal(status(), UDRE);
});

test("the port says how it is set", () => {
  const { cpu, usart } = port();
  assert.deepEqual(usart.setting, { bit: 136, parity: "none" });
  cpu.writeData(UCSRC, 0b11_0110);
  assert.deepEqual(usart.setting, { bit: 136, parity: "odd" });
  cpu.writeData(UCSRC, 0b10_0110);
  assert.deepEqual(usart.setting, { bit: 136, parity: "even" });
  cpu.writeData(UCSRA, 0);
  assert.deepEqual(usart.setting, { bit: 272, parity: "even" });
});
