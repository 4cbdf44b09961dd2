//! Diagnostics as text: the line, a caret under what is wrong, and help.

use crate::diagnostics::{Diagnostic, Lang, Severity, Told};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// More diagnostics than this are only counted.
const SHOWN: usize = 20;

/// Shows what has been told of a text that goes by this name, and how much more there is.
pub fn show(name: &str, text: &str, told: &Told, lang: Lang, renderer: &Renderer) -> String {
    let mut shown = String::new();
    // Where not all are shown, no warning takes the place of an error.
    let (mut errors, warnings): (Vec<_>, Vec<_>) =
        told.iter().partition(|d| d.severity() == Severity::Error);
    let room = SHOWN.saturating_sub(errors.len());
    errors.extend(warnings.into_iter().take(room));
    errors.truncate(SHOWN);
    errors.sort_by_key(|d| (d.span.start, d.span.end));
    for diagnostic in &errors {
        shown.push_str(&show_one(name, text, diagnostic, lang, renderer));
        shown.push_str("\n\n");
    }
    if let more @ 1.. = told.len() - errors.len() + told.more {
        shown.push_str(&match lang {
            Lang::En => format!("… and {more} more\n"),
            Lang::Pt => format!("… e mais {more}\n"),
        });
    }
    shown
}

fn show_one(
    name: &str,
    text: &str,
    diagnostic: &Diagnostic,
    lang: Lang,
    renderer: &Renderer,
) -> String {
    let level = match (diagnostic.severity(), lang) {
        (Severity::Error, Lang::En) => Level::ERROR,
        (Severity::Error, Lang::Pt) => Level::ERROR.with_name("erro"),
        (Severity::Warning, Lang::En) => Level::WARNING,
        (Severity::Warning, Lang::Pt) => Level::WARNING.with_name("aviso"),
    };
    let help_level = match lang {
        Lang::En => Level::HELP,
        Lang::Pt => Level::HELP.with_name("ajuda"),
    };
    let title = level
        .primary_title(diagnostic.message(lang))
        .id(diagnostic.code.to_string());
    let mark = AnnotationKind::Primary.span(diagnostic.span.range());
    let snippet = Snippet::source(text).path(name).annotation(mark);
    let help = diagnostic.help(lang);
    let help = (!help.is_empty()).then(|| help_level.message(help));
    renderer.render(&[title.element(snippet).elements(help)])
}
