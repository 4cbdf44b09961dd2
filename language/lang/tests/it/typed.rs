//! The cases of `typed/`: what a text in a typed language is told, and what it does in the interpreter.

use crate::board;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Holds, Symbol, Tree};
use unoclp_lang::{Diagnostic, Lang, Lines, TextLanguage, Told, check, given};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Cases {
    case: Vec<Case>,
}

/// A text, and what comes of it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What the case shows.
    pub name: String,
    st: Option<String>,
    scl: Option<String>,
    iscl: Option<String>,
    lce: Option<String>,
    il: Option<String>,
    /// What is told: the code, the line and the column of each, `ST-110 3:5`.
    #[serde(default)]
    told: Vec<String>,
    /// For each of them, a part of its message or help in English.
    #[serde(default)]
    says: Vec<String>,
    /// Likewise in Portuguese.
    #[serde(default)]
    diz: Vec<String>,
    /// What is set before a scan: `x = 1` before the first, or a list with a value for each scan.
    #[serde(default)]
    set: BTreeMap<String, toml::Value>,
    /// How many scans are made.
    scans: Option<u64>,
    /// ms from one scan to the next.
    #[serde(default)]
    every: i64,
    /// Symbols after the last scan; a list gives those after each.
    #[serde(default)]
    after: BTreeMap<String, toml::Value>,
    /// What PRINT shows, in all scans.
    #[serde(default)]
    printed: Vec<toml::Value>,
    /// What the board keeps over a power cut: `KD 09`.
    #[serde(default)]
    kept: Vec<String>,
    /// The line in which S 04 is set first.
    fails: Option<u32>,
    /// What is told besides where the board cannot do it; all else runs on the board's core too.
    #[serde(default)]
    board: Vec<String>,
    /// For each of them, a part of its message or help in English.
    #[serde(default)]
    board_says: Vec<String>,
    /// Likewise in Portuguese.
    #[serde(default)]
    board_diz: Vec<String>,
}

/// Each diagnostic by its code and place.
fn places(told: &Told, source: &str) -> Vec<String> {
    let lines = Lines::new(source);
    let place = |d: &Diagnostic| {
        let (line, column) = lines.place(source, d.span.start);
        format!("{} {line}:{column}", d.code)
    };
    told.iter().map(place).collect()
}

/// Its message and its help.
fn said(told: &Told, lang: Lang) -> Vec<String> {
    let one = |d: &Diagnostic| [d.message(lang), d.help(lang)].join("; ");
    told.iter().map(one).collect()
}

/// What should be told and is not: places, and parts of what is said.
fn untold(
    told: &Told,
    source: &str,
    expected: &[String],
    says: &[String],
    diz: &[String],
) -> Option<String> {
    let (english, portuguese) = (said(told, Lang::En), said(told, Lang::Pt));
    let places = places(told, source);
    if places != expected {
        return Some(format!("told {places:?} {english:#?}, not {expected:?}"));
    }
    let says = says.iter().zip(&english);
    let mut both = says.chain(diz.iter().zip(&portuguese));
    let (part, all) = both.find(|(part, all)| !all.contains(*part))?;
    Some(format!("{all:?} does not say {part:?}"))
}

/// A value of a table as a person writes it.
fn text(value: &toml::Value) -> String {
    match value {
        toml::Value::String(text) => text.clone(),
        toml::Value::Boolean(truth) => truth.to_string().to_uppercase(),
        other => other.to_string(),
    }
}

fn symbol<'t>(tree: &'t Tree, name: &str) -> Result<&'t Symbol, String> {
    let mut symbols = tree.symbols.iter();
    let exact = tree.symbols.iter().find(|symbol| symbol.name == name);
    let found = exact.or_else(|| symbols.find(|symbol| symbol.name.eq_ignore_ascii_case(name)));
    found.ok_or_else(|| format!("there is no symbol {name}"))
}

impl Case {
    /// Its text; none unless there is one alone.
    pub fn text(&self) -> Option<(&str, TextLanguage)> {
        let texts = [
            (&self.st, TextLanguage::St),
            (&self.scl, TextLanguage::Scl),
            (&self.iscl, TextLanguage::Iscl),
            (&self.lce, TextLanguage::Lce),
            (&self.il, TextLanguage::Il),
        ];
        let mut texts = texts
            .iter()
            .filter_map(|(text, language)| Some((text.as_deref()?, *language)));
        texts.next().filter(|_| texts.next().is_none())
    }

    fn fault(&self) -> Option<String> {
        let Some((source, language)) = self.text() else {
            return Some("needs one text".to_owned());
        };
        let checked = check(source, language, unoclp_core::Board::UNO);
        let lines = Lines::new(source);
        let untold = untold(
            &checked.diagnostics,
            source,
            &self.told,
            &self.says,
            &self.diz,
        );
        if untold.is_some() {
            return untold;
        }
        match &checked.tree {
            Some(tree) => {
                let ran = self.run(tree, source, &lines).err();
                ran.or_else(|| self.on_board(source, language).err())
            }
            None => (!self.after.is_empty()).then(|| "there is no program".to_owned()),
        }
    }

