//! `unoclp list`.

use super::open::{Shown, open};
use super::output::{Kind, cannot_write, create};
use super::wording::Wording;
use super::words::Form;
use crate::Outcome;
use anstream::{eprintln, print, println};
use anyhow::{anyhow, bail};
use std::io::Write;
use std::path::Path;
use unoclp_cli::{ascii, messages};
use unoclp_source::{Diagnostic, Lang, Source, list as listing};

/// Shows a program in this form, or draws it into a file.
pub fn list(
    path: &Path,
    wording: &Wording,
    form: Form,
    svg: Option<&Path>,
    width: usize,
) -> Outcome {
    if svg.is_some() && form != Form::Ladder {
        bail!(messages::svg_is_a_ladder());
    }
    let Some(program) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    let Some(listed) = form.listed() else {
        return Ok(project(&program));
    };
    let Some(svg) = svg else {
        let lang = messages::spoken();
        let listing = listing::list(&program, listed, width, lang);
        let listing = listing.map_err(|refused| anyhow!(said(&refused, lang)))?;
        match form {
            Form::Ladder => print!("{}", ascii::picture(&listing)),
            // These are programs, which stay as they are.
            Form::Il | Form::St | Form::Numeric | Form::Xml => print!("{listing}"),
        }
        return Ok(true);
    };
    let drawing = listing::svg(&program, width, messages::spoken());
    create(svg, Kind::Drawing, &[path])?
        .write_all(drawing.as_bytes())
        .map_err(cannot_write(svg))?;
    println!("{}", messages::drawn(svg.display()));
    Ok(true)
}

/// `ST-221: line 7: …; list the program as …`
fn said(refused: &Diagnostic, lang: Lang) -> String {
    let (message, help) = (refused.message(lang), refused.help(lang));
    format!("{}: {message}; {help}", refused.code)
}

/// Prints a program as a project in PLCopen XML, or why it is none.
fn project(program: &Source) -> bool {
    match listing::plcopen(program) {
        Ok(text) => print!("{text}"),
        Err(lost) => {
            for lost in &lost {
                eprintln!("{}", lost.text(messages::spoken()));
            }
            return false;
        }
    }
    true
}
