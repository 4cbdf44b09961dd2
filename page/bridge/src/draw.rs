//! Ladders and lists of programs.

use crate::answer::answer;
use crate::given::Given;
use crate::program;
use crate::words::{self, Both, No, both};
#[cfg(feature = "full")]
use unoclp_draw::to_blocks;
use unoclp_draw::{Look, Medium, Style, to_screen};
use unoclp_program::Lang;
#[cfg(feature = "full")]
use unoclp_program::Source;
use unoclp_program::list::title;
#[cfg(feature = "full")]
use unoclp_program::list::{
    Body, Form, Lost, Paper, list, pages, picture, plcopen, svg, svg_of_blocks,
};
use unoclp_workspace::Analysis;

/// The language of what is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Speak {
    /// English.
    En,
    /// Brazilian Portuguese.
    Pt,
}

impl Speak {
    /// As a request says; English where it does not.
    ///
    /// # Errors
    /// Where it is no text.
    pub fn of(given: &mut Given) -> Result<Speak, Both> {
        Ok(match given.text_if("speak")?.as_deref() {
            Some("pt") => Speak::Pt,
            _ => Speak::En,
        })
    }
}

impl From<Speak> for Lang {
    fn from(speak: Speak) -> Lang {
        match speak {
            Speak::En => Lang::En,
            Speak::Pt => Lang::Pt,
        }
    }
}

/// What a program is listed as.
#[cfg(feature = "full")]
#[derive(Clone, Copy, Debug)]
pub enum As {
    /// A ladder diagram in characters.
    Ladder,
    /// Instruction List.
    Il,
    /// Structured Text.
    St,
    /// Numeric code with its meaning.
    Numeric,
    /// A ladder diagram as an SVG file, for a report.
    Svg,
    /// The same without a heading, beside a text that says what it is.
    Picture,
    /// The same as `Svg`, of block diagrams.
    SvgFbd,
    /// A project in PLCopen XML, in LD.
    Xml,
    /// The same in FBD.
    XmlFbd,
}

answer! {
    /// A drawing of a page.
    pub struct LadderDrawn as "LadderDrawn" {
        /// The element.
        svg: String,
        /// Whether it is the code of a compiler, which no person would draw.
        code: bool,
    }
}

/// How a page wants a ladder to look.
pub fn look(is_blocks: Option<bool>) -> Look {
    match is_blocks {
        Some(true) => Look::Blocks,
        _ => Look::Ladder,
    }
}

/// The ladder of a program, for a page that shows it live.
///
/// # Errors
/// Where there is no program.
pub fn ladder(
    analysis: &Analysis,
    width: usize,
    look: Look,
    speak: Speak,
) -> Result<LadderDrawn, No> {
    let source = program::source(analysis)?;
    let (Some(ladder), Some(names)) = (analysis.ladder(), analysis.names()) else {
        return Err(both(words::faulty).into());
    };
    let style = Style {
        width: width.min(WIDEST),
        names,
        medium: Medium::Screen,
    };
    let (map, title, label) = (&source.map, title(speak.into()), &source.name);
    let svg = match look {
        Look::Ladder => to_screen(&ladder.draw(&style), map, names, &title, label),
        #[cfg(feature = "full")]
        Look::Blocks => to_blocks(ladder, &style, map, &title, label),
        #[cfg(not(feature = "full"))]
        Look::Blocks => return Err(No::More),
    };
    let code = source.is_code();
    Ok(LadderDrawn { svg, code })
}

/// The widest drawing, columns.
const WIDEST: usize = 400;

/// A program as text.
///
/// # Errors
/// Where Structured Text or PLCopen XML has no words for it.
#[cfg(feature = "full")]
pub fn listed(source: &Source, form: As, width: usize, speak: Speak) -> Result<String, No> {
    let width = width.min(WIDEST);
    let form = match form {
        As::Ladder => Form::Ladder,
        As::Il => Form::Il,
        As::St => Form::St,
        As::Numeric => Form::Numeric,
        As::Svg => return Ok(svg(source, width, speak.into())),
        As::Picture => return Ok(picture(source, width, speak.into())),
        As::SvgFbd => return Ok(svg_of_blocks(source, speak.into())),
        As::Xml | As::XmlFbd => {
            let body = match form {
                As::XmlFbd => Body::Blocks,
                _ => Body::Ladder,
            };
            let project = plcopen(source, body);
            let project = project.map_err(|lost| both(|lang| told(&lost, lang)))?;
            return Ok(project.text);
        }
    };
    list(source, form, width, speak.into())
        .map_err(|refused| both(|lang| refused.message(lang)).into())
}

/// A program on pages of paper, each an SVG document.
#[cfg(feature = "full")]
pub fn paged(source: &Source, letter: bool, width: usize, speak: Speak) -> Vec<String> {
    let paper = if letter { Paper::Letter } else { Paper::A4 };
    pages(source, width.min(WIDEST), paper, None, speak.into())
}

/// What a project cannot say, a line for each.
#[cfg(feature = "full")]
fn told(lost: &[Lost], lang: Lang) -> String {
    let lines: Vec<String> = lost.iter().map(|lost| lost.text(lang)).collect();
    lines.join("\n")
}
