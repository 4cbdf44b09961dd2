//! A program listed: as a ladder diagram, as Instruction List, as Structured Text, or as numeric code with the
//! meaning of each line.

mod numeric;
mod words;

use crate::{Source, WrittenIn, names};
use std::path::Path;
use unoclp_checked::SourceMap;
use unoclp_draw::edit::Document;
use unoclp_draw::{Drawing, Ladder, Medium, Names, Report, Style, Title};
use unoclp_draw::{listing, listing_of_blocks, to_picture, to_report, to_svg, to_svg_of_blocks};
use unoclp_lang::{Diagnostic, Lang, TextLanguage, instructions_to_il, to_st};

use unoclp_sfc::Sheet;

pub use unoclp_draw::Paper;
pub use unoclp_plcopen::{Exported, Lost};
pub use unoclp_sfc::Look;

/// What a program is listed as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// A ladder diagram
    #[default]
    Ladder,
    /// The same drawn as blocks
    Blocks,
    /// Instruction List, in the words of IEC 61131-3
    Il,
    /// Structured Text
    St,
    /// Numeric code, each line with its letters and its meaning
    Numeric,
}

/// Lists a program in so many columns, as far as the form can be narrow, with what is said of it in this language.
///
/// # Errors
/// What Structured Text has no words for.
pub fn list(
    source: &Source,
    form: Form,
    width: usize,
    lang: Lang,
) -> Result<String, Box<Diagnostic>> {
    let program = source.program();
    Ok(match form {
        Form::Numeric => numeric::listing(program, &source.map, lang),
        Form::Il => instructions_to_il(program.steps(), source.board()),
        Form::St => to_st(program, &source.map)?,
        Form::Blocks => {
            let ladder = Ladder::new(program.steps());
            let names = names(&source.map, &ladder);
            listing_of_blocks(&ladder, width, &source.map, &names, &title(lang))
        }
        Form::Ladder => {
            let ladder = Ladder::new(program.steps());
            let names = names(&source.map, &ladder);
            let drawing = draw(&ladder, &names, width, Medium::PLAIN);
            listing(&drawing, &source.map, &names, &title(lang))
        }
    })
}

/// What the steps do that a line of the text has become, which counts from 1, and how many bytes they take when they are
/// stored.
pub fn of_line(source: &Source, line: usize, lang: Lang) -> (Vec<String>, usize) {
    let mut steps = source.program().steps();
    let (mut effects, mut bytes) = (Vec::new(), 0);
    for place in &source.map.steps {
        let before = steps.at();
        let Some(step) = steps.next() else { break };
        if place.unit.is_none() && place.line == line {
            bytes += steps.at() - before;
            effects.push(numeric::meaning(step, lang));
        }
    }
    (effects, bytes)
}

/// The charts of a program, of characters, in the look of a norm; none where it has none.
pub fn charts(source: &Source, look: Look) -> Option<String> {
    let all = source.charts.iter().map(|chart| {
        let sheet = Sheet::drawn(chart, look);
        unoclp_sfc::picture(chart, &sheet, None)
    });
    let all: Vec<String> = all.collect();
    (!all.is_empty()).then(|| all.join("\n"))
}

/// The first chart of a program as an SVG document; none where it has none.
pub fn chart_svg(source: &Source, look: Look) -> Option<String> {
    let chart = source.charts.first()?;
    let sheet = Sheet::drawn(chart, look);
    Some(unoclp_sfc::svg(chart, &sheet, None, &about(source), false))
}

/// How a ladder is drawn in a project in PLCopen XML.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Body {
    /// As contacts and coils: LD.
    Ladder,
    /// As blocks: FBD.
    Blocks,
}

/// A program as a project in PLCopen XML, which goes by the name of its file. A chart is exported as it is written; so is a text
/// or a project that no ladder expresses.
///
/// # Errors
/// What no project can say.
pub fn plcopen(source: &Source, body: Body) -> Result<Exported, Vec<Lost>> {
    let name = Path::new(&source.name).file_stem().unwrap_or_default();
    let is_st = source.language.written_in() == WrittenIn::Typed(TextLanguage::St);
    if is_st && !source.charts.is_empty() {
        return Ok(Exported {
            text: unoclp_plcopen::export_text(&source.text, &name.to_string_lossy()),
            beyond: Vec::new(),
        });
    }
    let ladder = Ladder::new(source.program().steps());
    let document = Document::of_steps(source.program().steps());
    let document = document.with_text(&source.map);
    let document = document.with_names(names(&source.map, &ladder));
    let export = match body {
        Body::Ladder => unoclp_plcopen::export,
        Body::Blocks => unoclp_plcopen::export_blocks,
    };
    let exported = export(&document, &name.to_string_lossy(), source.board())?;
    if body == Body::Ladder && !exported.beyond.is_empty() {
        let own = match source.language.written_in() {
            WrittenIn::Xml => Some(source.text.clone()),
            _ if is_st => same(source, &name.to_string_lossy()),
            _ => None,
        };
        if let Some(text) = own {
            let beyond = Vec::new();
            return Ok(Exported { text, beyond });
        }
    }
    Ok(exported)
}

