//! Languages whose parts begin and end with words or braces: Structured Text, SCL, InterSCL, LCE.

use super::gaps::{begins_operand, is_operator, joined};
use super::line::Line;
use crate::reader::Word;
use unoclp_lang::Colour;

/// How a language groups its statements.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Blocks {
    /// IF … END_IF
    Words,
    /// se (…) { … }, after the name of a network
    Braces,
}

/// What is open where a line begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    /// What indents all that is in it.
    Part,
    /// Declarations, whose columns stay.
    Section,
    /// CASE, whose values stand before the statements.
    Case,
    /// The statements of a value of it.
    Arm,
    /// A network of LCE, which the next one ends.
    Network,
}

/// The lines of a text, placed.
pub(super) fn formed(lines: &[Line<'_, '_>], blocks: Blocks, step: usize) -> Vec<String> {
    let mut walk = Walk {
        blocks,
        open: Vec::new(),
        parentheses: 0,
        is_continued: false,
        shift: 0,
    };
    lines.iter().map(|line| walk.line(line, step)).collect()
}

struct Walk {
    blocks: Blocks,
    open: Vec<Open>,
    parentheses: usize,
    /// Whether the statement of the line before goes on.
    is_continued: bool,
    /// By how much its first line has moved to the right.
    shift: isize,
}

impl Walk {
    fn line(&mut self, line: &Line<'_, '_>, step: usize) -> String {
        if line.is_within {
            self.take(line);
            return line.text.to_owned();
        }
        let own = line.text.trim();
        if own.is_empty() {
            return String::new();
        }
        let blanks = (line.text.len() - line.text.trim_start().len()) as isize;
        let first = line.words.first();
        let is_continued = self.is_continued && first.is_some_and(|first| !is_border(*first));
        let in_section = self.open.last() == Some(&Open::Section);
        let indent = match is_continued {
            true => (blanks + self.shift).max((step * (self.depth() + 1)) as isize) as usize,
            false => {
                let depth = self.begins(line);
                self.shift = (step * depth) as isize - blanks;
                step * depth
            }
        };
        self.take(line);
        let text = joined(line, |words, next, gap| {
            between(words, next, gap, in_section)
        });
        format!("{:indent$}{text}", "")
    }

    fn depth(&self) -> usize {
        self.open.len()
    }

    /// How deep a line stands by its first word: what ends a part stands where the part began.
    fn begins(&self, line: &Line<'_, '_>) -> usize {
        let depth = self.depth();
        let Some(first) = line.words.first() else {
            // A comment before the next value of a CASE, or before what ends a part, stands with what is above.
            return depth;
        };
        let upper = first.text.to_ascii_uppercase();
        let arm = usize::from(self.open.last() == Some(&Open::Arm));
        let back = match self.blocks {
            Blocks::Braces if first.text == "}" => 1,
            Blocks::Braces if is_network(*first) => {
                usize::from(self.open.last() == Some(&Open::Network))
            }
            Blocks::Braces => 0,
            Blocks::Words if first.colour != Some(Colour::Word) => match arm {
                1 if is_value(line.words) => 1,
                _ => 0,
            },
            Blocks::Words if matches!(upper.as_str(), "END_CASE" | "ELSE") => 1 + arm,
            Blocks::Words if upper.starts_with("END_") && closes(&upper) => 1,
            Blocks::Words if matches!(upper.as_str(), "ELSIF" | "UNTIL") => 1,
            Blocks::Words => 0,
        };
        depth.saturating_sub(back)
    }

    /// What a line opens and closes.
    fn take(&mut self, line: &Line<'_, '_>) {
        for word in line.words {
            match word.text {
                "(" | "[" => self.parentheses += 1,
                ")" | "]" => self.parentheses = self.parentheses.saturating_sub(1),
                "{" if self.blocks == Blocks::Braces => self.open.push(Open::Part),
                "}" if self.blocks == Blocks::Braces => {
                    self.open.pop();
                }
                // After a value of a CASE its statements begin.
                ":" if self.parentheses == 0 && self.open.last() == Some(&Open::Case) => {
                    self.open.push(Open::Arm);
                }
                _ if word.colour == Some(Colour::Word) => self.word(*word),
                _ => {}
            }
        }
        if let [first, ..] = line.words
            && let Some(last) = line.words.last()
        {
            let is_whole = is_border(*first) || ends(*last, self.blocks);
            self.is_continued = self.parentheses > 0 || !is_whole;
        }
    }

