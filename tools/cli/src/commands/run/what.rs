//! What is run: its arguments, and its variables by their names.

use super::super::open::{Shown, read};
use super::super::wording::Wording;
use crate::messages;
use anyhow::bail;
use clap::Args;
use std::path::PathBuf;
use unoclp_program::Written;

/// What to run, and how.
#[derive(Args)]
pub struct What {
    /// The program, in any of the languages; - reads it from standard input
    file: Option<PathBuf>,
    /// The program itself, in place of a file
    #[arg(long, conflicts_with = "file", allow_hyphen_values = true)]
    text: Option<String>,
    #[command(flatten)]
    pub(super) wording: Wording,
    /// How many times the program runs
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) scans: u32,
    /// The time from the start of one scan to the start of the next, in ms
    #[arg(long, value_name = "MS", default_value_t = 1)]
    every: u32,
    /// Set a variable, such as an input, before the first scan
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Print everything as one JSON object
    #[arg(long)]
    pub(super) json: bool,
}

impl What {
    /// What --set says: names, and what they become.
    pub(super) fn settings(&self) -> anyhow::Result<Vec<(&str, &str)>> {
        let setting = |given| match str::split_once(given, '=') {
            Some((name, written)) => Ok((name.trim(), written.trim_start_matches(['=', ' ']))),
            None => bail!(messages::set_form(given)),
        };
        self.set.iter().map(|given| setting(given)).collect()
    }

    /// The time of a scan, in ms.
    pub(super) fn time(&self, scan: u32) -> i64 {
        i64::from(scan) * i64::from(self.every)
    }

    /// Where the errors of the program are told: standard output is for the object in JSON alone.
    pub(super) fn shown(&self) -> Shown {
        match self.json {
            true => Shown::Beside,
            false => Shown::Here,
        }
    }
}

/// The most steps of all scans together. So every run comes to an end, whatever it is asked for.
const MOST_STEPS: u64 = 1_000_000_000;

/// As many steps as a scan is worth besides its own: so a run has 2,000,000 scans at most, as a scenario has.
const BEGINNING: u64 = 500;

/// How much has been done of a run.
#[derive(Default)]
pub(super) struct Work {
    steps: u64,
    scans: u32,
}

impl Work {
    /// Counts a scan of so many steps.
    ///
    /// # Errors
    /// If that is all that a run may do.
    pub(super) fn scanned(&mut self, steps: u64) -> anyhow::Result<()> {
        self.steps += BEGINNING + steps;
        self.scans += 1;
        if self.steps > MOST_STEPS {
            bail!(messages::run_too_long(self.scans, MOST_STEPS));
        }
        Ok(())
    }
}

/// The program, wherever the arguments have it.
pub(super) fn program(arguments: &What) -> anyhow::Result<Written> {
    let (name, bytes) = match (&arguments.text, &arguments.file) {
        (Some(text), _) => (messages::the_text(), text.clone().into_bytes()),
        (None, Some(path)) => {
            let file = read(path)?;
            (file.name, file.bytes)
        }
        (None, None) => bail!(messages::nothing_to_run()),
    };
    Ok(arguments.wording.of(name, bytes))
}

/// The one of these names that is meant: exactly so, or else in whatever case.
pub(super) fn find(names: &[String], name: &str) -> anyhow::Result<usize> {
    let exact = names.iter().position(|of| of == name);
    let alike = || names.iter().position(|of| of.eq_ignore_ascii_case(name));
    match exact.or_else(alike) {
        Some(at) => Ok(at),
        None if names.is_empty() => bail!(messages::no_variables(name)),
        None => {
            // What has no name of its own is called by its address twice.
            let mut some: Vec<&str> = names.iter().map(String::as_str).collect();
            some.dedup();
            let count = some.len();
            some.truncate(12);
            let more = if count > some.len() { ", …" } else { "" };
            bail!(messages::no_variable(name, some.join(", ") + more))
        }
    }
}
