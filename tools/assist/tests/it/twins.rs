//! A variable and a unit of one name, in texts and in projects: the one that is meant is found and renamed.

use crate::texts::{alike, all, chart, projects, written};
use std::path::Path;
use unoclp_assist::{Edit, NoRename, Symbol, edited, rename, symbols, uses};
use unoclp_core::Board;
use unoclp_lang::Span;
use unoclp_lang::outline::What;
use unoclp_program::Written;
use unoclp_testing::{Random, rounds};
use unoclp_workspace::Workspace;

fn is_unit(symbol: &Symbol) -> bool {
    symbol.what.is_unit() || symbol.what == What::Type
}

fn places(written: &Written, symbol: &Symbol) -> Vec<Span> {
    let uses = uses(written, symbol.at.start).into_iter();
    uses.map(|own| own.span).collect()
}

fn changed(places: &[Span], name: &str) -> Vec<Edit> {
    let text = name.to_owned();
    let edit = |span: &Span| Edit {
        span: *span,
        text: text.clone(),
    };
    places.iter().map(edit).collect()
}

/// Where a name stands after these changes, which may be of it.
fn moved(place: Span, edits: &[Edit]) -> Span {
    let by = |edit: &Edit| (edit.text.len() as u32).wrapping_sub(edit.span.range().len() as u32);
    let before = edits.iter().filter(|edit| edit.span.end <= place.start);
    let start = before.fold(place.start, |start, edit| start.wrapping_add(by(edit)));
    let own = edits.iter().find(|edit| edit.span == place);
    let length = own.map_or(place.range().len(), |edit| edit.text.len());
    Span {
        start,
        end: start + length as u32,
    }
}

/// Gives a variable the name of a unit, by its places. Where that is the same program still, each of both is found where it
/// stood, and renamed there. Whether it was.
fn held(before: &Written, unit: &Symbol, variable: &Symbol) -> bool {
    let [own, other] = [unit, variable].map(|symbol| places(before, symbol));
    let edits = changed(&other, &unit.name);
    let mut twins = before.clone();
    twins.bytes = edited(&before.text(), &edits).into_bytes();
    if !alike(before, &twins) {
        return false;
    }
    let analysis = Workspace::default().open(twins.clone());
    for (symbol, places) in [(unit, own), (variable, other)] {
        let told = format!("{:?} {}\n{}", symbol.what, symbol.name, twins.text());
        let places: Vec<Span> = places.iter().map(|own| moved(*own, &edits)).collect();
        let at = moved(symbol.at, &edits).start;
        let found: Vec<Span> = uses(&twins, at).iter().map(|own| own.span).collect();
        assert_eq!(found, places, "{told}");
        for place in places.first().into_iter().chain(places.last()) {
            let edits = rename(&analysis, place.start, "xq").expect(&told);
            let mut after = twins.clone();
            after.bytes = edited(&twins.text(), &edits).into_bytes();
            assert!(alike(&twins, &after), "{told}");
        }
    }
    true
}

/// Of each program and project variables that chance takes, each under the name of a unit that it takes.
#[test]
fn one_name_for_two_means_the_one_under_the_cursor() {
    let mut kinds = [0; 4];
    let mut tried = 0;
    let mut share = |before: &Written, pairs: u32, random: &mut Random| {
        let named = symbols(before);
        let (units, rest): (Vec<&Symbol>, Vec<&Symbol>) =
            named.iter().partition(|one| is_unit(one));
        let variables = rest.into_iter().filter(|one| one.what == What::Variable);
        let variables: Vec<&Symbol> = variables.collect();
        let is_whole = before.clone().check(None).is_ok();
        if units.is_empty() || variables.is_empty() || !is_whole {
            return;
        }
        for _ in 0..pairs {
            let unit = units[random.below(units.len())];
            let variable = variables[random.below(variables.len())];
            tried += 1;
            if held(before, unit, variable) {
                let kind = match unit.what {
                    What::Program => 0,
                    What::Block => 1,
                    What::Function => 2,
                    _ => 3,
                };
                kinds[kind] += 1;
            }
        }
    };
    let mut random = Random(36);
    for path in all().into_iter().step_by(4) {
        share(&written(&path), 1, &mut random);
    }
    let drawn =
        |(_, text): (String, String)| Written::new("plc.xml".into(), text.into(), Board::UNO);
    for project in projects() {
        share(&drawn(project), rounds(12), &mut random);
    }
    for seed in 0..rounds(6).into() {
        unoclp_testing::held(|| share(&drawn(chart(seed)), rounds(12), &mut Random(seed)));
    }
    assert!(kinds.iter().all(|kind| *kind > 0), "{kinds:?} of {tried}");
}

#[test]
fn a_type_and_what_is_of_it_may_share_a_name() {
    let text = "FUNCTION_BLOCK motor\nVAR_OUTPUT q : BOOL; END_VAR\nq := TRUE;\nEND_FUNCTION_BLOCK\n\
        PROGRAM motor\nVAR motor : motor; lamp : BOOL; END_VAR\nmotor();\nlamp := motor.q;\nEND_PROGRAM\n";
    let written = crate::texts::text("st", text);
    let analysis = Workspace::default().open(written.clone());
    let after = |mark: &str| {
        let at = text.find(mark).unwrap() as u32;
        edited(text, &rename(&analysis, at, "new").unwrap())
    };
    let said = |name: &str, with: &str| text.replace(name, with);
    assert_eq!(
        after("motor\nVAR motor"),
        said("PROGRAM motor", "PROGRAM new")
    );
    let block = said("BLOCK motor", "BLOCK new").replace(": motor", ": new");
    assert_eq!(after("motor; lamp"), block);
    let variable = said("motor :", "new :").replace("motor()", "new()");
    assert_eq!(after("motor()"), variable.replace("motor.q", "new.q"));
}

#[test]
fn twins_of_a_text_that_does_not_parse_are_told_apart() {
    let text =
        "PROGRAM motor\nVAR motor : BOOL; lamp : BOOL; END_VAR\nlamp := := motor;\nEND_PROGRAM\n";
    let written = crate::texts::text("st", text);
    let analysis = Workspace::default().open(written);
    assert!(analysis.source().is_none());
    let after = |at: usize| edited(text, &rename(&analysis, at as u32, "new").unwrap());
    let variable = text
        .replace("motor :", "new :")
        .replace(":= motor", ":= new");
    assert_eq!(after(text.find("motor;").unwrap()), variable);
    assert_eq!(
        after(text.find("motor\n").unwrap()),
        text.replace("PROGRAM motor", "PROGRAM new")
    );
    for name in ["IF", "TON", "2a", ""] {
        assert!(matches!(
            rename(&analysis, 8, name),
            Err(NoRename::NoName(_))
        ));
    }
    assert!(matches!(
        rename(&analysis, 8, "lamp"),
        Err(NoRename::Taken(_))
    ));
}

/// In a project of all languages, every variable under the name of every unit.
#[test]
fn every_unit_of_a_project_may_share_its_name() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/it/units.xml");
    let before = Written::new("plc.xml".into(), std::fs::read(file).unwrap(), Board::UNO);
    let named = symbols(&before);
    let mut shared = 0;
    for unit in named.iter().filter(|one| is_unit(one)) {
        for variable in named.iter().filter(|one| one.what == What::Variable) {
            shared += usize::from(held(&before, unit, variable));
        }
    }
    assert!(shared > 20, "{shared}");
}
