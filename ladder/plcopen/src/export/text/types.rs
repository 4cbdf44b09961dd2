//! Types and first values as XML, from how Structured Text spells them.

use super::super::xml::escaped;
use crate::comments::without;
use std::fmt::Write as _;
use unoclp_lang::parts::Parts;
use unoclp_lang::typed::Base;

/// Types stand no deeper within each other.
const DEEPEST: usize = 40;

/// The types that a text declares.
pub(super) fn all(text: &str, parts: &Parts) -> String {
    if parts.types.is_empty() {
        return "    <dataTypes/>\n".to_owned();
    }
    let mut all = String::from("    <dataTypes>\n");
    for (name, of, first) in &parts.types {
        let said = |span: &unoclp_lang::Span| text.get(span.range()).unwrap_or_default();
        let first = first
            .as_ref()
            .map_or(String::new(), |first| initial(said(first)));
        let _ = writeln!(
            all,
            "      <dataType name=\"{}\"><baseType>{}</baseType>{first}</dataType>",
            escaped(&name.text),
            written(said(of))
        );
    }
    all.push_str("    </dataTypes>\n");
    all
}

/// A type.
pub(super) fn written(text: &str) -> String {
    spelled(text, 0)
}

/// The first value of a variable.
pub(super) fn initial(text: &str) -> String {
    format!("<initialValue>{}</initialValue>", value(text, 0))
}

fn spelled(text: &str, deep: usize) -> String {
    let text = bare(text);
    let text = text.trim();
    let upper = text.to_uppercase();
    let derived = |name: &str| format!("<derived name=\"{}\"/>", escaped(name));
    if deep > DEEPEST {
        return derived(text);
    }
    if upper.starts_with("ARRAY")
        && let Some((bounds, of)) = text.split_once('[').and_then(|(_, rest)| within(rest, ']'))
    {
        let of = of.trim_start();
        let of = of.get(2..).unwrap_or_default();
        let mut all = String::from("<array>");
        for bound in parts(bounds, ',') {
            let (low, high) = bound.split_once("..").unwrap_or((bound, bound));
            let _ = write!(
                all,
                "<dimension lower=\"{}\" upper=\"{}\"/>",
                escaped(low.trim()),
                escaped(high.trim())
            );
        }
        let _ = write!(
            all,
            "<baseType>{}</baseType></array>",
            spelled(of, deep + 1)
        );
        return all;
    }
    if upper.starts_with("STRUCT") && upper.ends_with("END_STRUCT") {
        let inner = text.get(6..text.len() - 10).unwrap_or_default();
        let members = parts(inner, ';').into_iter();
        let members = members.flat_map(|member| self::member(member, deep));
        let members: String = members.collect();
        return format!("<struct>{members}</struct>");
    }
    if let Some((values, _)) = text.strip_prefix('(').and_then(|rest| within(rest, ')')) {
        let values = parts(values, ',').into_iter().map(|value| {
            let (name, number) = value.split_once(":=").unwrap_or((value, ""));
            let number = match number.trim() {
                "" => String::new(),
                number => format!(" value=\"{}\"", escaped(number)),
            };
            format!("<value name=\"{}\"{number}/>", escaped(name.trim()))
        });
        let values: String = values.collect();
        return format!("<enum><values>{values}</values></enum>");
    }
    let (name, of) = match text.find(['[', '(']) {
        Some(at) => {
            let close = if text[at..].starts_with('[') {
                ']'
            } else {
                ')'
            };
            let inner = within(&text[at + 1..], close).map(|(inner, _)| inner.trim());
            (text[..at].trim(), inner)
        }
        None => (text, None),
    };
    let upper = name.to_uppercase();
    match (&*upper, of) {
        ("STRING", None) => "<string/>".to_owned(),
        ("WSTRING", None) => "<wstring/>".to_owned(),
        ("STRING", Some(length)) => format!("<string length=\"{}\"/>", escaped(length)),
        ("WSTRING", Some(length)) => format!("<wstring length=\"{}\"/>", escaped(length)),
        (base, Some(range)) => {
            let (low, high) = range.split_once("..").unwrap_or((range, range));
            let kind = match base.starts_with('U') {
                true => "subrangeUnsigned",
                false => "subrangeSigned",
            };
            format!(
                "<{kind}><range lower=\"{}\" upper=\"{}\"/><baseType>{}</baseType></{kind}>",
                escaped(low.trim()),
                escaped(high.trim()),
                spelled(name, deep + 1)
            )
        }
        (base, None) if Base::named(base).is_some() => format!("<{base}/>"),
        _ => derived(name),
    }
}

