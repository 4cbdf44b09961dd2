//! Reading a program, whichever of the two languages it is written in.

use crate::{Outcome, read, renderer};
use anstream::{eprint, eprintln, println};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::env;
use std::path::Path;
use unoclp_checked::Diagnosis;
use unoclp_core::Fault;
use unoclp_host_sim::scenario::ProgramFile;
use unoclp_lang::{self as lang, Diagnostic, Dialect, Lang, Severity};
use unoclp_source::{Language, Refused, Source, Written, diagnosis};

/// How to read Instruction List.
#[derive(Args)]
pub struct Il {
    /// Whose Instruction List it is; else what its words look like
    #[arg(long, value_parser = dialects())]
    dialect: Option<Dialect>,
    /// The language in which errors of Instruction List are told; else that of the environment
    #[arg(long, value_parser = langs())]
    lang: Option<Lang>,
}

fn dialects() -> impl TypedValueParser<Value = Dialect> {
    PossibleValuesParser::new(Dialect::ALL.map(Dialect::name))
        .map(|name| Dialect::named(&name).unwrap_or_default())
}

fn langs() -> impl TypedValueParser<Value = Lang> {
    PossibleValuesParser::new(["en", "pt-BR"]).map(|name| match name.as_str() {
        "en" => Lang::En,
        _ => Lang::Pt,
    })
}

impl Il {
    /// The language to speak: what was asked for, else what the environment says.
    pub fn lang(&self) -> Lang {
        let says = |name: &&str| env::var(name).is_ok_and(|value| !value.is_empty());
        let variable = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().find(says);
        let from_environment = || match variable.and_then(|name| env::var(name).ok()) {
            Some(value) if value.to_lowercase().starts_with("pt") => Lang::Pt,
            _ => Lang::En,
        };
        self.lang.unwrap_or_else(from_environment)
    }

    /// Whose Instruction List a text was taken to be, and why.
    pub fn dialect(&self, found: Dialect) -> String {
        match (self.dialect, self.lang()) {
            (Some(_), Lang::En) => format!("dialect {found}"),
            (Some(_), Lang::Pt) => format!("dialeto {found}"),
            (None, Lang::En) => format!("dialect {found}, by its words"),
            (None, Lang::Pt) => format!("dialeto {found}, pelas palavras"),
        }
    }
}

/// Where the errors of a text are shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// As what the command was asked for.
    Here,
    /// Beside what the command writes to standard output.
    Beside,
}

/// Reads a program that is right. The faults of one that is not are shown, and the warnings of its text.
pub fn open(path: &Path, il: &Il, shown: Shown) -> anyhow::Result<Option<Source>> {
    let ProgramFile { name, bytes } = read(path)?;
    Ok(check_written(Written::new(name, bytes), il, shown))
}

/// Checks a program that was read; see [`open`].
pub fn check_written(written: Written, il: &Il, shown: Shown) -> Option<Source> {
    match written.check(il.dialect) {
        Ok(source) => {
            if let Language::Il { warnings, .. } = &source.language {
                let Source { name, text, .. } = &source;
                let shown = lang::show(name, text, warnings, il.lang(), &renderer());
                eprint!("{shown}");
            }
            Some(source)
        }
        Err(Refused::Numeric { written, faults }) => {
            let Written { name, bytes, .. } = &written;
            println!("{}", diagnosis::show(name, bytes, &faults, &renderer()));
            None
        }
        Err(Refused::Il {
            name,
            text,
            diagnostics,
        }) => {
            let all = lang::show(&name, &text, &diagnostics, il.lang(), &renderer());
            let count = count(&diagnostics, il.lang());
            match shown {
                Shown::Here => println!("{all}{name}: {count}"),
                Shown::Beside => eprintln!("{all}{name}: {count}"),
            }
            None
        }
    }
}

/// How many errors there are.
fn count(diagnostics: &[Diagnostic], lang: Lang) -> String {
    let errors = diagnostics.iter();
    let errors = errors.filter(|d| d.severity() == Severity::Error).count();
    match (errors, lang) {
        (1, Lang::En) => "1 error; there is no program".to_owned(),
        (_, Lang::En) => format!("{errors} errors; there is no program"),
        (1, Lang::Pt) => "1 erro; não há programa".to_owned(),
        (_, Lang::Pt) => format!("{errors} erros; não há programa"),
    }
}

/// A fault that a board tells of a program, in the line of its text.
pub fn faulty(source: &Source, fault: Fault) -> String {
    let Source { name, code, .. } = source;
    if !source.is_il() {
        let diagnosis = Diagnosis {
            fault,
            told_at: None,
            lacking: [0; 2],
        };
        return diagnosis::show(name, code, &[diagnosis], &renderer());
    }
    let place = fault.line.and_then(|line| source.map.of_code(line));
    let place = place.map_or_else(String::new, |place| format!(":{}", place.line));
    let (number, text) = (fault.cause.number(), fault.cause.text());
    format!("{name}{place}: fault {number}: {text}")
}

/// `unoclp check`.
pub fn check(path: &Path, il: &Il) -> Outcome {
    let Some(source) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    println!("{}: OK: {}", source.name, source.size);
    if let Language::Il { dialect, .. } = source.language {
        println!("  {}", il.dialect(dialect));
    }
    Ok(true)
}
