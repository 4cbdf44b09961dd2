//! Every kind of mistake in a plant is refused with its line, the reason and a remedy, in both languages.

use std::collections::BTreeSet;
use std::mem::discriminant;
use unoclp_core::Board;
use unoclp_plant::{MOST_PARTS, Mistake, Plant, Wrong};
use unoclp_words::Lang;

fn read(text: &str) -> Result<Plant, Vec<Mistake>> {
    unoclp_plant::read(text, Board::UNO)
}

/// What is right, in lines 1 to 9.
const RIGHT: &str = "title = \"t\"\n[[part]]\nname = \"b\"\nkind = \"button\"\nto = \"I1\"\n[[part]]\nname = \"k\"\nkind = \"contactor\"\nby = \"Q1\"\n";

/// What is wrong, and in which line of the file.
fn mistakes() -> Vec<(String, usize, &'static str)> {
    let with = |more: &str| format!("{RIGHT}{more}");
    let part = |kind: &str, more: &str| {
        with(&format!(
            "[[part]]\nname = \"x\"\nkind = \"{kind}\"\n{more}"
        ))
    };
    vec![
        ("[[part]\n".into(), 1, "this is not TOML"),
        (with("by = \"Q2\"\n"), 10, "this is not TOML"),
        (
            with("[wheel]\n"),
            10,
            "no key `wheel` here; known keys: `title`",
        ),
        (
            with("colour = 1\n"),
            10,
            "no key `colour` here; known keys: `name`, `kind`",
        ),
        (
            "[[part]]\nname = \"b\"\nkind = \"button\"\n".into(),
            1,
            "`title` is missing",
        ),
        (
            "title = 5\n[[part]]\nname = \"b\"\nkind = \"button\"\n".into(),
            1,
            "`title` takes a different kind",
        ),
        ("title = \"t\"\n".into(), 1, "there are no parts"),
        (
            part("wheel", ""),
            12,
            "`kind` cannot be \"wheel\"; choose \"button\"",
        ),
        (part("lamp", ""), 10, "`by` is missing; write `by = \"Q1\"`"),
        (part("lamp", "by = 1\n"), 13, "`by` takes a different kind"),
        (
            with("[[part]]\nname = \"if\"\nkind = \"button\"\n"),
            11,
            "\"if\" cannot be the name of a part",
        ),
        (
            with("[[part]]\nname = \"Q1\"\nkind = \"button\"\n"),
            11,
            "\"Q1\" cannot be the name of a part",
        ),
        (
            with("[[part]]\nname = \"<script>\"\nkind = \"button\"\n"),
            11,
            "cannot be the name of a part",
        ),
        (
            with("[[part]]\nname = \"B\"\nkind = \"button\"\n"),
            10,
            "two parts are called B",
        ),
        (
            part("button", "to = \"I1\"\n"),
            13,
            "b also sets I1; choose another input",
        ),
        (
            part("button", "to = \"I9\"\n"),
            13,
            "the UNO has no I9; it has I1–I8",
        ),
        (part("button", "to = \"Q1\"\n"), 13, "\"I1 nc\""),
        (
            part("lamp", "by = \"Q5\"\n"),
            13,
            "the UNO has no Q5; it has Q1–Q4",
        ),
        (
            part("lamp", "by = \"P2\"\n"),
            13,
            "the UNO has no P2; it has P1, P4",
        ),
        (part("lamp", "by = \"Z\"\n"), 13, "Z cannot drive a part"),
        (
            part("lamp", "by = \"not k.heat\"\n"),
            13,
            "k has no value heat; it has closed, coil",
        ),
        (
            part("lamp", "by = \"m.closed\"\n"),
            13,
            "there is no part m; known parts: b, k, x",
        ),
        (
            part("valve", "by = \"P1\"\n"),
            10,
            "Q1 is used both with and without PWM",
        ),
        (
            part("dial", "to = \"I2\"\n"),
            13,
            "I2 is not an analogue input",
        ),
        (
            part("dial", "to = \"A7\"\n"),
            13,
            "the UNO has no A7; it has A0–A4",
        ),
        (
            part(
                "dial",
                "to = \"A0\"\n[[part]]\nname = \"y\"\nkind = \"button\"\nto = \"I5\"\n",
            ),
            17,
            "I5 shares its pin with A0",
        ),
        (
            part("float", "of = \"k\"\n"),
            13,
            "k is of kind contactor; name a part of kind tank",
        ),
        (part("float", "of = \"t\"\n"), 13, "there is no part t"),
        (
            part("tank", "holds = \"5 kg\"\n"),
            13,
            "`holds` must be a number with a unit (l, ml), but \"5 kg\" is not one",
        ),
        (
            part("tank", "holds = \"5000 l\"\n"),
            13,
            "`holds` is out of range; use 0.1 l to 2000 l",
        ),
        (
            part("feeder", "onto = \"k\"\nmost = \"many\"\n"),
            13,
            "k is of kind contactor",
        ),
        (
            part("feeder", "onto = \"k\"\nmost = \"many\"\n"),
            14,
            "`most` must be a whole number",
        ),
        (
            part("lamp", "by = \"Q2\"\ncolour = \"pink\"\n"),
            14,
            "`colour` cannot be \"pink\"; choose \"green\"",
        ),
        (
            part(
                "lamp",
                "by = \"y.lit\"\n[[part]]\nname = \"y\"\nkind = \"lamp\"\nby = \"x.lit\"\n",
            ),
            10,
            "in a loop: x → y → x",
        ),
        (part("lamp", "by = \"x.lit\"\n"), 10, "in a loop: x → x"),
        (
            with("[[never]]\nwhen = \"k.closed AND\"\ntext = \"x\"\n"),
            11,
            "not a condition in Structured Text",
        ),
        (
            with("[[never]]\nwhen = \"k.heat > 3\"\n"),
            11,
            "not a condition in Structured Text",
        ),
        (
            with("[[never]]\nwhen = \"k.closed; DELETE\"\n"),
            11,
            "not a condition in Structured Text",
        ),
        (with("[[never]]\ntext = \"x\"\n"), 10, "`when` is missing"),
        (
            with("[[goal]]\nwhen = \"k.closed\"\n"),
            10,
            "`within` is missing",
        ),
        (
            with("[[goal]]\nwhen = \"k.closed\"\nwithin = \"3 weeks\"\n"),
            12,
            "`within` must be a number with a unit",
        ),
        (
            with("[[step]]\nat = \"2 min\"\nset = { b = 1 }\n"),
            11,
            "`at` is after the end, at 60 s",
        ),
        (
            with("[[step]]\nat = \"1 s\"\nset = { k = 1 }\n"),
            12,
            "k cannot be changed by hand; change b.pressed",
        ),
        (
            with("[[step]]\nat = \"1 s\"\nset = { b = 2 }\n"),
            12,
            "`b` is out of range; use 0 to 1",
        ),
        (
            with("[[fault]]\npart = \"k\"\nis = \"leaking\"\nat = \"1 s\"\n"),
            12,
            "a part of kind contactor cannot be \"leaking\"; it can be \"welded\"",
        ),
        (
            with("[[fault]]\npart = \"k\"\nis = \"welded\"\n"),
            10,
            "this fault never occurs",
        ),
        (
            with("[[draw]]\nkind = \"pipe\"\npoints = [[0]]\n"),
            12,
            "`points` takes a different kind",
        ),
        (
            "title = \"t\"\n".to_owned()
                + &(0..10_000)
                    .map(|number| format!("[[part]]\nname = \"b{number}\"\nkind = \"button\"\n"))
                    .collect::<String>(),
            302,
            "there are more than 100 [[part]]",
        ),
    ]
}

