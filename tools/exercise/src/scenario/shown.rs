//! Scenarios as text that a student can read, in the two languages that the tools speak: what is wrong with a file, and
//! what came of a run.
//!
//! Owns which words tell of what. Must not know how scenarios are read and run.

use super::words::*;
use super::{
    Change, Columns, LONGEST, LoadError, MOST_SCANS, Report, Unmet, Unreadable, Verdict, Wrong,
};
use std::fmt;
use unoclp_core::{Board, Millis};
use unoclp_host_sim::engine::Refusal;
use unoclp_program::{Lang, WrittenIn, diagnosis};
use unoclp_words::system;

impl LoadError {
    /// In this language: `motor.toml:7: Q1 must be 0 or 1`
    pub fn text(&self, lang: Lang) -> String {
        let LoadError {
            file,
            line,
            wrong: what,
        } = self;
        let line = line.map_or_else(String::new, |line| format!(":{line}"));
        let mut told = wrong(what, lang);
        if matches!(what, Wrong::Toml { .. }) && !file.ends_with(".toml") {
            told = no_scenario(lang, told);
        }
        format!("{file}{line}: {told}")
    }
}

impl Unreadable {
    /// In this language, after the name of a file and a blank.
    pub fn text(&self, lang: Lang) -> String {
        match self {
            Unreadable::TooLong => too_long(lang, LONGEST),
            Unreadable::Folder => is_a_folder(lang),
            Unreadable::NoFile => no_file(lang),
            Unreadable::System { kind, told } => not_read(lang, system(lang, *kind, told)),
        }
    }
}

impl Report {
    /// The report in this language: the timeline, then `PASS` or `FAIL`.
    pub fn text(&self, lang: Lang) -> String {
        let mut text = format!("{}: {}\n", self.scenario, self.about.text(lang));
        text += &format!("{}\n", the_program(lang, &self.program));
        if !self.changes.is_empty() {
            text += &format!("\n{}\n", timeline(&self.columns, &self.changes, lang));
        }
        text + &self.verdict.text(lang)
    }
}

impl Verdict {
    /// `PASS`, or `FAIL` and below it why, in this language.
    pub fn text(&self, lang: Lang) -> String {
        verdict(self, lang)
    }

    /// The same in a line: `PASS`, or `FAIL` and the first reason.
    pub fn brief(&self, lang: Lang) -> String {
        match self.reason(lang) {
            reason if reason.is_empty() => self.text(lang),
            reason => format!("{}: {reason}", failed(lang)),
        }
    }

    /// The first reason why it is none that passes, in a line; empty of one that does.
    pub fn reason(&self, lang: Lang) -> String {
        let text = self.text(lang);
        let reasons = match self {
            Verdict::Unmet(_) => 1,
            _ => usize::MAX,
        };
        let words = |line: &str| line.split_whitespace().collect::<Vec<_>>().join(" ");
        let reasons = text.lines().skip(1).take(reasons).map(words);
        reasons.collect::<Vec<_>>().join("; ")
    }
}

/// `Display` is English, for developers.
macro_rules! in_english {
    ($($type:ty)*) => { $(
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(&self.text(Lang::En))
            }
        }
    )* };
}
in_english! { LoadError Unreadable Report Verdict }

impl std::error::Error for LoadError {}

