//! Errors in the arguments, in Portuguese; clap has the English ones.

use anstream::{eprint, print};
use clap::Error;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::error::Error as _;

/// Ends with what is wrong with the arguments, or with the help or the version, which are no errors.
pub fn refuse(error: &Error) -> ! {
    let page = error.render().ansi().to_string();
    let page = page.replace(OPTIONS[0], OPTIONS[1]);
    match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => print!("{page}"),
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => eprint!("{page}"),
        _ => {
            let (what, usage) = (wrong(error), usage(error));
            eprint!("erro: {what}\n\n{usage}Para mais informações, use '--help'.\n");
        }
    }
    std::process::exit(error.exit_code())
}

/// How clap calls the options of a command, and how this does.
const OPTIONS: [&str; 2] = ["[OPTIONS]", "[OPÇÕES]"];

/// `Uso: unoclp list [OPTIONS] <FILE>`, if the command is known.
fn usage(error: &Error) -> String {
    let Some(ContextValue::StyledStr(usage)) = error.get(ContextKind::Usage) else {
        return String::new();
    };
    let usage = usage.to_string().replace(OPTIONS[0], OPTIONS[1]);
    format!("Uso: {}\n\n", usage.trim_start_matches("Usage:").trim())
}

fn wrong(error: &Error) -> String {
    let value = |kind: ContextKind| match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    };
    let argument = value(ContextKind::InvalidArg);
    match error.kind() {
        ErrorKind::MissingRequiredArgument => format!("falta indicar: {argument}"),
        ErrorKind::MissingSubcommand => {
            let commands = value(ContextKind::ValidSubcommand);
            format!("falta indicar um comando: {commands}")
        }
        ErrorKind::InvalidSubcommand => {
            let command = value(ContextKind::InvalidSubcommand);
            let near = near(&value(ContextKind::SuggestedSubcommand));
            format!("não existe o comando '{command}'{near}")
        }
        ErrorKind::UnknownArgument => {
            let near = near(&value(ContextKind::SuggestedArg));
            format!("argumento inesperado: '{argument}'{near}")
        }
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => {
            let given = value(ContextKind::InvalidValue);
            let valid = match value(ContextKind::ValidValue) {
                valid if valid.is_empty() => range(error),
                valid => format!("; valores: {valid}"),
            };
            match given.is_empty() {
                true => format!("falta o valor de '{argument}'{valid}"),
                false => format!("valor inválido '{given}' para '{argument}'{valid}"),
            }
        }
        ErrorKind::ArgumentConflict => match value(ContextKind::PriorArg) {
            other if other.is_empty() || other == argument => {
                format!("'{argument}' só pode ser usado uma vez")
            }
            other => format!("'{argument}' não pode ser usado com '{other}'"),
        },
        _ => format!("argumentos inválidos ({argument})"),
    }
}

fn near(name: &str) -> String {
    match name.is_empty() {
        true => String::new(),
        false => format!("; você quis dizer '{name}'?"),
    }
}

/// The range of a number, which clap tells in a sentence alone: `20 is not in 56..=1000`.
fn range(error: &Error) -> String {
    let told = error.source().map(ToString::to_string).unwrap_or_default();
    match told.split_once(" is not in ") {
        Some((_, range)) => format!("; use um valor de {}", range.replace("..=", " a ")),
        None => String::new(),
    }
}
