// The file of a panel in TOML, as the gateway reads it.

import type { Both } from "../tools/answers";
import type { Panel } from "./ask";

/** A text as TOML writes it: JSON's escapes are TOML's, but for one. */
const quoted = (text: string): string => JSON.stringify(text).replaceAll("\u007f", "\\u007f");
/** A number as TOML reads it: 1e21 is a float there too. */
const plain = (number: number): string => String(number);
const both = ({ en, pt }: Both): string => (en === pt ? quoted(en) : `{ en = ${quoted(en)}, pt = ${quoted(pt)} }`);

/** What the site file names. A drawing stays a file of its own, of the same name. */
export function panelFile(panel: Panel): string {
  const lines = [`title = ${both(panel.title)}`, `columns = ${panel.columns}`];
  if (panel.drawing !== undefined) lines.push(`drawing = ${quoted(`${panel.name}.svg`)}`);
  for (const item of panel.items) {
    lines.push("", "[[item]]", `show = ${quoted(item.show)}`, `point = ${quoted(`${item.board}.${item.point}`)}`, `label = ${both(item.label)}`);
    if (item.unit) lines.push(`unit = ${quoted(item.unit)}`);
    lines.push(`least = ${plain(item.least)}`, `most = ${plain(item.most)}`);
    if (item.at) lines.push(`at = [${item.at.join(", ")}]`);
    lines.push(`size = [${item.size.map((of, at) => (at === 0 ? Math.min(of, panel.columns) : of)).join(", ")}]`);
  }
  for (const bind of panel.binds) {
    lines.push("", "[[bind]]", `id = ${quoted(bind.id)}`, `point = ${quoted(`${bind.board}.${bind.point}`)}`, `does = ${quoted(bind.does)}`, `least = ${plain(bind.least)}`, `most = ${plain(bind.most)}`);
  }
  return `${lines.join("\n")}\n`;
}
