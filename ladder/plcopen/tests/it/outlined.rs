//! The tree of a project, and its variables changed in the file.

use crate::alike::projects;
use std::fs;
use unoclp_core::Board;
use unoclp_lang::Lang;
use unoclp_plcopen::{Change, alter, import, outline};

fn of(wanted: &str) -> String {
    let mut projects = projects().into_iter();
    projects.find(|(name, ..)| name == wanted).unwrap().1
}

#[test]
fn a_project_is_a_tree_of_units_with_their_variables() {
    for (name, text, _) in projects() {
        let outline = outline(&text).unwrap();
        assert!(!outline.units.is_empty(), "{name}");
        for unit in &outline.units {
            assert!(
                ["LD", "FBD", "ST", "IL"].contains(&&*unit.language),
                "{name}"
            );
            assert!(text[unit.at.range()].contains(&unit.name), "{name}");
            for row in &unit.variables {
                assert!(text[row.at.range()].contains(&row.name), "{name}");
                assert!(!row.kind.is_empty(), "{name}: {row:?}");
            }
        }
    }
}

#[test]
fn what_is_changed_is_read_so_and_all_else_stays() {
    let count = changed("mixed") + changed("application");
    assert!(count > 100);
}

/// Changes each variable of a project; how many changes that takes.
fn changed(project: &str) -> usize {
    let text = of(project);
    let before = outline(&text).unwrap();
    let mut count = 0;
    for unit in &before.units {
        for row in &unit.variables {
            let changes = [
                Change::Kind("DINT".to_owned()),
                Change::Kind("Motor".to_owned()),
                Change::First(Some("7 < 8".to_owned())),
                Change::First(None),
                Change::Place(Some("%MX0.3".to_owned())),
                Change::Place(None),
                Change::Comment("the \"pump\" & its well".to_owned()),
                Change::Comment(String::new()),
            ];
            for change in changes {
                let changed = alter(&text, Some(&unit.name), &row.name.to_uppercase(), &change);
                let after = outline(&changed.unwrap()).unwrap();
                let mut wanted = row.clone();
                match change {
                    Change::Kind(kind) => wanted.kind = kind,
                    Change::First(first) => wanted.first = first,
                    Change::Place(place) => wanted.place = place,
                    Change::Comment(comment) => wanted.comment = comment,
                }
                let units = before.units.iter().zip(&after.units);
                for (one, other) in units {
                    let rows = one.variables.iter().zip(&other.variables);
                    assert_eq!(one.variables.len(), other.variables.len());
                    for (old, new) in rows {
                        let is_it = one.name == unit.name && old.name == row.name;
                        let old = if is_it { &wanted } else { old };
                        assert_eq!(
                            unoclp_plcopen::Row {
                                at: new.at,
                                ..old.clone()
                            },
                            *new
                        );
                    }
                }
                count += 1;
            }
        }
    }
    count
}

#[test]
fn what_is_not_there_is_not_changed() {
    let text = of("mixed");
    let change = Change::Place(None);
    assert_eq!(alter(&text, Some("nobody"), "q0", &change), None);
    assert_eq!(alter(&text, None, "q0", &change), None);
    assert_eq!(alter("<a", None, "q0", &change), None);
    assert!(outline("<a/>").is_err() && outline("no XML").is_err());
}

/// What a project is told that differs so from one that is right.
fn told(from: &str, to: &str) -> Vec<String> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/alike/diagrams.xml");
    let text = fs::read_to_string(path).unwrap();
    assert!(text.contains(from), "{from}");
    let changed = text.replacen(from, to, 1);
    let made = import(&changed, Board::UNO);
    assert!(made.program.is_none(), "{to}");
    let errors = made.diagnostics.iter();
    for told in errors.clone() {
        assert!(changed.get(told.span.range()).is_some());
        assert!(!told.message(Lang::En).is_empty());
    }
    errors.map(|told| told.code.to_string()).collect()
}

#[test]
fn what_no_project_can_be_is_told_at_its_place() {
    // Names that differ by letter case alone; a block that calls itself; a pin that is not there.
    let own = "<variable name=\"on\"><type><BOOL/></type></variable>";
    let within =
        format!("{own}<variable name=\"me\"><type><derived name=\"Latch\"/></type></variable>");
    let again = r#"<pous><pou name="LATCH" pouType="functionBlock"><body><ST/></body></pou>"#;
    let pin = |name| format!("formalParameter=\"{name}\"");
    for (from, to, code) in [
        ("<pous>", again, "XML-538"),
        (own, &*within, "ST-1"),
        (&*pin("stop"), &*pin("nothing"), "ST-1"),
    ] {
        let told = told(from, to);
        assert!(
            told.iter().any(|told| told.starts_with(code)),
            "{to}: {told:?}"
        );
    }
}
