//! Names: what may stand at a place, what one stands for, where it is used, and another in its place.
//!
//! A `|` in a text is where one stands.

use crate::texts::{alike, all, text, written};
use std::rc::Rc;
use unoclp_assist::{Edit, NoRename, complete, declaration, edited, hover, prepare, symbols, uses};
use unoclp_lang::Lang;
use unoclp_program::Written;
use unoclp_workspace::{All, Workspace};

/// A text without its mark, and where that was.
fn marked(end: &str, with_mark: &str) -> (Written, u32) {
    let at = with_mark.find('|').expect("a mark");
    let whole = format!("{}{}", &with_mark[..at], &with_mark[at + 1..]);
    (text(end, &whole), at as u32)
}

/// What gives a name at a byte another.
fn rename(written: &Written, byte: u32, name: &str) -> Result<Vec<Edit>, NoRename> {
    unoclp_assist::rename(&Workspace::default().open(written.clone()), byte, name)
}

fn offers(end: &str, with_mark: &str) -> Vec<String> {
    let (written, at) = marked(end, with_mark);
    let (_, offers) = complete(&written, at, Lang::En);
    offers.into_iter().map(|offer| offer.label).collect()
}

fn told(end: &str, with_mark: &str) -> String {
    let (written, at) = marked(end, with_mark);
    let workspace = Workspace::new(Rc::new(All::default()));
    let told = hover(&workspace.look(written), at, Lang::En).expect("something");
    format!("{}\n{}", told.head, told.lines.join("\n"))
}

const PROGRAM: &str = "\
TYPE
  Mode : (Off, Slow, Fast);
  Pair : STRUCT left : INT; right : INT; END_STRUCT;
END_TYPE
FUNCTION_BLOCK Motor
VAR_INPUT go : BOOL; speed : INT; END_VAR
VAR_OUTPUT runs : BOOL; END_VAR
VAR inner : TON; END_VAR
runs := go AND speed > 0;
END_FUNCTION_BLOCK
PROGRAM main
VAR
  start AT %IX1 : BOOL;
  lamp AT %QX1 : BOOL;
  pump : Motor;
  pause : TON;
  mode : Mode;
  pair : Pair;
  speed : INT;
