// The converter: avr8js' own, whose flag can be cleared as on the chip, and with pins that may be open.

import { ADCMuxInputType, AVRADC, type CPU, adcConfig } from "avr8js";
import { ADCSRA, ADIF, ADSC } from "./registers";

/** The highest reading. */
const HIGHEST = 1023;
/** The thermometer at 25 °C, mV. */
const THERMOMETER = 314;

/** Connects a converter with this interrupt; `millivolts` is the voltage at a channel. */
export function converter(cpu: CPU, adcInterrupt: number, millivolts: (channel: number) => number): void {
  const adc = new AVRADC(cpu, { ...adcConfig, adcInterrupt });
  adc.onADCRead = (input) => {
    const at =
      input.type === ADCMuxInputType.SingleEnded ? millivolts(input.channel)
      : input.type === ADCMuxInputType.Constant ? 1000 * input.voltage
      : THERMOMETER;
    const reading = Math.floor((at * (HIGHEST + 1)) / (1000 * adc.referenceVoltage));
    const result = Math.min(Math.max(reading, 0), HIGHEST);
    cpu.addClockEvent(() => adc.completeADCRead(result), adc.sampleCycles);
  };
  // A 1 written to the flag clears it; a 0 written to a conversion that goes on does not end it.
  const write = cpu.writeHooks[ADCSRA];
  cpu.writeHooks[ADCSRA] = (value, old, address, mask) => {
    const kept = (old & ADIF & ~value) | (old & ADSC);
    return write?.((value & ~ADIF) | kept, old, address, mask);
  };
}
