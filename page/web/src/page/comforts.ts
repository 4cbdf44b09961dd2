// What an editor has beyond writing: search, help, brackets matched, problems underlined. The page loads it as
// soon as it is ready.

import { bracketMatching } from "@codemirror/language";
import { lintKeymap } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";
import type { Speak } from "../tools/answers";
import { phrases } from "../words/editortable";
import { type Around, assist } from "./assist";

export { setDiagnostics } from "@codemirror/lint";

/** All of it, in the language that is spoken; `root`: the bar in which the menu of the editor stands. */
export const comforts = (language: Speak, around: Around, root: HTMLElement): Extension => [
  EditorState.phrases.of(phrases(language)),
  bracketMatching(),
  highlightSelectionMatches(),
  assist(around, root),
  keymap.of([...searchKeymap, ...lintKeymap]),
];
