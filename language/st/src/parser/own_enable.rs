//! Whether units have parameters of their own that are named as those of every call.

use super::super::token::{Kind, Token};
use super::super::words::Keyword;

/// Whether a unit of the text declares EN or ENO as an input or output; a variable of this name leaves calls theirs.
pub(super) fn declares_en(text: &str, tokens: &[Token], keywords: &[Keyword]) -> bool {
    let is = |token: &Token, what: &str| {
        let written = text.get(token.span.range()).unwrap_or_default();
        written.eq_ignore_ascii_case(what)
    };
    let mut parameters = false;
    // Names in parentheses are values: of an enumeration, or first ones.
    let mut depth = 0_u32;
    tokens.windows(2).zip(keywords).any(|(two, keyword)| {
        let [name, next] = two else {
            return false;
        };
        match keyword {
            Keyword::VarInput | Keyword::VarOutput | Keyword::VarInOut => parameters = true,
            Keyword::EndVar => parameters = false,
            other if other.is_section() => parameters = false,
            _ => {}
        }
        match name.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        parameters
            && depth == 0
            && (is(name, "EN") || is(name, "ENO"))
            && (matches!(next.kind, Kind::Colon | Kind::Comma) || is(next, "AT"))
    })
}
