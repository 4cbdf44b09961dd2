//! The pages' list of all kinds, made from the table.

use crate::kind::{Field, Form, Group, Kind, Limit, Slot};
use crate::parts::KINDS;
use crate::words;
use std::fmt::Write;
use unoclp_words::Lang;

fn said(about: [&'static str; 2], lang: Lang) -> &'static str {
    let [en, pt] = about;
    match lang {
        Lang::En => en,
        Lang::Pt => pt,
    }
}

fn group(group: Group, lang: Lang) -> String {
    match group {
        Group::Panel => words::group_panel(lang),
        Group::Electric => words::group_electric(lang),
        Group::Fluid => words::group_fluid(lang),
        Group::Heat => words::group_heat(lang),
        Group::Motion => words::group_motion(lang),
        Group::Transport => words::group_transport(lang),
        Group::Traffic => words::group_traffic(lang),
    }
}

/// What a field takes, in words.
fn takes(field: &Field, lang: Lang) -> String {
    let choice = |kinds: &[&str]| kinds.join(", ");
    let may = |text: String| format!("{text}; {}", words::left_out(lang));
    match field.form {
        Form::Number(unit, low, high, usual) => {
            let shown = |number: i32| unit.shown(number.into());
            let range = words::from_to(lang, shown(low), shown(high));
            format!("{range}; {}", words::usual(lang, shown(usual)))
        }
        Form::Drive => words::takes_drive(lang),
        Form::MayDrive | Form::Duty => may(words::takes_drive(lang)),
        Form::Sense => may(words::takes_input(lang)),
        Form::Reading => may(words::takes_analogue(lang)),
        Form::Part(kinds) => words::takes_part(lang, choice(kinds)),
        Form::MayPart(kinds) => may(words::takes_part(lang, choice(kinds))),
        Form::Value => words::takes_value(lang),
        Form::Choice(all) => crate::fields::quoted(all),
    }
}

/// The range of a value, in words.
fn range(slot: &Slot, lang: Lang) -> String {
    if slot.is_flag {
        return words::flag(lang);
    }
    let end = |limit: Limit| match limit {
        Limit::Is(number) => number.to_string(),
        Limit::Of(field) | Limit::Thousand(field) => format!("`{field}`"),
    };
    words::from_to(lang, end(slot.low), end(slot.high))
}

/// The list of all kinds in Markdown; pictures stand in the folder `plants/` beside the page.
pub fn guide(lang: Lang) -> String {
    let mut text = String::new();
    let mut last = None;
    for kind in KINDS {
        if last != Some(kind.group) {
            let _ = write!(text, "### {}\n\n", group(kind.group, lang));
            last = Some(kind.group);
        }
        one(&mut text, kind, lang);
    }
    text
}

fn one(text: &mut String, kind: &Kind, lang: Lang) {
    let name = kind.name;
    let about = said(kind.about, lang);
    let _ = write!(
        text,
        "#### {name}\n\n![{name}](plants/{name}.svg)\n\n{about}.\n\n"
    );
    for field in kind.fields {
        let (about, takes) = (said(field.about, lang), takes(field, lang));
        let _ = writeln!(text, "- `{}`: {about} ({takes})", field.name);
    }
    let seen = kind.values.iter().filter(|slot| slot.is_seen);
    for slot in seen {
        let (about, range) = (said(slot.about, lang), range(slot, lang));
        let mut more = String::new();
        if slot.by_hand {
            let _ = write!(more, "; {}", words::by_hand(lang));
        }
        if slot.is_damage {
            let _ = write!(more, "; {}", words::damage(lang));
        }
        let _ = writeln!(
            text,
            "- {} `.{}`: {about} ({range}{more})",
            words::values(lang),
            slot.name
        );
    }
    if !kind.faults.is_empty() {
        let faults: Vec<String> = kind
            .faults
            .iter()
            .map(|fault| format!("`{}`", fault.name()))
            .collect();
        let _ = writeln!(text, "- {} {}", words::faults(lang), faults.join(", "));
    }
    text.push('\n');
}

/// The file of a plant that has a part of this kind, and what that needs.
pub(crate) fn sample(kind: &Kind) -> String {
    let mut text = String::from("title = \"sample\"\n");
    let mut made = Vec::new();
    let mut left = vec![kind.name];
    while let Some(name) = left.pop() {
        if made.contains(&name) {
            continue;
        }
        made.push(name);
        let _ = write!(text, "[[part]]\nname = \"a_{name}\"\nkind = \"{name}\"\n");
        let Some(kind) = crate::parts::named(name) else {
            continue;
        };
        let _ = writeln!(text, "label = \"{name}\"");
        for field in kind.fields {
            match field.form {
                Form::Drive => {
                    let _ = writeln!(text, "{} = \"Q1\"", field.name);
                }
                Form::Part(kinds) => {
                    if let Some(first) = kinds.first() {
                        let _ = writeln!(text, "{} = \"a_{first}\"", field.name);
                        left.push(first);
                    }
                }
                Form::Value => {
                    let _ = writeln!(text, "{} = \"a_tank.level\"", field.name);
                    left.push("tank");
                }
                _ => {}
            }
        }
    }
    text
}
