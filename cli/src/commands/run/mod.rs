//! `unoclp run`: runs a text on this PC, and shows what its variables hold at the end.
//!
//! - `table`: the symbols as a table
//! - `json`: all of it as one object

mod json;
mod table;

use super::open::count;
use crate::{Outcome, renderer};
use anstream::{eprint, eprintln, print};
use anyhow::{anyhow, bail};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::io::Read;
use std::path::{Path, PathBuf};
use unoclp_cli::messages;
use unoclp_lang::run::{MOST_STEPS, Machine, Printed, Stop};
use unoclp_lang::typed::{Base, Holds, Symbol, Tree, Value};
use unoclp_lang::{self as lang, CheckedText, Lines, Span, TextLanguage};
use unoclp_source::{BOARD, decode, guess};

/// What to run, and how.
#[derive(Args)]
pub struct What {
    /// The text of the program; - reads it from standard input
    file: Option<PathBuf>,
    /// The program itself, in place of a file
    #[arg(long, conflicts_with = "file", allow_hyphen_values = true)]
    text: Option<String>,
    /// The language of the text; else what its name and its words tell
    #[arg(long, value_parser = languages())]
    language: Option<TextLanguage>,
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

fn languages() -> impl TypedValueParser<Value = TextLanguage> {
    PossibleValuesParser::new(TextLanguage::ALL.map(TextLanguage::name))
        .map(|name| TextLanguage::named(&name).unwrap_or(TextLanguage::St))
}

/// A text by its name.
struct Text {
    name: String,
    text: String,
    path: Option<PathBuf>,
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
    let text = read(&arguments)?;
    let language = match arguments.language {
        Some(language) => language,
        None => {
            let name = guess(text.path.as_deref(), &text.text);
            TextLanguage::named(name).ok_or_else(|| anyhow!(messages::not_run(name)))?
        }
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

fn read(arguments: &What) -> anyhow::Result<Text> {
    if let Some(text) = &arguments.text {
        return Ok(Text {
            name: messages::the_text(),
            text: text.clone(),
            path: None,
        });
    }
    let Some(path) = &arguments.file else {
        bail!(messages::nothing_to_run());
    };
    if path == Path::new("-") {
        let mut bytes = Vec::new();
        std::io::stdin().read_to_end(&mut bytes)?;
        return Ok(Text {
            name: messages::the_input(),
            text: decode(&bytes),
            path: None,
        });
    }
    let read = super::read(path)?;
    Ok(Text {
        text: decode(&read.bytes),
        name: read.name,
        path: Some(path.clone()),
    })
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
