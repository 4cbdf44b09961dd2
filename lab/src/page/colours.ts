// Colours of the text. Only what is on the screen is looked at, line by line; what it means is Rust's to say.

import { RangeSetBuilder } from "@codemirror/state";
import { Decoration, type DecorationSet, type EditorView, ViewPlugin, type ViewUpdate } from "@codemirror/view";

const MARKS = {
  comment: Decoration.mark({ class: "c-comment" }),
  text: Decoration.mark({ class: "c-text" }),
  point: Decoration.mark({ class: "c-point" }),
  number: Decoration.mark({ class: "c-number" }),
  word: Decoration.mark({ class: "c-word" }),
};

const WORDS = [
  "LDN? LDI LD NOT STN? ST S R AND ANDN ANI A AN OR ORN ORI O ON XORN? NOT OUT SET RST CAL CALCN? JMPC?N? RETC?N? ADD SUB MUL DIV MOD",
  "GT GE EQ NE LE LT MOVE SEL LIMIT MIN MAX ABS R_TRIG F_TRIG TON TOF TP TONR CTU CTD CTUD SR RS",
  "PROGRAM END_PROGRAM FUNCTION END_FUNCTION FUNCTION_BLOCK END_FUNCTION_BLOCK VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_GLOBAL",
  "VAR_EXTERNAL END_VAR CONSTANT RETAIN AT TYPE END_TYPE STRUCT END_STRUCT ARRAY OF IF THEN ELSIF ELSE END_IF CASE END_CASE FOR TO BY DO",
  "END_FOR WHILE END_WHILE REPEAT UNTIL END_REPEAT EXIT CONTINUE RETURN BOOL SINT INT DINT USINT UINT UDINT REAL TIME BYTE WORD DWORD",
  "TRUE FALSE BEGIN ORGANIZATION_BLOCK END_ORGANIZATION_BLOCK BLOCO FIM_BLOCO SE ENTAO SENAO FIM_SE CLP FIM REDE",
].join(" ").replaceAll(" ", "|");

const TOKEN = new RegExp(
  [
    String.raw`(?<comment>\(\*[^]*?(?:\*\)|$)|\/\/[^\n]*|^[ \t]*\/[^\n]*|(?<=^[ \t]*-?\d+[ \t]*)\/[^\n]*)`,
    String.raw`(?<text>'[^'\n]*'?|"[^"\n]*"?)`,
    String.raw`(?<point>%?\b(?:[IQMTCADP]|IX|QX|MX|MD|MW|IW)\d+(?:\.\d+)?\b)`,
    String.raw`(?<number>\b(?:T|TIME)#[\w.]+|\b\d[\w.#]*)`,
    String.raw`(?<word>\b(?:${WORDS})\b)`,
  ].join("|"),
  "gim",
);

function colour(view: EditorView): DecorationSet {
  const builder = new RangeSetBuilder<Decoration>();
  const { doc } = view.state;
  for (const { from, to } of view.visibleRanges) {
    // A comment may have begun some lines above.
    const start = doc.lineAt(Math.max(0, from - 2000)).from;
    for (const match of doc.sliceString(start, to).matchAll(TOKEN)) {
      const kind = Object.entries(match.groups ?? {}).find(([, text]) => text !== undefined)?.[0];
      const at = start + match.index;
      const end = at + match[0].length;
      if (kind && end > from) builder.add(at, end, MARKS[kind as keyof typeof MARKS]);
    }
  }
  return builder.finish();
}

export const colours = ViewPlugin.fromClass(
  class {
    decorations: DecorationSet;

    constructor(view: EditorView) {
      this.decorations = colour(view);
    }

    update(update: ViewUpdate): void {
      if (update.docChanged || update.viewportChanged) this.decorations = colour(update.view);
    }
  },
  { decorations: (plugin) => plugin.decorations },
);