#[test]
fn each_mistake_is_told_with_its_line() {
    read(RIGHT).unwrap();
    assert_eq!(MOST_PARTS, 100);
    let mut kinds = BTreeSet::new();
    for (text, line, words) in mistakes() {
        let told = read(&text).expect_err(words);
        let fits = |of: &&Mistake| of.line == line && of.reason(Lang::En).contains(words);
        let found = told.iter().find(fits);
        let all: Vec<String> = told
            .iter()
            .map(|mistake| mistake.text("p.toml", Lang::En))
            .collect();
        let found = found.unwrap_or_else(|| panic!("{line}: {words}: {all:#?}"));
        // What is wrong with any file has kinds of its own.
        let amiss = match &found.wrong {
            Wrong::Keys(amiss) => Some(discriminant(amiss)),
            _ => None,
        };
        kinds.insert(format!("{:?} {amiss:?}", discriminant(&found.wrong)));
        let portuguese = found.text("p.toml", Lang::Pt);
        assert!(
            portuguese.starts_with(&format!("p.toml:{line}: ")),
            "{portuguese}"
        );
        assert_ne!(found.reason(Lang::Pt), found.reason(Lang::En));
    }
    // Each kind of mistake that there is.
    assert_eq!(kinds.len(), 28, "{kinds:?}");
}

