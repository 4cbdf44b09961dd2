//! Reading a program, whichever of its languages it is written in.

use super::excerpt::renderer;
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::{eprint, eprintln, println};
use anyhow::{anyhow, bail};
use std::io::{Read, stdin};
use std::path::Path;
use std::rc::Rc;
use unoclp_checked::Diagnosis;
use unoclp_core::Fault;
use unoclp_exercise::scenario::{LONGEST, ProgramFile, Unreadable};
use unoclp_lang::{self as lang, Severity, Told};
use unoclp_program::{NoProgram, Refused, Seal, Source, Written, diagnosis, shown};
use unoclp_words::system;
use unoclp_workspace::{Analysis, Ready};

/// Where the errors of a text are shown.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// As what the command was asked for.
    Here,
    /// Beside what the command writes to standard output.
    Beside,
}

/// Reads a file, as long as a program may be; `-` is standard input.
pub fn read(path: &Path) -> anyhow::Result<ProgramFile> {
    if path == Path::new("-") {
        let name = messages::the_input();
        let mut bytes = Vec::new();
        stdin().take(LONGEST + 1).read_to_end(&mut bytes)?;
        if bytes.len() as u64 > LONGEST {
            bail!("{name} {}", Unreadable::TooLong.text(messages::spoken()));
        }
        return Ok(ProgramFile { name, bytes });
    }
    ProgramFile::read(path).map_err(|why| anyhow!(unreadable(&shown(path), &why)))
}

/// That a file of this name cannot be read, and why.
pub fn unreadable(name: &str, why: &Unreadable) -> String {
    match why {
        Unreadable::TooLong | Unreadable::Folder | Unreadable::NoFile => {
            format!("{name} {}", why.text(messages::spoken()))
        }
        Unreadable::System { kind, told } => {
            messages::cannot_read(name, system(messages::spoken(), *kind, told))
        }
    }
}

/// Reads a program that is right. The faults of one that is not are shown, and the warnings of its text.
pub fn open(path: &Path, wording: &Wording, shown: Shown) -> anyhow::Result<Option<Ready>> {
    let ProgramFile { name, bytes } = read(path)?;
    let analysis = wording.workspace().open(wording.of(name, bytes));
    checked(&analysis, wording, shown)
}

/// A program that was read, if it is right; see [`open`].
///
/// # Errors
/// If the file is in none of the languages.
pub fn checked(
    analysis: &Rc<Analysis>,
    wording: &Wording,
    shown: Shown,
) -> anyhow::Result<Option<Ready>> {
    Ok(match analysis.check() {
        Some(Ok(source)) => {
            if let Some(warnings) = source.language.warnings() {
                let Source { name, text, .. } = &**source;
                let shown = lang::show(name, text, warnings, messages::spoken(), &renderer());
                eprint!("{shown}");
            }
            let seal = source.seal();
            if let Some([what, help]) = seal.told(messages::spoken()) {
                let told = format!("{}: {what}; {help}", source.name);
                match seal {
                    // A part of a program may move a machine as nobody has meant it.
                    Seal::Cut => {
                        say!("{told}");
                        return Ok(None);
                    }
                    _ => eprintln!("{}", messages::warning(told)),
                }
            }
            analysis.ready()
        }
        Some(Err(Refused::Numeric { written, faults })) => {
            let Written { name, bytes, .. } = &**written;
            say!(
                "{}",
                diagnosis::show(name, bytes, faults, messages::spoken(), &renderer())
            );
            None
        }
        Some(Err(Refused::Text {
            name,
            text,
            diagnostics,
        })) => {
            let all = lang::show(name, text, diagnostics, messages::spoken(), &renderer());
            let count = count(diagnostics);
            let board = wording.board().name;
            let moved = moved(analysis.written());
            let adapt = moved.map(|moved| messages::can_be_adapted(name, moved, board));
            let adapt = adapt.map(|words| format!("\n{words}")).unwrap_or_default();
            match shown {
                Shown::Here => say!("{all}{name}: {count}{adapt}"),
                Shown::Beside => eprintln!("{all}{name}: {count}{adapt}"),
            }
            None
        }
        Some(Err(Refused::NoProgram { name, why })) => bail!(no_program(name, *why)),
        // Every compiler is at hand.
        None => None,
    })
}

