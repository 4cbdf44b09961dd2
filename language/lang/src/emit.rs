//! From instructions to the lines of a program file, each with where it comes from.

use crate::diagnostics::{Code, Found, Lang, Lines, Span};
use crate::lacking;
use crate::lower::Lowered;
use crate::origin::Origin;
use crate::places::{Places, name};
use crate::rung::Written;
use unoclp_checked::{Checked, SourceMap};
use unoclp_core::isa::{self, Opcode, Operand};
use unoclp_core::{Board, Cause, Fault, Instruction, Number, Target, TimerBlock};

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

/// Writes out what has been compiled. The numbers of labels are decided here, and the marker that takes
/// the Q of timers that nobody asks for it.
pub(crate) fn emit(
    text: &str,
    lines: &Lines,
    lowered: &mut Lowered<'_>,
    found: &mut Found,
) -> (Vec<CodeLine>, Vec<Origin>) {
    let dialect = lowered.names.dialect;
    let labels = number_labels(lowered, found);
    let mut unused = None;
    let mut out = vec![CodeLine {
        code: isa::START,
        letters: "program start".to_owned(),
        symbol: String::new(),
        source: None,
    }];
    let mut origins = vec![Origin::default()];
    for &(number, span) in &lowered.names.retained.numbers {
        let instruction = match number {
            Number::Register(register) => Instruction::numbered(Opcode::KeepRegister, register),
            Number::Counter(counter) => Instruction::numbered(Opcode::KeepCounter, counter),
        };
        out.extend(instruction.codes().map(|code| CodeLine {
            code,
            letters: letters(instruction),
            symbol: lowered.names.written(span),
            source: Some(lines.line(span.start)),
        }));
        origins.push(Origin { span, name: None });
    }
    let label = |index: usize| labels.get(index).copied().flatten().unwrap_or(1);
    for step in &lowered.steps {
        let operand = |operand| move |opcode| Instruction { opcode, operand };
        let instruction = match step.written {
            Written::Plain(opcode) => Instruction::plain(opcode),
            Written::Numbered(opcode, number) => Instruction::numbered(opcode, number),
            Written::Value(opcode, value) => operand(Operand::Value(value))(opcode),
            Written::Table(opcode, first, length) => {
                operand(Operand::Table { first, length })(opcode)
            }
            Written::OfTimer(opcode, _, block) => Instruction::numbered(opcode, block.unwrap_or(1)),
            Written::Timer(opcode, preset, target) => {
                let target = target.unwrap_or_else(|| {
                    let temps = &mut lowered.names.temps;
                    Target::Marker(*unused.get_or_insert_with(|| temps.named_marker(false)))
                });
                let preset = preset.cast_unsigned();
                operand(Operand::Timer(TimerBlock { preset, target }))(opcode)
            }
            Written::Count(opcode, counter, preset) => {
                operand(Operand::Count { counter, preset })(opcode)
            }
            Written::Label(index) => Instruction::numbered(Opcode::Label, label(index)),
            Written::Jump(opcode, index) => {
                let label = label(index);
                operand(Operand::Jump { label, line: 0 })(opcode)
            }
            Written::Code(code) => {
                out.push(CodeLine {
                    code,
                    letters: String::new(),
                    symbol: String::new(),
                    source: Some(lines.line(step.span.start)),
                });
                origins.push(Origin {
                    span: step.span,
                    name: None,
                });
                continue;
            }
        };
        // What only holds others together comes from no word of the text.
        let symbol = match step.written {
            Written::Plain(_) => "",
            _ => text.get(step.span.range()).unwrap_or_default(),
        };
        let symbol = symbol.lines().next().unwrap_or_default().trim();
        for (index, code) in instruction.codes().enumerate() {
            let first = index == 0;
            out.push(CodeLine {
                code,
                letters: if first {
                    letters(instruction)
                } else {
                    String::new()
                },
                symbol: if first {
                    symbol.to_owned()
                } else {
                    String::new()
                },
                source: Some(lines.line(step.span.start)),
            });
            let name = if first {
                name(symbol, instruction.opcode, dialect).map(str::to_owned)
            } else {
                None
            };
            origins.push(Origin {
                span: step.span,
                name,
            });
        }
    }
    lowered.names.told_none_left(Span::default(), found);
    (out, origins)
}

/// What a code spells, with its XX.
pub(crate) fn letters(instruction: Instruction<'_>) -> String {
    let letters = instruction.opcode.row().letters;
    match instruction.number() {
        Some(number) => format!("{letters} {number:02}"),
        None => letters.to_owned(),
    }
}

/// The number of each label that stands in the program: the one that its name asks for, or one that is free.
fn number_labels(lowered: &Lowered<'_>, found: &mut Found) -> Vec<Option<u8>> {
    let mut numbers: Vec<Option<u8>> = vec![None; lowered.labels.len()];
    let standing = || {
        lowered.steps.iter().filter_map(|step| match step.written {
            Written::Label(index) => Some(index),
            _ => None,
        })
    };
    let most = lowered.names.board.labels;
    let mut used: u128 = 0;
    for step in &lowered.steps {
        // Labels that the text writes as codes keep their numbers.
        if let Written::Code(code) = step.written
            && let number = code - Opcode::Label.row().code
            && (1..=most.into()).contains(&number)
        {
            used |= 1 << number;
        }
    }
    for index in standing() {
        if let Some(number) = lowered.labels[index].number
            && used >> number & 1 == 0
        {
            used |= 1 << number;
            numbers[index] = Some(number);
        }
    }
    for index in standing() {
        if numbers[index].is_some() {
            continue;
        }
        match (1..=most).find(|number| used >> number & 1 == 0) {
            Some(number) => {
                used |= 1 << number;
                numbers[index] = Some(number);
            }
            None => {
                let words = ("label", "rótulo");
                found.tell(Code::NoneLeft, lowered.labels[index].span, [words.into()]);
                return numbers;
            }
        }
    }
    numbers
}

/// The program file, a line for each code. A comment says what the code spells, what of the text it comes
/// from, and of which line, where that is another than that of the code before.
pub(crate) fn file(lines: &[CodeLine]) -> String {
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
                    lacking::lacking(lacking, Lang::En),
                    lacking::lacking(lacking, Lang::Pt),
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
