//! A text in a typed language, run by the interpreter of the typed tree.

use super::super::excerpt::renderer;
use super::super::open::count;
use super::ran::{Ran, Row};
use super::table;
use super::what::{What, Work, find};
use crate::messages;
use anstream::{eprint, eprintln, print};
use anyhow::anyhow;
use unoclp_lang::run::{MOST_STEPS, Machine, Stop};
use unoclp_lang::typed::{Base, Holds, Symbol, Tree, Value};
use unoclp_lang::{self as lang, CheckedText, Holding, Lines, Span, TextLanguage, Variable};
use unoclp_program::{Written, decode, harmless_lines};

/// A text by its name.
struct Text {
    name: String,
    text: String,
}

/// Runs a text; none where it has errors or does not end, which has been told.
pub(super) fn run(
    arguments: &What,
    written: Written,
    language: TextLanguage,
) -> anyhow::Result<Option<Ran>> {
    let board = written.board;
    let text = Text {
        text: decode(&written.bytes),
        name: written.name,
    };
    let (CheckedText { tree, diagnostics }, on_board) =
        lang::check_placed(&text.text, language, board);
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
        return Ok(None);
    };
    eprint!("{shown}");
    let mut machine = Machine::new(&tree);
    for (name, written) in arguments.settings()? {
        set(&mut machine, &tree, name, written)?;
    }
    let mut printed = Vec::new();
    let mut work = Work::default();
    for scan in 0..arguments.scans {
        let ran = machine.scan(arguments.time(scan));
        let told = machine.printed().into_iter();
        let told: Vec<_> = told.map(|told| (told.value, told.base)).collect();
        match arguments.json {
            true => printed.extend(told),
            // At once: nothing of it is lost where a later scan does not end.
            false => print!("{}", harmless_lines(&table::lines(&told))),
        }
        if let Err(stop) = ran {
            eprintln!("{}", stopped(&text, stop));
            return Ok(None);
        }
        work.scanned(machine.steps())?;
    }
    if let Some(at) = machine.failed() {
        eprintln!("{}", placed(&text, at, messages::not_computed));
    }
    let mut on_board = on_board.iter();
    let symbols = tree.symbols.iter();
    let symbols = symbols.map(|symbol| row(&machine, symbol, on_board.next()));
    Ok(Some(Ran {
        scans: arguments.scans,
        printed,
        symbols: symbols.collect(),
    }))
}

fn row(machine: &Machine<'_>, symbol: &Symbol, on_board: Option<&Variable>) -> Row {
    let (value, base) = machine.value(symbol);
    let point = on_board.and_then(|variable| match variable.holding {
        Holding::One((point, _)) => Some(point),
        Holding::Either { set, clear, .. } => {
            let both = [set, clear].into_iter().flatten();
            let mut meant = both.filter(|(_, of)| *of == base);
            meant.next().map(|(point, _)| point)
        }
        Holding::Constant(..) => None,
    });
    Row {
        name: symbol.name.clone(),
        type_name: match symbol.holds {
            Holds::Cell(_) => symbol.type_name.clone(),
            // It is of the type of what it holds.
            Holds::Either { .. } => base.name().to_owned(),
        },
        named: symbol.values.name_of(value.int()).map(str::to_owned),
        place: point.map(|point| format!("{point:#}")),
        value,
        base,
    }
}

/// Sets a variable as `--set` says.
fn set(machine: &mut Machine<'_>, tree: &Tree, name: &str, written: &str) -> anyhow::Result<()> {
    let names = tree.symbols.iter().map(|symbol| symbol.name.clone());
    let names: Vec<String> = names.collect();
    let symbol = &tree.symbols[find(&names, name)?];
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
        Stop::Codes(at) => placed(text, at, messages::codes_of_a_board),
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
