//! Random operations: none panics, each document can be drawn, and each can be taken back.

use super::operations::operation;
use unoclp_core::{Board, Loader};
use unoclp_draw::Names;
use unoclp_draw::edit::{Document, Drawn, Editor, visit};
use unoclp_testing::{Random, held, rounds};

/// Each on a document of its own.
const RUNS: u32 = 2_000;
const OPERATIONS: usize = 500;

#[test]
fn a_million_random_operations_can_be_taken_back() {
    let mut seen = Seen::default();
    for seed in 0..rounds(RUNS) {
        held(|| run(seed.into(), &mut seen));
    }
    println!("{seen:?}");
    // Most of what is tried is to be done, or nothing is tried.
    assert!(seen.done > seen.tried / 2, "{seen:?}");
    assert!(seen.came_back > seen.tried / 10_000, "{seen:?}");
}

#[derive(Debug, Default)]
struct Seen {
    tried: u64,
    done: u64,
    came_back: u64,
}

fn run(seed: u64, seen: &mut Seen) {
    let random = &mut Random(seed);
    let beginning = Document::new();
    let mut editor = Editor::new(beginning.clone());
    let mut log = Vec::new();
    for count in 1..=OPERATIONS {
        let operation = operation(random, editor.document());
        seen.tried += 1;
        seen.done += u64::from(editor.apply(&operation).is_ok());
        log.push(operation);
        if count % 100 == 0 {
            draws(editor.document());
            seen.came_back += u64::from(comes_back(editor.document()));
        }
    }
    let end = editor.document().clone();
    while editor.undo().is_ok() {}
    assert_eq!(*editor.document(), beginning, "seed {seed}");
    while editor.redo().is_ok() {}
    assert_eq!(*editor.document(), end, "seed {seed}");
    let mut again = Editor::new(beginning);
    for operation in &log {
        // What was refused is refused again.
        let _ = again.apply(operation);
    }
    assert_eq!(*again.document(), end, "seed {seed}");
}

/// It can be drawn: each of its elements is there, but for loads that are drawn with a comparison.
fn draws(document: &Document) {
    let drawn = Drawn::of(document);
    let drawing = drawn.draw(80, &Names::new());
    assert_eq!(drawing.rungs.len(), document.rungs().len());
    for rung in document.rungs() {
        visit(&rung.series, &mut |node| {
            if let unoclp_draw::edit::Node::Element(element) = node {
                assert!(drawn.elements.contains(&element.id));
            }
        });
    }
    let _ = document.check(Board::UNO);
}

/// Whether it is a program; such a one comes back from its codes.
fn comes_back(document: &Document) -> bool {
    let mistakes = document.check(Board::UNO);
    if mistakes.iter().any(|mistake| mistake.what.is_error()) {
        return false;
    }
    let codes = document.codes().unwrap();
    let mut memory = vec![0; 2_000];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    for byte in codes
        .iter()
        .flat_map(|code| format!("{code}\n").into_bytes())
    {
        loader.push(byte).unwrap();
    }
    let program = loader.finish().unwrap();
    assert_eq!(Document::of_steps(program.steps()).codes(), Ok(codes));
    true
}
