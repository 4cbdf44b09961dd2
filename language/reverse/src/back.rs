//! From the numeric code to Instruction List.
//!
//! A rung is written as Instruction List would say it, where that compiles to the same codes again; else its
//! codes stand in the text as they are, with CODE. Which of the two is found by compiling. What stands after the last
//! that a rung drives has no effect, so no compiler would write it: it alone stands there as codes.

use crate::spell::rung;
use unoclp_codegen::{CompiledText, compile};
use unoclp_core::isa::Class;
use unoclp_core::{Board, Fault, Instruction, Loader};
use unoclp_text::Dialect;
use unoclp_text::diagnostics::{Found, Lines, Severity};
use unoclp_tree::Options;

/// Reads a program file back as Instruction List, which compiles to the same codes.
///
/// # Errors
/// The file's first fault.
pub fn to_il(file: &[u8], board: Board) -> Result<String, Fault> {
    let mut memory = vec![0; usize::from(board.linked_bytes)];
    let mut loader = Loader::new(&mut memory, board);
    for &byte in file {
        loader.push(byte)?;
    }
    let program = loader.finish()?;
    Ok(instructions_to_il(program.steps(), board))
}

/// Likewise the instructions of a checked program.
pub fn instructions_to_il<'c>(
    steps: impl Iterator<Item = Instruction<'c>>,
    board: Board,
) -> String {
    let mut rungs = split(steps);
    let wanted: Vec<i32> = std::iter::once(0)
        .chain(rungs.iter().flat_map(|rung| rung.codes.iter().copied()))
        .collect();
    let options = Options {
        dialect: Some(Dialect::Iec),
        board,
    };
    // Each turn that fails takes one more rung as it is; all of them as they are compile for certain.
    for _ in 0..=rungs.len() {
        let (text, first_lines) = write(&rungs);
        let compiled = compiled(&text, &options);
        let Some((at, line)) = difference(&compiled, &text, &wanted) else {
            return text;
        };
        let by_line = first_lines
            .partition_point(|&first| first <= line)
            .saturating_sub(1);
        let by_code = rung_at(&rungs, at);
        let mut candidates = [by_code, by_line, by_code.wrapping_sub(1)].into_iter();
        let guilty =
            candidates.find(|&index| rungs.get(index).is_some_and(|rung| rung.spelled.is_some()));
        let guilty = guilty.or_else(|| rungs.iter().position(|rung| rung.spelled.is_some()));
        match guilty {
            Some(index) => rungs[index].spelled = None,
            None => break,
        }
    }
    write(&rungs).0
}

/// Likewise, but that nobody has compiled it yet: what does not compile to these instructions again takes
/// [`instructions_to_il`].
pub fn spelled<'c>(steps: impl Iterator<Item = Instruction<'c>>) -> String {
    write(&split(steps)).0
}

fn compiled(text: &str, options: &Options) -> CompiledText {
    let mut found = Found::default();
    let read = unoclp_il::read(text, options, &mut found);
    compile(text, read, options.board, found)
}

/// A rung, and how it may be written.
struct Rung {
    /// Its codes, with NL where it begins with one.
    codes: Vec<i32>,
    /// The codes as they are.
    verbatim: Vec<String>,
    /// As Instruction List; none where it cannot be said so.
    spelled: Option<Vec<String>>,
}

fn split<'c>(steps: impl Iterator<Item = Instruction<'c>>) -> Vec<Rung> {
    let mut rungs: Vec<Vec<Instruction<'c>>> = vec![Vec::new()];
    let mut ended = false;
    for step in steps {
        if ended || matches!(step.opcode.class(), Class::Rung | Class::Part) {
            rungs.push(Vec::new());
        }
        ended = step.opcode.class() == Class::If;
        if let Some(rung) = rungs.last_mut() {
            rung.push(step);
        }
    }
    let mut timers = 0;
    rungs
        .into_iter()
        .filter(|steps| !steps.is_empty())
        .map(|steps| {
            let verbatim: Vec<String> = steps.iter().map(|step| verbatim(*step)).collect();
            let driven = driven(&steps);
            let spelled = rung(&steps[..driven], &mut timers);
            Rung {
                codes: steps.iter().flat_map(|step| step.codes()).collect(),
                spelled: spelled.map(|lines| [lines, verbatim[driven..].to_vec()].concat()),
                verbatim,
            }
        })
        .collect()
}

