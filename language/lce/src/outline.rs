//! What a text in LCE declares, and where: the program, and after `var` a place, `=` and its name.

use crate::words::Word;
use unoclp_small::cursor::Keywords;
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
    let mut named: Vec<Named> = Vec::new();
    let mut declares = false;
    for (at, (span, colour)) in words.iter().enumerate() {
        if *colour == Some(Colour::Word) {
            declares = Word::of(written(at)) == Word::Var;
        }
        if colour.is_some() || at == 0 || !begins_name(written(at)) {
            continue;
        }
        if Word::of(written(at - 1)) == Word::Plc {
            named.push(Named::new(What::Program, *span, None));
        } else if declares && at > 1 && written(at - 1) == "=" {
            let (point, _) = words[at - 2];
            let mut variable = Named::new(What::Variable, *span, None);
            variable.point = Some(point);
            variable.whole = point.to(*span);
            named.push(variable);
        }
    }
    Outline {
        named,
        letters_apart: true,
    }
}
