//! Whether a text in Instruction List has what the typed tree is for: types, and functions of the norm.
//!
//! What has neither is read by `il`, which knows every maker's words.

use super::Dialect;
use super::lexer::tokens;
use super::token::{Kind, Token};
use super::words::Keyword;
use crate::diagnostics::Found;
use crate::operators;
use crate::typed::build::is_function;
use std::collections::HashSet;

/// Types that `il` does not have.
const TYPES: [&str; 15] = [
    "REAL",
    "LREAL",
    "LINT",
    "ULINT",
    "LWORD",
    "STRING",
    "WSTRING",
    "DATE",
    "TOD",
    "TIME_OF_DAY",
    "DT",
    "DATE_AND_TIME",
    "ARRAY",
    "STRUCT",
    "(",
];

/// Whether a text declares a type of its own or one that has parts or fractions, or has an operator that is a function of
/// the norm alone: then it is compiled by way of the typed tree.
pub fn has_types(text: &str) -> bool {
    if !may_have_types(text) {
        return false;
    }
    let tokens = tokens(text, Dialect::Il, &mut Found::default());
    let word = |at: usize| -> &str {
        let token = tokens.get(at);
        let text = token.and_then(|token| text.get(token.span.range()));
        text.unwrap_or_default()
    };
    let kind = |at: usize| tokens.get(at).map(|token| token.kind);
    let mut own: HashSet<String> = HashSet::new();
    for at in 1..tokens.len() {
        let named = ["FUNCTION", "FUNCTION_BLOCK"]
            .iter()
            .any(|k| word(at - 1).eq_ignore_ascii_case(k));
        // What is declared is the text's own, whatever its name.
        if named || matches!(kind(at + 1), Some(Kind::Colon)) {
            own.insert(word(at).to_uppercase());
        }
    }
    let mut declares = false;
    (0..tokens.len()).any(|at| match kind(at) {
        Some(Kind::Colon) => {
            let ty = word(at + 1).to_uppercase();
            let label = begins_line(text, &tokens, at.saturating_sub(1)) && is_operator(&ty);
            !label && (TYPES.contains(&ty.as_str()) || is_part(&tokens, at + 1, &ty))
        }
        Some(Kind::Word) => {
            match Keyword::of(word(at)) {
                Keyword::EndVar => declares = false,
                keyword if keyword.is_section() => declares = true,
                _ => {}
            }
            let first = begins_line(text, &tokens, at);
            let behind_label =
                at > 1 && kind(at - 1) == Some(Kind::Colon) && begins_line(text, &tokens, at - 2);
            let key = word(at).to_uppercase();
            if declares || !first && !behind_label || own.contains(&key) {
                return false;
            }
            let begins_type = key == "TYPE" && kind(at + 1) == Some(Kind::Word);
            begins_type || is_function(&key) && !is_operator(&key)
        }
        Some(Kind::Typed) => {
            let prefix = word(at)
                .split('#')
                .next()
                .unwrap_or_default()
                .to_uppercase();
            matches!(
                prefix.as_str(),
                "D" | "DATE" | "TOD" | "TIME_OF_DAY" | "DT" | "DATE_AND_TIME" | "STRING" | "LREAL"
            )
        }
        _ => false,
    })
}

/// Whether some word of the text may be one of those, wherever it stands; found without keeping anything of the text.
fn may_have_types(text: &str) -> bool {
    let behind_colon = |part: &str| part.trim_start().starts_with(['(', '/']);
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    text.contains("..")
        || text.split(':').skip(1).any(behind_colon)
        || text.split(|c| !is_word(c)).any(may_be_of_types)
}

fn may_be_of_types(word: &str) -> bool {
    // `DATE_AND_TIME_TO_DATE_AND_TIME` has 30; no word that matters is longer.
    let mut upper = [0; 32];
    let Some(upper) = upper.get_mut(..word.len()) else {
        return false;
    };
    upper.copy_from_slice(word.as_bytes());
    upper.make_ascii_uppercase();
    let key = str::from_utf8(upper).unwrap_or_default();
    TYPES.contains(&key) || ["TYPE", "D"].contains(&key) || !is_operator(key) && is_function(key)
}

fn is_operator(key: &str) -> bool {
    operators::find(key).is_some()
}

/// `INT (0..100)`
fn is_part(tokens: &[Token], at: usize, ty: &str) -> bool {
    let kind = |at: usize| tokens.get(at).map(|token| token.kind);
    let integer = crate::typed::Base::named(ty).is_some_and(|base| base.is_int());
    let range = (at + 2..at + 6).any(|at| kind(at) == Some(Kind::Range));
    integer && kind(at + 1) == Some(Kind::Open) && range
}

fn begins_line(text: &str, tokens: &[Token], at: usize) -> bool {
    let Some(token) = tokens.get(at) else {
        return false;
    };
    let before = at.checked_sub(1).and_then(|at| tokens.get(at));
    let start = before.map_or(0, |before| before.span.end as usize);
    let between = text.get(start..token.span.start as usize);
    before.is_none() || between.is_some_and(|between| between.contains('\n'))
}