    fn run(&self, tree: &Tree, source: &str, lines: &Lines) -> Result<(), String> {
        let mut machine = Machine::new(tree);
        for scan in 0..self.scans.unwrap_or(1) {
            for (name, value) in &self.set {
                let value = match value {
                    toml::Value::Array(values) => match values.get(scan as usize) {
                        Some(value) => text(value),
                        None => continue,
                    },
                    _ if scan > 0 => continue,
                    value => text(value),
                };
                let symbol = symbol(tree, name)?;
                let (_, base) = machine.value(symbol);
                let Holds::Cell(cell) = symbol.holds else {
                    return Err(format!("{name} is of mixed kinds"));
                };
                let value = given(&value, base, &symbol.values)
                    .ok_or(format!("{name} cannot be {value}"))?;
                machine.set_cell(cell, value);
            }
            machine
                .scan(scan as i64 * self.every)
                .map_err(|stop| format!("{stop:?}"))?;
            for (name, values) in &self.after {
                if let toml::Value::Array(values) = values
                    && let Some(value) = values.get(scan as usize)
                {
                    self.expect(tree, &machine, name, &text(value), Some(scan))?;
                }
            }
        }
        for (name, value) in &self.after {
            if !value.is_array() {
                self.expect(tree, &machine, name, &text(value), None)?;
            }
        }
        let printed = machine.printed();
        let shown = printed.iter().map(|one| one.value.shown(one.base));
        let (shown, wanted): (Vec<_>, Vec<_>) =
            (shown.collect(), self.printed.iter().map(text).collect());
        if shown != wanted {
            return Err(format!("printed {shown:?}, not {wanted:?}"));
        }
        let fails = machine.failed().map(|at| lines.place(source, at.start).0);
        match fails == self.fails {
            true => Ok(()),
            false => Err(format!("S 04 was set in line {fails:?}")),
        }
    }

    /// The same on the board's core, where the board can do it.
    fn on_board(&self, source: &str, language: TextLanguage) -> Result<(), String> {
        let made = board::compiled(source, language);
        if board::errors(&made).is_some() || !self.board.is_empty() {
            let told = &made.diagnostics;
            let untold = untold(told, source, &self.board, &self.board_says, &self.board_diz);
            return untold.map_or(Ok(()), |fault| Err(format!("for the board: {fault}")));
        }
        let spelt = made.lines.iter().map(|line| line.letters.to_string());
        let kept: Vec<String> = spelt.filter(|letters| letters.starts_with('K')).collect();
        if !self.kept.is_empty() && kept != self.kept {
            return Err(format!("keeps {kept:?}"));
        }
        let places = made.places();
        let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
            return Err("no program".to_owned());
        };
        board::with_plc(&mut checked, |plc| {
            let mut twins = board::Twins::new(&tree, &places);
            for scan in 0..self.scans.unwrap_or(1) {
                for (name, value) in &self.set {
                    let value = match value {
                        toml::Value::Array(values) => match values.get(scan as usize) {
                            Some(value) => text(value),
                            None => continue,
                        },
                        _ if scan > 0 => continue,
                        value => text(value),
                    };
                    let symbols = &tree.symbols;
                    let at = symbols
                        .iter()
                        .position(|s| s.name.eq_ignore_ascii_case(name));
                    let Some(at) = at else { continue };
                    let (_, base) = twins.machine.value(&symbols[at]);
                    if let Some(value) = given(&value, base, &symbols[at].values) {
                        twins.set(plc, at, &value);
                    }
                }
                let ran = twins.scan(plc, (scan as i64 * self.every) as u32);
                match ran {
                    Err(why) if why == "stopped" => return Ok(()),
                    other => other.map_err(|why| {
                        let lines: Vec<String> = made
                            .lines
                            .iter()
                            .map(|l| format!("{} {} {}", l.code, l.letters, l.symbol))
                            .collect();
                        format!("scan {scan}: {why}\n{}", lines.join("\n"))
                    })?,
                }
            }
            Ok(())
        })
    }

    fn expect(
        &self,
        tree: &Tree,
        machine: &Machine<'_>,
        name: &str,
        wanted: &str,
        scan: Option<u64>,
    ) -> Result<(), String> {
        let symbol = symbol(tree, name)?;
        let (value, base) = machine.value(symbol);
        let shown = match symbol.values.name_of(value.int()) {
            Some(name) => name.to_owned(),
            None => value.shown(base),
        };
        match shown == wanted {
            true => Ok(()),
            false => Err(format!("{name} is {shown}, not {wanted} (scan {scan:?})")),
        }
    }
}

/// All cases, each with its file.
pub fn all() -> Vec<(String, Case)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/typed");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    paths.sort();
    let cases = paths.into_iter().flat_map(|path| {
        let text = fs::read_to_string(&path).unwrap();
        let cases: Cases =
            toml::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let file = file.into_owned();
        cases.case.into_iter().map(move |case| (file.clone(), case))
    });
    cases.collect()
}

/// Each case is run, and what is wrong in any of them is shown.
#[test]
fn cases() {
    let all = all();
    let wrong = all.iter().filter_map(|(file, case)| {
        let fault = case.fault()?;
        Some(format!("{file}: {}: {fault}", case.name))
    });
    let wrong: Vec<String> = wrong.collect();
    assert!(
        wrong.is_empty(),
        "{} of {}:\n{}",
        wrong.len(),
        all.len(),
        wrong.join("\n\n")
    );
}
