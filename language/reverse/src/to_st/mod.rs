//! From the numeric code to Structured Text.
//!
//! Owns what each step of a checked program is in Structured Text, and which have no words there. Must not know how a
//! text is compiled, nor files.
//!
//! - `flow`: parts of IF, jumps and loops; `live`: which accumulator is looked at; `registers`: what registers hold
//! - `counters`: which of them are blocks; `why`: what cannot be said
//! - `expr`, `statement`: what is written; `names`: what places are called, by what is `given`, and their declarations
//! - `machine`: the run of a program on expressions; `bits`, `numbers`, `views`, `tables`, `stores`, `blocks`,
//!   `jumps`: its steps; `filter`: what stands before them

mod bits;
mod blocks;
mod counters;
mod expr;
mod filter;
mod flow;
mod given;
mod jumps;
mod live;
mod machine;
mod names;
mod numbers;
mod registers;
mod statement;
mod stores;
mod tables;
mod views;
mod why;

use statement::{comment, lines};
use unoclp_checked::SourceMap;
use unoclp_core::{Instruction, Program};
use unoclp_text::diagnostics::{Code, Diagnostic, Span, Word};
use why::Why;

/// Writes a checked program as Structured Text, which compiles to a program that does the same. `map` has the names and
/// comments of the text that it comes from.
///
/// # Errors
/// What Structured Text cannot say, with its line.
pub fn to_st(program: &Program<'_>, map: &SourceMap) -> Result<String, Box<Diagnostic>> {
    let steps: Vec<Instruction<'_>> = program.steps().collect();
    let failed = |(at, why): (usize, Why)| Box::new(diagnostic(&steps, map, at, why));
    let flow = flow::Flow::of(&steps).map_err(failed)?;
    let body = machine::run(&steps, map, &flow, program.board()).map_err(failed)?;
    let names = names::Names::of(&steps, map, &body).map_err(failed)?;
    let mut text: String = map.title.iter().map(|line| comment(line) + "\n").collect();
    text.push_str("PROGRAM main\n");
    text.push_str(&names.declarations());
    text.push_str(&lines(&body.statements, &|place| names.name(place)));
    text.push_str("END_PROGRAM\n");
    Ok(text + body.functions())
}

fn diagnostic(steps: &[Instruction<'_>], map: &SourceMap, at: usize, why: Why) -> Diagnostic {
    let code = match why {
        Why::NoWords => Code::BackNoWords,
        Why::IntoPart => Code::BackIntoPart,
        Why::TimerInLoop => Code::BackTimerInLoop,
        Why::EarlyTime => Code::BackEarlyTime,
        Why::NoRegister => Code::BackNoRegister,
        Why::PartOfArray => Code::BackPartOfArray,
    };
    let step = steps.get(at).map(ToString::to_string).unwrap_or_default();
    let line = map.steps.get(at).map_or(0, |place| place.line);
    Diagnostic::new(
        code,
        Span::default(),
        vec![Word::from(step), Word::from(line.to_string())],
    )
}
