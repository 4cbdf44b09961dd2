// Colours of the text, as Rust's own lexers say them. Until they say so of what was typed last, those of before move along.

import { RangeSetBuilder, StateEffect, StateField, type Text } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";
import type { Checked } from "../tools/answers";

const MARKS = ["comment", "text", "point", "number", "word"].map((kind) => Decoration.mark({ class: `c-${kind}` }));

const setColours = StateEffect.define<DecorationSet>();

export const colours = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(before, transaction) {
    for (const effect of transaction.effects) if (effect.is(setColours)) return effect.value;
    return before.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Paints the text that was looked at. */
export function paint(doc: Text, parts: Checked["colours"]): StateEffect<DecorationSet> {
  const builder = new RangeSetBuilder<Decoration>();
  let at = 0;
  for (let part = 0; part + 2 < parts.length; part += 3) {
    const from = at + (parts[part] ?? 0);
    at = from + (parts[part + 1] ?? 0);
    const mark = MARKS[parts[part + 2] ?? -1];
    if (mark && from < at && at <= doc.length) builder.add(from, at, mark);
  }
  return setColours.of(builder.finish());
}
