//! Projects that are compiled as a text: in Instruction List alone, or in Structured Text with all other bodies beside it.

use crate::found::{Found, span};
use crate::imported::Imported;
use crate::project::{Pou, Project, Variable};
use crate::repeated::repeated;
use crate::sfc;
use crate::st::{self, Units};
use crate::text::Text;
use crate::types::{Types, kind};
use crate::xml::first;
use std::collections::{HashSet, VecDeque};
use unoclp_core::Board;
use unoclp_lang::{Code, Span, TextLanguage, Word, compile_text};

/// Compiles a project as a text in this language; one in Instruction List that calls other bodies, as Structured Text.
pub(crate) fn compile(
    xml: &str,
    project: &Project<'_, '_>,
    language: TextLanguage,
    board: Board,
    found: &mut Found,
    imported: &mut Imported,
) {
    let (mut written, language) = write(xml, project, language, found);
    written.unqualified(&project.lists);
    if found.has_errors() {
        return;
    }
    let text = &written.text;
    let mut made = compile_text(text, language, board);
    let code = made.file();
    let (variables, traces) = made.take_shown();
    imported.variables = variables;
    imported.traces = written.traced(xml, traces);
    for diagnostic in &made.diagnostics.listed {
        found.take(written.moved(diagnostic));
    }
    if found.has_errors() {
        return;
    }
    imported.charts = unoclp_sfc::Document::all(text);
    imported.code = code;
    let program = made.program;
    if let Some((_, map)) = &program {
        let charts = imported.charts.iter();
        imported.origins = charts.map(|of| of.origins(map.at())).collect();
    }
    imported.program = program.map(|(checked, map)| (checked, written.placed(xml, map)));
}

/// The text of a project in Structured Text, as far as its bodies can be read.
pub(crate) fn as_text(xml: &str, project: &Project<'_, '_>, found: &mut Found) -> Text {
    write(xml, project, TextLanguage::St, found).0
}

/// The text of a project, and the language that it is in. Functions and blocks that are drawn, or in a language that is not
/// imported, count where
/// something uses them.
fn write(
    xml: &str,
    project: &Project<'_, '_>,
    language: TextLanguage,
    found: &mut Found,
) -> (Text, TextLanguage) {
    let mut written = Text::default();
    let types = Types::of(&project.types, &project.lent);
    types.write(&mut written);
    if !project.globals.is_empty() {
        section(&mut written, "VAR_GLOBAL", project.globals.iter(), found);
    }
    let units = Units::of(&project.others, &types);
    let own = if language == TextLanguage::Il {
        "IL"
    } else {
        "ST"
    };
    let is_text = |pou: &&Pou<'_, '_>| pou.body.is_some_and(|(language, _)| language == own);
    let is_library = project.programs.is_empty();
    let units_of_text = project
        .others
        .iter()
        .filter(|pou| is_library || is_text(pou));
    let mut waiting: VecDeque<&Pou<'_, '_>> = units_of_text.collect();
    let mut programs: Vec<&Pou<'_, '_>> = project.programs.iter().collect();
    programs.dedup_by_key(|pou| pou.name.clone());
    waiting.extend(programs);
    let mut named: HashSet<String> = HashSet::new();
    named.extend(waiting.iter().map(|pou| pou.name.to_uppercase()));
    while let Some(pou) = waiting.pop_front() {
        let from = written.text.len();
        let body = match pou.body {
            Some((of_text, body)) if of_text == own => Some(body),
            Some(("LD" | "FBD", body)) if own == "ST" => {
                let drawn = st::write(pou, body, &project.globals, &units, found);
                write_pou(&mut written, pou, &drawn.variables, found, |to| {
                    for (piece, from) in &drawn.pieces {
                        to.piece(piece, *from);
                    }
                });
                None
            }
            Some(("SFC", body)) if own == "ST" => {
                let chart = sfc::write((xml, pou), body, &project.globals, &units, found);
                write_pou(&mut written, pou, &chart.variables, found, |to| {
                    to.add(chart.text)
                });
                None
            }
            Some(("IL", body)) if own == "ST" => {
                let list = st::list::write(xml, pou, body, &project.globals, found);
                write_pou(&mut written, pou, &list.variables, found, |to| {
                    for (piece, from) in &list.pieces {
                        to.piece(piece, *from);
                    }
                });
                None
            }
            Some(("LD" | "FBD" | "SFC" | "ST", _)) => {
                return write(xml, project, TextLanguage::St, found);
            }
            other => {
                refuse(pou, other.map_or("?", |(language, _)| language), found);
                None
            }
        };
        if let Some(body) = body {
            write_pou(&mut written, pou, &[], found, |to| {
                let from = to.text.len();
                to.body(xml, body);
                if own == "ST" {
                    to.blank(from, &repeated(&to.text[from..], !pou.variables.is_empty()));
                }
            });
        }
        let new = written.text.get(from..).unwrap_or_default();
        let words = new.split(|c: char| !c.is_alphanumeric() && c != '_');
        for word in words.filter(|word| !word.is_empty()) {
            if let Some(other) = units.get(word)
                && named.insert(word.to_uppercase())
            {
                waiting.push_back(other);
            }
        }
    }
    (written, language)
}