/// How many steps of a rung lead to what it drives; all, where it drives nothing.
fn driven(steps: &[Instruction<'_>]) -> usize {
    let (mut depth, mut drives, mut end) = (0_usize, false, 0);
    for (index, step) in steps.iter().enumerate() {
        let class = step.opcode.class();
        match class {
            Class::Close => depth = depth.saturating_sub(1),
            class if class.opens() => depth += 1,
            class => drives |= !is_wire(class),
        }
        if depth == 0 && std::mem::take(&mut drives) {
            end = index + 1;
        }
    }
    // What begins or ends a part, and a label, are no wire: a rung of them alone is spelled whole.
    if end == 0 { steps.len() } else { end }
}

/// Whether an instruction only makes the result, or the value, that another one uses.
fn is_wire(class: Class) -> bool {
    match class {
        Class::OpenOr | Class::OpenAnd | Class::OpenXor | Class::Close => true,
        Class::Contact | Class::Condition | Class::ValueContact | Class::Comparison => true,
        Class::Xor | Class::Logic | Class::Load | Class::LoadResult | Class::Operation => true,
        Class::StorePoint | Class::RecallPoint | Class::Rung | Class::Label => true,
        Class::Coil | Class::Timer | Class::Count | Class::Store => false,
        Class::Leave | Class::If | Class::Part | Class::Setting => false,
    }
}

/// `CODE 847978, 20000, 7901  (* TON 20000 ms O 01 *)`
fn verbatim(step: Instruction<'_>) -> String {
    let codes: Vec<String> = step.codes().map(|code| code.to_string()).collect();
    format!("CODE {:<20} (* {step} *)", codes.join(", "))
}

/// The text, and the first line of each rung in it.
fn write(rungs: &[Rung]) -> (String, Vec<u32>) {
    let mut text = String::new();
    let (mut lines, mut first_lines) = (1, Vec::new());
    for (index, rung) in rungs.iter().enumerate() {
        if index > 0 {
            text.push('\n');
            lines += 1;
        }
        first_lines.push(lines);
        for line in rung.spelled.as_ref().unwrap_or(&rung.verbatim) {
            text.push_str(line.trim_end());
            text.push('\n');
            lines += 1;
        }
    }
    (text, first_lines)
}

/// The first code that is not the wanted one, and the line it comes from; none where all are the same.
fn difference(compiled: &CompiledText, text: &str, wanted: &[i32]) -> Option<(usize, u32)> {
    let codes = compiled.codes();
    let error = compiled
        .diagnostics
        .iter()
        .find(|d| d.severity() == Severity::Error);
    if let Some(error) = error {
        let line = Lines::new(text).line(error.span.start);
        let at = compiled
            .lines
            .iter()
            .position(|code| code.source >= Some(line));
        return Some((at.unwrap_or(0), line));
    }
    let same = codes.iter().zip(wanted).take_while(|(a, b)| a == b).count();
    if same == codes.len() && same == wanted.len() {
        return None;
    }
    let line = compiled
        .lines
        .get(same)
        .or(compiled.lines.last())
        .and_then(|code| code.source);
    Some((same, line.unwrap_or(1)))
}

/// The rung that the code with this index stands in; program start is the first code.
fn rung_at(rungs: &[Rung], at: usize) -> usize {
    let mut behind = 1;
    let ends = rungs.iter().map(|rung| {
        behind += rung.codes.len();
        behind
    });
    ends.take_while(|&end| end <= at)
        .count()
        .min(rungs.len().saturating_sub(1))
}
