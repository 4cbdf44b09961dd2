//! Points that only one maker has, in a text that uses no word of his: `X0`, `%M0`.

use super::Parser;
use crate::lexer::Kind;
use std::collections::HashSet;
use unoclp_text::Dialect;

impl Parser<'_, '_> {
    /// Looks for points that leave no doubt whose they are. Names of the text's own do, and so do points of others.
    pub(super) fn find_points(&mut self) {
        let mut found: HashSet<&str> = HashSet::new();
        let mut declared: HashSet<String> = HashSet::new();
        let mut others = false;
        for (index, token) in self.tokens.iter().enumerate() {
            let text = self.text.get(token.span.range()).unwrap_or_default();
            if token.kind != Kind::Name || text.len() > 4 {
                continue;
            }
            let next = self.tokens.get(index + 1).copied().unwrap_or(*token);
            let declares = matches!(next.kind, Kind::Colon | Kind::Assign) || self.is(next, "AT");
            let letter = text.as_bytes().first().map(u8::to_ascii_uppercase);
            match letter {
                Some(b'X' | b'Y') if declares || next.kind == Kind::Comma => {
                    declared.insert(text.to_uppercase());
                }
                Some(b'X' | b'Y') if is_octal(text.get(1..)) => {
                    found.insert(text);
                }
                Some(b'I' | b'Q') if text.ends_with(|c: char| c.is_ascii_digit()) => others = true,
                _ if text.eq_ignore_ascii_case("%M0") || text.eq_ignore_ascii_case("%MW0") => {
                    self.signs.see_point(Dialect::Twido);
                }
                _ => {}
            }
        }
        let named = |name: &&str| declared.contains(&name.to_uppercase());
        if !others && !found.is_empty() && !found.iter().any(named) {
            self.signs.see_point(Dialect::Mitsubishi);
        }
    }
}

fn is_octal(digits: Option<&str>) -> bool {
    digits.is_some_and(|digits| {
        !digits.is_empty() && digits.bytes().all(|b| matches!(b, b'0'..=b'7'))
    })
}
