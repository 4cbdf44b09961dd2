//! What is drawn is what is done: power that follows the tree of a document comes to its coil as it does in the scan.

use unoclp_core::{Board, Image, Loader, Plc};
use unoclp_draw::edit::{
    Along, Cursor, Document, Draft, Editor, Id, Node, Operation, Place, Series, Way, visit,
};
use unoclp_point::Address;
use unoclp_testing::{Random, held, rounds};

#[test]
fn power_follows_the_tree_as_it_does_in_the_scan() {
    let (mut compared, mut stored) = (0, 0);
    let usual = rounds(3_000);
    let mut compare = |seed: u32| {
        let document = drawn_at_random(&mut Random(seed.into()));
        // More branches in each other than a rung can have are told as such.
        let Ok(codes) = document.codes() else {
            return;
        };
        compared += 1;
        stored += u32::from(codes.contains(&404_103));
        let text: String = codes.iter().map(|code| format!("{code}\n")).collect();
        let mut memory = vec![0; 4_000];
        let mut loader = Loader::new(&mut memory, Board::UNO);
        if text.bytes().any(|byte| loader.push(byte).is_err()) {
            return;
        }
        let mut plc = Plc::new(loader.finish().unwrap());
        for inputs in 0..16 {
            plc.scan(Image(inputs), 0).unwrap();
            let series = &document.rungs().next().unwrap().series;
            let wanted = power(series, true, inputs);
            assert_eq!(
                plc.outputs().0 & 1 == 1,
                wanted,
                "seed {seed}, inputs {inputs:04b}\n{text}"
            );
        }
    };
    (0..usual).for_each(|seed| held(|| compare(seed)));
    assert!(compared > usual * 9 / 10, "{compared}");
    assert!(stored > usual / 100, "{stored} with three points");
}

#[test]
fn a_load_right_before_a_comparison_belongs_to_it() {
    let mut memory = vec![0; 100];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    for byte in *b"0\n76686500\n716900\n500\n877901\n" {
        loader.push(byte).unwrap();
    }
    let document = Document::of_steps(loader.finish().unwrap().steps());
    let series = &document.rungs().next().unwrap().series;
    let loads = series.iter().map(|node| match node {
        Node::Element(element) => element.load.is_some(),
        _ => false,
    });
    assert!(loads.eq([true, false]));
}

/// One rung of contacts in series and in parallel, and a coil after them.
fn drawn_at_random(random: &mut Random) -> Document {
    let mut editor = Editor::new(Document::new());
    for _ in 0..random.below(60) {
        let at = random.pick(&nodes(editor.document()));
        let _ = editor.apply(&Operation::Select(Cursor::at(at)));
        let operation = match random.below(12) {
            0..3 => Operation::Insert(contact(random), Place::Before),
            3..5 => Operation::Insert(contact(random), Place::Behind),
            5..8 => Operation::Insert(contact(random), Place::Beside),
            8 => Operation::Delete,
            9 => Operation::Stretch(
                random.pick(&[Along::Back, Along::Forth]),
                random.pick(&[Way::In, Way::Out]),
            ),
            10 => Operation::Carry(
                random.pick(&nodes(editor.document())),
                random.pick(&[Place::Before, Place::Beside]),
            ),
            _ => {
                let _ = editor.apply(&Operation::Extend(Along::Forth));
                Operation::Insert(contact(random), Place::Beside)
            }
        };
        // What cannot be done there is refused.
        let _ = editor.apply(&operation);
    }
    let rung = editor.document().rungs().next().unwrap().id;
    let coil = Draft::coil(Some(Address::Output(1)), unoclp_draw::edit::Coil::Normal);
    let last = Operation::Insert(coil.unwrap(), Place::Behind);
    editor.apply(&Operation::Select(Cursor::at(rung))).unwrap();
    editor.apply(&last).unwrap();
    editor.document().clone()
}

fn contact(random: &mut Random) -> Draft {
    let input = 1 + random.below(4) as u8;
    Draft::contact(Some(Address::Input(input)), random.percent(40)).unwrap()
}

fn nodes(document: &Document) -> Vec<Id> {
    let rung = document.rungs().next().unwrap();
    let mut nodes = Vec::new();
    visit(&rung.series, &mut |node| nodes.push(node.id()));
    if nodes.is_empty() {
        nodes.push(rung.id);
    }
    nodes
}

/// The power after a series that has this before it.
fn power(series: &Series, before: bool, inputs: u128) -> bool {
    series.iter().fold(before, |before, node| match node {
        Node::Element(element) => {
            let number = element.step.number().unwrap();
            let is_contact = element.step.opcode().row().code.abs() / 100 == 8_273;
            let input = inputs >> (number - 1) & 1 == 1;
            before && (!is_contact || input != element.step.opcode().is_inverted())
        }
        Node::Parallel(parallel) => {
            let mut paths = parallel.paths.iter();
            paths.any(|path| power(&path.series, before, inputs))
        }
        Node::Block(_) | Node::Store(_) => unreachable!("none was drawn"),
    })
}
