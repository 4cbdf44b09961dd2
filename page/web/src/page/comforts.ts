// What an editor has beyond writing: search, words completed, brackets matched, problems underlined. The page loads it as
// soon as it is ready.

import { autocompletion, completeAnyWord } from "@codemirror/autocomplete";
import { bracketMatching } from "@codemirror/language";
import { lintKeymap } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, type Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";
import type { Speak } from "../tools/answers";
import { phrases } from "../words/editortable";

export { setDiagnostics } from "@codemirror/lint";

/** All of it, in the language that is spoken. */
export const comforts = (language: Speak): Extension => [
  EditorState.phrases.of(phrases(language)),
  bracketMatching(),
  highlightSelectionMatches(),
  autocompletion({ override: [completeAnyWord], activateOnTyping: false }),
  keymap.of([...searchKeymap, ...lintKeymap]),
];
