// The timing diagram as a picture for a report.

import { fixed } from "./numbers";
import type { Recorder } from "./recorder";

const LEFT = 150;
const WIDTH = 760;
const LANE = 34;

/** An SVG of these channels from one time to another, in ms. */
export function timingSvg(recorder: Recorder, channels: readonly { name: string; label: string }[], from: number, to: number): string {
  const height = channels.length * LANE + 44;
  const x = (time: number): number => LEFT + ((time - from) / Math.max(to - from, 1)) * WIDTH;
  const parts = channels.map(({ name, label }, lane) => {
    const base = 12 + lane * LANE + LANE - 8;
    const { times, values } = recorder.table([name], from, to);
    const own = values[0] ?? [];
    const seen = own.filter((value) => !Number.isNaN(value));
    const [least, most] = [Math.min(0, ...seen), Math.max(1, ...seen)];
    let path = "";
    times.forEach((time, index) => {
      const value = own[index] ?? Number.NaN;
      if (Number.isNaN(value)) return;
      const y = (base - ((value - least) / (most - least)) * (LANE - 14)).toFixed(1);
      path += path ? `H${x(time).toFixed(1)}V${y}` : `M${x(time).toFixed(1)} ${y}`;
    });
    return `<text x="${LEFT - 10}" y="${base - 4}" text-anchor="end">${escape(label)}</text><path d="M${LEFT} ${base}H${LEFT + WIDTH}" stroke="#ddd"/><path d="${path}" stroke="#0b6b63" stroke-width="2"/>`;
  });
  const ticks = Array.from({ length: 6 }, (_, tick) => {
    const time = from + ((to - from) * tick) / 5;
    return `<text x="${x(time).toFixed(1)}" y="${height - 10}" text-anchor="middle">${fixed(time / 1000, 2)} s</text>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${LEFT + WIDTH + 40} ${height}" width="${LEFT + WIDTH + 40}" height="${height}" font-family="Helvetica, Arial, sans-serif" font-size="13" fill="none"><rect width="100%" height="100%" fill="#fff"/><g fill="#1a1a1a">${""}</g>${[...parts, ...ticks].join("").replaceAll("<text", '<text fill="#1a1a1a"')}</svg>\n`;
}

function escape(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}
