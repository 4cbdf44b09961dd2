//! Reading a program, whichever of the two languages it is written in.

use crate::{Outcome, read, refuse, renderer};
use anstream::{eprint, eprintln, println};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::env;
use std::path::Path;
use unoclp_host_sim::scenario::ProgramFile;
use unoclp_lang::{Dialect, Lang, Severity, show};
use unoclp_source::diagnosis::{Size, diagnose};
use unoclp_source::{Written, is_il};

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

/// Reads a program that is right, and its size. The faults of one that is not are shown, and the warnings of
/// its text.
pub fn open(path: &Path, il: &Il, shown: Shown) -> anyhow::Result<Option<(Written, Size)>> {
    let ProgramFile { name, bytes } = read(path)?;
    let program = match is_il(path, &bytes) {
        true => Written::il(name, &bytes, il.dialect),
        false => Written::numeric(name, bytes),
    };
    if !passes(&program, il.lang(), shown) {
        return Ok(None);
    }
    match diagnose(&program.bytes) {
        Ok(size) => Ok(Some((program, size))),
        Err(faults) => {
            refuse(&program, &faults);
            Ok(None)
        }
    }
}

/// Shows what there is to say of a text of Instruction List; whether there is a program. Warnings stand beside
/// what was asked for.
fn passes(program: &Written, lang: Lang, shown: Shown) -> bool {
    let Some(compiled) = &program.compiled else {
        return true;
    };
    let Written { name, text, .. } = program;
    let text = show(name, text, &compiled.diagnostics, lang, &renderer());
    if !compiled.has_errors() {
        eprint!("{text}");
        return true;
    }
    let errors = compiled.diagnostics.iter();
    let errors = errors.filter(|d| d.severity() == Severity::Error).count();
    let count = match (errors, lang) {
        (1, Lang::En) => "1 error; there is no program".to_owned(),
        (_, Lang::En) => format!("{errors} errors; there is no program"),
        (1, Lang::Pt) => "1 erro; não há programa".to_owned(),
        (_, Lang::Pt) => format!("{errors} erros; não há programa"),
    };
    match shown {
        Shown::Here => println!("{text}{name}: {count}"),
        Shown::Beside => eprintln!("{text}{name}: {count}"),
    }
    false
}

/// `unoclp check`.
pub fn check(path: &Path, il: &Il) -> Outcome {
    let Some((program, size)) = open(path, il, Shown::Here)? else {
        return Ok(false);
    };
    println!("{}: OK: {size}", program.name);
    if let Some(compiled) = &program.compiled {
        println!("  {}", il.dialect(compiled.dialect));
    }
    Ok(true)
}
