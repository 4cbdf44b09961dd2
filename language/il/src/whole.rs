//! What is wrong with a text as a whole.

use crate::ast::{Stmt, Unit};
use unoclp_text::diagnostics::{Code, Found, Span};

/// Whether a text can be understood. Where it is another language, or a comment swallows its end, all else
/// that was told follows from that, and is left out.
pub(crate) fn is_readable(found: &mut Found) -> bool {
    for code in [Code::NumericCode, Code::StructuredText] {
        if let Some(first) = found.place_of(code) {
            found.keep(|d| d.code == code && d.span == first);
            return false;
        }
    }
    let swallows = found.place_of(Code::CommentOpen).is_some();
    if swallows {
        found.keep(|d| d.code != Code::Structure);
    }
    !swallows
}

/// Whether there is a program, and whether it does anything.
pub(crate) fn check(text: &str, units: &[Unit], writes: bool, found: &mut Found) {
    let acts = |unit: &Unit| unit.body.iter().any(|stmt| matches!(stmt, Stmt::Instr(_)));
    let (program, others) = match units {
        [program, others @ ..] => (program, others),
        [] => return,
    };
    let end = text.trim_end().len() as u32;
    let end = Span { start: end, end };
    if found.has_errors() {
    } else if !acts(program) {
        let missing: (&str, &str) = match (others, program.vars.as_slice()) {
            ([], []) => ("the text has no instructions", "o texto não tem instruções"),
            ([], _) => (
                "the text has only declarations",
                "o texto só tem declarações",
            ),
            _ => (
                "functions and function blocks do nothing until a program calls them",
                "funções e blocos de funções não fazem nada até que um programa os chame",
            ),
        };
        found.tell(Code::NoProgram, end, [missing.into()]);
    } else if !writes {
        found.tell(Code::NothingWritten, end, []);
    }
}
