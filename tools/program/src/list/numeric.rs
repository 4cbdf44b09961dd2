//! Numeric code in columns: code, letters, meaning. It is a program file that means the same.

use super::words;
use crate::effect::effect;
use std::fmt::Write;
use unoclp_checked::SourceMap;
use unoclp_core::isa::{self, Kind, Opcode, Operand, Value};
use unoclp_core::{Instruction, Program, Target};
use unoclp_lang::Lang;

/// A line of the listing.
struct Line {
    code: String,
    letters: String,
    meaning: String,
}

/// Lists a program. Of the file's comments it keeps those on lines of their own.
pub(super) fn listing(program: &Program<'_>, map: &SourceMap, lang: Lang) -> String {
    let steps: Vec<(Vec<Line>, Opcode)> = program
        .steps()
        .map(|step| (lines(step, lang), step.opcode))
        .collect();
    let all = || steps.iter().flat_map(|(lines, _)| lines);
    let longest = |length: fn(&Line) -> usize| all().map(length).max().unwrap_or(0);
    let code_width = longest(|line| line.code.len());
    let letters_width = longest(|line| line.letters.len());
    let mut text = String::new();
    // Writing to a string cannot fail.
    let mut put = |line: &Line| {
        let Line {
            code,
            letters,
            meaning,
        } = line;
        let _ = writeln!(
            text,
            "{code:<code_width$}  / {letters:<letters_width$}  {meaning}"
        );
    };
    let start = Line {
        code: isa::START.to_string(),
        letters: String::new(),
        meaning: words::program_start(lang),
    };
    put(&start);
    for (lines, _) in &steps {
        lines.iter().for_each(&mut put);
    }
    with_comments(&text, &steps, map)
}

/// Puts the comments of the file before the codes that they stand before in it, and a blank line before
/// each rung.
fn with_comments(text: &str, steps: &[(Vec<Line>, Opcode)], map: &SourceMap) -> String {
    let mut lines = text.lines();
    let mut all: String = map.title.iter().map(|line| comment(line)).collect();
    if !all.is_empty() {
        all.push('\n');
    }
    all.extend(lines.next().map(|line| format!("{line}\n")));
    for (index, (step, opcode)) in steps.iter().enumerate() {
        let comments = map.steps.get(index).map(|place| &place.comments[..]);
        let comments = comments.unwrap_or_default();
        if *opcode == Opcode::NewRung || !comments.is_empty() {
            all.push('\n');
        }
        all.extend(comments.iter().map(|line| comment(line)));
        for line in lines.by_ref().take(step.len()) {
            all.push_str(line);
            all.push('\n');
        }
    }
    all
}

fn comment(line: &str) -> String {
    format!("{}\n", format!("/ {line}").trim_end())
}

/// What an instruction does, with its operands: `acc := acc AND input 01`.
pub(super) fn meaning(step: Instruction<'_>, lang: Lang) -> String {
    let mut lines = lines(step, lang).into_iter();
    lines.next().map_or_else(String::new, |line| line.meaning)
}

/// The lines of an instruction: its code, then its operands.
fn lines(step: Instruction<'_>, lang: Lang) -> Vec<Line> {
    let row = step.opcode.row();
    let mut codes = step.codes();
    let number = step
        .number()
        .map_or_else(String::new, |n| format!("{n:02}"));
    let letters = match number.as_str() {
        "" => row.letters.to_owned(),
        number => format!("{} {number}", row.letters),
    };
    let operand = match step.operand {
        Operand::Value(Value::Register(register)) => format!("D {register:02}"),
        Operand::Value(Value::Constant(number)) if row.kind == Kind::Real => {
            format!("{:?}", f32::from_bits(number.cast_unsigned()))
        }
        Operand::Value(Value::Constant(number)) => number.to_string(),
        Operand::Value(Value::Popped) => words::popped(lang),
        _ => words::operand(lang),
    };
    let does = effect(step.opcode, lang);
    let meaning = match step.operand {
        Operand::Value(Value::Constant(_)) => does.replace(&words::register(lang), &operand),
        _ => does.replace("XX", &number),
    };
    let code = Line {
        code: codes.next().unwrap_or(row.code).to_string(),
        letters,
        meaning: meaning.replace(&words::operand(lang), &operand),
    };
    let operands = codes.enumerate().map(|(index, code)| Line {
        code: match (step.operand, index) {
            // A digit for each output.
            (Operand::Drum { .. }, 1..) => format!("{code:04}"),
            _ => code.to_string(),
        },
        letters: String::new(),
        meaning: operand_meaning(step.operand, index, code, lang),
    });
    std::iter::once(code).chain(operands).collect()
}

/// What an operand line says; they are counted from 0.
fn operand_meaning(operand: Operand<'_>, index: usize, code: i32, lang: Lang) -> String {
    match (operand, index) {
        (Operand::Timer(_), 0) => words::preset_ms(lang, code),
        (Operand::Timer(block), _) => match block.target {
            Target::Timer(_) => words::calls_again(lang, block.target),
            driven => words::drives(lang, driven),
        },
        (Operand::Count { .. }, _) => words::preset(lang, code),
        (Operand::Value(_), _) => words::constant(lang),
        (Operand::Move { to, .. }, 0) => words::to_registers(lang, format!("D {to:02}")),
        (Operand::Move { .. }, _) => words::so_many_registers(lang),
        (Operand::Drum { .. }, 0) => words::so_many_steps(lang),
        (Operand::Drum { .. }, index) => words::outputs_of(lang, index - 1),
        (Operand::Scale { .. }, 0) => words::from_this(lang),
        (Operand::Scale { .. }, 2) => words::becomes_from(lang),
        (Operand::Scale { .. }, _) => words::to_this(lang),
        (Operand::Filter { .. }, _) => words::filter_time(lang, code),
        (Operand::Table { .. }, _) => words::so_many_registers(lang),
        (Operand::None | Operand::Number(_) | Operand::Jump { .. }, _) => String::new(),
    }
}
