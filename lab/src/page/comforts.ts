// What an editor has beyond writing: search, and words completed. The page loads it as soon as it is ready.

import { autocompletion, completeAnyWord } from "@codemirror/autocomplete";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import type { Extension } from "@codemirror/state";
import { keymap } from "@codemirror/view";

export const comforts: Extension = [
  highlightSelectionMatches(),
  autocompletion({ override: [completeAnyWord], activateOnTyping: false }),
  keymap.of(searchKeymap),
];
