//! A document as numeric code.

use std::fmt::Write;
use unoclp_draw::edit::Emitted;

/// A line for each code, with its letters, the rungs under what they are about.
pub(super) fn text(emitted: &Emitted<'_>) -> String {
    let mut text = String::new();
    for line in emitted.document().title() {
        let _ = writeln!(text, "/ {line}");
    }
    text += "0\n";
    for (rung, steps) in emitted.rungs() {
        text.push('\n');
        for line in &rung.comment {
            let _ = writeln!(text, "/ {line}");
        }
        for step in steps {
            let mut codes = step.codes();
            if let Some(code) = codes.next() {
                let _ = writeln!(text, "{code:<9} / {step}");
            }
            for operand in codes {
                let _ = writeln!(text, "{operand}");
            }
        }
    }
    text
}
