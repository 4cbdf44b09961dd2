// The four menus, as lists of rows: what the bar does not show by itself. A row more is a line more here.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { say, speak } from "../words/words";
import { asked } from "./asked";
import type { Bench } from "./bench";
import type { CardSlot } from "./cardslot";
import type { ProgramDocument } from "./document";
import { byId, h } from "./dom";
import { download, pick } from "./files";
import { later } from "./later";
import { blocks, looks } from "./look";
import { type Row, elementsOf, entry, menu } from "./menu";
import { note } from "./notes";
import { isLetter } from "./paper";
import { others } from "./place";
import { copyLink } from "./links";
import type { Tabs } from "./tabs";
import { theme } from "./theme";
import { tongue } from "./tongue";

const SVG = "image/svg+xml";
/** Programs of before that the menu has. */
const KEPT = 6;
/** The chart with which one begins. */
const newChart = later(async () => (await import("./sfc/new.st")).default);

interface Parts {
  readonly program: ProgramDocument;
  readonly bench: Bench;
  readonly open: (text: Text) => void;
  readonly take: (files: readonly File[]) => Promise<void>;
  readonly slot: CardSlot;
  readonly remote: RemoteTools;
  readonly tabs: Tabs;
  /** Opens the tutorial or the exercises. */
  learn(what: "lessons" | "exercises"): void;
  showMachines(): void;
  showExamples(): void;
  /** Opens the program of a place, or shows all of them. */
  goTo(id: string): void;
  showPrograms(): void;
  /** Goes through a scan in slow motion. */
  slow(): void;
  /** Shows a card beside the board, or takes it away. */
  turnCard(card: "hardware" | "faults"): void;
  /** Reads the program of the board. */
  fetch(): void;
  /** Connecting, firmware; which board a program is for; how time goes. */
  readonly desk: readonly HTMLElement[];
  readonly forBoard: HTMLElement;
  readonly time: readonly HTMLElement[];
  readonly allButtons: HTMLElement;
}

/** Puts the menus into the bar. */
export function menus(root: HTMLElement, parts: Parts): void {
  const { program, tabs } = parts;
  const field = (say: string, control: HTMLElement): HTMLElement => h("label", { class: "menu-field" }, h("span", { "data-say": say }), control);
  const [language, target] = [field("language", tongue()), field("forBoard", parts.forBoard)];
  const light = theme();
  const look = looks();
  const learn = (): Row[] => [
    { id: "exercises", say: "exercises", act: () => parts.learn("exercises") },
    { id: "lessons", say: "lessons", act: () => parts.learn("lessons") },
    { id: "examples", say: "examples", act: () => parts.showExamples() },
    { id: "machines", say: "machines", act: () => parts.showMachines() },
  ];
  const board = (): Row[] => [
    ...parts.desk, "line", target, "line",
    { id: "fetch", say: "fetch", act: () => parts.fetch() },
    { id: "open-settings", say: "tabSettings", act: () => tabs.open("settings") },
    { id: "open-card-tab", say: "tabCard", act: () => tabs.open("card") },
    { id: "open-serial", say: "tabSerial", act: () => tabs.open("serial") },
    "line", ...parts.time,
    { id: "slow-motion", say: "slow", act: () => parts.slow() }, "line",
    { id: "show-hardware", say: "simulated", act: () => parts.turnCard("hardware") },
    { id: "show-faults", say: "faults", act: () => parts.turnCard("faults") },
  ];
  const view = (): Row[] => [
    { id: "open-trend", say: "tabTrend", act: () => tabs.open("trend") },
    { id: "open-watch", say: "tabWatch", act: () => tabs.open("watch") },
    { id: "open-problems", say: "tabProblems", act: () => tabs.open("problems") },
    "line", look, parts.allButtons, light, language,
  ];
  root.append(
    menu("fileMenu", null, () => elementsOf(files(parts))), menu("learnMenu", null, () => elementsOf(learn())),
    menu("boardMenu", null, () => elementsOf(board())), menu("viewMenu", null, () => elementsOf(view())),
  );
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey)) return;
    if (event.key === "s") save(program);
    else if (event.key === "o") pick((files) => void parts.take(files));
    else return;
    event.preventDefault();
  });
}

function files({ program, open, take, slot, remote, goTo, showPrograms }: Parts): Row[] {
  const text = program.text.value;
  const code = program.whole?.made.code;
  const when = (): boolean => code !== undefined;
  const stem = text.name.replace(/\.\w+$/, "");
  const shown = { of: text, width: 80, speak: speak.value };
  return [
    {
      id: "new-file",
      say: "newFile",
      act: () => {
        open({ name: "program.il", text: "" });
        write();
      },
    },
    {
      id: "new-chart",
      say: "newChart",
      act: () => void newChart().then((text) => {
        if (text === null) return;
        open({ name: "chart.st", text });
        byId("view-draw").click();
      }),
    },
    { id: "open-file", say: "openFile", act: () => pick((files) => void take(files)) },
    { id: "save-file", say: "saveFile", act: () => save(program) },
    { id: "programs", say: "programs", act: showPrograms },
    { id: "share", say: "share", act: () => void shareLink(program) },
    "line",
    { id: "save-code", say: "saveCode", when, act: () => download("PROGRAM.TXT", code ?? "") },
    { id: "save-drawing", say: "saveDrawing", when, act: () => void asked(remote.ask("list", { ...shown, as: blocks.value ? "svg-fbd" : "svg" }), (svg) => download(`${stem}.svg`, svg, SVG)) },
    {
      id: "save-pages",
      say: "savePages",
      when,
      act: () => void asked(remote.ask("pages", { ...shown, letter: isLetter() }), (pages) => {
        pages.forEach((page, at) => download(`${stem}-${at + 1}.svg`, page, SVG));
      }),
    },
    { id: "make-project", say: "makeProject", when: () => code !== undefined && !text.name.endsWith(".xml"), act: () => void asked(remote.ask("list", { ...shown, as: blocks.value ? "xml-fbd" : "xml" }), (xml) => open({ name: `${stem}.xml`, text: xml })) },
    { id: "save-project", say: "saveProject", when, act: () => void asked(remote.ask("list", { ...shown, as: blocks.value ? "xml-fbd" : "xml" }), (xml) => download(`${stem}.xml`, xml, "application/xml")) },
    {
      id: "save-card",
      say: "saveCard",
      when,
      act: () => void slot.build(true).then((image) => image && download("card.img", image, "application/octet-stream")),
    },
    ...others().slice(0, KEPT).map(({ id, name, at }) => entry(say("keptBefore", { name }), () => goTo(id), new Date(at).toLocaleString(document.documentElement.lang))),
  ];
}

/** The focus goes where one writes, or draws. */
function write(): void {
  const shown = [...document.querySelectorAll<HTMLElement>(".cm-content, #sheet")].find((one) => one.offsetParent !== null);
  shown?.focus();
}

function save(program: ProgramDocument): void {
  const { name, text } = program.text.value;
  download(name, text);
  if (program.lacks.value > 0) note(() => say("savedUnfinished"));
}

/** A drawing that is no program yet is more than its text. */
async function shareLink(program: ProgramDocument): Promise<void> {
  const { name, text, drawing } = program.work;
  const unfinished = program.lacks.value > 0 ? ["drawing", JSON.stringify(drawing)] : [];
  await copyLink("p", [name, text, ...unfinished]);
}
