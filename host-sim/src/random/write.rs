//! A program file, in one of the many ways to write it.

use super::stream::Random;
use unoclp_core::{Instruction, isa};

/// Writes a program file, in one of the many ways to do so (NC-2, NC-3).
pub(super) fn write(random: &mut Random, instructions: &[Instruction<'_>]) -> String {
    let line_end = if random.percent(30) { "\r\n" } else { "\n" };
    // Programs are either plain or decorated here and there.
    let decorated = if random.percent(50) { 10 } else { 0 };
    let mut text = String::new();
    if random.percent(decorated) {
        text.push('\u{FEFF}');
    }
    let codes = instructions
        .iter()
        .flat_map(|instruction| instruction.codes());
    for code in std::iter::once(isa::START).chain(codes) {
        if random.percent(decorated) {
            text.push_str(random.pick(BLANK_LINES).unwrap_or_default());
            text.push_str(line_end);
        }
        if random.percent(decorated) {
            text.push_str(random.pick(&[" ", "\t", "    "]).unwrap_or_default());
        }
        if code < 0 {
            text.push('-');
        }
        if random.percent(decorated) {
            text.push_str("000");
        }
        text.push_str(&code.unsigned_abs().to_string());
        if random.percent(decorated) {
            text.push_str(random.pick(AFTER_CODES).unwrap_or_default());
        }
        text.push_str(line_end);
    }
    if random.percent(decorated) {
        text.truncate(text.len() - line_end.len());
    }
    text
}

/// Lines without a code.
const BLANK_LINES: &[&str] = &[
    "",
    "  ",
    "\t",
    "/",
    "/ a comment",
    "  / partida do motor: ação",
];

/// What may be between a code and the end of its line.
const AFTER_CODES: &[&str] = &[" ", "\t ", "/", " / 827301", "\t// I1 \u{2192} Q1"];
