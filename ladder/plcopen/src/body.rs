//! Bodies of text: Structured Text and Instruction List, with the declarations that stand in XML.

use crate::found::{Found, span};
use crate::imported::Imported;
use crate::project::{Pou, Project, Variable};
use crate::xml::first;
use roxmltree::Node;
use unoclp_checked::SourceMap;
use unoclp_core::Board;
use unoclp_lang::{
    Code, Diagnostic, Lines, Options, Span, TextLanguage, Trace, compile_text, compile_untyped,
    has_types,
};

/// A text, and where its pieces stand in the XML.
#[derive(Default)]
struct Text {
    text: String,
    /// The first byte of each piece, the first byte of what it came from, and whether both go on alike.
    pieces: Vec<(u32, Span, bool)>,
}

/// Compiles the programs of a project whose bodies are in this language.
pub(crate) fn compile(
    xml: &str,
    project: &Project<'_, '_>,
    language: &str,
    board: Board,
    found: &mut Found,
    imported: &mut Imported,
) {
    let mut written = Text::default();
    let fine = project.others.iter().filter(|pou| match pou.body {
        // One in another language is told of where something uses it: it is not there.
        Some((own, _)) => own == language,
        None => false,
    });
    if !project.globals.is_empty() {
        written.section("VAR_GLOBAL", project.globals.iter());
    }
    let mut programs: Vec<&Pou<'_, '_>> = project.programs.iter().collect();
    programs.dedup_by_key(|pou| pou.name.clone());
    for pou in fine.chain(programs) {
        written.pou(xml, pou);
    }
    if let Some(types) = project.types.filter(|types| types.has_children())
        && let Some(of) = types.children().find(Node::is_element)
    {
        let name = ("the types of the project", "os tipos do projeto");
        let what = ("a table", "uma tabela");
        found.tell(Code::XmlBody, of, [name.into(), what.into()]);
        return;
    }
    let text = &written.text;
    let (diagnostics, lines, program) = match language {
        "IL" if !has_types(text) => {
            let options = Options {
                dialect: None,
                board,
            };
            let made = compile_untyped(text, &options);
            let file = made.file();
            (made.diagnostics, file, made.program)
        }
        other => {
            let language = match other {
                "IL" => TextLanguage::Il,
                _ => TextLanguage::St,
            };
            let made = compile_text(text, language, board);
            let file = made.file();
            imported.variables = made.variables;
            imported.traces = written.traced(xml, made.traces);
            (made.diagnostics, file, made.program)
        }
    };
    for diagnostic in &diagnostics.listed {
        found.take(written.moved(diagnostic));
    }
    if found.has_errors() {
        return;
    }
    imported.code = lines;
    imported.program = program.map(|(checked, map)| (checked, written.placed(xml, map)));
}

impl Text {
    fn pou(&mut self, xml: &str, pou: &Pou<'_, '_>) {
        let (begin, end) = match pou.kind.as_str() {
            "function" => ("FUNCTION", "END_FUNCTION"),
            "functionBlock" => ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK"),
            _ => ("PROGRAM", "END_PROGRAM"),
        };
        let at = span(pou.node);
        self.piece(&format!("{begin} {}", pou.name), at);
        let returns = first(pou.node, "interface").and_then(|of| first(of, "returnType"));
        if let Some(kind) = returns.and_then(|of| of.children().find(Node::is_element)) {
            let name = kind.attribute("name").map(str::to_owned);
            let name = name.unwrap_or_else(|| kind.tag_name().name().to_uppercase());
            self.piece(&format!(" : {name}"), span(kind));
        }
        self.piece("\n", at);
        let mut rest = &pou.variables[..];
        while let Some(first) = rest.first() {
            let like = |other: &&Variable| {
                other.section == first.section
                    && other.retain == first.retain
                    && other.constant == first.constant
            };
            let count = rest.iter().take_while(like).count();
            let section = match first.section.as_str() {
                "inputVars" => "VAR_INPUT",
                "outputVars" => "VAR_OUTPUT",
                "inOutVars" => "VAR_IN_OUT",
                "externalVars" => "VAR_EXTERNAL",
                "tempVars" => "VAR_TEMP",
                _ => "VAR",
            };
            self.section(section, rest[..count].iter());
            rest = &rest[count..];
        }
        if let Some((_, body)) = pou.body {
            self.body(xml, body);
        }
        self.piece(&format!("\n{end}\n"), at);
    }

