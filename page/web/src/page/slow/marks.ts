// What slow motion marks: the elements that come next and the breakpoints, in drawings and in the text.

import { RangeSetBuilder, StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";
import { byId } from "../dom";
import { reveal } from "../reveal";

/** Instructions, from the first to before the last. */
export type Range = readonly [from: number, until: number];

interface Lines {
  /** From 1; none. */
  readonly here: number | null;
  readonly stops: readonly number[];
}

const setLines = StateEffect.define<Lines>();
const [here, stop] = [Decoration.line({ class: "slow-here" }), Decoration.line({ class: "slow-stop" })];

const field = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    const told = transaction.effects.find((effect) => effect.is(setLines));
    if (!told) return marks.map(transaction.changes);
    const { here: now, stops } = told.value as Lines;
    const builder = new RangeSetBuilder<Decoration>();
    const { doc } = transaction.state;
    for (const line of [...new Set([...stops, ...(now === null ? [] : [now])])].filter((line) => line <= doc.lines).sort((one, other) => one - other)) {
      const { from } = doc.line(line);
      if (line === now) builder.add(from, from, here);
      if (stops.includes(line)) builder.add(from, from, stop);
    }
    return builder.finish();
  },
  provide: (own) => EditorView.decorations.from(own),
});

/** Marks lines of the text, and has the one that comes next be seen. */
export function markText(view: EditorView, lines: Lines): void {
  if (view.state.field(field, false) === undefined) view.dispatch({ effects: StateEffect.appendConfig.of(field) });
  const effects: StateEffect<unknown>[] = [setLines.of(lines)];
  if (lines.here !== null && lines.here <= view.state.doc.lines) effects.push(EditorView.scrollIntoView(view.state.doc.line(lines.here).from, { y: "nearest" }));
  view.dispatch({ effects });
}

/** Marks elements of the drawings that are shown, and parts of a chart. */
export function markDrawings(next: Range | null, stops: readonly number[]): void {
  let seen: Element | null = null;
  for (const [element, holds] of [...drawn(), ...charted()]) {
    const comes = next !== null && holds(...next);
    element.classList.toggle("slow-here", comes);
    element.classList.toggle("slow-stop", stops.some((step) => holds(step, step + 1)));
    if (comes && element.getClientRects().length > 0) seen ??= element;
  }
  if (seen) reveal(seen);
}

/** Whether one of these instructions is an element's. */
type Holds = (...[from, until]: Range) => boolean;

/** The parts of the chart that is shown. */
function charted(): (readonly [Element, Holds])[] {
  return [...document.querySelectorAll<SVGElement>("#chart-sheet [data-code]")].map((part) => {
    const steps = codeOf(part);
    return [part, (from, until) => steps.some((step) => from <= step && step < until)];
  });
}

/** The elements of the drawings. */
function drawn(): (readonly [Element, Holds])[] {
  return [byId("ladder"), byId("draw")].flatMap((root) =>
    [...root.querySelectorAll<SVGElement>(".rung")].flatMap((rung) => {
      const first = Number(rung.dataset["first"]);
      return [...rung.querySelectorAll<SVGElement>(".element[data-steps]")].flatMap((element) => {
        const steps = stepsOf(element);
        const [own, last] = [first + Math.min(...steps), first + Math.max(...steps)];
        return steps.length > 0 ? [[element, (from: number, until: number) => own < until && last >= from] as const] : [];
      });
    }),
  );
}

/** The instruction of what is selected in the drawing; `null` where nothing is. */
export function selected(): number | null {
  const one = document.querySelector<SVGElement>("#draw .selected");
  const rung = one?.closest<SVGElement>(".rung");
  if (!one || !rung) return null;
  const steps = stepsOf(one);
  return Number(rung.dataset["first"]) + (steps.length > 0 ? Math.min(...steps) : 0);
}

/** The part of a chart that is selected where one is shown: what it is, and its first instruction. */
export function selectedPart(): { readonly name: string; readonly step: number | null } | null {
  const part = document.querySelector<SVGElement>("#chart-sheet .selected[data-code]");
  if (!part || part.getClientRects().length === 0) return null;
  return { name: part.dataset["said"] ?? "", step: codeOf(part)[0] ?? null };
}

/** The instructions that a part of a chart has become. */
function codeOf(part: SVGElement): number[] {
  return (part.dataset["code"] ?? "").split(" ").filter(Boolean).map(Number);
}

/** The instructions of an element, from the first of its rung; some elements have none of their own. */
function stepsOf(element: SVGElement): number[] {
  return (element.dataset["steps"] ?? "").split(" ").filter(Boolean).map(Number);
}
