//! Names of projects in PLCopen XML: found and renamed in all units, whatever each is written or drawn in.

use crate::texts::{alike, chart, projects};
use std::path::Path;
use std::rc::Rc;
use unoclp_assist::{NoRename, declaration, declared, edited, rename, symbols, uses};
use unoclp_core::Board;
use unoclp_program::Written;
use unoclp_testing::{Random, held, rounds};
use unoclp_workspace::{Analysis, Workspace};

fn project(text: &str) -> Written {
    Written::new("plc.xml".into(), text.into(), Board::UNO)
}

/// A project with a global `run`, and a block of its own that programs in LD, FBD, SFC and ST use.
fn units() -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/units.xml");
    std::fs::read_to_string(file).unwrap()
}

fn opened(written: &Written) -> Rc<Analysis> {
    Workspace::default().open(written.clone())
}

/// What the project becomes; each line that changes.
fn renamed(of: Option<&str>, old: &str, new: &str) -> Vec<String> {
    let before = project(&units());
    let analysis = opened(&before);
    assert!(analysis.source().is_some(), "{:?}", analysis.check());
    let at = declared(&before, of, old).expect("it is declared");
    let edits = rename(&analysis, at, new).unwrap_or_else(|why| panic!("{old}: {why:?}"));
    let after = edited(&before.text(), &edits);
    assert!(alike(&before, &project(&after)));
    let own = units();
    let lines = after.lines().zip(own.lines());
    let changed = lines.filter(|(new, old)| new != old);
    changed.map(|(new, _)| new.trim().to_owned()).collect()
}

#[test]
fn a_global_variable_is_renamed_in_every_language() {
    let lines = renamed(None, "run", "works");
    let told = lines.join("\n");
    // Declared, taken from outside by three programs; a contact, a box of FBD, a condition of SFC, a statement.
    for part in [
        "<variable name=\"works\">",
        "<variable>works</variable>",
        "<expression>works</expression>",
        "IF works AND NOT (n",
        "works AND i3",
        "NOT works",
        "go := works",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn a_block_and_its_pins_are_renamed_where_they_are_used() {
    let told = renamed(None, "Motor", "Drive").join("\n");
    for part in [
        "pou name=\"Drive\"",
        "<derived name=\"Drive\"",
        "typeName=\"Drive\"",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let told = renamed(Some("Motor"), "go", "start").join("\n");
    for part in [
        "<variable name=\"start\">",
        "formalParameter=\"start\"",
        "pump(start := run",
    ] {
        assert!(told.contains(part), "{part}: {told}");
    }
    let told = renamed(Some("motor"), "RUNS", "turns").join("\n");
    for part in ["turns := ", "formalParameter=\"turns\"", "pump.turns"] {
        assert!(told.contains(part), "{part}: {told}");
    }
}

#[test]
fn a_type_and_its_values_are_renamed() {
    let told = renamed(None, "Mode", "Way").join("\n");
    assert!(told.contains("<dataType name=\"Way\">"), "{told}");
    assert!(told.contains("<derived name=\"Way\""), "{told}");
    let told = renamed(Some("Mode"), "Fast", "Quick").join("\n");
    assert!(told.contains("<value name=\"Quick\""), "{told}");
    assert!(told.contains("speed = Quick"), "{told}");
}

#[test]
fn a_program_is_renamed_where_a_task_runs_it() {
    let told = renamed(None, "written", "texts").join("\n");
    assert!(told.contains("typeName=\"texts\""), "{told}");
}

#[test]
fn a_name_of_one_unit_stays_in_it() {
    let before = project(&units());
    let at = declared(&before, Some("written"), "n").unwrap();
    let text = before.text();
    let within =
        text.find("<pou name=\"written\"").unwrap()..text.find("<pou name=\"chart\"").unwrap();
    let all = uses(&before, at);
    assert!(all.len() > 2, "{all:?}");
    for own in &all {
        assert!(within.contains(&(own.span.start as usize)), "{own:?}");
        assert_eq!(declaration(&before, own.span.start).unwrap().start, at);
    }
}

#[test]
fn what_another_unit_has_is_refused() {
    let before = project(&units());
    let analysis = opened(&before);
    let at = declared(&before, None, "run").unwrap();
    // The program in LD has a variable of that name: its contact would be that one.
    let refused = rename(&analysis, at, "i0");
    assert!(matches!(refused, Err(NoRename::Another(_))), "{refused:?}");
    assert!(matches!(
        rename(&analysis, at, "Motor"),
        Err(NoRename::Taken(_))
    ));
    assert!(matches!(
        rename(&analysis, at, "a b"),
        Err(NoRename::NoName(_))
    ));
    let coordinate = before.text().find("<position").unwrap() as u32;
    assert_eq!(
        rename(&analysis, coordinate + 12, "x"),
        Err(NoRename::NothingThere)
    );
    assert_eq!(declared(&before, Some("nothing"), "run"), None);
}

#[test]
fn a_project_with_mistakes_is_helped_too() {
    let broken = units().replace("n := n + 1;", "n := := n + 1;");
    let before = project(&broken);
    let analysis = opened(&before);
    assert!(analysis.source().is_none());
    let at = declared(&before, None, "run").unwrap();
    assert!(matches!(
        rename(&analysis, at, "i0"),
        Err(NoRename::Taken(_))
    ));
    let edits = rename(&analysis, at, "works").unwrap();
    assert!(!edited(&broken, &edits).contains(">run<"));
}

/// Every name of every project, one at a time, under another that is new, and under one that chance takes from those that
/// are there: the codes stay, or it is refused.
#[test]
fn projects_keep_their_codes_under_other_names() {
    let [mut new, mut taken] = [0, 0];
    let mut keeps = |(from, text): &(String, String), random: &mut Random| {
        let before = project(text);
        let analysis = opened(&before);
        if analysis.source().is_none() {
            return;
        }
        let all = symbols(&before);
        for (at, symbol) in all.iter().enumerate() {
            let edits = rename(&analysis, symbol.at.start, &format!("xq{at}"));
            let edits =
                edits.unwrap_or_else(|why| panic!("{from} {}: {why:?}\n{text}", symbol.name));
            assert!(
                edits.iter().any(|edit| edit.span == symbol.at),
                "{from} {}",
                symbol.name
            );
            assert!(
                alike(&before, &project(&edited(text, &edits))),
                "{from} {}",
                symbol.name
            );
            new += 1;
            let other = &all[random.below(all.len())].name;
            if let Ok(edits) = rename(&analysis, symbol.at.start, other) {
                assert!(
                    alike(&before, &project(&edited(text, &edits))),
                    "{from} {} {other}",
                    symbol.name
                );
                taken += 1;
            }
        }
    };
    let mut random = Random(36);
    projects()
        .iter()
        .for_each(|project| keeps(project, &mut random));
    (0..rounds(6).into()).for_each(|seed| held(|| keeps(&chart(seed), &mut Random(seed))));
    assert!(new > 300 && taken > 0, "{new} {taken}");
}

/// At every byte of a project all is asked, in whatever state its text is.
#[test]
fn whatever_is_asked_of_a_project_is_answered() {
    let text = units();
    let mut random = Random(1);
    for _ in 0..20 {
        let [one, other] = [0, 1].map(|_| random.below(text.len()));
        let broken = format!("{}{}", &text[..one], &text[other..]);
        let before = project(&broken);
        for at in (0..broken.len() as u32 + 2).step_by(97) {
            for own in uses(&before, at) {
                assert!(broken.get(own.span.range()).is_some());
            }
            declaration(&before, at);
        }
    }
}
