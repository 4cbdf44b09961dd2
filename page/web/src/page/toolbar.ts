// The bar at the top: files, examples, tutorial, exercises, sharing, language, light or dark.

import type { Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { say, speak } from "../words/words";
import { asked } from "./asked";
import type { CardSlot } from "./cardslot";
import type { ProgramDocument } from "./document";
import { h } from "./dom";
import { download, pick } from "./files";
import { icon } from "./icons";
import { type ListedMachine, listedMachines } from "./listed";
import { entry, menu } from "./menu";
import { note } from "./notes";
import { isLetter } from "./paper";
import { others } from "./place";
import { copyLink } from "./share";
import type { ProgramView } from "./programview";
import { theme } from "./theme";
import { tongue } from "./tongue";

const SVG = "image/svg+xml";
/** Programs of before that the menu has. */
const KEPT = 6;

interface Parts {
  readonly program: ProgramDocument;
  readonly open: (text: Text) => void;
  readonly take: (files: readonly File[]) => Promise<void>;
  readonly view: ProgramView;
  readonly slot: CardSlot;
  readonly remote: RemoteTools;
  /** Opens the tutorial or the exercises. */
  learn(what: "lessons" | "exercises"): void;
  showMachines(): void;
  showExamples(): void;
}

/** Puts the bar together; what it gives loads what its menus list, which nobody sees before they are opened. */
export function toolbar(root: HTMLElement, parts: Parts): () => Promise<readonly ListedMachine[]> {
  const { program } = parts;
  const examples = h("button", { type: "button", id: "menu-examples", "aria-haspopup": "dialog", click: () => parts.showExamples() }, icon("examples"), h("span", { "data-say": "examples" }));
  const machines = h("button", { type: "button", id: "machines", "aria-haspopup": "dialog", click: () => parts.showMachines() }, icon("machine"), h("span", { "data-say": "machines" }));
  const lessons = h("button", { type: "button", id: "lessons", click: () => parts.learn("lessons") }, icon("book"), h("span", { "data-say": "lessons" }));
  const exercises = h("button", { type: "button", id: "exercises", click: () => parts.learn("exercises") }, icon("tick"), h("span", { "data-say": "exercises" }));
  const share = h("button", { type: "button", id: "share", "data-say-label": "share", click: () => void shareLink(program) }, icon("share"));
  root.append(
    menu("fileMenu", "folder", () => files(parts)),
    examples, machines, lessons, exercises, share, theme(), tongue(),
  );
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey)) return;
    if (event.key === "s") save(program);
    else if (event.key === "o") pick((files) => void parts.take(files));
    else return;
    event.preventDefault();
  });
  return listedMachines;
}

function files({ program, open, take, slot, remote }: Parts): HTMLElement[] {
  const text = program.text.value;
  const code = program.whole?.made.code;
  const stem = text.name.replace(/\.\w+$/, "");
  const shown = { of: text, width: 80, speak: speak.value };
  const saved = code === undefined ? [] : [
    entry(say("saveCode"), () => download("PROGRAM.TXT", code)),
    entry(say("saveDrawing"), () => void asked(remote.ask("list", { ...shown, as: "svg" }), (svg) => download(`${stem}.svg`, svg, SVG))),
    entry(say("savePages"), () => void asked(remote.ask("pages", { ...shown, letter: isLetter() }), (pages) => {
      pages.forEach((page, at) => download(`${stem}-${at + 1}.svg`, page, SVG));
    })),
    entry(say("saveProject"), () => void asked(remote.ask("list", { ...shown, as: "xml" }), (xml) => download(`${stem}.xml`, xml, "application/xml"))),
    entry(say("saveCard"), () => {
      void slot.build(true).then((image) => {
        if (image) download("card.img", image, "application/octet-stream");
      });
    }),
  ];
  return [
    entry(say("newFile"), () => {
      open({ name: "program.il", text: "" });
      write();
    }),
    entry(say("openFile"), () => pick((files) => void take(files))),
    entry(say("saveFile"), () => save(program)),
    ...saved,
    ...others().slice(0, KEPT).map(({ name, text, at }) => entry(say("keptBefore", { name }), () => open({ name, text }), new Date(at).toLocaleString(document.documentElement.lang))),
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

async function shareLink(program: ProgramDocument): Promise<void> {
  const text = program.text.value;
  if (program.lacks.value > 0) note(() => say("savedUnfinished"));
  await copyLink("p", [text.name, text.text]);
}