/// The project of a text, with its bodies as they are written; none where it is not read as the same codes.
fn same(source: &Source, name: &str) -> Option<String> {
    let text = unoclp_plcopen::export_text(&source.text, name);
    let (read, _) = unoclp_plcopen::import(&text, source.board()).program?;
    let steps = read.program().steps().flat_map(|step| step.codes());
    let own = source.program().steps().flat_map(|step| step.codes());
    steps.eq(own).then_some(text)
}

/// A ladder diagram as an SVG document. Its title is the first comment of the file, or the file's name.
pub fn svg(source: &Source, width: usize, lang: Lang) -> String {
    drawn(source, width, lang, to_svg)
}

/// The same without its title, for a place that says what it is.
pub fn picture(source: &Source, width: usize, lang: Lang) -> String {
    drawn(source, width, lang, to_picture)
}

type ToSvg = fn(&Drawing<'_>, &SourceMap, &Names, Title<'_>, &str) -> String;

fn drawn(source: &Source, width: usize, lang: Lang, to_svg: ToSvg) -> String {
    let ladder = Ladder::new(source.program().steps());
    let names = names(&source.map, &ladder);
    let drawing = draw(&ladder, &names, width, Medium::Paper);
    to_svg(&drawing, &source.map, &names, &title(lang), &about(source))
}

/// As [`svg`], of block diagrams.
pub fn svg_of_blocks(source: &Source, lang: Lang) -> String {
    let ladder = Ladder::new(source.program().steps());
    let names = &names(&source.map, &ladder);
    let (width, medium) = (unoclp_draw::NARROWEST, Medium::Paper);
    let style = Style {
        width,
        names,
        medium,
    };
    to_svg_of_blocks(&ladder, &style, &source.map, &title(lang), &about(source))
}

/// A ladder diagram on pages of paper, each an SVG document: under `heading`, or under the first comment of the file, or
/// under its name.
pub fn pages(
    source: &Source,
    width: usize,
    paper: Paper,
    heading: Option<&str>,
    lang: Lang,
) -> Vec<String> {
    let ladder = Ladder::new(source.program().steps());
    let names = names(&source.map, &ladder);
    let drawing = draw(&ladder, &names, width, Medium::Paper);
    let texts = [
        words::writer(lang),
        words::date(lang),
        words::points(lang),
        words::point(lang),
        words::name(lang),
        words::rungs(lang),
    ];
    let [writer, date, points @ ..] = texts.each_ref().map(String::as_str);
    let heading = heading.map_or_else(|| about(source), str::to_owned);
    let report = Report {
        paper,
        title: &heading,
        file: &file(source),
        name: writer,
        date,
        points,
        page: &|page, pages| words::page(lang, page, pages),
    };
    to_report(&drawing, &source.map, &names, &title(lang), &report)
}

/// The name of a program's file, without its folder.
fn file(source: &Source) -> String {
    let name = Path::new(&source.name).file_name();
    name.unwrap_or_default().to_string_lossy().into_owned()
}

/// What a program is about: its first comment, or the name of its file.
fn about(source: &Source) -> String {
    let title = source.map.title.first();
    title.cloned().unwrap_or_else(|| file(source))
}

/// What a rung is called: by its number, from 1, and its first and last line.
pub fn title(lang: Lang) -> impl Fn(usize, Option<(usize, usize)>) -> String {
    move |number, lines| match lines {
        None => words::rung(lang, number),
        Some((from, to)) if from == to => words::rung_line(lang, number, from),
        Some((from, to)) => words::rung_lines(lang, number, from, to),
    }
}

fn draw<'l>(ladder: &'l Ladder, names: &Names, width: usize, medium: Medium<'_>) -> Drawing<'l> {
    ladder.draw(&Style {
        width,
        names,
        medium,
    })
}
