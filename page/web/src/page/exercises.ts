// The exercises: a list by kinds, and of the chosen one its task, its hints one after the other, and the check.

import type { Both, Sheet, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { Refusal } from "../tools/tools";
import { say as sayHere } from "../words/learn";
import { say, speak, told } from "../words/words";
import type { ProgramDocument } from "./document";
import { byId, h } from "./dom";
import { fetched } from "./fetched";
import { FindForm } from "./findform";
import { GivenView } from "./givenview";
import { HandIn } from "./handin";
import { icon } from "./icons";
import { keep, kept } from "./kept";
import type { MachineArea } from "./machine";
import { announce, note } from "./notes";
import { showColumn } from "./column";
import { copyLink } from "./links";
import { Verdict } from "./verdict";

/** An exercise as the build has put it into the page. */
interface File {
  readonly name: string;
  /** The end of the name of its model solution, which says in which language it is best begun. */
  readonly language: string;
  readonly scenario: string;
  /** Its machine, by the name of the file. */
  readonly plant?: Text;
  /** The program that is right, where a fault is to be found. */
  readonly program?: Text;
  /** The machine of the gallery beside which it is listed. */
  readonly shelf?: string;
  /** Whether a teacher has brought it. */
  readonly isOwn?: boolean;
}

/** An exercise, and how far the student has come. */
interface Exercise extends File {
  readonly sheet: Sheet;
  readonly verdict: Verdict;
  hints: number;
  passed: boolean;
}

/** An exercise as others list it. */
export interface Listed {
  readonly name: string;
  readonly title: Both;
  readonly passed: boolean;
  /** The machine beside which it is listed, by the name of its file. */
  readonly shelf: string | null;
}

const KEPT = "exercises";
/** The groups of the list. */
const GROUPS = { own: "kindOwn", program: "kindProgram", find: "kindFind", write: "kindWrite" } as const;

/** What the browser keeps of the exercises: names, since a later page may have others. */
interface Progress {
  readonly open: string;
  readonly passed: readonly string[];
}

export class Exercises {
  private all: readonly Exercise[] = [];
  private at = 0;
  /** Whether the machine beside the board is that of an exercise. */
  private hasOpened = false;
  private readonly find: FindForm;
  private readonly given: GivenView;
  private readonly handIn: HandIn;

  constructor(
    private readonly root: HTMLElement,
    private readonly tools: RemoteTools,
    private readonly program: ProgramDocument,
    private readonly open: (text: Text) => void,
    /** Makes the buttons of these inputs normally closed, and no others. */
    private readonly closed: (inputs: readonly number[]) => void,
    private readonly machine: MachineArea,
  ) {
    this.find = new FindForm(machine, () => this.chosen(), () => this.pass());
    this.given = new GivenView(tools);
    this.handIn = new HandIn(tools, program);
    speak.follow(() => {
      if (!this.root.hidden) this.show();
    });
  }

  /** Opens a file of a teacher beside the others, with its machine, if that is among these; tells what it is, and why it is
   * none. */
  async take({ name, text }: Text, machines: readonly Text[]): Promise<boolean> {
    const file = { name: name.replace(/\.toml$/i, ""), language: "il", scenario: text, isOwn: true };
    let exercise: Exercise;
    try {
      const read = await this.read(file, false);
      const plant = machines.find((machine) => machine.name === read.sheet.plant);
      exercise = plant ? { ...read, plant } : read;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      note(() => sayHere("fileNoExercise", { why: told(error.both) }));
      return false;
    }
    await this.load();
    this.all = [...this.all.filter((one) => one.name !== file.name), exercise];
    this.at = this.all.length - 1;
    this.appear();
    note(() => sayHere("exerciseOpened"));
    return true;
  }

  /** Opens the exercise of this name. */
  async choose(name: string): Promise<void> {
    await this.load();
    const at = this.all.findIndex((exercise) => exercise.name === name);
    if (at < 0) return note(() => sayHere("exerciseUnknown", { name }));
    this.at = at;
    this.keep();
    this.appear();
  }

  /** All of them, and which of them a student has passed. */
  async listed(): Promise<readonly Listed[]> {
    await this.load();
    return this.all.map(({ name, sheet, passed, shelf, plant }) => ({ name, title: sheet.title, passed, shelf: shelf ?? plant?.name ?? null }));
  }

  /** Opens the exercise that was open last. */
  async start(): Promise<void> {
    await this.load();
    this.appear();
  }

  private async load(): Promise<void> {
    if (this.all.length === 0) {
      const files = await fetched<File>("exercises.json");
      if (!files) return;
      const { open, passed } = progress();
      const all = await Promise.all(files.map((file) => this.read(file, passed.includes(file.name)).catch(refused)));
      this.all = all.filter((exercise) => exercise !== null);
      this.at = Math.max(0, this.all.findIndex(({ name }) => name === open));
    }
  }

  private appear(): void {
    if (this.all.length === 0) return;
    this.root.hidden = false;
    showColumn();
    this.chosen();
    this.root.querySelector("select")?.focus();
  }

  close(): void {
    this.root.hidden = true;
    showColumn();
    this.handIn.minutes.turn(null);
    // A machine with a hidden fault is of no use but to this.
    if (this.machine.opened?.find !== undefined) void this.machine.close();
  }

  private async read(file: File, passed: boolean): Promise<Exercise> {
    const sheet = await this.tools.ask("sheet", { scenario: file.scenario, title: file.name });
    return { ...file, sheet, verdict: new Verdict(this.tools), hints: 0, passed };
  }

  private keep(): void {
    // Another tab may have passed others meanwhile.
    const before = progress().passed.filter((name) => this.all.some((exercise) => exercise.name === name));
    const passed = [...new Set([...before, ...this.all.filter((exercise) => exercise.passed).map(({ name }) => name)])];
    keep(KEPT, JSON.stringify({ open: this.all[this.at]?.name ?? "", passed } satisfies Progress));
  }

  /** Shows the exercise that is chosen, and makes the buttons as it says. */
  private chosen(): void {
    this.show();
    const exercise = this.all[this.at];
    this.handIn.minutes.turn(exercise?.name ?? null);
    this.closed(exercise?.sheet.normallyClosed ?? []);
    // One whose points are another board's brings it.
    if (exercise?.sheet.board) this.program.board.value = exercise.sheet.board;
    const machine = exercise && this.machineOf(exercise);
    this.find.begin();
    if (exercise && machine) {
      const more = { isOwn: exercise.isOwn === true, ...(exercise.sheet.kind === "find" ? { find: exercise.scenario } : {}) };
      void this.machine.open({ name: machine.name, text: machine.text, ...more });
    }
    else if (this.hasOpened) void this.machine.close();
    this.hasOpened = Boolean(machine);
  }

  /** The machine of an exercise; of a teacher's own, the one that has been opened. */
  private machineOf({ plant, sheet }: Exercise): Text | null {
    const opened = this.machine.opened;
    return plant ?? (opened && opened.name === sheet.plant ? opened : null);
  }

  private show(): void {
    const exercise = this.all[this.at];
    if (!exercise) return;
    const { sheet, verdict } = exercise;
    verdict.show();
    const names = Object.entries(sheet.names);
    const points = names.map(([point, name]) => h("li", {}, h("code", {}, point), ` ${told(name)}`,
      sheet.normallyClosed.some((input) => point === `I${input}`) ? h("span", { class: "note" }, `: ${sayHere("exerciseClosed")}`) : null));
    const isFind = sheet.kind === "find";
    if (isFind) this.find.show();
    if (sheet.given) this.given.show(sheet.given);
    const hints = sheet.hints.slice(0, exercise.hints).map((hint) => h("li", {}, told(hint)));
    const next = exercise.hints < sheet.hints.length;
    const passed = this.all.filter((one) => one.passed).length;
    const buttons = h("div", { class: "row" },
      isFind ? null : h("button", { type: "button", class: "primary", id: "exercise-check", click: () => void this.check(exercise) }, sayHere("exerciseCheck")),
      isFind ? null : h("button", { type: "button", id: "exercise-begin", click: () => this.open(begun(exercise)) }, sayHere("exerciseBegin")),
      isFind && exercise.program ? h("button", { type: "button", id: "find-open", click: () => exercise.program && this.open(exercise.program) }, sayHere("findOpen")) : null,
      next ? h("button", { type: "button", id: "exercise-hint", click: () => this.hint(exercise) }, sayHere("exerciseHint", { n: exercise.hints + 1, all: sheet.hints.length })) : null,
      this.handIn.button(() => ({ name: exercise.name, scenario: exercise.scenario, machine: this.machineOf(exercise), search: isFind ? this.find.search : null })),
      this.at + 1 < this.all.length ? h("button", { type: "button", class: exercise.passed ? "primary" : "quiet", id: "exercise-next", click: () => this.next() }, sayHere("exerciseNext")) : null);
    const parts = [
      h("div", { class: "row" }, this.list(),
        exercise.isOwn ? h("button", { type: "button", class: "quiet", id: "exercise-link", "aria-label": sayHere("exerciseLink"), title: sayHere("exerciseLink"), click: () => void this.share(exercise) }, icon("share")) : null,
        h("button", { type: "button", class: "quiet", "aria-label": say("close"), click: () => this.close() }, "×")),
      h("div", { class: "row" }, h("progress", { max: this.all.length, value: passed, "aria-label": sayHere("exerciseProgress"), style: "flex:1;width:auto" }),
        h("span", { class: "chip", id: "exercise-progress" }, sayHere("exerciseFar", { done: passed, all: this.all.length }))),
      h("h3", {}, told(sheet.title), sheet.kind === "program" ? null : h("span", { class: "chip" }, sayHere(GROUPS[sheet.kind]))),
      h("p", { class: "task" }, sheet.task ? told(sheet.task) : ""),
      sheet.given ? this.given.element : null,
      h("ul", { class: "names", "aria-label": sayHere("exerciseNames") }, ...points),
      h("ol", { class: "hints", "aria-label": sayHere("exerciseHints"), hidden: hints.length === 0 }, ...hints),
      isFind ? this.find.element : verdict.element,
      h("div", { class: "pinned" }, isFind ? null : verdict.line, buttons),
    ];
    this.root.replaceChildren(...parts.filter((part) => part !== null));
  }

  private list(): HTMLElement {
    const groups = (Object.keys(GROUPS) as (keyof typeof GROUPS)[]).map((group) => {
      const options = this.all.map(({ sheet, passed, isOwn }, index) => ((isOwn ? "own" : sheet.kind) === group
        ? h("option", { value: index, selected: index === this.at }, `${isOwn ? "" : `${index + 1}. `}${told(sheet.title)}${passed ? " ✓" : ""}`) : null)).filter((option) => option !== null);
      return options.length > 0 ? h("optgroup", { label: sayHere(GROUPS[group]) }, ...options) : null;
    });
    const change = (event: Event): void => {
      this.at = Number((event.target as HTMLSelectElement).value);
      this.keep();
      this.chosen();
      this.root.querySelector("select")?.focus();
    };
    return h("select", { id: "exercise-list", "aria-label": say("exercises"), change }, ...groups);
  }

  private next(): void {
    this.at += 1;
    this.keep();
    this.chosen();
    this.root.scrollTo(0, 0);
    this.root.querySelector("select")?.focus();
  }

  private hint(exercise: Exercise): void {
    const hint = exercise.sheet.hints[exercise.hints];
    exercise.hints++;
    this.show();
    if (hint) announce(told(hint));
    // The last hint takes its button with it.
    (this.root.querySelector<HTMLElement>("#exercise-hint") ?? this.root.querySelector<HTMLElement>("#exercise-check"))?.focus();
  }

  private async check(exercise: Exercise): Promise<void> {
    const machine = this.machineOf(exercise);
    const { plant } = exercise.sheet;
    if (plant && !machine) note(() => sayHere("noMachineFile", { name: plant }));
    const passed = await exercise.verdict.check(this.program, exercise.scenario, exercise.name, machine);
    if (!passed || exercise.passed) return;
    this.pass(exercise);
    this.root.querySelector<HTMLElement>("#exercise-check")?.focus();
  }

  /** It is solved: that is kept. */
  private pass(exercise = this.all[this.at]): void {
    if (!exercise || exercise.passed) return;
    exercise.passed = true;
    this.keep();
    this.show();
  }

  private async share(exercise: Exercise): Promise<void> {
    const machine = this.machineOf(exercise);
    await copyLink("x", [`${exercise.name}.toml`, exercise.scenario, ...(machine ? [machine.name, machine.text] : [])]);
  }
}

/** A file of a teacher that is wrong is left out, and told. */
function refused(error: unknown): null {
  if (!(error instanceof Refusal)) throw error;
  note(() => sayHere("fileNoExercise", { why: told(error.both) }));
  return null;
}

/** How far the student had come before. */
function progress(): Progress {
  try {
    const { open, passed } = JSON.parse(kept(KEPT) ?? "{}") as Partial<Progress>;
    return { open: String(open), passed: Array.isArray(passed) ? passed : [] };
  } catch {
    return { open: "", passed: [] };
  }
}

/** A program that says what is connected, and does nothing yet; whoever draws begins to draw it. */
function begun({ name: whole, language: own, sheet }: Exercise): Text {
  const name = whole.split("/").pop() ?? whole;
  const language = sheet.given?.answerIn ?? own;
  const isDrawn = sheet.given === null && byId("views").dataset["view"] === "draw";
  if (language === "il" || isDrawn) return { name: `${name}.il`, text: told(sheet.begin) };
  const points = Object.entries(sheet.names).map(([point, connected]) => `   ${point}  ${told(connected)}\n`);
  return { name: `${name}.${language}`, text: `(* ${told(sheet.title)}\n\n${points.join("")}*)\n` };
}
