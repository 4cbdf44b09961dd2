// How often a program of 200 contacts is read of the simulated board, in a real Chromium: `npm run bench`.
// @ts-check

import { Lab, run, type } from "../page/harness.mjs";
import { CONTACTS, count, counted, more } from "../page/readings.mjs";

const READINGS = 200;

const lab = await Lab.begin();
const page = await lab.open();
await count(page);
await type(page, CONTACTS, "contacts.il");
await run(page);
await more(page, READINGS / 4);
const [before, began] = [await counted(page), performance.now()];
await more(page, READINGS);
const [after, ended] = [await counted(page), performance.now()];
const readings = after.readings - before.readings;
console.log(`200 contacts, live: ${((1000 * readings) / (ended - began)).toFixed(1)} readings a second, ${((after.requests - before.requests) / readings).toFixed(1)} requests for each`);
await lab.end();