    fn section<'v>(&mut self, section: &str, variables: impl Iterator<Item = &'v Variable>) {
        let mut variables = variables.peekable();
        let Some(first) = variables.peek() else {
            return;
        };
        let retain = if first.retain { " RETAIN" } else { "" };
        let constant = if first.constant { " CONSTANT" } else { "" };
        self.piece(&format!("{section}{retain}{constant}\n"), first.at);
        let mut at = first.at;
        for variable in variables {
            let Variable { name, kind, .. } = variable;
            at = variable.at;
            let place = variable.address.as_ref();
            let place = place.map_or(String::new(), |address| format!(" AT {address}"));
            let first = variable.initial.as_ref();
            let first = first.map_or(String::new(), |first| format!(" := {first}"));
            self.piece(&format!("  {name}{place} : {kind}{first};\n"), at);
        }
        self.piece("END_VAR\n", at);
    }

    /// The text of a body; where the file has it as it is, its bytes keep their places.
    fn body(&mut self, xml: &str, body: Node<'_, '_>) {
        for node in body.descendants().filter(Node::is_text) {
            let written = node.text().unwrap_or_default();
            let range = node.range();
            let raw = xml.get(range.clone()).unwrap_or_default();
            let own = raw.find(written).filter(|_| !written.is_empty());
            match own {
                Some(at) => {
                    let start = (range.start + at) as u32;
                    let end = start + written.len() as u32;
                    self.pieces
                        .push((self.text.len() as u32, Span { start, end }, true));
                    self.text.push_str(written);
                }
                None => self.piece(written, span(node)),
            }
        }
    }

    fn piece(&mut self, text: &str, from: Span) {
        self.pieces.push((self.text.len() as u32, from, false));
        self.text.push_str(text);
    }

    /// Where a byte of the text stands in the XML.
    fn place(&self, byte: u32) -> (u32, bool, Span) {
        let behind = self.pieces.partition_point(|(first, ..)| *first <= byte);
        let piece = behind.checked_sub(1).and_then(|at| self.pieces.get(at));
        match piece {
            Some((first, from, true)) => ((from.start + byte - first).min(from.end), true, *from),
            Some((_, from, false)) => (from.start, false, *from),
            None => (0, false, Span::default()),
        }
    }

    /// A diagnostic of the text as one of the XML.
    fn moved(&self, diagnostic: &Diagnostic) -> Diagnostic {
        let (start, is_alike, from) = self.place(diagnostic.span.start);
        let length = diagnostic.span.end - diagnostic.span.start;
        let span = match is_alike {
            true => Span {
                start,
                end: (start + length).min(from.end),
            },
            false => from,
        };
        diagnostic.at(span)
    }

    /// The byte of this line and column of the text.
    fn byte(&self, own: &Lines, line: usize, column: usize) -> u32 {
        let start = own.start(line as u32);
        let behind = self.text.get(start as usize..).unwrap_or_default();
        let before = behind.chars().take(column.saturating_sub(1));
        start + before.map(char::len_utf8).sum::<usize>() as u32
    }

    /// What the lines of the text show, as lines of the XML.
    fn traced(&self, xml: &str, mut traces: Vec<Trace>) -> Vec<Trace> {
        let (own, other) = (Lines::new(&self.text), Lines::new(xml));
        for trace in &mut traces {
            let (at, ..) = self.place(self.byte(&own, trace.line, trace.column));
            let (line, column) = other.place(xml, at);
            (trace.line, trace.column) = (line as usize, column as usize);
        }
        traces
    }

    /// The map of the text as one of the XML.
    fn placed(&self, xml: &str, mut map: SourceMap) -> SourceMap {
        let (own, other) = (Lines::new(&self.text), Lines::new(xml));
        for place in &mut map.steps {
            let (at, ..) = self.place(self.byte(&own, place.line, place.column));
            let (last, ..) = self.place(self.byte(&own, place.last, 1));
            let (line, column) = other.place(xml, at);
            let last = other.line(last).max(line);
            (place.line, place.column, place.last) =
                (line as usize, column as usize, last as usize);
        }
        map
    }
}
