//! What is wrong with a text, or worth a second look.

use crate::documents::Open;
use crate::lines::Places;
use lsp_types::{Diagnostic, DiagnosticSeverity, NumberOrString, Position, Range};
use unoclp_checked::Diagnosis;
use unoclp_lang::{Lang, Severity};
use unoclp_program::{Refused, diagnosis};
use unoclp_workspace::Analysis;

/// All of them in the order of their places.
pub(crate) fn problems(open: &Open, lang: Lang) -> Vec<Diagnostic> {
    if let Some(Err(Refused::Numeric { written, faults })) = open.analysis.check() {
        let fault = |fault: &Diagnosis| numeric(&written.bytes, fault, lang);
        return faults.iter().map(fault).collect();
    }
    told(&open.analysis)
        .iter()
        .map(|about| of_text(&open.places, about, lang))
        .collect()
}

/// What a compiler says of a text.
pub(crate) fn told(analysis: &Analysis) -> &[unoclp_lang::Diagnostic] {
    match analysis.check() {
        Some(Ok(source)) => source.language.warnings().map_or(&[], |told| &told.listed),
        Some(Err(Refused::Text { diagnostics, .. })) => &diagnostics.listed,
        _ => &[],
    }
}

/// One of them.
pub(crate) fn of_text(places: &Places, about: &unoclp_lang::Diagnostic, lang: Lang) -> Diagnostic {
    let help = about.help(lang);
    let message = match help.is_empty() {
        true => about.message(lang),
        false => format!("{}\n{help}", about.message(lang)),
    };
    Diagnostic {
        range: places.range(about.span),
        severity: Some(match about.severity() {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
        }),
        code: Some(NumberOrString::String(about.code.to_string())),
        source: Some("unoclp".to_owned()),
        message,
        ..Diagnostic::default()
    }
}

/// A fault of numeric code. Its columns are characters; numeric code has none beyond the first plane before a comment.
fn numeric(file: &[u8], fault: &Diagnosis, lang: Lang) -> Diagnostic {
    let told = diagnosis::tell(file, fault, lang);
    let line = told.line.unwrap_or(1).saturating_sub(1);
    let [start, end] =
        [told.columns.start, told.columns.end].map(|at| Position::new(line, at as u32));
    let help = told.help.unwrap_or_default();
    Diagnostic {
        range: Range::new(start, end),
        severity: Some(DiagnosticSeverity::ERROR),
        code: Some(NumberOrString::String(
            fault.fault.cause.number().to_string(),
        )),
        source: Some("unoclp".to_owned()),
        message: format!("{}\n{help}", told.message).trim_end().to_owned(),
        ..Diagnostic::default()
    }
}
