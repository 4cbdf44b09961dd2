//! A document as numeric code.

use super::parts::rungs;
use std::fmt::Write;
use unoclp_core::Program;
use unoclp_draw::edit::Document;

/// A line for each code, with its letters, the rungs under what they are about.
pub(super) fn text(document: &Document, program: &Program<'_>) -> String {
    let mut text = String::new();
    for line in document.title() {
        let _ = writeln!(text, "/ {line}");
    }
    text += "0\n";
    let rungs = rungs(document, program);
    let mut rungs = rungs.iter().peekable();
    for (index, step) in program.steps().enumerate() {
        if let Some((_, rung)) = rungs.next_if(|(first, _)| *first == index) {
            text.push('\n');
            for line in &rung.comment {
                let _ = writeln!(text, "/ {line}");
            }
        }
        let mut codes = step.codes();
        if let Some(code) = codes.next() {
            let _ = writeln!(text, "{code:<9} / {step}");
        }
        for operand in codes {
            let _ = writeln!(text, "{operand}");
        }
    }
    text
}
