//! The words of both norms: how a condition and an action are written in IEC 61131-3, and in GRAFCET (IEC 60848).
//!
//! A condition is taken word by word; what GRAFCET has no sign for stays as it was written.

use crate::document::{Document, Does, Transition};
use unoclp_chart::Qualifier;

/// How a chart looks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// As IEC 61131-3 draws it.
    #[default]
    Norm,
    /// As IEC 60848 does.
    Grafcet,
}

impl Look {
    /// What stands beside a transition.
    pub fn condition(self, transition: &Transition) -> String {
        let written = plain(&transition.condition);
        let said = match self {
            Look::Norm => written,
            Look::Grafcet => grafcet(&written),
        };
        let name = transition.name.as_deref().filter(|_| self == Look::Grafcet);
        let mut all = name.map_or(String::new(), |name| format!("({name}) "));
        all.push_str(&said);
        if let Some(priority) = transition.priority {
            all.push_str(&format!("  [{priority}]"));
        }
        all
    }

    /// The two fields of an action: when, and which.
    pub fn action(self, step: &str, does: &Does) -> (String, String) {
        let time = does.time.as_deref().map(plain);
        match self {
            Look::Norm => {
                let qualifier = does.qualifier.name();
                let when = time.map_or(qualifier.to_owned(), |time| format!("{qualifier} {time}"));
                (when, does.action.clone())
            }
            Look::Grafcet => {
                let time = time.map(|time| seconds(&time)).unwrap_or_default();
                let action = &does.action;
                use Qualifier::*;
                match does.qualifier {
                    N => (String::new(), action.clone()),
                    S => ("↑".to_owned(), format!("{action} := 1")),
                    R => ("↑".to_owned(), format!("{action} := 0")),
                    P | P1 => ("↑".to_owned(), action.clone()),
                    P0 => ("↓".to_owned(), action.clone()),
                    D => (format!("{time}/X{step}"), action.clone()),
                    L => (format!("¬({time}/X{step})"), action.clone()),
                    SD | DS | SL => (format!("{} {time}", does.qualifier.name()), action.clone()),
                }
            }
        }
    }

    /// What a step is called in its box: GRAFCET numbers it.
    pub fn step(self, document: &Document, number: usize) -> String {
        let name = document.steps.get(number).map_or("", |step| &step.name);
        match self {
            Look::Norm => name.to_owned(),
            Look::Grafcet => short(name).to_owned(),
        }
    }
}

/// `3` of `S3`.
fn short(name: &str) -> &str {
    let rest = name.strip_prefix(['S', 's', 'X', 'x', 'E', 'e']);
    let rest = rest.filter(|rest| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit()));
    rest.unwrap_or(name)
}

/// A text on one line, without comments.
pub(crate) fn plain(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find(['(', '/']) {
        let (before, from) = rest.split_at(at);
        said.push_str(before);
        let end = match () {
            () if from.starts_with("(*") => from.find("*)").map(|end| end + 2),
            () if from.starts_with("/*") => from.find("*/").map(|end| end + 2),
            () if from.starts_with("//") => Some(from.find('\n').unwrap_or(from.len())),
            () => None,
        };
        match end {
            Some(end) => {
                said.push(' ');
                rest = &from[end..];
            }
            None => {
                said.push_str(&from[..1]);
                rest = &from[1..];
            }
        }
    }
    said.push_str(rest);
    let words: Vec<&str> = said.split_whitespace().collect();
    words.join(" ")
}

/// `5s` of `T#5s`.
fn seconds(time: &str) -> String {
    let upper = time.to_ascii_uppercase();
    let prefix = ["TIME#", "T#"]
        .into_iter()
        .find(|prefix| upper.starts_with(prefix));
    time.get(prefix.map_or(0, str::len)..)
        .unwrap_or(time)
        .to_owned()
}

/// A word of a condition, or a sign.
fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text;
    let is_word = |c: char| c.is_alphanumeric() || "_.#%".contains(c);
    while let Some(first) = rest.chars().next() {
        let end = match () {
            () if is_word(first) => rest.find(|c| !is_word(c)).unwrap_or(rest.len()),
            () if rest.starts_with(":=") || rest.starts_with("<=") => 2,
            () if rest.starts_with(">=") || rest.starts_with("<>") => 2,
            () => first.len_utf8(),
        };
        words.push(&rest[..end]);
        rest = &rest[end..];
    }
    words
}

/// A condition with the signs of GRAFCET: `·`, `+`, `¬`, `X3`, `5s/X3`.
fn grafcet(condition: &str) -> String {
    let words: Vec<&str> = words(condition)
        .into_iter()
        .filter(|word| *word != " ")
        .collect();
    let mut said = String::new();
    let mut at = 0;
    while let Some(word) = words.get(at).copied() {
        at += 1;
        let upper = word.to_ascii_uppercase();
        let is = |sign: &str| words.get(at) == Some(&sign);
        match &*upper {
            "AND" | "&" => said.push('·'),
            "OR" => said.push_str(" + "),
            "NOT" => said.push('¬'),
            "XOR" => said.push_str(" ⊕ "),
            "TRUE" => said.push('1'),
            "FALSE" => said.push('0'),
            "<>" => said.push_str(" ≠ "),
            "<=" => said.push_str(" ≤ "),
            ">=" => said.push_str(" ≥ "),
            "<" | ">" | "=" | "+" | "-" | "*" | "/" => {
                said.push_str(&format!(" {word} "));
            }
            "," => said.push_str(", "),
            _ if upper.ends_with(".X") => {
                said.push('X');
                said.push_str(short(&word[..word.len() - 2]));
            }
            _ if upper.ends_with(".T") && (is(">=") || is(">")) => {
                let step = short(&word[..word.len() - 2]);
                let time = words.get(at + 1).copied().unwrap_or_default();
                said.push_str(&format!("{}/X{step}", seconds(time)));
                at += 2;
            }
            _ => said.push_str(word),
        }
    }
    said.trim().to_owned()
}
