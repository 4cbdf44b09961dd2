//! Diagnostics as text: the line, a caret under what is wrong, and help.

use crate::{Diagnostic, Lang, Severity};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// More diagnostics than this are only counted.
const SHOWN: usize = 20;

/// Shows the diagnostics of a text that goes by this name.
pub fn show(
    name: &str,
    text: &str,
    diagnostics: &[Diagnostic],
    lang: Lang,
    renderer: &Renderer,
) -> String {
    let mut shown = String::new();
    for diagnostic in diagnostics.iter().take(SHOWN) {
        shown.push_str(&show_one(name, text, diagnostic, lang, renderer));
        shown.push_str("\n\n");
    }
    if let more @ 1.. = diagnostics.len().saturating_sub(SHOWN) {
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
