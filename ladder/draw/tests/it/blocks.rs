//! Documents as block diagrams: the same elements as in their ladder, each with a place.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use unoclp_checked::SourceMap;
use unoclp_core::{Board, Loader};
use unoclp_draw::edit::{Canvas, Document, Drawn};
use unoclp_draw::{Ladder, Look, Medium, Names, Style, listing_of_blocks, to_svg_of_blocks};
use unoclp_point::Address;

/// The programs of this folder, and of those within.
fn programs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            programs(&path, found);
        } else if path.extension().is_some_and(|end| end == "txt") {
            found.push(path);
        }
    }
}

fn document(file: &[u8]) -> Option<Document> {
    let mut memory = vec![0; usize::from(Board::UNO.linked_bytes)];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    file.iter().try_for_each(|&byte| loader.push(byte)).ok()?;
    Some(Document::of_steps(loader.finish().ok()?.steps()))
}

fn canvas(document: &Document, look: Look) -> Canvas {
    let title = |number: usize| format!("Rung {number}");
    Drawn::of(document).canvas(document, (look, 80), &title, None)
}

/// What is on a canvas, and what has places beside it.
fn named(canvas: &Canvas) -> (BTreeSet<u32>, BTreeSet<u32>) {
    let rungs = || canvas.rungs.iter().map(|strip| &strip.drawn);
    let spots = rungs().flat_map(|drawn| &drawn.spots);
    let places = rungs().flat_map(|drawn| &drawn.places);
    (
        spots.map(|spot| spot.id.0).collect(),
        places.map(|place| place.at.0).collect(),
    )
}

#[test]
fn both_looks_of_the_samples_have_the_same_elements_and_places() {
    let mut paths = Vec::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs");
    programs(&folder, &mut paths);
    let mut count = 0;
    for path in paths {
        let Some(document) = document(&fs::read(&path).unwrap()) else {
            continue;
        };
        let (ladder, blocks) = (
            canvas(&document, Look::Ladder),
            canvas(&document, Look::Blocks),
        );
        assert_eq!(named(&ladder), named(&blocks), "{path:?}");
        for strip in &blocks.rungs {
            let drawn = &strip.drawn;
            let places = drawn.places.iter().map(|place| place.area);
            for area in drawn.spots.iter().map(|spot| spot.area).chain(places) {
                let is_inside = area.y >= 0.0 && area.y + area.height <= drawn.height + 12.0;
                assert!(is_inside, "{path:?}: {area:?} of {}", drawn.height);
                assert!(area.x + area.width <= blocks.size.0, "{path:?}: {area:?}");
            }
        }
        count += 1;
    }
    assert!(count > 50);
}

#[test]
fn a_rung_that_is_as_it_was_is_not_drawn_again_until_it_looks_otherwise() {
    let document = document(b"0\n827301\n877901\n787600\n827302\n877902\n").unwrap();
    let title = |number: usize| format!("Rung {number}");
    let drawn = Drawn::of(&document);
    let blocks = canvas(&document, Look::Blocks);
    let again = drawn.canvas(&document, (Look::Blocks, 80), &title, Some(&blocks));
    assert!(again.rungs.iter().all(|strip| !strip.is_new));
    let other = drawn.canvas(&document, (Look::Ladder, 80), &title, Some(&blocks));
    assert!(other.rungs.iter().all(|strip| strip.is_new));
}

#[test]
fn a_latch_is_two_gates_with_a_negated_input() {
    let document = document(b"0\n827301\n40\n827901\n41\n-827302\n877901\n").unwrap();
    let canvas = canvas(&document, Look::Blocks);
    let svg = &canvas.rungs[0].drawn.svg;
    for (text, count) in [
        (">≥1<", 1),
        (">&amp;<", 1),
        ("data-says=\"I1\"", 2),
        ("a4 4 0 1 0 8 0", 1),
    ] {
        assert_eq!(svg.matches(text).count(), count, "{text}\n{svg}");
    }
}

#[test]
fn a_rung_is_drawn_as_blocks_in_characters() {
    let file = "0\n827301\n40\n827901\n41\n-827302\n877901\n83877902\n787600\n-827303\n-877903\n";
    let mut memory = vec![0; usize::from(Board::UNO.linked_bytes)];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    file.bytes().for_each(|byte| loader.push(byte).unwrap());
    let program = loader.finish().unwrap();
    let ladder = Ladder::new(program.steps());
    let names = Names::from([(Address::Input(1), "start".to_owned())]);
    let title = |number: usize, _: Option<(usize, usize)>| format!("Rung {number}");
    let map = SourceMap::default();
    assert_eq!(
        listing_of_blocks(&ladder, 80, &map, &names, &title),
        "Rung 1
start I1 ───┤≥1 ├───┤ & ├─┬──┤ Q1 │
      Q1 ───┤   │   │   │ │
      I2 ──────────o┤   │ │
                          └──┤ S Q2 │

Rung 2
I3 ───┤ Q3 │
"
    );
    let style = Style {
        width: 80,
        names: &names,
        medium: Medium::Paper,
    };
    let svg = to_svg_of_blocks(&ladder, &style, &map, &title, "Motor");
    assert_eq!(svg.matches("≥1").count(), 1);
    assert!(svg.contains("start") && svg.contains("Motor"), "{svg}");
}
