// What an editor has beyond writing: search, words completed, brackets matched, problems underlined. The page loads it as
// soon as it is ready.

import { autocompletion, completeAnyWord } from "@codemirror/autocomplete";
import { bracketMatching, matchBrackets } from "@codemirror/language";
import { lintKeymap } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";
import { find } from "./untreed";

export { setDiagnostics } from "@codemirror/lint";

find(matchBrackets);

export const comforts: Extension = [
  bracketMatching(),
  highlightSelectionMatches(),
  autocompletion({ override: [completeAnyWord], activateOnTyping: false }),
  keymap.of([...searchKeymap, ...lintKeymap]),
];
