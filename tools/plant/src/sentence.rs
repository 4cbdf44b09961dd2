//! A rule as a sentence, where its file has a condition alone: `tank.level > 950` is "how full “Tank” is".
//!
//! Owns how a condition reads. Must not know what it means: that is the language's.

use crate::names::CLOCK;
use crate::plant::Plant;
use crate::text::Text;
use crate::unit::Unit;
use crate::words;
use unoclp_words::Lang;

/// What must never be, as a sentence; it may be before this time, and for so long, ms.
pub(crate) fn never(when: &str, after: u64, lasts: u64, plant: &Plant) -> Text {
    let say = |lang| {
        let mut said = words::never(lang, condition(when, plant, lang));
        if lasts > 0 {
            said = words::longer_than(lang, said, time(lasts));
        }
        if after > 0 {
            said = words::from_then_on(lang, said, time(after));
        }
        said
    };
    both(say)
}

/// What must come to be within this time, ms, as a sentence.
pub(crate) fn goal(when: &str, each: Option<&str>, within: u64, plant: &Plant) -> Text {
    let say = |lang| {
        let when = condition(when, plant, lang);
        match each {
            Some(each) => {
                words::within_after(lang, time(within), condition(each, plant, lang), when)
            }
            None => words::within(lang, time(within), when),
        }
    };
    both(say)
}

fn both(say: impl Fn(Lang) -> String) -> Text {
    Text {
        en: say(Lang::En),
        pt: say(Lang::Pt),
    }
}

fn time(ms: u64) -> String {
    Unit::Ms.shown(i64::try_from(ms).unwrap_or(i64::MAX))
}

/// A condition in words, sign by sign.
fn condition(text: &str, plant: &Plant, lang: Lang) -> String {
    let mut words: Vec<String> = Vec::new();
    // What a number counts that is compared with the name before it.
    let mut unit = Unit::Count;
    for sign in signs(text) {
        let upper = sign.to_ascii_uppercase();
        let word = match upper.as_str() {
            "AND" | "&" => words::and(lang),
            "OR" => words::or(lang),
            "XOR" => words::either(lang),
            "NOT" => words::not(lang),
            ">" => words::more(lang),
            ">=" => words::at_least(lang),
            "<" => words::less(lang),
            "<=" => words::at_most(lang),
            "=" => words::is(lang),
            "<>" => words::is_not(lang),
            _ => match sign.parse::<i64>() {
                Ok(number) => unit.shown(number),
                Err(_) => {
                    let (said, counts) = named(sign, plant, lang);
                    unit = counts.unwrap_or(unit);
                    said
                }
            },
        };
        match words.last_mut() {
            // What brackets hold stands close to them.
            Some(last) if last.ends_with('(') || word == ")" || word == "," => last.push_str(&word),
            _ => words.push(word),
        }
    }
    words.join(" ")
}

/// What a name stands for, and what it counts.
fn named(name: &str, plant: &Plant, lang: Lang) -> (String, Option<Unit>) {
    if name.eq_ignore_ascii_case(CLOCK) {
        return (words::the_time(lang), Some(Unit::Ms));
    }
    if let Some((part, value)) = plant.value(name)
        && let Some(own) = plant.parts.get(part)
        && let Some(slot) = own.kind.values.get(value)
    {
        let about = match lang {
            Lang::En => slot.about[0].trim_start_matches("whether "),
            Lang::Pt => slot.about[1].trim_start_matches("se "),
        };
        let said = format!("{} ({about})", own.label.text(lang));
        return (said, (!slot.is_flag).then_some(slot.unit));
    }
    (name.to_owned(), None)
}

/// The signs of a condition: names and numbers, and what stands between them; without comments.
fn signs(text: &str) -> Vec<&str> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.';
    let mut signs = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        if let Some(comment) = rest.strip_prefix("(*") {
            rest = comment.split_once("*)").map_or("", |(_, behind)| behind);
            continue;
        }
        let Some(first) = rest.chars().next() else {
            return signs;
        };
        let length = match rest.as_bytes() {
            [byte, ..] if is_word(*byte) => rest.bytes().take_while(|byte| is_word(*byte)).count(),
            [b'<' | b'>', b'=' | b'>', ..] => 2,
            _ => first.len_utf8(),
        };
        let (sign, behind) = rest.split_at_checked(length).unwrap_or((rest, ""));
        signs.push(sign);
        rest = behind;
    }
}
