//! The lines of a program file, and whether the board takes them.

use crate::origin::Origin;
use crate::places::Places;
use unoclp_checked::{Checked, SourceMap};
use unoclp_core::{Board, Cause, Fault, Instruction};
use unoclp_text::diagnostics::{Code, Found, Lang, Span};

/// A line of the program file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeLine {
    /// The code or operand.
    pub code: i32,
    /// What the code spells, `RI 01`; empty of an operand line.
    pub letters: String,
    /// What of the text it comes from, such as `start`; it may be empty.
    pub symbol: String,
    /// The line of the text it comes from, from 1; none of program start.
    pub source: Option<u32>,
}

/// What a code spells, with its XX.
pub(crate) fn letters(instruction: Instruction<'_>) -> String {
    let letters = instruction.opcode.row().letters;
    match instruction.number() {
        Some(number) => format!("{letters} {number:02}"),
        None => letters.to_owned(),
    }
}

/// The program file, a line for each code. A comment says what the code spells, what of the text it comes
/// from, and of which line, where that is another than that of the code before.
pub fn file(lines: &[CodeLine]) -> String {
    let mut file = String::new();
    let mut told = None;
    for line in lines {
        let CodeLine {
            code,
            letters,
            symbol,
            source,
        } = line;
        let other = source.filter(|_| *source != told);
        told = *source;
        let place = other.map(|line| format!("line {line}"));
        let parts = [Some(symbol.clone()).filter(|s| !s.is_empty()), place];
        let from: Vec<String> = parts.into_iter().flatten().collect();
        let from = from.join(", ");
        let row = match (letters.is_empty(), from.is_empty()) {
            (true, true) => code.to_string(),
            (_, true) => format!("{code:<10}/ {letters}"),
            _ => format!("{code:<10}/ {letters:<8} {from}"),
        };
        file.push_str(row.trim_end());
        file.push('\n');
    }
    file
}

/// Gives the program to the loader, as the board would, and each of its steps a place.
pub(crate) fn check(
    text: &str,
    lines: &[CodeLine],
    origins: &[Origin],
    board: Board,
    mut places: Places<'_>,
    found: &mut Found,
) -> Option<(Checked, SourceMap)> {
    let mut faults = Vec::new();
    let mut lacking = [0; 2];
    let checked = Checked::new(board, |loader| {
        for ((line, origin), number) in lines.iter().zip(origins).zip(1..) {
            let before = loader.codes();
            let code = format!("{}\n", line.code);
            let told = code.bytes().filter_map(|byte| loader.push(byte).err());
            let full =
                |fault: &Fault| matches!(fault.cause, Cause::ProgramFull | Cause::RunMemoryFull);
            if faults.iter().any(full) {
                // Only how much is lacking is of interest.
                told.for_each(drop);
                continue;
            }
            faults.extend(told);
            match before {
                // Program start is no step.
                0 => {}
                _ if loader.codes() > before => places.begin(origin, number),
                _ => places.operand(origin, number),
            }
        }
        lacking = loader.lacking();
        if faults.is_empty() {
            while let Err(fault) = loader.end() {
                faults.push(fault);
            }
        }
    });
    for fault in faults {
        let index = fault.line.map_or(0, |line| line as usize - 1);
        let span = origins
            .get(index)
            .map_or(Span::default(), |origin| origin.span);
        match fault.cause {
            Cause::ProgramFull | Cause::RunMemoryFull => {
                let in_both = (
                    unoclp_text::lacking(lacking, Lang::En),
                    unoclp_text::lacking(lacking, Lang::Pt),
                );
                let most = [
                    board.stored_bytes.to_string().into(),
                    board.linked_bytes.to_string().into(),
                    in_both.into(),
                ];
                found.tell(Code::DoesNotFit, span, most);
            }
            Cause::PinUsedTwice => {
                let point = text.get(span.range()).unwrap_or_default();
                found.tell(Code::PinTwice, span, [point.into()]);
            }
            cause @ Cause::UnknownCode if !board.real => {
                let letters = lines.get(index).map_or("", |line| &line.letters);
                let both = (
                    format!("{letters}: the firmware of a Nano has no REAL numbers"),
                    format!("{letters}: o firmware de um Nano não tem números REAL"),
                );
                let words = [cause.number().to_string().into(), both.into()];
                found.tell(Code::Refused, span, words);
            }
            cause => {
                let words = [cause.number().to_string().into(), cause.text().into()];
                found.tell(Code::Refused, span, words);
            }
        }
    }
    Some((checked.ok()?, places.finish()))
}
