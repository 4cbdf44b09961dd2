// The program as text: problems underlined as one types, and what each line does while it runs.

import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import type { Diagnostic } from "@codemirror/lint";
import { Compartment, EditorState, RangeSetBuilder, StateEffect, StateField, Text } from "@codemirror/state";
import {
  Decoration,
  type DecorationSet,
  EditorView,
  GutterMarker,
  drawSelection,
  gutter,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import type { Checked, Live } from "../tools/answers";
import { say, speak, told } from "../words/words";
import type { Around } from "./assist";
import { colours, paint } from "./colours";
import { scrollsAlone } from "./reveal";

type Lines = Live["lines"];
const setLines = StateEffect.define<Lines>();

/** What each line does; an edit takes it away. */
const lines = StateField.define<Lines>({
  create: () => [],
  update(lines, transaction) {
    for (const effect of transaction.effects) if (effect.is(setLines)) return effect.value;
    return transaction.docChanged ? [] : lines;
  },
  provide: (field) => EditorView.decorations.from(field, (lines) => (view) => powered(view, lines)),
});

function powered(view: EditorView, lines: Lines): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  const line = Decoration.line({ class: "cm-powered" });
  lines.forEach((state, index) => {
    if (state === true && index < view.state.doc.lines) builder.add(view.state.doc.line(index + 1).from, view.state.doc.line(index + 1).from, line);
  });
  return builder.finish();
}

class StateMarker extends GutterMarker {
  constructor(private readonly state: boolean | number | string) {
    super();
  }

  override eq(other: StateMarker): boolean {
    return other.state === this.state;
  }

  override toDOM(): Node {
    const mark = document.createElement("span");
    mark.className = this.state === true ? "lit" : "";
    mark.textContent = typeof this.state === "boolean" ? (this.state ? "●" : "○") : `= ${this.state}`;
    return mark;
  }
}

const states = gutter({
  class: "cm-state",
  lineMarker(view, block) {
    const state = view.state.field(lines)[view.state.doc.lineAt(block.from).number - 1];
    return state === undefined || state === null ? null : new StateMarker(state);
  },
  lineMarkerChange: (update) => update.startState.field(lines) !== update.state.field(lines),
});

/** Characters that a text may have: no program is that long, and a browser keeps no more. */
const LONGEST = 1 << 20;

/** Who hears of edits. */
export interface Edited {
  changed(text: string): void;
  /** What was to be put in is too long: nothing has changed. */
  tooLong(): void;
}

export class Editor {
  readonly view: EditorView;
  private quiet = false;
  private readonly comforts = new Compartment();
  private comfort: typeof import("./comforts") | undefined;
  /** The problems of a text. */
  private found: { doc: Text; problems: Diagnostic[] } = { doc: Text.empty, problems: [] };

  constructor(parent: HTMLElement, text: string, edited: Edited) {
    this.view = new EditorView({
      parent,
      state: EditorState.create({
        doc: text,
        extensions: [
          lineNumbers(),
          states,
          lines,
          history(),
          drawSelection(),
          highlightActiveLine(),
          highlightActiveLineGutter(),
          scrollsAlone,
          this.comforts.of([]),
          colours,
          keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
          EditorState.tabSize.of(4),
          EditorState.changeFilter.of(({ newDoc, startState }) => {
            const fits = newDoc.length <= Math.max(LONGEST, startState.doc.length);
            if (!fits) edited.tooLong();
            return fits;
          }),
          EditorView.contentAttributes.of({ tabindex: "0" }),
          EditorView.updateListener.of((update) => {
            if (update.docChanged && !this.quiet) edited.changed(update.state.doc.toString());
          }),
        ],
      }),
    });
    speak.follow(() => {
      const content = this.view.contentDOM;
      content.setAttribute("aria-label", `${say("programText")}. ${say("editorHelp")}`);
    });
  }

  /** Loads what nobody needs for the first line, with its menu in this bar. Without it one still writes. */
  furnish(around: Around, bar: HTMLElement): void {
    import("./comforts").then(
      (comfort) => {
        this.comfort = comfort;
        speak.follow((language) => {
          this.view.dispatch({ effects: this.comforts.reconfigure(comfort.comforts(language, around, bar)) });
          this.underline();
        });
      },
      () => undefined,
    );
  }

  /** Shows another text; undo brings the one before back. */
  show(text: string): void {
    if (text === this.view.state.doc.toString()) return;
    this.quiet = true;
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text }, selection: { anchor: 0 }, scrollIntoView: true });
    this.quiet = false;
  }

  /** Colours this text and underlines its problems. */
  tell(text: string, { problems, colours }: Checked): void {
    const { doc } = this.view.state;
    // A newer text is on its way to be looked at.
    if (doc.toString() !== text) return;
    const within = (at: number): number => Math.min(at, doc.length);
    const diagnostics = problems.map((problem): Diagnostic => ({
      from: within(problem.from),
      to: within(Math.max(problem.to, problem.from)),
      severity: problem.severity,
      source: problem.number,
      message: [told(problem.message), told(problem.help)].filter(Boolean).join("\n"),
    }));
    this.view.dispatch({ effects: paint(doc, colours) });
    this.found = { doc, problems: diagnostics };
    this.underline();
  }

  /** Underlines the problems, unless they are of a text before. */
  private underline(): void {
    const { state } = this.view;
    if (this.comfort && state.doc.eq(this.found.doc)) this.view.dispatch(this.comfort.setDiagnostics(state, this.found.problems));
  }

  /** Shows what each line does; nothing without a running program. */
  live(states: Lines): void {
    const now = this.view.state.field(lines);
    if (now.length === states.length && now.every((state, index) => state === states[index])) return;
    this.view.dispatch({ effects: setLines.of(states) });
  }

  /** Goes to a line, counted from 1. */
  go(line: number, column = 1): void {
    const { doc } = this.view.state;
    const there = doc.line(Math.min(Math.max(line, 1), doc.lines));
    this.view.dispatch({ selection: { anchor: Math.min(there.from + column - 1, there.to) }, scrollIntoView: true });
    this.view.focus();
  }
}