/// What is wrong with a scenario file.
fn wrong(wrong: &Wrong, lang: Lang) -> String {
    match wrong {
        Wrong::Unreadable(why) => the_file(lang, why.text(lang)),
        Wrong::Toml { told } => toml(told, lang),
        Wrong::KeyInStep { told, .. } => key_in_step(lang, toml(told, lang)),
        Wrong::Program { name, why } => program(lang, name, why.text(lang)),
        Wrong::FaultyProgram { name } => program(lang, name, has_errors(lang)),
        Wrong::NoProgram => no_program(lang),
        Wrong::GivenAlone => given_alone(lang),
        Wrong::NoLanguage => no_language(lang, WrittenIn::names(lang)),
        Wrong::FaultyGiven => faulty_given(lang),
        Wrong::FindWithout => find_without(lang),
        Wrong::SeedsWithout => seeds_without(lang),
        Wrong::ManySeeds { most } => many_seeds(lang, most),
        Wrong::TwoPrograms => two_programs(lang),
        Wrong::LongText { most } => long_text(lang, most),
        Wrong::FaultAndSteps => fault_and_steps(lang),
        Wrong::NoFault { number } => no_fault(lang, number),
        Wrong::LineZero => line_zero(lang),
        Wrong::NoPeriod => no_period(lang),
        Wrong::EndsEarly { last } => ends_early(lang, last),
        Wrong::NoTitle => toml("missing field `about`", lang),
        Wrong::TooManyScans { scans } => too_many_scans(lang, scans, MOST_SCANS),
        Wrong::NoBoard { name } => {
            let known = Board::ALL.map(|board| board.id()).join(", ");
            no_board(lang, name, known)
        }
        Wrong::CasesAndSteps => cases_and_steps(lang),
        Wrong::SeveralCases { count } => several_cases(lang, count),
        Wrong::NotNamed { name, board } => not_named(
            lang,
            name,
            board.inputs,
            board.analogue.saturating_sub(1),
            board.outputs,
            board.markers,
            unoclp_core::isa::REGISTERS,
        ),
        Wrong::NothingHappens => nothing_happens(lang),
        Wrong::GoesOn => goes_on(lang),
        Wrong::NoScan { at, period } => no_scan(lang, at, period),
        Wrong::Order { at, last } => order(lang, at, last),
        Wrong::NotSet { name, board } => not_set(
            lang,
            name,
            board.inputs,
            board.analogue.saturating_sub(1),
            board.markers,
            unoclp_core::isa::REGISTERS,
        ),
        Wrong::NotExpected { name, board } => not_expected(
            lang,
            name,
            board.outputs,
            board.markers,
            unoclp_core::isa::REGISTERS,
        ),
        Wrong::Value {
            name,
            from,
            to,
            or_any: any,
        } => {
            let valid = match (from, to) {
                (0, 1) => zero_or_one(lang),
                _ => number_from(lang, from, to),
            };
            must_be(lang, name, if *any { or_any(lang, valid) } else { valid })
        }
    }
}

/// What the reader of TOML says: its own words in English; in Portuguese what they come to.
fn toml(told: &str, lang: Lang) -> String {
    let mut quoted = told.split('`').skip(1).step_by(2);
    let mut quoted_first = || quoted.next().unwrap_or_default();
    match told {
        _ if lang == Lang::En => told.to_owned(),
        _ if told == a_text(Lang::En) => a_text(lang),
        _ if told == both_languages(Lang::En) => both_languages(lang),
        _ if told.starts_with("unknown field") => {
            let key = quoted_first();
            let valid: Vec<String> = quoted.map(|key| format!("`{key}`")).collect();
            no_key(lang, key, valid.join(", "))
        }
        _ if told.starts_with("missing field") => missing_key(lang, quoted_first()),
        _ if told.starts_with("duplicate key") => key_twice(lang),
        _ if told.starts_with("invalid type") || told.starts_with("invalid value") => {
            wrong_kind(lang)
        }
        _ => no_toml(lang),
    }
}

/// A refusal by its numbers: `fault 24, line 7`.
fn refusal(refusal: Refusal, lang: Lang) -> String {
    let Refusal { number, line } = refusal;
    match line {
        Some(line) => fault_in_line(lang, number, line),
        None => fault(lang, number),
    }
}

/// The same with the text of its fault.
fn told(of: Refusal, lang: Lang) -> String {
    let numbers = refusal(of, lang);
    match of.fault() {
        Some(fault) => format!("{numbers}: {}", diagnosis::cause(fault.cause, lang)),
        None => numbers,
    }
}

/// More expectations that were not met than this are only counted.
const UNMET_SHOWN: usize = 8;

