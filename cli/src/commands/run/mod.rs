//! `unoclp run`: runs a text on this PC, and shows what its variables hold at the end.
//!
//! - `table`: the symbols as a table
//! - `json`: all of it as one object

mod json;
mod table;

use super::open::{count, no_program, read};
use super::wording::Wording;
use crate::{Outcome, renderer};
use anstream::{eprint, eprintln, print};
use anyhow::{anyhow, bail};
use clap::Args;
use std::path::PathBuf;
use unoclp_cli::messages;
use unoclp_lang::run::{MOST_STEPS, Machine, Printed, Stop};
use unoclp_lang::typed::{Base, Holds, Symbol, Tree, Value};
use unoclp_lang::{self as lang, CheckedText, Lines, Span};
use unoclp_source::{BOARD, Written, WrittenIn, decode};

/// What to run, and how.
#[derive(Args)]
pub struct What {
    /// The program, in any of the languages; - reads it from standard input
    file: Option<PathBuf>,
    /// The program itself, in place of a file
    #[arg(long, conflicts_with = "file", allow_hyphen_values = true)]
    text: Option<String>,
    #[command(flatten)]
    wording: Wording,
    /// How often the program runs
    #[arg(long, value_name = "N", default_value_t = 1)]
    scans: u32,
    /// How much later each scan begins than the one before, in ms
    #[arg(long, value_name = "MS", default_value_t = 1)]
    every: u32,
    /// Set a variable before the first scan, like an input
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Print one object in JSON
    #[arg(long)]
    json: bool,
}

/// A text by its name.
struct Text {
    name: String,
    text: String,
}

/// What a run has come to.
struct Ran<'t> {
    scans: u32,
    printed: Vec<Printed>,
    /// Each with its value, its type, and where the board keeps it.
    symbols: Vec<(&'t Symbol, Value, Base, Option<String>)>,
}

/// `unoclp run`.
pub fn run(arguments: What) -> Outcome {
    let written = program(&arguments)?;
    let language = match written.language {
        Ok(WrittenIn::Typed(language)) => language,
        Ok(other) => bail!(messages::not_run(other.name())),
        Err(why) => bail!(no_program(&written.name, why)),
    };
    let text = Text {
        text: decode(&written.bytes),
        name: written.name,
    };
    let CheckedText { tree, diagnostics } = lang::check(&text.text, language);
    let shown = lang::show(
        &text.name,
        &text.text,
        &diagnostics,
        messages::spoken(),
        &renderer(),
    );
    let Some(tree) = tree else {
        let all = format!("{shown}{}: {}", text.name, count(&diagnostics));
        match arguments.json {
            true => eprintln!("{all}"),
            false => say!("{all}"),
        }
        return Ok(false);
    };
    eprint!("{shown}");
    let mut machine = Machine::new(&tree);
    for given in &arguments.set {
        set(&mut machine, &tree, given)?;
    }
    let mut printed = Vec::new();
    for scan in 0..arguments.scans {
        let now = i64::from(scan) * i64::from(arguments.every);
        let ran = machine.scan(now);
        let told = machine.printed();
        match arguments.json {
            true => printed.extend(told),
            // At once: nothing of it is lost where a later scan does not end.
            false => print!("{}", table::lines(&told)),
        }
        if let Err(stop) = ran {
            eprintln!("{}", stopped(&text, stop));
            return Ok(false);
        }
    }
    if let Some(at) = machine.failed() {
        eprintln!("{}", placed(&text, at, messages::not_computed));
    }
    let mut places = lang::places(&text.text, language, BOARD).into_iter();
    let symbols = tree.symbols.iter().map(|symbol| {
        let (value, base) = machine.value(symbol);
        (symbol, value, base, places.next().flatten())
    });
    let ran = Ran {
        scans: arguments.scans,
        printed,
        symbols: symbols.collect(),
    };
    match arguments.json {
        true => print!("{}", json::json(&ran)),
        false => print!("{}", table::table(&ran)),
    }
    Ok(true)
}

/// The program, wherever the arguments have it.
fn program(arguments: &What) -> anyhow::Result<Written> {
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

/// Sets a variable as `--set` says.
fn set(machine: &mut Machine<'_>, tree: &Tree, given: &str) -> anyhow::Result<()> {
    let Some((name, written)) = given.split_once('=') else {
        bail!(messages::set_form(given));
    };
    let (name, written) = (name.trim(), written.trim_start_matches(['=', ' ']));
    let mut symbols = tree.symbols.iter();
    let exact = tree.symbols.iter().find(|symbol| symbol.name == name);
    let symbol = exact.or_else(|| symbols.find(|symbol| symbol.name.eq_ignore_ascii_case(name)));
    let Some(symbol) = symbol else {
        let names: Vec<&str> = tree
            .symbols
            .iter()
            .map(|symbol| symbol.name.as_str())
            .take(12)
            .collect();
        bail!(messages::no_variable(name, names.join(", ")));
    };
    let base = machine.value(symbol).1;
    let read = |base| lang::given(written, base, &symbol.values);
    let no_value = || anyhow!(messages::no_value(written, name, &symbol.type_name));
    match symbol.holds {
        Holds::Cell(cell) => machine.set_cell(cell, read(base).ok_or_else(no_value)?),
        Holds::Either { flag, set, clear } => {
            // A whole number is held as one, and another as REAL.
            let whole = read(Base::Dint);
            machine.set_cell(flag, Value::truth(whole.is_none()));
            match whole {
                Some(value) => machine.set_cell(clear, value),
                None => machine.set_cell(set, read(Base::Real).ok_or_else(no_value)?),
            }
        }
    }
    Ok(())
}

fn stopped(text: &Text, stop: Stop) -> String {
    match stop {
        Stop::Endless(at) => placed(text, at, |place| messages::scan_endless(place, MOST_STEPS)),
        Stop::TooDeep(at) => placed(text, at, messages::calls_too_deep),
    }
}

/// A message about a place of the text, and its line.
fn placed(text: &Text, at: Span, told: impl Fn(String) -> String) -> String {
    let (line, column) = Lines::new(&text.text).place(&text.text, at.start);
    let shown = text.text.lines().nth(line as usize - 1).unwrap_or_default();
    format!(
        "{}\n  {}",
        told(format!("{}:{line}:{column}", text.name)),
        shown.trim()
    )
}

/// The type of a symbol; of one that holds what was last written, that of what it holds.
fn type_name(symbol: &Symbol, base: Base) -> String {
    match symbol.holds {
        Holds::Cell(_) => symbol.type_name.clone(),
        Holds::Either { .. } => base.name().to_owned(),
    }
}

/// A value as a person reads it: an enumeration by its names.
fn written(symbol: &Symbol, value: &Value, base: Base) -> String {
    let named = usize::try_from(value.int())
        .ok()
        .and_then(|at| symbol.values.get(at));
    match named {
        Some(name) => name.clone(),
        None => value.shown(base),
    }
}