/// Tells that a body cannot be imported, and what it is.
pub(crate) fn refuse(pou: &Pou<'_, '_>, language: &str, found: &mut Found) {
    let (what, help): (Word, Word) = match language {
        "?" => (
            ("empty", "vazio").into(),
            ("draw or write its body", "desenhe ou escreva o corpo dele").into(),
        ),
        "" => (
            ("on several sheets", "dividido em várias folhas").into(),
            ("put it on one sheet", "ponha-o em uma folha só").into(),
        ),
        other => (
            Word::Both(format!("in {other}"), format!("em {other}")),
            (
                "write it in ST, or draw it in LD",
                "escreva-o em ST, ou desenhe-o em LD",
            )
                .into(),
        ),
    };
    found.tell(
        Code::XmlBody,
        pou.node,
        [pou.name.clone().into(), what, help],
    );
}

fn write_pou(
    to: &mut Text,
    pou: &Pou<'_, '_>,
    added: &[(String, String, Span)],
    found: &mut Found,
    body: impl FnOnce(&mut Text),
) {
    let (begin, end) = match pou.kind.as_str() {
        "function" => ("FUNCTION", "END_FUNCTION"),
        "functionBlock" => ("FUNCTION_BLOCK", "END_FUNCTION_BLOCK"),
        _ => ("PROGRAM", "END_PROGRAM"),
    };
    let at = span(pou.node);
    to.piece(&format!("{begin} {}", pou.name), at);
    let returns = first(pou.node, "interface").and_then(|of| first(of, "returnType"));
    if let Some(returns) = returns {
        to.piece(&format!(" : {}", kind(returns)), span(returns));
    }
    to.piece("\n", at);
    let mut rest = &pou.variables[..];
    while let Some(first) = rest.first() {
        let like = |other: &&Variable| {
            other.section == first.section
                && other.retain == first.retain
                && other.constant == first.constant
        };
        let count = rest.iter().take_while(like).count();
        let name = match first.section.as_str() {
            "inputVars" => "VAR_INPUT",
            "outputVars" => "VAR_OUTPUT",
            "inOutVars" => "VAR_IN_OUT",
            "externalVars" => "VAR_EXTERNAL",
            "tempVars" => "VAR_TEMP",
            _ => "VAR",
        };
        section(to, name, rest[..count].iter(), found);
        rest = &rest[count..];
    }
    if !added.is_empty() {
        to.piece("VAR\n", at);
        for (name, kind, at) in added {
            to.piece(&format!("  {name} : {kind};\n"), *at);
        }
        to.piece("END_VAR\n", at);
    }
    body(to);
    to.piece(&format!("\n{end}\n"), at);
}

fn section<'v>(
    to: &mut Text,
    section: &str,
    variables: impl Iterator<Item = &'v Variable>,
    found: &mut Found,
) {
    let mut variables = variables.peekable();
    let Some(first) = variables.peek() else {
        return;
    };
    let retain = if first.retain { " RETAIN" } else { "" };
    let constant = if first.constant { " CONSTANT" } else { "" };
    to.piece(&format!("{section}{retain}{constant}\n"), first.at);
    let mut at = first.at;
    for variable in variables {
        let Variable { name, kind, .. } = variable;
        at = variable.at;
        let place = variable.address.as_ref();
        let place = place.map_or(String::new(), |address| format!(" AT {address}"));
        let mut first = variable.initial.as_ref();
        let is_input = variable.address.as_ref().is_some_and(|address| {
            let address = address.trim_start_matches('%');
            address.starts_with(['I', 'i'])
        });
        if let (Some(value), true) = (first, is_input) {
            // Inputs are read before the first scan; a value that they have anyway is no mistake.
            if !matches!(&*value.to_uppercase(), "0" | "FALSE") {
                let who = ("the program", "o programa").into();
                found.tell_at(Code::XmlFirst, at, [who, name.as_str().into()]);
            }
            first = None;
        }
        let first = first.map_or(String::new(), |first| format!(" := {first}"));
        to.piece(&format!("  {name}{place} : {kind}{first};\n"), at);
    }
    to.piece("END_VAR\n", at);
}
