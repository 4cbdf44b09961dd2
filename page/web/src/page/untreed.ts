// What CodeMirror's keys ask a syntax tree. Rust's lexers colour the text, so there is none, and a line begins below the
// one before. The build gives this to `@codemirror/commands` in place of `@codemirror/language` and `@lezer/common`,
// which are a seventh of the editor; the page loads them as soon as it is ready.

import { Facet, type EditorState } from "@codemirror/state";
import type { matchBrackets as Match } from "@codemirror/language";

export const indentUnit = Facet.define<string, string>({ combine: ([unit]) => unit ?? "  " });
export const getIndentUnit = (state: EditorState): number => state.facet(indentUnit).length;
export const indentString = (_: EditorState, columns: number): string => " ".repeat(columns);

/** No place has an indentation of its own. */
export class IndentContext {}
export const getIndentation = (): null => null;

/** The bracket that belongs to one; none until the page has loaded what finds it. */
export let matchBrackets: typeof Match = () => null;
export function find(match: typeof Match): void {
  matchBrackets = match;
}

/** A tree of one node, which is all of the text. */
export function syntaxTree({ doc }: EditorState): object {
  const node = { from: 0, to: doc.length, type: { prop: () => undefined }, childBefore: () => null, childAfter: () => null };
  return { resolveInner: () => node, resolveStack: () => ({ node, next: null }) };
}
export const NodeProp = {};