/// The points of a text that lack on its board and have a free one there, for a message.
fn moved(written: &Written) -> Option<String> {
    let adapted = written.adapted().ok()??;
    let points = adapted.moved.iter().map(|(old, _)| old.as_str());
    let points: Vec<&str> = points.collect();
    (!points.is_empty()).then(|| points.join(", "))
}

/// What a file is that is no program, and what one is.
pub fn no_program(name: &str, why: NoProgram) -> String {
    match why {
        NoProgram::Empty => messages::is_empty(name, messages::languages()),
        NoProgram::Binary => messages::is_binary(name, messages::languages()),
        NoProgram::Other => messages::is_no_program(name, messages::languages()),
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
        let faults = [Diagnosis::new(fault, source.board())];
        return diagnosis::show(name, code, &faults, messages::spoken(), &renderer());
    }
    running(source, fault)
}

/// A fault of a program that runs, where it is in its text: `lamp.il:12: fault 75: …`, and that line below.
pub fn running(source: &Source, fault: Fault) -> String {
    let mut cause = messages::fault(fault.cause);
    if let Some(help) = fault.line.and_then(|line| no_real(source, line)) {
        cause = format!("{cause}: {help}");
    }
    match fault.line.and_then(|line| source.line_of(line)) {
        Some((line, text)) => format!("{}:{line}: {cause}\n  {text}", source.name),
        None => format!("{}: {cause}", source.name),
    }
}

/// What is in this line of numeric code, where a board without REAL numbers refuses it.
fn no_real(source: &Source, line: u32) -> Option<String> {
    let code = String::from_utf8_lossy(&source.code);
    let text = code.lines().nth((line as usize).checked_sub(1)?)?;
    let text = text.split('/').next()?.trim();
    diagnosis::no_real(text.parse().ok()?, messages::spoken())
}

/// `unoclp check`.
pub fn check(path: &Path, wording: &Wording) -> Outcome {
    let Some(source) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    println!("{}: OK: {}", source.name, messages::size(&source.size));
    if let Some(told) = wording.told(&source.language) {
        println!("  {told}");
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;
    use unoclp_checked::Work;
    use unoclp_core::Board;

    #[derive(Parser)]
    struct Asked {
        #[command(flatten)]
        wording: Wording,
    }

    fn wording() -> Wording {
        Asked::parse_from(["unoclp"]).wording
    }

    #[test]
    fn a_text_that_is_checked_is_compiled_and_loaded_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lamp.il");
        std::fs::write(&path, "LD I1\nST Q1\n").unwrap();
        let before = Work::done();
        assert!(check(&path, &wording()).unwrap());
        let work = Work::since(before);
        assert_eq!((work.compiles, work.passes), (1, 1), "{work:?}");
    }

    #[test]
    fn a_text_that_is_opened_again_is_what_it_was() {
        let wording = wording();
        let mut texts = wording.workspace();
        let written = |wording: &Wording| wording.of("lamp.il".into(), b"LD I1\nST Q1\n".into());
        let before = Work::done();
        for _ in 0..3 {
            let ready = checked(&texts.open(written(&wording)), &wording, Shown::Here);
            let ready = ready.unwrap().unwrap();
            assert_eq!(ready.symbols().len(), 0);
        }
        assert_eq!(Work::since(before).compiles, 1);
        let nano = wording.on(Board::NANO);
        assert!(texts.open(written(&nano)).source().is_some());
        assert_eq!(
            Work::since(before).compiles,
            2,
            "another board, another version"
        );
    }
}
