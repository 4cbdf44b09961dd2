// What can be done to what is selected: each with its words, its key, and what it asks of Rust.

import type { Act } from "../../tools/answers";
import type { DRAW } from "../../words/drawtable";
import type { Plain } from "../../words/words";

export interface Action {
  readonly say: Plain<typeof DRAW>;
  /** As `KeyboardEvent` has it, with Ctrl+, Alt+ and Shift+ before it. */
  readonly key: string;
  /** What Rust does; or what the screen does by itself. */
  readonly act: Act | "edit" | "paste" | "help" | "where" | "find" | "comment" | "rung";
  /** Whether the menu leaves it out. */
  readonly quiet?: true;
}

/** The keys are those of LDmicro where it has some that clash with nothing here. */
export const ACTIONS: readonly Action[] = [
  { say: "edit", key: "Enter", act: "edit" },
  { say: "comment", key: ";", act: "comment" },
  { say: "branch", key: "b", act: { do: "branch" } },
  { say: "around", key: "g", act: { do: "out" } },
  { say: "widen", key: "]", act: { do: "stretch", along: "forth", out: true } },
  { say: "narrow", key: "[", act: { do: "stretch", along: "forth", out: false } },
  { say: "toggle", key: "n", act: { do: "toggle" } },
  { say: "toSet", key: "s", act: { do: "coil", coil: "set" } },
  { say: "toReset", key: "r", act: { do: "coil", coil: "reset" } },
  { say: "remove", key: "Delete", act: { do: "delete" } },
  { say: "cut", key: "Ctrl+x", act: { do: "cut" } },
  { say: "copy", key: "Ctrl+c", act: { do: "copy" } },
  { say: "paste", key: "Ctrl+v", act: "paste" },
  { say: "rungBelow", key: "Shift+Enter", act: { do: "insertRung", along: "forth" } },
  { say: "rungAbove", key: "Alt+Enter", act: { do: "insertRung", along: "back" } },
  { say: "rungDelete", key: "Shift+Delete", act: "rung" },
  { say: "rungUp", key: "Alt+ArrowUp", act: { do: "moveRung", along: "back" } },
  { say: "rungDown", key: "Alt+ArrowDown", act: { do: "moveRung", along: "forth" } },
  { say: "split", key: "p", act: { do: "split" } },
  { say: "join", key: "q", act: { do: "join" } },
  { say: "drawUndo", key: "Ctrl+z", act: { do: "undo" }, quiet: true },
  { say: "drawRedo", key: "Ctrl+y", act: { do: "redo" }, quiet: true },
  { say: "drawRedo", key: "Ctrl+Shift+z", act: { do: "redo" }, quiet: true },
  { say: "moveKeys", key: "ArrowLeft", act: { do: "move", to: "left" }, quiet: true },
  { say: "moveKeys", key: "ArrowRight", act: { do: "move", to: "right" }, quiet: true },
  { say: "moveKeys", key: "ArrowUp", act: { do: "move", to: "up" }, quiet: true },
  { say: "moveKeys", key: "ArrowDown", act: { do: "move", to: "down" }, quiet: true },
  { say: "extendKeys", key: "Shift+ArrowLeft", act: { do: "extend", along: "back" }, quiet: true },
  { say: "extendKeys", key: "Shift+ArrowRight", act: { do: "extend", along: "forth" }, quiet: true },
  { say: "extendKeys", key: "Shift+ArrowUp", act: { do: "extend", along: "back" }, quiet: true },
  { say: "extendKeys", key: "Shift+ArrowDown", act: { do: "extend", along: "forth" }, quiet: true },
  { say: "whereKeys", key: "w", act: "where", quiet: true },
  { say: "find", key: "Ctrl+f", act: "find", quiet: true },
  { say: "keys", key: "?", act: "help", quiet: true },
];

/** What a key press is called in the table. */
export function keyOf(event: KeyboardEvent): string {
  const letter = event.key.length === 1;
  const shift = event.shiftKey && (!letter || event.ctrlKey || event.metaKey);
  const key = letter ? event.key.toLowerCase() : event.key;
  return `${event.ctrlKey || event.metaKey ? "Ctrl+" : ""}${event.altKey ? "Alt+" : ""}${shift ? "Shift+" : ""}${key}`;
}
