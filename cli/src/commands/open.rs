//! Reading a program, whichever of its languages it is written in.

use crate::{Outcome, renderer};
use anstream::{eprint, eprintln, println};
use anyhow::anyhow;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::path::Path;
use unoclp_checked::Diagnosis;
use unoclp_cli::messages;
use unoclp_core::Fault;
use unoclp_host_sim::scenario::{ProgramFile, Unreadable};
use unoclp_lang::TextLanguage;
use unoclp_lang::{self as lang, Dialect, Lang, Severity, Told};
use unoclp_source::messages::system;
use unoclp_source::{Language, Refused, Source, Written, diagnosis};

/// How to read Instruction List.
#[derive(Args)]
pub struct Il {
    /// Whose Instruction List it is; else what its words look like
    #[arg(long, value_parser = dialects())]
    dialect: Option<Dialect>,
}

fn dialects() -> impl TypedValueParser<Value = Dialect> {
    PossibleValuesParser::new(Dialect::ALL.map(Dialect::name))
        .map(|name| Dialect::named(&name).unwrap_or_default())
}

/// The languages that --lang knows.
pub fn langs() -> impl TypedValueParser<Value = Lang> {
    PossibleValuesParser::new([
        PossibleValue::new("en"),
        PossibleValue::new("pt-BR").aliases(["pt", "pt_BR", "pt-br", "pt_br"]),
    ])
    .map(|name| language(&name).unwrap_or_default())
}

/// The language of this name, as --lang and environments have it: `en`, `pt`, `pt-BR`, `pt_BR.UTF-8`.
pub fn language(name: &str) -> Option<Lang> {
    match name.to_lowercase().split(['-', '_', '.']).next() {
        Some("pt") => Some(Lang::Pt),
        Some("en") => Some(Lang::En),
        _ => None,
    }
}

impl Il {
    /// What a text was taken to be; nothing of numeric code.
    pub fn told(&self, language: &Language) -> Option<String> {
        match language {
            Language::Numeric => None,
            Language::Il { dialect, .. } => Some(self.dialect(*dialect)),
            Language::Typed { language, .. } => Some(match language {
                TextLanguage::St | TextLanguage::Scl => messages::structured_text(),
                // Names, the same in every language.
                TextLanguage::Iscl => "InterSCL".to_owned(),
                TextLanguage::Lce => "LCE".to_owned(),
            }),
        }
    }

    /// Whose Instruction List a text was taken to be, and why.
    pub fn dialect(&self, found: Dialect) -> String {
        match self.dialect {
            Some(_) => messages::dialect(found),
            None => messages::dialect_by_words(found),
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

/// Reads a file, as long as a program may be.
pub fn read(path: &Path) -> anyhow::Result<ProgramFile> {
    ProgramFile::read(path).map_err(|why| {
        let name = path.display();
        anyhow!(match &why {
            Unreadable::TooLong => format!("{name} {}", why.text(messages::spoken())),
            Unreadable::System { kind, told } => {
                messages::cannot_read(name, system(messages::spoken(), *kind, told))
            }
        })
    })
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
            if let Some(warnings) = source.language.warnings() {
                let Source { name, text, .. } = &source;
                let shown = lang::show(name, text, warnings, messages::spoken(), &renderer());
                eprint!("{shown}");
            }
            Some(source)
        }
        Err(Refused::Numeric { written, faults }) => {
            let Written { name, bytes, .. } = &written;
            say!(
                "{}",
                diagnosis::show(name, bytes, &faults, messages::spoken(), &renderer())
            );
            None
        }
        Err(Refused::Text {
            name,
            text,
            diagnostics,
        }) => {
            let all = lang::show(&name, &text, &diagnostics, messages::spoken(), &renderer());
            let count = count(&diagnostics);
            match shown {
                Shown::Here => say!("{all}{name}: {count}"),
                Shown::Beside => eprintln!("{all}{name}: {count}"),
            }
            None
        }
    }
}

/// How many errors there are; of a text with more than are listed nothing is counted.
pub(super) fn count(told: &Told) -> String {
    let errors = told.iter();
    let errors = errors.filter(|d| d.severity() == Severity::Error).count();
    match errors {
        _ if told.more > 0 => messages::there_is_no_program(),
        1 => messages::one_error(),
        errors => messages::errors(errors),
    }
}

/// A fault that a board tells of a program, in the line of its text.
pub fn faulty(source: &Source, fault: Fault) -> String {
    let Source { name, code, .. } = source;
    if !source.is_text() {
        let faults = [Diagnosis::from(fault)];
        return diagnosis::show(name, code, &faults, messages::spoken(), &renderer());
    }
    running(source, fault)
}

/// A fault of a program that runs, where it stands in its text: `lamp.il:12: fault 75: …`, and that line below.
pub fn running(source: &Source, fault: Fault) -> String {
    let cause = messages::fault(fault.cause);
    match fault.line.and_then(|line| source.line_of(line)) {
        Some((line, text)) => format!("{}:{line}: {cause}\n  {text}", source.name),
        None => format!("{}: {cause}", source.name),
    }
}

/// `unoclp check`.
pub fn check(path: &Path, il: &Il) -> Outcome {
    let Some(source) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    println!("{}: OK: {}", source.name, messages::size(&source.size));
    if let Some(told) = il.told(&source.language) {
        println!("  {told}");
    }
    Ok(true)
}