/// How an engine did: `PASS`, or `FAIL` and below it why.
fn verdict(verdict: &Verdict, lang: Lang) -> String {
    let pass = |what: String| format!("{}: {what}", passed(lang));
    let fail = |lines: Vec<String>| {
        let lines: String = lines.iter().map(|line| format!("\n  {line}")).collect();
        failed(lang) + &lines
    };
    match verdict {
        Verdict::Met { comparisons: 0 } => pass(nothing_expected(lang)),
        Verdict::Met { .. } => passed(lang),
        Verdict::Refused(refusal) => pass(refused_as_expected(lang, told(*refusal, lang))),
        Verdict::Stopped(at, refusal) => pass(stopped_as_expected(lang, at, told(*refusal, lang))),
        Verdict::WrongStop {
            expected: e,
            came: c,
        } => {
            let said = |(at, refusal): (Millis, Refusal)| at_time(lang, at, told(refusal, lang));
            fail(vec![
                expected(lang, e.map_or_else(|| that_it_runs_on(lang), said)),
                c.map_or_else(|| but_ran_on(lang), |stop| came(lang, said(stop))),
            ])
        }
        Verdict::Unmet(all) => {
            let shown = all.iter().take(UNMET_SHOWN);
            let mut lines: Vec<String> = shown.map(|unmet| not_met(unmet, lang)).collect();
            if let left @ 1.. = all.len().saturating_sub(UNMET_SHOWN) {
                lines.push(more(lang, left));
            }
            fail(lines)
        }
        Verdict::WrongRefusal {
            expected: e,
            came: c,
        } => {
            let said = |refusal| told(refusal, lang);
            fail(vec![
                expected(lang, e.map_or_else(|| that_it_runs(lang), said)),
                c.map_or_else(|| but_accepted(lang), |refusal| came(lang, said(refusal))),
            ])
        }
        Verdict::Broken { at: None, reason } => fail(vec![while_loaded(lang, reason)]),
        Verdict::Broken {
            at: Some(at),
            reason,
        } => fail(vec![broken_at(lang, at, reason)]),
    }
}

/// `Q1 at 5000 ms: expected 0, got 1 (until 5020 ms)`
fn not_met(of: &Unmet, lang: Lang) -> String {
    let text = unmet(lang, of.place, of.from, of.expected, of.came);
    match of.to > of.from {
        true => unmet_until(lang, text, of.to),
        false => text,
    }
}

/// One line for each change, under the names of the points.
fn timeline(columns: &Columns, changes: &[Change], lang: Lang) -> String {
    let inputs = || super::points(columns.inputs);
    let outputs = || super::points(columns.outputs);
    let mut text = format!("{:>10}", "ms");
    text.extend(inputs().map(|point| format!("  I{}", point.number())));
    let analogue = columns.analogue.iter();
    text.extend(analogue.map(|input| format!("{:>6}", format!("A{input}"))));
    text += "  ";
    text.extend(outputs().map(|point| format!("  Q{}", point.number())));
    for place in &columns.seen {
        let width = if place.is_bit() { 5 } else { NUMBER_WIDTH };
        text += &format!("{:>width$}", place.to_string());
    }
    text += &format!("    {}\n", legend(lang));
    for change in changes {
        text += &format!("{:>10}", change.at);
        text.extend(inputs().map(|point| state(change.inputs.points.get(point))));
        for &input in &columns.analogue {
            let reading = change.inputs.analogue.get(usize::from(input));
            text += &format!("{:>6}", reading.copied().unwrap_or_default());
        }
        text += "  ";
        text.extend(outputs().map(|point| state(change.outputs.get(point))));
        for (place, value) in columns.seen.iter().zip(&change.seen) {
            text += &match (place.is_bit(), value) {
                (true, 0) => format!("{:>5}", "·"),
                (true, _) => format!("{value:>5}"),
                (false, _) => format!("{value:>NUMBER_WIDTH$}"),
            };
        }
        text.push('\n');
    }
    text
}

/// Columns of a number with a sign and 32 bits, and a space.
const NUMBER_WIDTH: usize = 12;

const fn state(state: bool) -> &'static str {
    if state { "   1" } else { "   ·" }
}
