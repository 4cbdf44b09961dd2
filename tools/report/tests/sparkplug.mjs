// Reads messages of Sparkplug B by npm's sparkplug-payload, as sparkplug.py does by pysparkplug: verb, device and hexadecimal
// digits a line, JSON a line.

import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const require = createRequire(new URL("../../../page/package.json", import.meta.url));
const { decodePayload } = require("sparkplug-payload").get("spBv1.0");

/** A number as JSON has it: 64 bits come as an object of their own. */
const plain = (value) => (value !== null && typeof value === "object" ? Number(value) : (value ?? null));

for await (const line of createInterface({ input: process.stdin })) {
  const [verb, device, digits] = line.split(" ");
  const payload = decodePayload(Buffer.from(digits, "hex"));
  const seq = payload.seq === undefined || verb === "NDEATH" ? null : plain(payload.seq);
  const told = { verb, device, seq };
  for (const metric of payload.metrics) {
    if (verb === "NDEATH") {
      told.bd_seq = plain(metric.value);
      continue;
    }
    told.metrics ??= {};
    told.metrics[metric.name] = [metric.type.toUpperCase(), plain(metric.value), metric.isHistorical ?? false, metric.isNull ?? (metric.value ?? null) === null];
  }
  console.log(JSON.stringify(told));
}