END_VAR
pump(go := start, speed := speed);
lamp := pump.runs AND mode = Fast;
pause(IN := lamp, PT := T#2s);
IF pause.Q THEN speed := pair.left + 1; END_IF;
END_PROGRAM
";

fn at(mark_before: &str) -> String {
    assert_eq!(PROGRAM.matches(mark_before).count(), 1, "{mark_before}");
    let place = PROGRAM.find(mark_before).unwrap();
    // The mark stands after the first letter.
    format!("{}|{}", &PROGRAM[..place + 1], &PROGRAM[place + 1..])
}

#[test]
fn members_follow_a_point() {
    let with = |line: &str| PROGRAM.replace("END_PROGRAM", &format!("{line}\nEND_PROGRAM"));
    assert_eq!(offers("st", &with("pause.|")), ["IN", "PT", "Q", "ET"]);
    assert_eq!(offers("st", &with("pump.|")), ["go", "speed", "runs"]);
    assert_eq!(offers("st", &with("pair.l|")), ["left"]);
    assert_eq!(
        offers("il", "VAR t : TON; END_VAR\nLD t.|"),
        ["IN", "PT", "Q", "ET"]
    );
    assert!(offers("st", &with("nothing.|")).is_empty());
}

#[test]
fn calls_offer_their_inputs_first() {
    let with = |line: &str| PROGRAM.replace("END_PROGRAM", &format!("{line}\nEND_PROGRAM"));
    assert_eq!(offers("st", &with("pause(|"))[..2], ["IN", "PT"]);
    assert_eq!(
        offers("st", &with("pump(go := start, |"))[..2],
        ["go", "speed"]
    );
    assert_eq!(
        offers("st", &with("speed := LIMIT(|"))[..3],
        ["MN", "IN", "MX"]
    );
}

#[test]
fn types_follow_a_colon() {
    let offered = offers("st", "PROGRAM p\nVAR\n  x : T|\nEND_VAR\nEND_PROGRAM");
    assert!(
        offered.contains(&"TON".to_owned()) && offered.contains(&"TIME".to_owned()),
        "{offered:?}"
    );
    assert!(!offered.contains(&"THEN".to_owned()), "{offered:?}");
}

#[test]
fn names_are_those_of_the_unit() {
    let inside = PROGRAM.replace("runs := go", "| runs := go");
    let offered = offers("st", &inside);
    assert!(offered.contains(&"inner".to_owned()), "{offered:?}");
    assert!(!offered.contains(&"pause".to_owned()), "{offered:?}");
    assert!(offers("st", &PROGRAM.replace("IF pause", "p| IF pause")).contains(&"pump".to_owned()));
    assert!(
        offers("il", "VAR motor AT %QX1 : BOOL; END_VAR\nLD mo|").contains(&"motor".to_owned())
    );
    assert!(offers("iscl", "BLOCO\n INT motor;\n mo|\nEND_BLOCK").contains(&"motor".to_owned()));
    assert!(
        offers(
            "lce",
            "clp x\nvar\n Q0.0 = motor;\nrede a\n aciona mo|\nfim"
        )
        .contains(&"motor".to_owned())
    );
}

#[test]
fn nothing_is_offered_in_a_comment_or_a_number() {
    assert!(offers("st", "PROGRAM p (* st|").is_empty());
    assert!(offers("st", "PROGRAM p // st|\nEND_PROGRAM").is_empty());
    assert!(offers("st", "PROGRAM p x := 12|; END_PROGRAM").is_empty());
}

#[test]
fn a_word_is_told_what_it_stands_for() {
    assert!(
        told("st", &at("start AT"))
            .starts_with("start AT %IX1 : BOOL\nis at I1\nuses: 1, never written")
    );
    assert!(told("st", &at("mode : Mode")).contains("mode : Mode"));
    assert!(told("st", &at("runs AND mode")).contains("runs : BOOL\nVAR_OUTPUT"));
    assert!(told("st", &at("Q THEN")).contains("Q : BOOL\nan output of TON"));
    assert!(
        told("st", &at("Motor;"))
            .contains("Motor(go : BOOL; speed : INT; runs => : BOOL)\nfunction block")
    );
    assert!(told("st", &at("Fast;\n")).contains("value of an enumeration"));
    let operator = told(
        "il",
        "VAR a AT %IX1 : BOOL; b AT %QX1 : BOOL; END_VAR\nL|D a\nST b\n",
    );
    assert!(
        operator.contains("input 01") && operator.contains("bytes"),
        "{operator}"
    );
}

#[test]
fn a_name_leads_to_its_declaration() {
    let (written, place) = marked("st", &at("left + 1"));
    let name = declaration(&written, place).unwrap();
    assert_eq!(&PROGRAM[name.range()], "left");
    assert!(PROGRAM[name.range().start..].starts_with("left : INT"));
    // A parameter of a call is the block's, not the variable of the same name.
    let (written, place) = marked("st", &at("speed := speed"));
    let name = declaration(&written, place).unwrap();
    assert!(PROGRAM[name.range().start..].starts_with("speed : INT; END_VAR"));
}

#[test]
fn uses_are_those_of_the_same_name_alone() {
    let (written, place) = marked("st", &at("speed := pair"));
    let all = uses(&written, place);
    assert_eq!(all.len(), 3, "{all:?}");
    assert_eq!(all.iter().filter(|own| own.declares).count(), 1);
    assert_eq!(all.iter().filter(|own| own.writes).count(), 1);
}

#[test]
fn a_name_gives_way_to_another() {
    let (written, place) = marked("st", &at("speed : INT; END"));
    let edits = rename(&written, place, "rate").unwrap();
    let after = edited(&written.text(), &edits);
    assert!(
        after.contains("pump(go := start, rate := speed);"),
        "{after}"
    );
    assert!(after.contains("runs := go AND rate > 0;"), "{after}");
    assert!(after.contains("  speed : INT;\nEND_VAR\npump"), "{after}");
}

#[test]
fn a_type_is_renamed_in_its_literals_too() {
    let text = "TYPE Mode : (Off, On); END_TYPE\nPROGRAM p\nVAR m : Mode; END_VAR\nm := Mo|de#On;\nEND_PROGRAM\n";
    let (written, place) = marked("st", text);
    assert!(uses(&written, place).iter().any(|own| own.declares));
    let after = |at: u32, name: &str| edited(&written.text(), &rename(&written, at, name).unwrap());
    let renamed = written.text().replace("Mode", "Way");
    assert_eq!(after(place, "Way"), renamed);
    assert_eq!(after(6, "Way"), renamed);
    // The value after the sign is another name.
    let value = written.text().replace("On", "Run");
    assert_eq!(after(place + 4, "Run"), value);
}

#[test]
fn what_cannot_be_a_name_is_refused() {
    let (written, place) = marked("st", &at("speed := pair"));
    let refused = |name: &str| rename(&written, place, name).unwrap_err();
    assert!(matches!(refused("IF"), NoRename::NoName(_)));
    assert!(matches!(refused("TON"), NoRename::NoName(_)));
    assert!(matches!(refused("2a"), NoRename::NoName(_)));
    assert!(matches!(refused("lamp"), NoRename::Taken(_)));
    // It would hide the block.
    assert!(matches!(refused("Motor"), NoRename::Taken(_)));
    let (written, place) = marked("st", &at("Q THEN"));
    assert_eq!(rename(&written, place, "done"), Err(NoRename::NothingThere));
    assert_eq!(prepare(&written, place), None);
}

#[test]
fn a_text_with_mistakes_is_helped_too() {
    let broken = "PROGRAM p\nVAR a : INT; END_VAR\na := := a +|";
    let (written, place) = marked("st", broken);
    assert_eq!(uses(&written, 14).len(), 3);
    let after = rename(&written, 14, "b").map(|edits| edited(&written.text(), &edits));
    assert_eq!(
        after.unwrap(),
        "PROGRAM p\nVAR b : INT; END_VAR\nb := := b +"
    );
    assert!(
        complete(&written, place, Lang::En)
            .1
            .iter()
            .any(|offer| offer.label == "a")
    );
}

/// Every name of every program, one at a time, under another: the codes stay.
#[test]
fn programs_keep_their_codes_under_other_names() {
    let mut renamed = 0;
    for path in all() {
        let before = written(&path);
        if before.clone().check(None).is_err() {
            continue;
        }
        let own = before.text();
        for (at, symbol) in symbols(&before).iter().enumerate() {
            let name = format!("xq{at}");
            let edits = rename(&before, symbol.at.start, &name);
            let edits = edits.unwrap_or_else(|why| panic!("{path:?} {}: {why:?}", symbol.name));
            assert!(
                edits.iter().any(|edit| edit.span == symbol.at),
                "{path:?} {}",
                symbol.name
            );
            let mut after = before.clone();
            after.bytes = edited(&own, &edits).into_bytes();
            assert!(alike(&before, &after), "{path:?} {}", symbol.name);
            renamed += 1;
        }
    }
    assert!(renamed > 1000, "{renamed}");
}

/// At every byte of every program all is asked: nothing panics, and a name found is where it is said to be.
#[test]
fn whatever_is_asked_is_answered() {
    let workspace = Workspace::new(Rc::new(All::default()));
    for path in all().into_iter().step_by(7) {
        let written = written(&path);
        let own = written.text();
        let analysis = workspace.look(written.clone());
        for at in (0..=own.len()).step_by(3) {
            let at = at as u32;
            if let Some(told) = hover(&analysis, at, Lang::Pt) {
                assert!(told.span.start <= at && at <= told.span.end);
            }
            let found = uses(&written, at);
            if let Some(first) = found.first() {
                let name = &own[first.span.range()];
                let same = |own_use: &unoclp_assist::Use| {
                    own[own_use.span.range()].eq_ignore_ascii_case(name)
                };
                assert!(
                    found.iter().all(same) || name.starts_with('%') || name.len() < 5,
                    "{path:?} {name}"
                );
            }
            let (_, offers) = complete(&written, at, Lang::Pt);
            assert!(offers.iter().all(|offer| !offer.label.is_empty()));
        }
    }
}
