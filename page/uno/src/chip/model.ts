// The chips of the boards: their memories, the places of their peripherals, and their interrupts (ATmega328P datasheet,
// sections 12 and 36; ATmega2560 datasheet, sections 14 and 33). avr8js has the first of them, and the ports of both.

import {
  type AVRPortConfig,
  type AVRTimerConfig,
  adcConfig,
  portAConfig,
  portBConfig,
  portCConfig,
  portDConfig,
  portEConfig,
  portFConfig,
  portGConfig,
  portHConfig,
  portJConfig,
  portKConfig,
  portLConfig,
  spiConfig,
  timer0Config,
  timer1Config,
  timer2Config,
  watchdogConfig,
} from "avr8js";

export type Port = "A" | "B" | "C" | "D" | "E" | "F" | "G" | "H" | "J" | "K" | "L";

export interface Model {
  /** Bytes of the flash. */
  readonly flash: number;
  /** First address of the RAM, and its bytes. */
  readonly ram: number;
  readonly ramLen: number;
  /** Bytes of the EEPROM. */
  readonly eeprom: number;
  readonly ports: Readonly<Partial<Record<Port, AVRPortConfig>>>;
  readonly timers: readonly AVRTimerConfig[];
  /** Interrupts, as words of the flash: of USART0 the first of three, for a byte that came. */
  readonly received: number;
  readonly spi: number;
  readonly converted: number;
  readonly eepromReady: number;
  readonly watchdog: number;
}

export const ATMEGA328P: Model = {
  flash: 32 * 1024,
  ram: 0x100,
  ramLen: 2048,
  eeprom: 1024,
  ports: { B: portBConfig, C: portCConfig, D: portDConfig },
  timers: [timer0Config, timer1Config, timer2Config],
  received: 0x24,
  spi: spiConfig.spiInterrupt,
  converted: adcConfig.adcInterrupt,
  eepromReady: 0x2c,
  watchdog: watchdogConfig.watchdogInterrupt,
};

/** A port whose pins ask for no interrupt: those of the ATmega2560 stand elsewhere, and the firmware has no use for them. */
const quiet = ({ PIN, DDR, PORT }: AVRPortConfig): AVRPortConfig => ({ PIN, DDR, PORT, externalInterrupts: [] });

/** The interrupts of a timer from that of its unit A on, where it has three units; `capture` stands before them. */
const vectors = (first: number) => ({ compAInterrupt: first, compBInterrupt: first + 2, compCInterrupt: first + 4, ovfInterrupt: first + 6, captureInterrupt: first - 2 });

/** A timer of 16 bits with three units, all at one port, whose pins stand in a row. */
const wide = (first: number, control: number, number: number, port: AVRPortConfig): AVRTimerConfig => ({
  ...timer1Config,
  ...vectors(first),
  TCCRA: control,
  TCCRB: control + 1,
  TCCRC: control + 2,
  TCNT: control + 4,
  ICR: control + 6,
  OCRA: control + 8,
  OCRB: control + 10,
  OCRC: control + 12,
  TIMSK: timer0Config.TIMSK + number,
  TIFR: timer0Config.TIFR + number,
  compPortA: port.PORT,
  compPinA: 3,
  compPortB: port.PORT,
  compPinB: 4,
  compPortC: port.PORT,
  compPinC: 5,
  externalClockPort: 0,
});

export const ATMEGA2560: Model = {
  flash: 256 * 1024,
  ram: 0x200,
  ramLen: 8192,
  eeprom: 4096,
  ports: {
    A: quiet(portAConfig),
    B: quiet(portBConfig),
    C: quiet(portCConfig),
    D: quiet(portDConfig),
    E: quiet(portEConfig),
    F: quiet(portFConfig),
    G: quiet(portGConfig),
    H: quiet(portHConfig),
    J: quiet(portJConfig),
    K: quiet(portKConfig),
    L: quiet(portLConfig),
  },
  timers: [
    { ...timer0Config, compAInterrupt: 0x2a, compBInterrupt: 0x2c, ovfInterrupt: 0x2e, compPortA: portBConfig.PORT, compPinA: 7, compPortB: portGConfig.PORT, compPinB: 5 },
    { ...timer1Config, ...vectors(0x22), OCRC: 0x8c, compPortA: portBConfig.PORT, compPinA: 5, compPortB: portBConfig.PORT, compPinB: 6, compPortC: portBConfig.PORT, compPinC: 7 },
    { ...timer2Config, compAInterrupt: 0x1a, compBInterrupt: 0x1c, ovfInterrupt: 0x1e, compPortA: portBConfig.PORT, compPinA: 4, compPortB: portHConfig.PORT, compPinB: 6 },
    wide(0x40, 0x90, 3, portEConfig),
    wide(0x54, 0xa0, 4, portHConfig),
    wide(0x5e, 0x120, 5, portLConfig),
  ],
  received: 0x32,
  spi: 0x30,
  converted: 0x3a,
  eepromReady: 0x3c,
  watchdog: 0x18,
};
