// The page: what it is made of, and what leads to what.

import { isSingle, worker } from "../offline/beside";
import type { Both, Text } from "../tools/answers";
import { Modules } from "../tools/modules";
import { RemoteTools } from "../tools/remote";
import { Tools } from "../tools/tools";
import { say, speakIn, told, translate } from "../words/words";
import { Bench, firmwareOf } from "./bench";
import { CardSlot } from "./cardslot";
import { Desk } from "./desk";
import { ProgramDocument, type Work, drawingOf, isOf, lastText } from "./document";
import { byId, h } from "./dom";
import { Editor } from "./editor";
import { ForBoard } from "./forboard";
import { download, isHandIn, isMachine, isScenario, read, takeDrops } from "./files";
import { later } from "./later";
import { menus } from "./menus";
import { MachineArea } from "./machine";
import { note } from "./notes";
import { OnBoard } from "./onboard";
import { Panel } from "./panel";
import { here, keptAt, keptHere, moveOn, moveTo, programOf } from "./place";
import { pointsOf } from "./points";
import { whyNot } from "./problems";
import { ProgramView } from "./programview";
import { carriedBy } from "./links";
import { startControl } from "./start";
import { statusOf } from "./status";
import { Tabs } from "./tabs";
import { tooLarge } from "./toolarge";
import { Trend } from "./trend";
import { Watch } from "./watch";
import { begin, greet, isFirstVisit } from "./welcome";

