//! The units of a project, as lines in the words of the standard.

use crate::text::decode;
use std::fmt::Write;
use unoclp_lang::Told;
use unoclp_plcopen::{Outline, Row, outline};

/// The text of a project, and its types, units and variables, a line each: `PROGRAM main (FBD)`, below it
/// `  VAR start AT %IX0.0 : BOOL (* the button *)`.
///
/// # Errors
/// Where it is no project.
pub fn units(bytes: &[u8]) -> (String, Result<String, Told>) {
    let text = decode(bytes);
    let lines = outline(&text).map(|outline| lines(&outline));
    (text, lines)
}

fn lines(outline: &Outline) -> String {
    let mut lines = String::new();
    for name in &outline.types {
        let _ = writeln!(lines, "TYPE {name}");
    }
    outline
        .globals
        .iter()
        .for_each(|row| self::row(&mut lines, "", row));
    for unit in &outline.units {
        let kind = match unit.kind.as_str() {
            "functionBlock" => "FUNCTION_BLOCK",
            "function" => "FUNCTION",
            _ => "PROGRAM",
        };
        let gives = unit.gives.as_ref();
        let gives = gives.map_or(String::new(), |kind| format!(" : {kind}"));
        let language = match &*unit.language {
            "" => "-",
            language => language,
        };
        let _ = write!(lines, "{kind} {}{gives} ({language})", unit.name);
        comment(&mut lines, &unit.comment);
        unit.variables
            .iter()
            .for_each(|row| self::row(&mut lines, "  ", row));
    }
    lines
}

fn row(lines: &mut String, indent: &str, row: &Row) {
    let section = match row.section.as_str() {
        "inputVars" => "VAR_INPUT",
        "outputVars" => "VAR_OUTPUT",
        "inOutVars" => "VAR_IN_OUT",
        "externalVars" => "VAR_EXTERNAL",
        "tempVars" => "VAR_TEMP",
        "globalVars" => "VAR_GLOBAL",
        _ => "VAR",
    };
    let retained = if row.retained { " RETAIN" } else { "" };
    let constant = if row.constant { " CONSTANT" } else { "" };
    let place = row.place.as_ref();
    let place = place.map_or(String::new(), |place| format!(" AT {place}"));
    let first = row.first.as_ref();
    let first = first.map_or(String::new(), |first| format!(" := {first}"));
    let (name, kind) = (&row.name, &row.kind);
    let _ = write!(
        lines,
        "{indent}{section}{retained}{constant} {name}{place} : {kind}{first}"
    );
    comment(lines, &row.comment);
}

/// Ends a line with a comment, where there is one.
fn comment(lines: &mut String, comment: &str) {
    let words: Vec<&str> = comment.split_whitespace().collect();
    match words.is_empty() {
        true => lines.push('\n'),
        false => {
            let _ = writeln!(lines, " (* {} *)", words.join(" "));
        }
    }
}