/// The members of a declaration within a structure.
fn member(text: &str, deep: usize) -> Vec<String> {
    let Some((names, rest)) = text.split_once(':') else {
        return Vec::new();
    };
    let (of, first) = match rest.find(":=") {
        Some(at) => (&rest[..at], Some(&rest[at + 2..])),
        None => (rest, None),
    };
    let of = spelled(of, deep + 1);
    let first = first.map_or(String::new(), initial);
    let names = names
        .split(',')
        .map(str::trim)
        .filter(|name| !name.is_empty());
    let member = |name| {
        let name = escaped(name);
        format!("<variable name=\"{name}\"><type>{of}</type>{first}</variable>")
    };
    names.map(member).collect()
}

fn value(text: &str, deep: usize) -> String {
    let text = bare(text);
    let text = text.trim();
    let simple = || format!("<simpleValue value=\"{}\"/>", escaped(text));
    if deep > DEEPEST {
        return simple();
    }
    if let Some((inner, "")) = text.strip_prefix('[').and_then(|rest| within(rest, ']')) {
        let values = parts(inner, ',').into_iter().map(|one| {
            let one = one.trim();
            let times = one
                .split_once('(')
                .filter(|(times, _)| is_number(times.trim()));
            match times.and_then(|(times, rest)| Some((times.trim(), within(rest, ')')?))) {
                Some((times, (own, ""))) => format!(
                    "<value repetitionValue=\"{times}\">{}</value>",
                    value(own, deep + 1)
                ),
                _ => format!("<value>{}</value>", value(one, deep + 1)),
            }
        });
        let values: String = values.collect();
        return format!("<arrayValue>{values}</arrayValue>");
    }
    if let Some((inner, "")) = text.strip_prefix('(').and_then(|rest| within(rest, ')'))
        && inner.contains(":=")
    {
        let values = parts(inner, ',').into_iter().map(|one| {
            let (name, own) = one.split_once(":=").unwrap_or((one, ""));
            format!(
                "<value member=\"{}\">{}</value>",
                escaped(name.trim()),
                value(own, deep + 1)
            )
        });
        let values: String = values.collect();
        return format!("<structValue>{values}</structValue>");
    }
    simple()
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// What is before the bracket that closes one, and after it.
fn within(text: &str, close: char) -> Option<(&str, &str)> {
    let (mut depth, mut quote) = (0_usize, None);
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(mark), _) if c == mark => quote = None,
            (Some(_), _) => {}
            (None, '\'' | '"') => quote = Some(c),
            (None, '(' | '[') => depth += 1,
            (None, _) if c == close && depth == 0 => {
                return Some((&text[..at], text[at + c.len_utf8()..].trim()));
            }
            (None, ')' | ']') => depth = depth.saturating_sub(1),
            _ => {}
        }
    }
    None
}

/// The parts of a list, at signs that are in no bracket, text or structure.
fn parts(text: &str, sign: char) -> Vec<&str> {
    let (mut depth, mut quote, mut from) = (0_usize, None, 0);
    let mut all = Vec::new();
    let word = |at: usize, word: &str| {
        let before = text[..at].chars().next_back();
        let is_begin = before.is_none_or(|c| !c.is_alphanumeric() && c != '_');
        is_begin
            && text
                .get(at..at + word.len())
                .is_some_and(|own| own.eq_ignore_ascii_case(word))
    };
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(mark), _) if c == mark => quote = None,
            (Some(_), _) => {}
            (None, '\'' | '"') => quote = Some(c),
            (None, '(' | '[') => depth += 1,
            (None, ')' | ']') => depth = depth.saturating_sub(1),
            (None, 'S' | 's') if word(at, "STRUCT") => depth += 1,
            (None, 'E' | 'e') if word(at, "END_STRUCT") => depth = depth.saturating_sub(1),
            (None, _) if c == sign && depth == 0 => {
                all.push(&text[from..at]);
                from = at + c.len_utf8();
            }
            _ => {}
        }
    }
    all.push(&text[from..]);
    all.retain(|part| !part.trim().is_empty());
    all
}

/// A text without comments.
fn bare(text: &str) -> String {
    let said = without(text);
    let lines = said
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    let lines: Vec<&str> = lines.collect();
    lines.join("\n")
}
