//! What a text has that is lost once its drawing is written in its place.

use crate::{Language, Source, Written, words};
use std::collections::BTreeSet;
use unoclp_lang::{Colour, Dialect, Lang};

/// What a text has that is lost once its drawing is written in its place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lost {
    /// Whether it declares types, blocks or arrays, in whose place a drawing has points.
    pub types: bool,
    /// Whose words it has, in place of those of the standard.
    pub dialect: Option<Dialect>,
    /// Lines of its comments.
    pub comments: Vec<String>,
}

/// A comment is told as far as this, characters.
const TOLD: usize = 40;

impl Lost {
    /// What of this program is not in the text that its drawing is written as; none where all of it is.
    pub fn of(source: &Source, drawing: &Written) -> Option<Lost> {
        let language = source.language.written_in();
        let own = Written {
            language: Ok(language),
            bytes: source.text.clone().into_bytes(),
            ..drawing.clone()
        };
        let kept = comments(drawing);
        let is_lost = |line: &String| !kept.iter().any(|kept| kept.contains(line.as_str()));
        let lost = Lost {
            types: !declared(&own).is_subset(&declared(drawing)),
            dialect: match &source.language {
                Language::Il { dialect, .. } if *dialect != Dialect::Iec => Some(*dialect),
                _ => None,
            },
            comments: comments(&own).into_iter().filter(is_lost).collect(),
        };
        (lost != Lost::default()).then_some(lost)
    }

    /// `Changes in the drawing remove this from the text: 2 lines of comments, such as “pump of the well”`
    pub fn text(&self, lang: Lang) -> String {
        let types = self.types.then(|| words::lost_types(lang));
        let dialect = self
            .dialect
            .map(|dialect| words::lost_dialect(lang, dialect));
        let comments = self.comments.first().map(|first| {
            let told: String = first.chars().take(TOLD).collect();
            match self.comments.len() {
                1 => words::lost_comment(lang, told),
                count => words::lost_comments(lang, count, told),
            }
        });
        let parts: Vec<String> = [types, dialect, comments].into_iter().flatten().collect();
        words::lost(lang, parts.join("; "))
    }
}

/// The words of the language in the declarations of a text, and those that declare something beside variables.
fn declared(written: &Written) -> BTreeSet<String> {
    let text = written.text();
    let colours = written.colours();
    let words = colours.iter().filter(|(_, colour)| *colour == Colour::Word);
    let words = words.map(|(span, _)| text.get(span.range()).unwrap_or_default());
    let mut declared = BTreeSet::new();
    let mut is_within = false;
    for word in words.map(str::to_uppercase) {
        match word.as_str() {
            "END_VAR" => is_within = false,
            "AT" => {}
            _ if word.starts_with("VAR") => is_within = true,
            "TYPE" | "STRUCT" | "FUNCTION" | "FUNCTION_BLOCK" => drop(declared.insert(word)),
            _ if is_within => drop(declared.insert(word)),
            _ => {}
        }
    }
    declared
}

/// The lines of the comments of a text that say something.
fn comments(written: &Written) -> Vec<String> {
    let text = written.text();
    let colours = written.colours();
    let comments = colours
        .iter()
        .filter(|(_, colour)| *colour == Colour::Comment);
    let lines = comments.flat_map(|(span, _)| text.get(span.range()).unwrap_or_default().lines());
    let lines = lines.map(|line| {
        let says = |ch: char| !matches!(ch, '(' | '*' | '/' | ')') && !ch.is_whitespace();
        let line = line.trim_start_matches(|ch| !says(ch));
        let line = line.trim_end_matches(|ch: char| ch.is_whitespace() || ch == '*');
        line.strip_suffix("*)").unwrap_or(line).trim().to_owned()
    });
    lines.filter(|line| says_something(line)).collect()
}

/// Lines of nothing but signs say nothing, and what a tool writes about a file is written again.
fn says_something(line: &str) -> bool {
    let is_ours = line.starts_with("unoclp:") || line.contains("[unoclp:");
    line.chars().any(char::is_alphanumeric) && !is_ours
}

#[cfg(test)]
mod tests {
    use super::Lost;
    use crate::drawn::{WriteAs, document, written};
    use crate::{Dialect, Written};
    use unoclp_core::Board;
    use unoclp_draw::edit::Emitted;

    fn lost(name: &str, text: &str, form: WriteAs) -> Option<Lost> {
        let open = |text: &str| Written::new(name.to_owned(), text.into(), Board::UNO);
        let source = open(text).check(None).unwrap();
        let document = document(&source);
        let drawing = open(&written(&Emitted::of(&document), form));
        Lost::of(&source, &drawing)
    }

    #[test]
    fn a_text_of_declared_points_and_comments_of_rungs_loses_nothing() {
        for text in [
            "LD I1\nST Q1\n",
            "(* A pump *)\nVAR\n pump AT Q1 : BOOL; (* of the well *)\nEND_VAR\n\n(* starts *)\nLD I1\nST pump\n",
            "VAR\n a : BOOL;\n n AT D1 : INT;\n t : TON;\nEND_VAR\nLD I1\nST a\nLD n\nGT 5\nST Q1\nLD a\nTON t, 100\nST Q2\n",
            "// A pump\nVAR pump AT Q1 : BOOL; END_VAR\n// starts\nLD I1\nST pump\n",
        ] {
            assert_eq!(lost("a.il", text, WriteAs::Il), None, "{text}");
        }
        let text = "/ A pump\n0\n\n/ starts\n827301\n877901\n";
        assert_eq!(lost("a.txt", text, WriteAs::Numeric), None);
    }

    #[test]
    fn comments_within_a_rung_types_and_the_words_of_a_maker_are_lost() {
        let told = |text| lost("a.il", text, WriteAs::Il).unwrap();
        let comments = told("LD I1 (* start *)\nANDN I2 (* stop *)\nST Q1\n").comments;
        assert_eq!(comments, ["start", "stop"]);
        let typed = told("VAR\n n : ARRAY[1..3] OF INT;\nEND_VAR\nLD n[1]\nGT 5\nST Q1\n");
        assert!(typed.types);
        let maker = told("LD X0\nOUT Y0\nLDI X1\nOUT Y1\n");
        assert_eq!(maker.dialect, Some(Dialect::Mitsubishi));
        let numeric = "0\n827301 / the button\n877901\n";
        let numeric = lost("a.txt", numeric, WriteAs::Numeric).unwrap();
        assert_eq!(numeric.comments, ["the button"]);
    }
}
