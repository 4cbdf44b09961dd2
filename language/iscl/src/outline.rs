//! What a text in InterSCL declares, and where: a type, and then a name.

use unoclp_text::colour::Colour;
use unoclp_text::diagnostics::Span;
use unoclp_text::outline::{Named, Outline, What, begins_name};

/// What these words of a text declare.
pub fn outline(text: &str, words: &[(Span, Option<Colour>)]) -> Outline {
    let written = |at: usize| {
        let word: Option<&(Span, Option<Colour>)> = words.get(at);
        word.and_then(|(span, _)| text.get(span.range()))
            .unwrap_or_default()
    };
    let types = ["BOOL", "INT", "REAL"];
    let mut named = Vec::new();
    for (at, (span, colour)) in words.iter().enumerate().skip(1) {
        let ty = written(at - 1);
        let is_type = types.iter().any(|own| own.eq_ignore_ascii_case(ty));
        if colour.is_some() || !is_type || !begins_name(written(at)) {
            continue;
        }
        let (ty, _) = words[at - 1];
        let is_at = written(at + 1).eq_ignore_ascii_case("AT");
        let point = words.get(at + 2).filter(|_| is_at).map(|(span, _)| *span);
        let mut variable = Named::new(What::Variable, *span, None);
        (variable.ty, variable.point) = (Some(ty), point);
        variable.whole = ty.to(point.unwrap_or(*span));
        named.push(variable);
    }
    Outline {
        named,
        letters_apart: false,
    }
}