/// Cut anywhere, or with a byte changed, a file is read or refused, and nothing else.
#[test]
fn a_damaged_file_is_refused_in_words() {
    let folder = crate::folder("programs/plants");
    for name in ["two-tanks.toml", "sorting.toml"] {
        let text = std::fs::read_to_string(folder.join(name)).unwrap();
        let ends = text.char_indices().map(|(at, _)| at).step_by(37);
        for end in ends {
            if let Err(mistakes) = read(&text[..end]) {
                assert!(!mistakes.is_empty());
            }
            let (before, after) = text.split_at(end);
            let mut rest = after.chars();
            rest.next();
            if let Err(mistakes) = read(&format!("{before}9{}", rest.as_str())) {
                assert!(
                    mistakes
                        .iter()
                        .all(|mistake| !mistake.reason(Lang::Pt).is_empty())
                );
            }
        }
    }
}

/// A rule without words of its own is a sentence about its parts, with their units.
#[test]
fn a_rule_without_words_is_a_sentence() {
    let text = r#"
title = "t"
[[part]]
name = "t1"
kind = "tank"
label = { en = "Tank", pt = "Tanque" }
holds = "50 l"
[[part]]
name = "start"
kind = "button"
label = { en = "Start", pt = "Liga" }
to = "I1"
[[never]]
when = "t1.level >= 950 AND NOT (start.pressed OR clock < 2500) (* full *)"
for = "400 ms"
after = "2 s"
[[goal]]
each = "start.pressed"
when = "t1.level > 500"
within = "1 min"
"#;
    let plant = read(text).unwrap();
    let [never, goal] = [&plant.nevers[0].text, &plant.goals[0].text];
    assert_eq!(
        never.en,
        "Never: Tank (how full it is) is at least 95% and not (Start (it is pressed) or the time is less than 2.5 s), \
         for longer than 0.4 s, from 2 s on"
    );
    assert!(
        never
            .pt
            .starts_with("Nunca: Tanque (quanto está cheio) é no mínimo 95%"),
        "{}",
        never.pt
    );
    assert!(
        goal.en
            .ends_with("within 60 s: Tank (how full it is) is more than 50%"),
        "{}",
        goal.en
    );
    assert!(goal.pt.starts_with("A cada vez (“Liga ("), "{}", goal.pt);
}

/// A text that is no TOML at all is told once: it is one mistake.
#[test]
fn what_is_no_toml_is_told_once() {
    let page = std::fs::read_to_string(crate::folder("README.md")).unwrap();
    for text in [
        page.as_str(),
        "<html>\n<body>\n<p>\n",
        &"x\n".repeat(10_000),
    ] {
        let told = read(text).unwrap_err();
        assert_eq!(told.len(), 1, "{told:?}");
    }
}
