//! A document as the body of a program in Instruction List, for what no ladder of a project has a form.

use super::names::Variables;
use unoclp_core::Board;
use unoclp_draw::edit::{Document, Emitted};
use unoclp_lang::instructions_to_il;
use unoclp_point::Address;

/// A body, and the variables that it has.
pub(crate) struct Body {
    pub text: String,
    pub variables: Variables,
}

/// A body that says points by their names; of `plain`, by the board's words, without a variable.
pub(crate) fn body(document: &Document, board: Board, plain: bool) -> Body {
    let emitted = Emitted::of(document);
    let said = instructions_to_il(emitted.steps(), board);
    let mut variables = Variables::new(document.table().names());
    let mut rungs = document.rungs();
    let mut text = String::new();
    for (index, lines) in said.split("\n\n").enumerate() {
        if index > 0 {
            text.push('\n');
        }
        for line in rungs.next().iter().flat_map(|rung| &rung.comment) {
            let line = line.replace("*)", "* )").replace("(*", "( *");
            text += &format!("(* {} *)\n", cleared(&line));
        }
        for line in lines.lines() {
            match plain || line.starts_with("CODE") {
                true => text += line,
                false => text += &named(line, &mut variables),
            }
            text.push('\n');
        }
    }
    Body { text, variables }
}

/// A line with variables in place of points.
fn named(line: &str, variables: &mut Variables) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut named = String::new();
    let mut rest = line;
    while let Some(start) = rest.find(is_word) {
        let behind = rest.get(start..).unwrap_or_default();
        let end = behind.find(|c| !is_word(c)).unwrap_or(behind.len());
        let (word, after) = behind.split_at(end);
        named += rest.get(..start).unwrap_or_default();
        let spelled = word.strip_prefix("IW").map(|number| format!("A{number}"));
        let point = Address::parse(spelled.as_deref().unwrap_or(word));
        named += &match point {
            Some(point @ (Address::Input(_) | Address::Output(_) | Address::Marker(_))) => {
                variables.of(point, "BOOL")
            }
            Some(point @ Address::Register(_)) => variables.of(point, "DINT"),
            Some(point @ Address::Analogue(_)) => variables.of(point, "INT"),
            _ => word.to_owned(),
        };
        rest = after;
    }
    named + rest
}

/// A comment without what XML lacks, and without the end of a body.
fn cleared(line: &str) -> String {
    let cleared = line.replace("]]>", "]] >");
    let is_fine = |c: &char| *c >= ' ' && !matches!(c, '\u{FFFE}' | '\u{FFFF}');
    cleared.chars().filter(is_fine).collect()
}
