//! Wrong programs made of a right one: each has one mistake that students make.
//!
//! Owns which mistakes those are. Must not know who finds them.

use crate::machine::with_chances;
use crate::scenario::{Exercise, ProgramFile, passes};
use std::collections::BTreeSet;
use unoclp_core::Board;
use unoclp_host_sim::engine::HostEngine;
use unoclp_lang::to_il;
use unoclp_plant::Plant;
use unoclp_program::Written;

/// A mistake that students make.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Slip {
    /// A contact is inverted.
    Inverted,
    /// A contact is left out; a seal-in among them.
    Dropped,
    /// In series instead of in parallel, or the other way round.
    Joined,
    /// A number, a preset among them, is half of what it should be.
    Halved,
    /// It is twice that.
    Doubled,
    /// Two coils are exchanged.
    Swapped,
    /// A coil is never reset.
    NotReset,
}

/// A wrong program.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// Its mistake.
    pub slip: Slip,
    /// The line in Instruction List that it is in, as it was.
    pub was: String,
    /// And as it is; empty where it is gone.
    pub is: String,
    /// Its numeric code.
    pub code: Vec<u8>,
}

impl Mutant {
    /// The two lines with single spaces.
    pub fn lines(&self) -> [String; 2] {
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        [plain(&self.was), plain(&self.is)]
    }
}

/// What an exercise makes of wrong programs.
#[derive(Debug)]
pub struct Passing {
    /// How many wrong programs there are, without those that are written down as right.
    pub of: usize,
    /// How many pass the cases, and the machine alone catches.
    pub machine_alone: usize,
    /// Those that pass.
    pub pass: Vec<Mutant>,
}

/// The wrong programs made of this one that an exercise and its machine let pass.
pub fn passing(
    exercise: &Exercise,
    plant: Option<&Plant>,
    program: &[u8],
    board: Board,
) -> Passing {
    let mut all = mutants(program, board);
    all.retain(|mutant| {
        let lines = mutant.lines();
        let same = exercise.equivalent.iter();
        !same
            .into_iter()
            .any(|one| [&one.was, &one.is] == lines.each_ref())
    });
    let of = all.len();
    all.retain(|mutant| {
        let program = ProgramFile {
            name: "mutant".to_owned(),
            bytes: mutant.code.clone(),
        };
        passes(exercise, &program, &mut HostEngine::new(board))
    });
    let by_cases = all.len();
    all.retain(|mutant| {
        plant.is_none_or(|plant| {
            let engine = &mut HostEngine::new(board);
            with_chances(plant, &exercise.seeds, &mutant.code, engine) == Ok(None)
        })
    });
    Passing {
        of,
        machine_alone: by_cases - all.len(),
        pass: all,
    }
}

/// More wrong programs are not made of one.
const MOST: usize = 1000;

/// The wrong programs that differ from this one, and that compile; none of one that has a fault.
pub fn mutants(program: &[u8], board: Board) -> Vec<Mutant> {
    let Ok(text) = to_il(program, board) else {
        return Vec::new();
    };
    let lines: Vec<&str> = text.lines().collect();
    let right = compiled(&text, board);
    let mut seen: BTreeSet<Vec<u8>> = right.into_iter().collect();
    let mut all = Vec::new();
    for (slip, at, becomes) in slips(&lines) {
        let made = lines.iter().enumerate().map(|(line, text)| {
            match becomes.iter().find(|(of, _)| *of == line) {
                Some((_, other)) => other.as_str(),
                None => text,
            }
        });
        let made = made.collect::<Vec<_>>().join("\n");
        let Some(code) = compiled(&made, board).filter(|code| seen.insert(code.clone())) else {
            continue;
        };
        let one = |line: usize| lines.get(line).copied().unwrap_or_default().to_owned();
        let is = becomes
            .iter()
            .find(|(line, _)| *line == at)
            .map(|(_, is)| is.clone());
        all.push(Mutant {
            slip,
            was: one(at),
            is: is.unwrap_or_default(),
            code,
        });
        if all.len() == MOST {
            break;
        }
    }
    all
}

fn compiled(text: &str, board: Board) -> Option<Vec<u8>> {
    let written = Written::new("mutant.il".to_owned(), text.as_bytes().to_vec(), board);
    written.check(None).ok().map(|source| source.code)
}

/// A mistake, the line that shows it, and each line that it changes.
type Made = (Slip, usize, Vec<(usize, String)>);

