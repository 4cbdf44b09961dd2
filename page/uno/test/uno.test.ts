// The firmware on the simulated UNO, with what is connected to it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { BLOCK_LEN } from "../src/messages";
import { type Fixture, card, ms, newBoard, poweredBoard, runningBoard } from "./fixture";
import { answer, request } from "./modbus";

/** What a board answers to a request. */
function ask({ board, notes }: Fixture, ...bytes: number[]): number[] | null {
  notes.bytes = [];
  board.send(request(...bytes));
  board.run(ms(20));
  return answer(notes.bytes);
}

/** Discrete inputs 0 to 7. */
const READ_INPUTS = [2, 0, 0, 0, 8];

test("a program from a card runs, and buttons and outputs are at its pins", () => {
  const { board, notes } = runningBoard("motor");
  assert.match(notes.text, /unoclp \d+\.\d+\.\d+\r\nprogram: 19 codes/);
  const { surroundings } = board;
  for (const [input, closed, outputs] of [[1, true, 1], [1, false, 1], [2, true, 1], [3, true, 0], [2, false, 0], [4, true, 8]] as const) {
    board.press(input, closed);
    board.run(ms(20));
    assert.equal(surroundings.outputs, outputs, `input ${input} ${closed ? "closed" : "open"}`);
  }
  assert.deepEqual(notes.outputs, [{ output: 1, high: true }, { output: 1, high: false }, { output: 4, high: true }]);
});

test("the switch STOP turns the outputs off, and LED L flashes", () => {
  const { board } = runningBoard("motor");
  board.takePins();
  board.press(4, true);
  board.run(ms(500));
  // But for the moments in which the state is written to the card.
  assert.ok(board.takePins().led > 0.9);
  board.setStop(true);
  board.run(ms(50));
  assert.equal(board.surroundings.outputs, 0);
  board.takePins();
  board.run(ms(4096));
  const { led } = board.takePins();
  assert.ok(led > 0.08 && led < 0.12, `LED L at ${led}`);
  board.setStop(false);
  board.run(ms(50));
  assert.equal(board.surroundings.outputs, 8);
});

test("LED L flickers while the card is read", () => {
  const { board, notes } = poweredBoard("motor");
  let flickered = 0;
  for (let at = 0; at < 300 && !notes.text.includes("RUN"); at += 10) {
    board.run(ms(10));
    const { led } = board.takePins();
    if (led > 0.05 && led < 0.6) flickered += 1;
  }
  assert.ok(flickered > 2, `${flickered} times`);
});

test("a program that was kept runs without its card", () => {
  const { board } = runningBoard("motor");
  const alone = newBoard();
  alone.board.eeprom.bytes.set(board.eeprom.bytes);
  alone.board.plug(true);
  alone.board.run(ms(1000));
  assert.match(alone.notes.text, /no card answers.*\r\nthe program that was stored runs[^]*RUN\r\n$/);
});

test("a faulty program is told with its line, and an empty slot with what to look at", () => {
  const wrong = poweredBoard("wrong");
  wrong.board.run(ms(1000));
  assert.match(wrong.notes.text, /fault 24, line 3: no such code/);
  const empty = newBoard();
  empty.board.plug(true);
  empty.board.run(ms(1000));
  assert.match(empty.notes.text, /fault 51: no card answers/);
  assert.equal(empty.notes.outputs.length, 0);
});

test("the state is written to the card's STATE.TXT, and only there", () => {
  const { board, notes } = runningBoard("motor");
  const image = card("motor");
  board.press(4, true);
  board.run(ms(2500));
  assert.ok(notes.blocks.length >= 1);
  assert.equal(new Set(notes.blocks).size, 1);
  const [block = 0] = notes.blocks;
  const text = new TextDecoder().decode(image.subarray(block * BLOCK_LEN, (block + 1) * BLOCK_LEN));
  assert.match(text, /^unoclp state/);
});

test("a card that is pulled out does not stop the program, and one that is put in is read at the next start", () => {
  const fixture = runningBoard("motor");
  const { board, notes } = fixture;
  board.press(4, true);
  board.insert(null);
  board.run(ms(3000));
  assert.equal(board.surroundings.outputs, 8);
  const before = notes.blocks.length;
  board.press(4, false);
  board.run(ms(3000));
  assert.equal(notes.blocks.length, before);

  notes.text = "";
  board.insert(card("memory"));
  board.reset();
  board.run(ms(1000));
  assert.match(notes.text, /program: 8 codes/);
});

test("a card that is pulled out in the middle of its reading is a fault with its number", () => {
  const { board, notes } = poweredBoard("motor");
  // Each look is a fraction of a block.
  for (let at = 0; at < 3000 && board.takePins().led < 0.2; at += 1) board.run(ms(0.1));
  board.insert(null);
  board.run(ms(3000));
  assert.match(notes.text, /fault \d+: /);
  assert.equal(board.surroundings.outputs, 0);
});

