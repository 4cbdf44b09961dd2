//! A text as words and signs, without its comments.
//!
//! Owns where each begins, and what follows the parts that are passed over. Must not know a language from another.

use std::collections::HashSet;

/// The text with a blank for each comment, each line where it was: `(* *)`, `/* */`, `//`, and lines that begin with `;`.
pub(super) fn without_comments(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut nests = true;
    let mut rest = text.trim_start_matches('\u{FEFF}');
    while let Some(at) = rest.find(['(', '/', ';']) {
        let (before, from) = rest.split_at(at);
        code.push_str(before);
        let begins_line = code
            .rsplit('\n')
            .next()
            .unwrap_or_default()
            .trim()
            .is_empty();
        let end = if from.starts_with("(*") {
            behind_comment(from, &mut nests).unwrap_or(from.len())
        } else if from.starts_with("/*") {
            from.find("*/").map_or(from.len(), |end| end + 2)
        } else if from.starts_with("//") || from.starts_with(';') && begins_line {
            from.find('\n').unwrap_or(from.len())
        } else {
            code.push_str(&from[..1]);
            rest = &from[1..];
            continue;
        };
        let (comment, behind) = from.split_at(end);
        code.push(' ');
        code.extend(comment.chars().filter(|c| *c == '\n'));
        rest = behind;
    }
    code.push_str(rest);
    code
}

/// After the comment that begins here. Comments hold comments, until one is found that then has no end.
fn behind_comment(text: &str, nests: &mut bool) -> Option<usize> {
    if *nests {
        let (mut deep, mut at) = (0_usize, 0);
        while let Some(pair) = text.as_bytes().get(at..at + 2) {
            at += match pair {
                b"(*" | b"*)" => 2,
                _ => 1,
            };
            match pair {
                b"(*" => deep += 1,
                b"*)" => deep -= 1,
                _ => {}
            }
            if deep == 0 {
                return Some(at);
            }
        }
        *nests = false;
    }
    text.find("*)").map(|end| end + 2)
}

/// The words and signs of a text; `:=` is one.
pub(super) struct Words<'t> {
    text: &'t str,
    /// Where each begins and ends.
    places: Vec<(usize, usize)>,
    /// All of them, each once, in upper case.
    all: HashSet<String>,
    /// Whether something of the standard ends.
    pub(super) ends: bool,
}

impl<'t> Words<'t> {
    pub(super) fn new(text: &'t str) -> Words<'t> {
        let mut places = Vec::new();
        let of_word = |c: char| c.is_alphanumeric() || c == '_';
        let mut at = 0;
        while let Some(first) = text[at..].chars().next() {
            let rest = &text[at..];
            let length = if first.is_whitespace() {
                0
            } else if of_word(first) {
                rest.find(|c| !of_word(c)).unwrap_or(rest.len())
            } else if rest.starts_with(":=") {
                2
            } else {
                first.len_utf8()
            };
            if length > 0 {
                places.push((at, at + length));
            }
            at += match length {
                0 => first.len_utf8(),
                length => length,
            };
        }
        let word = |&(start, end): &(usize, usize)| text[start..end].to_uppercase();
        let all: HashSet<String> = places.iter().map(word).collect();
        Words {
            ends: all.iter().any(|word| word.starts_with("END_")),
            text,
            places,
            all,
        }
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }

    /// The word or sign; empty after the last.
    pub(super) fn at(&self, at: usize) -> &'t str {
        let place = self.places.get(at);
        place.map_or("", |&(start, end)| &self.text[start..end])
    }

    pub(super) fn upper(&self, at: usize) -> String {
        self.at(at).to_uppercase()
    }

    pub(super) fn is_word(&self, at: usize) -> bool {
        self.at(at)
            .starts_with(|c: char| c.is_alphabetic() || c == '_')
    }

    /// Whether any of them is this one, given in upper case.
    pub(super) fn has(&self, word: &str) -> bool {
        self.all.contains(word)
    }

    fn between(&self, at: usize) -> &'t str {
        let before = at.checked_sub(1).and_then(|at| self.places.get(at));
        let start = self.places.get(at).map_or(self.text.len(), |place| place.0);
        &self.text[before.map_or(0, |place| place.1)..start]
    }

    pub(super) fn begins_line(&self, at: usize) -> bool {
        at == 0 || self.between(at).contains('\n')
    }

    /// Whether nothing stands before it.
    pub(super) fn touches(&self, at: usize) -> bool {
        self.between(at).is_empty()
    }

    /// Its line, from it on.
    pub(super) fn line(&self, at: usize) -> &'t str {
        let start = self.places.get(at).map_or(self.text.len(), |place| place.0);
        self.text[start..].lines().next().unwrap_or_default()
    }

    /// After the next word like this.
    pub(super) fn behind(&self, word: &str, from: usize) -> usize {
        let end = (from..self.len()).find(|&at| self.at(at).eq_ignore_ascii_case(word));
        end.map_or(self.len(), |at| at + 1)
    }

    /// After `FUNCTION name : INT`, whose name a mistake may have left out.
    pub(super) fn behind_head(&self, at: usize) -> usize {
        let name = match self.at(at + 1) {
            "\"" => at + 4,
            _ if self.is_word(at + 1) && !self.upper(at + 1).starts_with("VAR") => at + 2,
            _ => at + 1,
        };
        match self.at(name) {
            ":" => name + 2,
            _ => name,
        }
    }

    /// Whether what begins here is a unit or a declaration, and no sentence.
    pub(super) fn is_unit(&self, at: usize) -> bool {
        let second = self.upper(at + 1);
        match self.upper(at).as_str() {
            "VAR" | "TYPE" => {
                let declares =
                    self.is_word(at + 1) && matches!(self.at(at + 2), ":" | "," | "AT" | "at");
                declares && (self.ends || self.has(";"))
                    || matches!(
                        second.as_str(),
                        "END_VAR" | "END_TYPE" | "CONSTANT" | "RETAIN"
                    )
                    || self.has("END_VAR")
            }
            word if word.starts_with("VAR_") => true,
            _ => self.has(":=") || self.ends || self.has("VAR"),
        }
    }

    /// Whether the statement that begins here stores something: `a[1].x := …`
    pub(super) fn is_stored(&self, at: usize) -> bool {
        let mut behind = (at..self.len()).take(64).map(|at| self.at(at));
        behind.find(|word| matches!(*word, ":=" | ";")) == Some(":=")
    }

    /// After the parenthesis of a call: `t(IN := x)`
    pub(super) fn behind_call(&self, at: usize) -> Option<usize> {
        let mut deep = 0_i64;
        for at in at + 1..self.len() {
            match self.at(at) {
                "(" => deep += 1,
                ")" => deep -= 1,
                _ => {}
            }
            if deep == 0 {
                return Some(at + 1);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_leave_lines_as_they_were() {
        for (text, code) in [
            ("a(* b\nc *)d//e\nf", "a \nd \nf"),
            ("; a\nb; c", " \nb; c"),
            ("a (* b", "a  "),
            ("a (* b (* c *) d *) e", "a   e"),
            ("a (* b (* c *) d", "a   d"),
            ("a/b(c", "a/b(c"),
        ] {
            assert_eq!(without_comments(text), code);
        }
    }
}