    fn word(&mut self, word: Word<'_>) {
        if self.blocks == Blocks::Braces {
            if is_network(word) {
                if self.open.last() == Some(&Open::Network) {
                    self.open.pop();
                }
                let upper = word.text.to_lowercase();
                if matches!(upper.as_str(), "var" | "rede" | "network") {
                    self.open.push(Open::Network);
                }
            }
            return;
        }
        let upper = word.text.to_ascii_uppercase();
        match upper.as_str() {
            "IF" | "FOR" | "WHILE" | "REPEAT" | "REGION" | "BLOCO" | "BLOCK" => {
                self.open.push(Open::Part);
            }
            "CASE" => self.open.push(Open::Case),
            "TYPE" | "STRUCT" => self.open.push(Open::Section),
            "VAR_IN_OUT" | "VAR" => self.open.push(Open::Section),
            _ if upper.starts_with("VAR_") => self.open.push(Open::Section),
            "END_CASE" => {
                if self.open.last() == Some(&Open::Arm) {
                    self.open.pop();
                }
                self.open.pop();
            }
            // Of a CASE it ends the values.
            "ELSE" if matches!(self.open.last(), Some(Open::Arm | Open::Case)) => {
                if self.open.last() == Some(&Open::Arm) {
                    self.open.pop();
                }
                self.open.pop();
                self.open.push(Open::Part);
            }
            _ if upper.starts_with("END_") && closes(&upper) => {
                self.open.pop();
            }
            _ => {}
        }
    }
}

/// Whether these words of a line begin with a value of a CASE: a colon comes before any semicolon.
fn is_value(words: &[Word<'_>]) -> bool {
    let mut ends = words.iter().map(|word| word.text);
    ends.find(|text| matches!(*text, ":" | ";" | ":=" | "(")) == Some(":")
}

/// Whether this ends what indents: no unit does, nor a part of a chart.
fn closes(upper: &str) -> bool {
    matches!(
        upper,
        "END_IF"
            | "END_FOR"
            | "END_WHILE"
            | "END_REPEAT"
            | "END_REGION"
            | "END_BLOCK"
            | "END_VAR"
            | "END_STRUCT"
            | "END_TYPE"
    )
}

/// Whether it begins a network of LCE, its names, or ends them.
fn is_network(word: Word<'_>) -> bool {
    let lower = word.text.to_lowercase();
    word.colour == Some(Colour::Word)
        && matches!(lower.as_str(), "var" | "rede" | "network" | "fim" | "end")
}

/// Whether a line that begins with this word goes on nowhere: it begins or ends a unit or a section.
fn is_border(word: Word<'_>) -> bool {
    let upper = word.text.to_ascii_uppercase();
    let unit = [
        "PROGRAM",
        "FUNCTION",
        "FUNCTION_BLOCK",
        "TYPE",
        "CONFIGURATION",
        "RESOURCE",
        "VAR",
    ];
    let begins = ["VAR_", "END_"]
        .iter()
        .any(|begins| upper.starts_with(begins));
    word.colour == Some(Colour::Word) && (begins || unit.contains(&upper.as_str()))
}

/// Whether a line that ends with this word is a whole one.
fn ends(last: Word<'_>, blocks: Blocks) -> bool {
    if matches!(last.text, ";" | ":" | "{" | "}") || blocks == Blocks::Braces {
        return true;
    }
    let upper = last.text.to_ascii_uppercase();
    let is_word = last.colour == Some(Colour::Word);
    let opens = matches!(
        upper.as_str(),
        "THEN"
            | "DO"
            | "OF"
            | "ELSE"
            | "REPEAT"
            | "TYPE"
            | "STRUCT"
            | "BEGIN"
            | "VAR"
            | "RETAIN"
            | "CONSTANT"
            | "NON_RETAIN"
            | "BLOCO"
            | "BLOCK"
    );
    // What is no statement has a line of its own.
    is_word && (opens || upper.starts_with("END_") || upper.starts_with("VAR_"))
        || !is_word && last.is_name()
}

/// Blanks between the last of these words and the next.
fn between(words: &[Word<'_>], next: Word<'_>, gap: &str, in_section: bool) -> usize {
    let [before @ .., word] = words else { return 0 };
    // Columns that somebody has laid stay.
    let is_column = in_section || matches!(next.text, ":=" | "=>");
    let columns = if is_column { gap.len().max(1) } else { 1 };
    // A sign that has one operand.
    let is_sign = |word: &Word<'_>| matches!(word.text, "-" | "+" | "!");
    let of_one = is_sign(word) && before.last().is_none_or(|before| begins_operand(*before));
    match (word.text, next.text) {
        (_, ";" | ",") | (_, ")" | "]") | ("(" | "[", _) => 0,
        (".", _) | (_, ".") | ("..", _) | (_, "..") => 0,
        // A place that is left open: `%M*`.
        (place, "*") if place.starts_with('%') && gap.is_empty() => 0,
        (_, "[") if word.is_name() || matches!(word.text, "]" | ")") => 0,
        (_, ":") if gap.is_empty() => 0,
        _ if of_one => gap.len().min(1),
        (_, "(") if word.is_name() || word.text == ")" => 0,
        // NOT(…) and ABS(…) as they are written.
        (_, "(") if word.colour == Some(Colour::Word) => gap.len().min(1),
        ("," | ";" | ":", _) => columns,
        (_, text) | (text, _) if is_operator(text) => columns,
        _ if gap.is_empty() => 0,
        _ => columns,
    }
}