/// Each mistake of each line.
fn slips(lines: &[&str]) -> Vec<Made> {
    let mut all = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        let (operator, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let mut one = |slip, becomes: String| all.push((slip, at, vec![(at, becomes)]));
        let with = |operator: &str| format!("{operator} {}", rest.trim_start());
        if let Some(other) = inverted(operator) {
            one(Slip::Inverted, with(other));
        }
        if let Some(other) = joined(operator) {
            one(Slip::Joined, with(other));
            if !rest.is_empty() {
                one(Slip::Dropped, String::new());
            }
        }
        if operator == "R" {
            one(Slip::NotReset, String::new());
        }
        for (slip, times, by) in [(Slip::Halved, 1, 2), (Slip::Doubled, 2, 1)] {
            if let Some(rest) = scaled(rest, times, by) {
                one(slip, format!("{operator} {rest}"));
            }
        }
    }
    let coils: Vec<(usize, &str)> = lines
        .iter()
        .enumerate()
        .filter_map(|(at, line)| Some((at, line.strip_prefix("ST ")?.trim())))
        .filter(|(_, point)| point.starts_with('Q'))
        .collect();
    for (number, (first, a)) in coils.iter().enumerate() {
        for (second, b) in coils.iter().skip(number + 1).filter(|(_, b)| a != b) {
            let swapped = vec![(*first, format!("ST {b}")), (*second, format!("ST {a}"))];
            all.push((Slip::Swapped, *first, swapped));
        }
    }
    all
}

fn inverted(operator: &str) -> Option<&'static str> {
    Some(match operator {
        "LD" => "LDN",
        "LDN" => "LD",
        "AND" => "ANDN",
        "ANDN" => "AND",
        "OR" => "ORN",
        "ORN" => "OR",
        _ => return None,
    })
}

fn joined(operator: &str) -> Option<&'static str> {
    Some(match operator {
        "AND" => "OR",
        "ANDN" => "ORN",
        "OR" => "AND",
        "ORN" => "ANDN",
        "AND(" => "OR(",
        "OR(" => "AND(",
        _ => return None,
    })
}

/// The same operands with the last number so many times as great; none where there is no number above 1.
fn scaled(rest: &str, times: i64, by: i64) -> Option<String> {
    let is_digit = |sign: char| sign.is_ascii_digit();
    let end = rest.rfind(is_digit)? + 1;
    let begin = rest
        .get(..end)?
        .rfind(|sign| !is_digit(sign))
        .map_or(0, |at| at + 1);
    // The number of a point is none of these.
    let before = rest.get(..begin)?.chars().next_back();
    if before.is_some_and(|sign| sign.is_ascii_alphabetic()) {
        return None;
    }
    let number: i64 = rest
        .get(begin..end)?
        .parse()
        .ok()
        .filter(|number| *number > 1)?;
    let (head, tail) = (rest.get(..begin)?.trim_start(), rest.get(end..)?);
    Some(format!("{head}{}{tail}", number * times / by))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Vec<(Slip, String, String)> {
        let code = compiled(text, Board::UNO).unwrap();
        let all = mutants(&code, Board::UNO);
        all.into_iter()
            .map(|mutant| (mutant.slip, mutant.was, mutant.is))
            .collect()
    }

    #[test]
    fn a_motor_with_seal_in_has_the_usual_mistakes() {
        let all = of("LD I1\nOR Q1\nAND I2\nST Q1\nLDN Q1\nST Q2\n");
        let has = |slip, was: &str, is: &str| {
            let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
            all.iter().any(|(of, before, now)| {
                (*of, plain(before), plain(now)) == (slip, was.to_owned(), is.to_owned())
            })
        };
        assert!(has(Slip::Dropped, "OR Q1", ""), "{all:?}");
        assert!(has(Slip::Inverted, "AND I2", "ANDN I2"), "{all:?}");
        assert!(has(Slip::Joined, "AND I2", "OR I2"), "{all:?}");
        assert!(
            all.iter().any(|(slip, ..)| *slip == Slip::Swapped),
            "{all:?}"
        );
    }

    #[test]
    fn numbers_are_halved_and_doubled_and_points_are_not() {
        assert_eq!(scaled("T#500ms", 1, 2), Some("T#250ms".to_owned()));
        assert_eq!(scaled("T1, 500", 2, 1), Some("T1, 1000".to_owned()));
        assert_eq!(scaled("I2", 2, 1), None);
        assert_eq!(scaled("1", 2, 1), None);
    }
}
