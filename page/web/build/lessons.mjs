// The tutorial, the exercises and the examples as the page takes them, made from what the repository has of them anyway.

import { readFileSync, readdirSync } from "node:fs";
import { basename, dirname, extname, join } from "node:path";
import { marked } from "marked";

const PAGES = { en: "tutorial.md", pt: "tutorial.pt-BR.md" };

/** The sections of a tutorial: number, title, what it says. */
function sections(text) {
  const parts = text.split(/^## (?=\d+\. )/m).slice(1);
  return parts.map((part) => {
    const end = part.search(/^## /m);
    const [title, ...lines] = (end < 0 ? part : part.slice(0, end)).split("\n");
    return { title, lines: lines.join("\n") };
  });
}

/** A section as the page shows it: each listing in a frame of its own, which gets a button there, and a place for the picture
 * of each ladder. No link leads away, and nobody is asked for a command line. */
function shown(lines) {
  const frames = [];
  const frame = (_, kind, text) => {
    frames.push(FRAMES[kind]?.(text) ?? `<pre>${escaped(text)}</pre>`);
    return `<div data-frame="${frames.length - 1}"></div>\n`;
  };
  const own = lines
    .replace(/^```(\w*)\n([\s\S]*?)^```\n/gm, frame)
    .replace(/^\[`programs[^\n]*\n/gm, "")
    .replace(/\]\((?!https?:)[^)]*\)/g, "]")
    .replace(/\[([^\]\n]+)\]/g, "$1");
  const html = marked.parse(own, { async: false }).replace(/<div data-frame="(\d+)"><\/div>/g, (_, at) => frames[at]);
  const [command] = /unoclp (?:check|compile|run|sim|list|upload)\b/.exec(html) ?? [];
  if (command) throw new Error(`a step of the tutorial asks for a command line: ${command}`);
  return html;
}

const listing = (end) => (text) => `<figure class="listing" data-end="${end}"><pre>${escaped(text)}</pre></figure>`;
const FRAMES = {
  il: listing("il"),
  st: listing("st"),
  ladder: (text) => `<figure class="rungs"><pre>${escaped(text)}</pre></figure>`,
  // The first line is the command that prints the rest.
  run: (text) => `<pre>${escaped(text.slice(text.indexOf("\n") + 1))}</pre>`,
};

function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

/** Each step: its title and words in both languages, its program, the scenarios of step and exercise, a solution. */
export function lessons(root) {
  const folder = join(root, "programs/tutorial");
  const read = (name) => readFileSync(join(folder, name), "utf8");
  const names = (under) => readdirSync(join(folder, under)).filter((name) => /\.(?:il|st)$/.test(name)).sort();
  const told = Object.entries(PAGES).map(([language, page]) => [language, sections(readFileSync(join(root, "docs", page), "utf8"))]);
  const both = (index, take) => Object.fromEntries(told.map(([language, all]) => [language, take(all[index])]));
  const solutions = names("solutions");
  return names(".").map((name, index) => {
    const solution = solutions.find((one) => one.slice(0, 2) === name.slice(0, 2));
    const beside = (file) => read(file.replace(/\.\w+$/, ".toml"));
    return {
      title: both(index, (section) => section.title),
      words: both(index, (section) => shown(section.lines)),
      name,
      text: read(name),
      step: beside(name),
      exercise: beside(`solutions/${solution}`),
      solution: read(`solutions/${solution}`),
    };
  });
}

/** The machine of the gallery beside which each exercise is listed, by their numbers; those of the two other kinds by their
 * folders too. */
const SHELVES = {
  batch: "26", belts: "08 14 28", crossing: "17 34 35 43", cylinders: "24 25 find/03", elevator: "18", filling: "12 33 42",
  "four-floors": "48 49", garage: "41", level: "16 21 38 39 40", motor: "05 10 30 31 find/01", oven: "19", parking: "13 36", press: "02 22 29",
  reversing: "06", sorting: "27 32", "star-delta": "15", "three-bins": "46 47", "three-cylinders": "44 45",
  "two-roads": "50 51", "two-tanks": "23 37 find/02",
};
const SHELF = new Map(Object.entries(SHELVES).flatMap(([machine, all]) => all.split(" ").map((number) => [number, `${machine}.toml`])));

/** Each exercise without its solution: a student finds that. Where a fault is to be found, the program is right and given. */
export function exercises(root) {
  const folder = join(root, "programs/exercises");
  const of = (under) => {
    const files = readdirSync(join(folder, under)).sort();
    return files.filter((file) => file.endsWith(".toml")).map((file) => exercise(folder, under, file, files));
  };
  const all = [...of("."), ...of("find"), ...of("write")];
  const lost = all.filter(({ plant, shelf }) => plant && !shelf);
  if (lost.length > 0) throw new Error(`the gallery has no place for ${lost.map(({ name }) => name).join(", ")}`);
  return all;
}

function exercise(folder, under, file, files) {
  const stem = file.replace(/\.toml$/, "");
  const name = under === "." ? stem : `${under}/${stem}`;
  const model = files.find((one) => one !== file && one.startsWith(`${stem}.`));
  const read = (path) => readFileSync(join(folder, under, path), "utf8");
  const scenario = read(file);
  const [, plant] = /^plant = "([^"]+)"/m.exec(scenario) ?? [];
  const machine = plant && { plant: { name: plant.split("/").pop(), text: read(plant) } };
  const shelf = SHELF.get(name.replace(/-[^/]*$/, ""));
  const program = /^\[find\]/m.test(scenario) && { program: { name: model, text: read(model) } };
  return { name, language: model.split(".").pop(), scenario, ...machine, ...(shelf && { shelf }), ...program };
}

/** The programs of the tables in programs/README.md, each with what it does. */
export function examples(root) {
  const folder = join(root, "programs");
  const rows = readFileSync(join(folder, "README.md"), "utf8").matchAll(/^\| \[([\w/-]+)\]\(([\w/.-]+)\) \|(.*)\|$/gm);
  const all = [];
  for (const [, name, file, rest] of rows) {
    const [en, pt] = rest.split(" | ").map((cell) => cell.trim()).slice(-2);
    const stem = file.replace(/\.\w+$/, "");
    // A program in all languages is shown in those that are typed.
    const isList = file.endsWith(".txt");
    for (const one of readdirSync(join(folder, dirname(file))).sort((a, b) => a.length - b.length)) {
      const end = extname(one);
      if (basename(one, end) !== basename(stem) || end === ".toml" || [".il", ".txt"].includes(end) !== isList) continue;
      all.push({ name: one, about: { en, pt }, text: readFileSync(join(folder, dirname(file), one), "utf8") });
    }
    if (!all.some((one) => one.name.startsWith(name.split("/").pop()))) throw new Error(`programs/README.md names ${name}, which is not there`);
  }
  return all;
}

/** Each machine, with a program that controls it. */
export function machines(root) {
  const folder = join(root, "programs/plants");
  const read = (name) => readFileSync(join(folder, name), "utf8");
  const both = (text, key) => {
    const [, en, pt] = new RegExp(`^${key} = \\{ en = "([^"]*)", pt = "([^"]*)" \\}`, "m").exec(text) ?? [];
    if (!en || !pt) throw new Error(`a machine has no ${key} in both languages`);
    return { en, pt };
  };
  return readdirSync(folder).filter((name) => name.endsWith(".toml")).sort().map((name) => {
    const text = read(name);
    const solution = name.replace(/\.toml$/, ".st");
    return { name, text, title: both(text, "title"), about: both(text, "about"), solution: { name: solution, text: read(solution) } };
  });
}