async function load(): Promise<void> {
  if (typeof WebAssembly === "undefined") return stuck();
  const firmware = firmwareOf("uno");
  const modules = new Modules();
  const [checker, simulator] = [worker("tools.js"), worker("board.js")];
  const module = await modules.first();
  const remote = new RemoteTools(await checker, modules, module);
  const isFirst = isFirstVisit();
  /** Whether there is a program here that a link must not take the place of. */
  let hasOwn = keptHere("program") !== null;
  const program = new ProgramDocument(remote);
  const first = program.text.value;
  const board = await simulator;
  const tools = await Tools.of(module);
  const bench = new Bench(tools, modules, board, (both) => note(() => told(both)));
  const forBoard = new ForBoard(tools, program);

  byId("stuck").remove();
  const editor = new Editor(byId("editor"), program.text.value.text, {
    changed: (text) => {
      hasOwn = true;
      program.text.value = { ...program.text.value, text };
    },
    tooLong: () => note(() => say("textTooLong")),
  });
  holdFast(program);
  const put = (work: Text & Partial<Work>): Work => {
    const before = program.replace(work);
    editor.show(work.text);
    panel.kindsOf(work.text);
    return before;
  };
  /** Another program, in a place of its own; the one before stays where it was, and comes back on request. */
  const open = (work: Text & Partial<Work>): void => {
    const [before, from] = [program.work, here()];
    const isNothing = before.text.trim() === "" && !before.drawing?.log.length;
    const isSame = before.text === work.text && before.drawing === (work.drawing ?? null);
    if (!isNothing && !isSame) moveOn();
    put(work);
    if (isNothing || isSame) return;
    const to = here();
    note(() => say("replaced"), { text: () => say("undo"), take: () => travel(from, before, to, "restored") });
  };
  /** Goes to another place, where this stands; and back again, as often as one likes. */
  const travel = (to: string, work: Work, from: string, said: "restored" | "replaced"): void => {
    const before = program.work;
    moveTo(to);
    put(work);
    const isBack = said === "restored";
    note(() => say(said), { text: () => say(isBack ? "redo" : "undo"), take: () => travel(from, before, to, isBack ? "replaced" : "restored") });
  };
  /** Opens the program of a place. */
  const goTo = (id: string): void => {
    const kept = programOf(keptAt(id, "program"));
    if (kept && id !== here()) travel(id, { name: kept.name, text: kept.text, drawing: drawingOf(keptAt(id, "drawing")) }, here(), "replaced");
  };
  const learning = later(async () => new (await import("./learning")).Learning(remote, program, open, (inputs) => panel.normallyClosed(inputs), machine));
  const handedIn = later(async () => (await import("./handedin")).handedIn);
  /** Opens files: machines first, which the exercises beside them may need. */
  const take = async (files: readonly File[]): Promise<void> => {
    const texts = (await Promise.all(files.map(read))).filter((text) => text !== null);
    const machines = texts.filter((text) => isMachine(text) && !isHandIn(text));
    const scenarios = texts.filter((text) => !isMachine(text) && !isHandIn(text) && isScenario(text));
    for (const text of machines) await machine.open({ ...text, isOwn: true });
    for (const text of scenarios) await (await learning())?.take(text, machines);
    const handed = texts.filter(isHandIn);
    for (const text of handed) {
      const work = (await handedIn())?.(text, (name) => void learning().then((them) => them?.choose(name)));
      if (work) open(work);
    }
    for (const text of texts) if (![...machines, ...scenarios, ...handed].includes(text)) open(text);
  };

  const trend = new Trend(bench);
  const watch = new Watch(bench);
  const problems = h("div");
  const serial = h("pre", { id: "serial-text" });
  bench.serial.follow((text) => {
    serial.textContent = text || say("serialEmpty");
  });
  const unsent = (): Both | null => program.whole?.made.unsent ?? null;
  const slot = new CardSlot(bench, remote, () => (unsent() ? null : (program.whole?.made.code ?? null)), () => {
    const why = unsent();
    note(() => (why ? told(why) : whyNot(program)));
  });
  const card = h("div");
  const cardTab = later(async () => new (await import("./cardtab")).CardTab(slot, card));
  const settings = h("div");
  const settingsTab = later(async () => new (await import("./settings")).SettingsTab(bench, settings));
  const view = new ProgramView(program, editor, remote, bench, problems, open, forBoard);
  const tabs = new Tabs(byId("below"), [
    { id: "trend", title: "tabTrend", panel: trend.panel, shown: () => trend.shown() },
    { id: "watch", title: "tabWatch", panel: watch.panel },
    { id: "problems", title: "tabProblems", panel: problems, label: view.count },
    { id: "serial", title: "tabSerial", isRare: true, panel: h("div", {}, serial) },
    { id: "card", title: "tabCard", isRare: true, panel: card, shown: () => void cardTab().then((tab) => tab?.show()) },
    { id: "settings", title: "tabSettings", isRare: true, panel: settings, shown: () => void settingsTab().then((tab) => tab?.read()) },
  ]);
  const judged = later(() => import("./judged"));
  const machine = new MachineArea(bench, (facts) => panel.fold(facts !== null), (file, into) => void judged().then((part) => part?.judge(remote, program, file, into)), forBoard, program.board);
  const start = startControl(bench, program, forBoard, tabs, () => view.goDraw());
  const desk = new Desk(bench);
  const showMachines = (): void => void shown().then((gallery) => gallery?.show());
  const panel = new Panel(byId("board"), bench, slot, desk.about, machine.root, showMachines);
  byId("running").append(...start.controls, statusOf(bench, program), panel.time.speed);
  const onBoard = new OnBoard(bench, program, remote);
  const learn = (what: "lessons" | "exercises"): void => void learning().then((them) => them?.start(what));
  const shown = later(async () => {
    const them = await learning();
    return them && new (await import("./gallery")).Gallery(remote, them, machine, open);
  });
  const examples = (): void => void import("./examples").then(({ showExamples }) => showExamples(remote, open));
  const slow = later(async () => new (await import("./slow/slow")).SlowMotion(program, bench, remote, editor));
  menus(byId("menus"), {
    slow: () => void slow().then((part) => part?.open()),
    program, bench, open, take, slot, remote, tabs, learn,
    showMachines,
    showExamples: examples,
    goTo,
    showPrograms: () => void import("./programs").then(({ showPrograms }) => showPrograms(program, remote, goTo, open)),
    turnCard: (card) => panel.turnCard(card),
    fetch: () => void import("./fetch").then(({ fetchProgram }) => fetchProgram(bench, onBoard, remote, program.text.value, open)),
    desk: desk.rows, forBoard: forBoard.control, time: panel.time.rows, allButtons: panel.allButtons,
  });
  if (isFirst) {
    greet({
      draw: () => {
        open({ name: "program.il", text: "" });
        view.goDraw(true);
      },
      exercises: () => learn("exercises"),
      examples,
    });
  }
  takeDrops(byId("drop"), (files) => void take(files));
  /** A program of a link gets a place of its own: what stood here is kept where it was. The others stand beside it. */
  const fromLink = async (): Promise<void> => {
    const carried = await carriedBy(location.hash);
    if (carried === undefined) return;
    history.replaceState(null, "", location.pathname + location.search);
    const [text, beside] = carried ? pairs(carried.parts) : [];
    if (!carried || !text) return note(() => say("linkBroken"));
    if (carried.kind === "p") {
      if (hasOwn) moveOn();
      const drawing = drawingOf(beside?.text ?? null);
      put({ ...text, drawing: drawing && isOf(drawing, text) ? drawing : null });
      if (hasOwn) note(() => say("linkOpened"));
      hasOwn = true;
    } else if (carried.kind === "m") await machine.open({ ...text, isOwn: true });
    else await (await learning())?.take(text, beside ? [beside] : []);
  };
  document.addEventListener("too-large", () => open(tooLarge(bench.board.value)));

  onBoard.shown.follow((made) => {
    if (!made) return;
    panel.uses(made);
    const points = pointsOf(made);
    watch.watch(points);
    trend.watch(points);
  });
  speakIn(document);
  translate(document);
  bench.simulated.start("uno", await firmware);
  await fromLink();
  hasOwn ||= !isFirst;
  addEventListener("hashchange", () => void fromLink());
  document.documentElement.dataset["ready"] = "yes";
  performance.mark("ready");
  setTimeout(() => {
    editor.furnish({
      tools: remote,
      of: (text) => ({ ...program.text.value, text }),
      value: (name) => view.value(name),
    }, byId("program-bar"));
    if (isFirst) void begin(bench, () => program.text.value === first, start.run);
  });
  if (!isSingle && "serviceWorker" in navigator && location.protocol.startsWith("http")) {
    await navigator.serviceWorker.register("sw.js").catch(() => undefined);
  }
}

/** Texts, each by its name and what it says. */
function pairs(parts: readonly string[]): Text[] {
  const at = parts.map((_, index) => index).filter((index) => index % 2 === 0 && index + 1 < parts.length);
  return at.map((index) => ({ name: parts[index] ?? "", text: parts[index + 1] ?? "" }));
}

/** The page cannot run here: its HTML says why. What was written is given back as a file. */
function stuck(): void {
  speakIn(document);
  document.body.classList.add("stuck");
  const text = lastText();
  if (text) byId("stuck").append(h("button", { type: "button", id: "save-kept", click: () => download(text.name, text.text) }, say("saveFile")));
}

/** Tells of a program that the browser does not keep, and asks before it would be lost. */
function holdFast(program: ProgramDocument): void {
  program.isKept.follow((is) => {
    if (!is) note(() => say("notKept"), { text: () => say("saveFile"), take: () => download(program.text.value.name, program.text.value.text) });
  });
  addEventListener("beforeunload", (event) => {
    if (!program.isKept.value) event.preventDefault();
  });
}

load().catch((error: unknown) => {
  console.error(error);
  const why = error instanceof Error ? error.message : String(error);
  note(() => say("loadFailed", { why }), { text: () => say("reload"), take: () => location.reload() }, true);
});
