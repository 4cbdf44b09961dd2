// What helps one write a text: words offered, what a word stands for, names, form, remedies. By mouse, keyboard and finger.

import { autocompletion, startCompletion, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import type { Extension } from "@codemirror/state";
import { EditorView, hoverTooltip, keymap, type Tooltip } from "@codemirror/view";
import type { Change, Meant, Text } from "../tools/answers";
import type { RemoteTools } from "../tools/remote";
import { ASSIST } from "../words/assisttable";
import { sayFrom, speak, translate } from "../words/words";
import { asked } from "./asked";
import { h } from "./dom";
import { entry, menu, openAt, type At } from "./menu";
import { note } from "./notes";

const say = sayFrom(ASSIST);

/** What the helper needs of the page. */
export interface Around {
  readonly tools: RemoteTools;
  /** The program, with this text. */
  of(text: string): Text;
  /** What a variable or point is worth now, in words; null where that is not known. */
  value(name: string): string | null;
}

/** What the menu shows when it opens next. */
let shown: (() => HTMLElement[]) | null = null;

/** All of it, for an editor; `root`: the bar in which its menu stands. */
export function assist(around: Around, root: HTMLElement): Extension {
  const of = (view: EditorView): { of: Text } => ({ of: around.of(view.state.doc.toString()) });
  const at = (view: EditorView): number => view.state.selection.main.head;

  /** The menu of the editor, or a list in its place, at a point of the window; none: at the cursor. */
  const open = (view: EditorView, list: (() => HTMLElement[]) | null, point?: At): void => {
    const cursor = view.coordsAtPos(at(view));
    shown = list;
    openAt(own, point ?? { x: cursor?.left ?? 0, y: cursor?.bottom ?? 0 });
    shown = null;
  };

  /** Does something with what Rust says of the text; nothing if the text has changed since. */
  const ask = <T>(view: EditorView, answer: Promise<T>, then: (told: T) => void): void => {
    const { doc } = view.state;
    void asked(answer, (told) => (view.state.doc.eq(doc) ? then(told) : note(() => say("changedSince"))));
  };

  const change = (view: EditorView, changes: readonly Change[]): void => {
    view.dispatch({ changes: changes.map(({ from, to, insert }) => ({ from, to, insert })), userEvent: "input.assist" });
    view.focus();
  };

  const go = (view: EditorView, from: number): void => {
    view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    view.focus();
  };

  const declaration = (view: EditorView): void =>
    ask(view, around.tools.ask("uses", { ...of(view), at: at(view) }), (uses) => {
      const declared = uses.find((use) => use.declares);
      if (declared) go(view, declared.from);
      else note(() => say("notDeclared"));
    });

  const uses = (view: EditorView): void =>
    ask(view, around.tools.ask("uses", { ...of(view), at: at(view) }), (uses) => {
      if (uses.length === 0) return note(() => say("notDeclared"));
      const line = (from: number): string => view.state.doc.lineAt(from).text.trim().slice(0, 60);
      open(view, () => uses.map((use) => entry(`${use.line}: ${line(use.from)}`, () => go(view, use.from), use.declares ? say("useDeclares") : use.writes ? say("useWrites") : "")));
    });

  const rename = (view: EditorView): void => {
    const place = at(view);
    const word = view.state.wordAt(place);
    const name = h("input", { type: "text", value: word ? view.state.sliceDoc(word.from, word.to) : "", "aria-label": say("newName"), spellcheck: "false" });
    const form = h("form", { class: "rename" }, name, h("button", { type: "submit", class: "primary" }, say("renameName")));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      ask(view, around.tools.ask("rename", { ...of(view), at: place, to: name.value }), (changes) => change(view, changes));
    });
    open(view, () => [form]);
    name.select();
    name.focus();
  };

  const format = (view: EditorView): void => ask(view, around.tools.ask("form", of(view)), (changes) => change(view, changes));

  const remedies = (view: EditorView): void => {
    const { from, to } = view.state.doc.lineAt(at(view));
    ask(view, around.tools.ask("remedies", { ...of(view), from, to, speak: speak.value }), (mended) => {
      if (mended.length === 0) return note(() => say("noRemedy"));
      open(view, () => mended.map((remedy) => entry(remedy.title, () => change(view, remedy.changes))));
    });
  };

  const commands: readonly (readonly [string, keyof typeof ASSIST, string, (view: EditorView) => void])[] = [
    ["assist-suggest", "suggest", "Ctrl-Space", (view) => void (view.focus(), startCompletion(view))],
    ["assist-declaration", "declaration", "F12", declaration],
    ["assist-uses", "findUses", "Shift-F12", uses],
    ["assist-rename", "renameName", "F2", rename],
    ["assist-format", "formText", "Shift-Alt-f", format],
    ["assist-remedies", "remedies", "Ctrl-.", remedies],
  ];
  let writing: EditorView | null = null;
  // The menu closes first: an act may open it again.
  const later = (act: (view: EditorView) => void): void => void setTimeout(() => writing && act(writing));
  const own = menu("textMenu", null, () =>
    shown?.() ?? commands.map(([id, key, press, act]) => entry(say(key), () => later(act), press.replace(/[a-z]$/, (letter) => letter.toUpperCase()), id)));
  root.querySelector(".text-menu")?.remove();
  const bar = h("div", { class: "text-menu" }, own);
  translate(bar);
  root.querySelector(".grow")?.before(bar);

  return [
    autocompletion({ override: [(context) => complete(around, context)], selectOnOpen: false, interactionDelay: 0, maxRenderedOptions: 60 }),
    hoverTooltip(async (view, pos) => tooltip(around, await around.tools.ask("meant", { ...of(view), at: pos, speak: speak.value }).catch(() => null))),
    keymap.of(commands.slice(1).map(([, , key, act]) => ({ key, preventDefault: true, run: (view) => (act(view), true) }))),
    EditorView.updateListener.of(({ view }) => (writing = view)),
    EditorView.domEventHandlers({
      contextmenu: (event, view) => {
        event.preventDefault();
        const there = view.posAtCoords({ x: event.clientX, y: event.clientY });
        if (there !== null && view.state.selection.main.empty) view.dispatch({ selection: { anchor: there } });
        writing = view;
        open(view, null, { x: event.clientX, y: event.clientY });
        return true;
      },
    }),
  ];
}

/** What may stand at the cursor. */
async function complete(around: Around, context: CompletionContext): Promise<CompletionResult | null> {
  const before = context.matchBefore(/[\p{L}\p{N}_]+|\./u);
  if (!before && !context.explicit) return null;
  const text = context.state.doc.toString();
  const told = await around.tools.ask("complete", { of: around.of(text), at: context.pos, speak: speak.value }).catch(() => null);
  if (!told || context.aborted || told.offers.length === 0) return null;
  const options = told.offers.map(({ label, kind, detail, insert }, index): Completion => ({ label, type: kind, detail, boost: -index / 100, ...(insert === null ? {} : { apply: insert }) }));
  return { from: told.from, options, validFor: /^[\p{L}\p{N}_]*$/u };
}

/** What a word stands for, beside it. */
function tooltip(around: Around, meant: Meant | null): Tooltip | null {
  if (!meant) return null;
  const value = meant.value === null ? null : around.value(meant.value);
  return {
    pos: meant.from,
    end: meant.to,
    above: true,
    create: () => ({
      dom: h("div", { class: "meant" }, h("code", {}, meant.head), ...meant.lines.map((line) => h("p", {}, line)), value === null ? null : h("p", { class: "now" }, `= ${value}`)),
    }),
  };
}
