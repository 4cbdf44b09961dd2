//! Random acts of the drawing in the units of random projects. After each the wires are those that the act means, and all
//! else of the file is what it was, byte for byte; what is drawn and erased again leaves the codes that there were.

mod act;
mod sheet;

use crate::diagrams::random_project;
use crate::round_trip::document;
use act::Act;
use sheet::Sheet;
use unoclp_core::Board;
use unoclp_host_sim::random::{Random as Programs, random_program};
use unoclp_plcopen::{
    Touch, Where, add, draw, erase, export, export_blocks, import, outline, remove, shown, touch,
};
use unoclp_testing::{Random, rounds};

const FIVE: &str = include_str!("../../../../../page/web/test/page/five.xml");

fn large() -> Board {
    Board {
        stored_bytes: 30_000,
        linked_bytes: 30_000,
        ..Board::UNO
    }
}

/// The codes of a project; none where it has mistakes.
fn codes(text: &str) -> Option<Vec<i32>> {
    let (program, _) = import(text, large()).program?;
    Some(
        program
            .program()
            .steps()
            .flat_map(|step| step.codes().collect::<Vec<_>>())
            .collect(),
    )
}

/// A project, and the unit of it that is drawn.
fn project(seed: u32, random: &mut Random) -> (String, &'static str) {
    let mut programs = Programs::new(u64::from(seed) + 1);
    match seed % 5 {
        0 => (FIVE.to_owned(), "Latch"),
        1 => (FIVE.to_owned(), "Pair"),
        2 => (random_project(random), "Main"),
        way => loop {
            let document = document(random_program(&mut programs).as_bytes()).unwrap();
            let made = match way {
                3 => export(&document, "test", Board::UNO),
                _ => export_blocks(&document, "test", Board::UNO),
            };
            let made = made.unwrap();
            if made.beyond.is_empty() {
                let unit = outline(&made.text).unwrap().units[0].name.clone();
                assert_eq!(unit, "Main");
                // With marks of its author.
                let text = made
                    .text
                    .replace("\n            <", "\n<!-- mine -->\t\n  <");
                return (text, "Main");
            }
        },
    }
}

const OF_LADDERS: [&str; 9] = [
    "contact", "coil", "TON", "CTU", "R_TRIG", "GT", "ADD", "MOVE", "SR",
];
const OF_BLOCKS: [&str; 11] = [
    "value", "variable", "AND", "NOT", "TON", "CTUD", "GT", "ADD", "MOVE", "SR", "OR",
];

/// The variables of a unit.
fn names(text: &str, unit: &str) -> Vec<String> {
    let units = outline(text).unwrap().units.into_iter();
    let own = units.filter(|of| of.name == unit);
    let rows = own.flat_map(|of| of.variables);
    rows.map(|row| row.name).collect()
}

/// A drawing without what has just been drawn, and without the instance that came with it.
fn without(text: &str, unit: &str, new: &str, old: &[String]) -> String {
    let erased = erase(text, unit, new).unwrap();
    let more = names(&erased, unit);
    let more = more.iter().filter(|name| !old.contains(name));
    more.fold(erased.clone(), |text, name| {
        remove(&text, Some(unit), name).unwrap()
    })
}

/// Draws something; the text then, and whether its codes were compared.
fn draws(text: &str, unit: &str, random: &mut Random) -> Option<(String, bool)> {
    let before = Sheet::of(text, unit);
    let place = random.pick(&[Where::Before, Where::After, Where::Beside, Where::Below]);
    let what = match shown(text, unit).unwrap().language == "FBD" {
        true => random.pick(&OF_BLOCKS),
        false => random.pick(&OF_LADDERS),
    };
    let at = one_of(&before, random)?;
    let after = draw(text, unit, place, &at, what)?;
    let act = Act::of(&before, &after, unit);
    // A block that takes a value may have got a pin for it.
    act.keeps((what == "value").then_some(&at));
    act.drawn(place, &at, what);
    let was = codes(text);
    if was.is_some() {
        let back = without(&after, unit, &act.added(), &names(text, unit));
        assert!(
            codes(&back) == was,
            "{what} {place:?} {at}\n{back}\nwas\n{text}"
        );
    }
    Some((after, was.is_some()))
}

/// Erases something; but for comments and, since little can be drawn without them, rails.
fn erases(text: &str, unit: &str, random: &mut Random) -> Option<String> {
    let before = Sheet::of(text, unit);
    let at = one_of(&before, random)?;
    if before.kinds[&at] == "comment" || before.kinds[&at].ends_with("Rail") {
        return None;
    }
    let after = erase(text, unit, &at)?;
    let act = Act::of(&before, &after, unit);
    act.keeps(None);
    act.erased(&at);
    Some(after)
}

/// Changes an element; the text goes on as it was.
fn changes(text: &str, unit: &str, random: &mut Random) -> Option<()> {
    let before = Sheet::of(text, unit);
    let at = one_of(&before, random)?;
    let element = |text: &str| {
        let mut elements = shown(text, unit).unwrap().elements.into_iter();
        elements.find(|of| of.id == at).unwrap()
    };
    let is_negated = element(text).negated;
    let change = match random.below(3) {
        0 => Touch::Written("a < \"b\" & 'c'".to_owned()),
        1 => Touch::Negated(!is_negated),
        _ => Touch::Storage("set".to_owned()),
    };
    let after = touch(text, unit, &at, &change)?;
    let act = Act::of(&before, &after, unit);
    act.keeps(Some(&at));
    act.wires(|_, wires| wires.to_vec());
    let now = element(&after);
    match &change {
        Touch::Written(new) => assert_eq!(&now.written, new, "{after}"),
        Touch::Negated(is) => assert_eq!(now.negated, *is, "{after}"),
        _ => assert_eq!(now.storage, "set", "{after}"),
    }
    Some(())
}

/// Declares an instance, and takes it away again.
fn declares(text: &str, unit: &str) {
    let again = |text: &str| {
        let more = add(text, Some(unit), "localVars", "fresh", "TON").unwrap();
        Act::of(&Sheet::of(text, unit), &more, unit).keeps(None);
        remove(&more, Some(unit), "FRESH").unwrap()
    };
    // An empty section may stay, and is used again.
    let back = again(text);
    assert!(again(&back) == back, "{back}");
}

/// The number of an element; none where nothing is drawn.
fn one_of(sheet: &Sheet, random: &mut Random) -> Option<String> {
    let mut ids = sheet.said.keys();
    let at = random.below(ids.len().max(1));
    ids.nth(at).cloned()
}

#[test]
fn random_acts_change_what_they_mean_and_nothing_else() {
    let (mut drawn, mut compared, mut erased, mut changed) = (0, 0, 0, 0);
    for seed in 0..rounds(100) {
        let mut random = Random(u64::from(seed) + 7);
        let (mut text, unit) = project(seed, &mut random);
        for _ in 0..8 {
            match random.below(10) {
                0 | 1 => {
                    if let Some(after) = erases(&text, unit, &mut random) {
                        erased += 1;
                        text = after;
                    }
                }
                2 => changed += u32::from(changes(&text, unit, &mut random).is_some()),
                3 => declares(&text, unit),
                _ => {
                    if let Some((after, is_compared)) = draws(&text, unit, &mut random) {
                        drawn += 1;
                        compared += u32::from(is_compared);
                        text = after;
                    }
                }
            }
        }
    }
    println!("{drawn} drawn, {compared} compared, {erased} erased, {changed} changed");
    let least = rounds(100);
    let is_enough = drawn >= least && compared >= least && erased * 4 >= least;
    assert!(least < 100 || is_enough && changed * 8 >= least);
}