test("PWM is seen as brightness, and its pulses are no edges", () => {
  const { board, notes } = runningBoard("dimmer");
  for (const reading of [0, 1, 64, 128, 255, 1023]) {
    board.setAnalogue(0, { reading });
    board.run(ms(100));
    board.takePins();
    board.run(ms(400));
    const { outputs } = board.takePins();
    const duty = Math.min(reading, 255);
    for (const output of [outputs[0] ?? NaN, outputs[3] ?? NaN]) {
      assert.ok(Math.abs(output - duty / 255) < 0.01, `reading ${reading}: ${output}`);
    }
    assert.deepEqual([outputs[1], outputs[2]], [0, 0]);
  }
  assert.equal(notes.outputs.length, 0);
});

test("an analogue input reads voltages and readings, and a button beside it closes it to ground", () => {
  const fixture = runningBoard("dimmer");
  const { board } = fixture;
  for (const [to, expected] of [
    [{ millivolts: 0 }, 0],
    [{ millivolts: 2500 }, 512],
    [{ millivolts: 5000 }, 1023],
    [{ reading: 777 }, 777],
    ["open", 0],
  ] as const) {
    board.setAnalogue(0, to);
    board.run(ms(50));
    // Input register 0: A 00.
    const told = ask(fixture, 4, 0, 0, 0, 1);
    assert.deepEqual(told, [2, expected >> 8, expected & 0xff], JSON.stringify(to));
  }
  board.setAnalogue(0, { reading: 777 });
  board.press(5, true);
  board.run(ms(50));
  assert.deepEqual(ask(fixture, 4, 0, 0, 0, 1), [2, 0, 0]);
});

test("Modbus is answered on a line of the same form, and met by silence on another", () => {
  const fixture = runningBoard("motor");
  const { board } = fixture;
  board.press(2, true);
  board.run(ms(20));
  assert.deepEqual(ask(fixture, ...READ_INPUTS), [1, 2]);
  for (const format of [{ baud: 9600, parity: "none" }, { baud: 115_200, parity: "even" }] as const) {
    board.setLine(format);
    assert.equal(ask(fixture, ...READ_INPUTS), null);
    board.run(ms(100));
  }
  board.setLine({ baud: 115_200, parity: "none" });
  assert.deepEqual(ask(fixture, ...READ_INPUTS), [1, 2]);
});

test("requests that come at once are answered as far as they leave room for silence", () => {
  const fixture = runningBoard("motor");
  const { board, notes } = fixture;
  notes.bytes = [];
  for (let n = 0; n < 20; n += 1) {
    board.send(request(...READ_INPUTS));
    board.run(ms(15));
  }
  assert.equal(notes.bytes.length, 20 * 6);
});

test("a retentive marker outlasts the plug, and a cut in the middle of its writing leaves an old or a new state", () => {
  const { board } = runningBoard("memory");
  board.press(1, true);
  board.run(ms(200));
  board.press(1, false);
  board.run(ms(400));
  assert.equal(board.surroundings.outputs, 1);
  board.plug(false);
  assert.equal(board.surroundings.outputs, 0);
  board.plug(true);
  board.run(ms(1000));
  assert.equal(board.surroundings.outputs, 1);

  board.pullPlugAtWrite(true);
  board.press(2, true);
  board.run(ms(500));
  assert.equal(board.hasPower, false);
  board.press(2, false);
  board.plug(true);
  board.run(ms(1000));
  assert.ok([0, 1].includes(board.surroundings.outputs));
});

test("the button RESET starts the program again", () => {
  const { board, notes } = runningBoard("motor");
  board.press(1, true);
  board.run(ms(20));
  board.press(1, false);
  board.run(ms(20));
  assert.equal(board.surroundings.outputs, 1);
  notes.text = "";
  board.reset();
  board.run(ms(1000));
  assert.equal(board.surroundings.outputs, 0);
  assert.match(notes.text, /RUN\r\n$/);
  assert.deepEqual(notes.resets, ["power", "button"]);
});

test("a board that bounces runs its program all the same, and its contact moves more than once", () => {
  const { board } = runningBoard("motor");
  board.bouncing = true;
  board.press(4, true);
  let moves = 0;
  let before = board.takePins().closed;
  for (let at = 0; at < 10; at += 0.05) {
    board.run(ms(0.05));
    const { closed } = board.takePins();
    if (closed !== before) moves += 1;
    before = closed;
  }
  assert.ok(moves >= 2, `${moves} moves`);
  assert.equal(board.surroundings.outputs, 8);
});

test("a millisecond of a running board has few events: that is what makes it fast", () => {
  const { board } = runningBoard("motor");
  const cpu = board.inside?.cpu;
  assert.ok(cpu);
  let events = 0;
  const add = cpu.addClockEvent.bind(cpu);
  cpu.addClockEvent = (callback, cycles) => {
    events += 1;
    return add(callback, cycles);
  };
  // No block of the card is written in this time.
  board.run(ms(100));
  // The clock's overflow, and ten conversions of 0.1 ms; avr8js' own timers have 2,000 more.
  assert.ok(events > 500 && events < 1300, `${events} in 100 ms`);
});
