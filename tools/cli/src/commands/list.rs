//! `unoclp list`.

use super::open::{Shown, open};
use super::output::{Kind, Over, may_write, write};
use super::wording::Wording;
use super::words::Form;
use crate::outcome::Outcome;
use crate::{ascii, messages};
use anstream::{eprintln, print, println};
use anyhow::{anyhow, bail};
use std::path::{Path, PathBuf};
use unoclp_program::{Diagnostic, Lang, Source, harmless_lines, list as listing, shown};

/// A ladder diagram in a file.
pub struct Picture<'p> {
    /// Its name; of several pages what their names begin with.
    pub file: &'p Path,
    /// What its pages are; none where it is one picture, as large as it gets.
    pub paper: Option<listing::Paper>,
    /// The title of the pages, if not the program's own.
    pub title: Option<&'p str>,
    /// What may be overwritten.
    pub over: Over,
}

/// Shows a program in this form, or draws it into a file.
pub fn list(
    path: &Path,
    wording: &Wording,
    form: Form,
    picture: Option<Picture<'_>>,
    width: usize,
) -> Outcome {
    let look = form.look();
    match &picture {
        Some(_) if !matches!(form, Form::Ladder | Form::Fbd) && look.is_none() => {
            bail!(messages::svg_is_a_ladder())
        }
        Some(picture) if picture.paper.is_some() && form != Form::Ladder => {
            bail!(messages::paper_is_a_ladder())
        }
        _ => {}
    }
    let Some(program) = open(path, wording, Shown::Here)? else {
        return Ok(false);
    };
    if let Some(look) = look {
        return charts(path, &program, look, picture.as_ref());
    }
    if let Some(picture) = picture {
        return draw(path, &program, &picture, (form, width));
    }
    let Some(listed) = form.listed() else {
        return Ok(project(&program, form.body()));
    };
    let lang = messages::spoken();
    let listing = listing::list(&program, listed, width, lang);
    let listing = listing.map_err(|refused| anyhow!(said(&refused, lang)))?;
    match form {
        Form::Ladder | Form::Fbd => print!("{}", ascii::picture(&listing)),
        // These are programs, whose characters stay as they are.
        _ => print!("{}", harmless_lines(&listing)),
    }
    Ok(true)
}

/// Shows the charts of a program, or draws the first into a file.
fn charts(
    path: &Path,
    program: &Source,
    look: listing::Look,
    picture: Option<&Picture<'_>>,
) -> Outcome {
    let Some(picture) = picture else {
        let Some(charts) = listing::charts(program, look) else {
            bail!(messages::no_chart());
        };
        print!("{}", ascii::picture(&charts));
        return Ok(true);
    };
    let Some(svg) = listing::chart_svg(program, look) else {
        bail!(messages::no_chart());
    };
    write(
        picture.file,
        svg.into_bytes(),
        Kind::Drawing,
        &[path],
        picture.over,
    )?;
    println!("{}", messages::drawn(shown(picture.file)));
    Ok(true)
}

/// Draws a program into a file, or its pages into as many.
fn draw(
    path: &Path,
    program: &Source,
    picture: &Picture<'_>,
    (form, width): (Form, usize),
) -> Outcome {
    let lang = messages::spoken();
    let pages = match picture.paper {
        None if form == Form::Fbd => vec![listing::svg_of_blocks(program, lang)],
        None => vec![listing::svg(program, width, lang)],
        Some(paper) => listing::pages(program, width, paper, picture.title, lang),
    };
    let files: Vec<PathBuf> = match pages.len() {
        1 => vec![picture.file.to_owned()],
        count => (1..=count)
            .map(|page| numbered(picture.file, page))
            .collect(),
    };
    // Nothing is written where one of them cannot be.
    for file in &files {
        may_write(file, Kind::Drawing, &[path], picture.over)?;
    }
    for (file, page) in files.iter().zip(pages) {
        write(
            file,
            page.into_bytes(),
            Kind::Drawing,
            &[path],
            picture.over,
        )?;
        println!("{}", messages::drawn(shown(file)));
    }
    Ok(true)
}

/// `motor-2.svg` of `motor.svg`.
fn numbered(file: &Path, page: usize) -> PathBuf {
    let mut name = file.file_stem().unwrap_or_default().to_owned();
    name.push(format!("-{page}"));
    if let Some(extension) = file.extension() {
        name.push(".");
        name.push(extension);
    }
    file.with_file_name(name)
}

/// `ST-221: line 7: …; list the program as …`
fn said(refused: &Diagnostic, lang: Lang) -> String {
    let (message, help) = (refused.message(lang), refused.help(lang));
    format!("{}: {message}; {help}", refused.code)
}

/// Prints a program as a project in PLCopen XML, or why it is none.
fn project(program: &Source, body: listing::Body) -> bool {
    let project = listing::plcopen(program, body);
    let told = match &project {
        Ok(project) => &project.beyond,
        Err(lost) => lost,
    };
    for lost in told {
        eprintln!("{}", lost.text(messages::spoken()));
    }
    if let Ok(project) = &project {
        print!("{}", harmless_lines(&project.text));
    }
    project.is_ok()
}
