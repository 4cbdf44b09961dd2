//! Random operations of the editor. The tests of PLCopen XML draw with them too.

use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{
    Along, Begin, Coil, Cursor, Direction, Document, Draft, Edge, Gate, Id, Operation, Place, Row,
    Step, Way, visit,
};
use unoclp_point::Address;
use unoclp_testing::Random;

/// What somebody might do to a document, most of it possible.
pub(crate) fn operation(random: &mut Random, document: &Document) -> Operation {
    match random.below(40) {
        0..4 => Operation::Select(cursor(random, document)),
        4..7 => Operation::Move(random.pick(&[
            Direction::Left,
            Direction::Right,
            Direction::Up,
            Direction::Down,
        ])),
        7 => Operation::Extend(along(random)),
        8..17 => Operation::Insert(draft(random), place(random)),
        17 => Operation::Branch,
        18 => Operation::Stretch(along(random), random.pick(&[Way::In, Way::Out])),
        19..23 => Operation::Delete,
        23 => Operation::Copy,
        24 => Operation::Cut,
        25 => Operation::Paste(place(random)),
        26..28 => Operation::Carry(id(random, document), place(random)),
        28 => match random.below(3) {
            0 => Operation::Toggle,
            1 => Operation::Enclose(random.pick(&[Gate::And, Gate::Or, Gate::Xor])),
            _ => Operation::Dissolve,
        },
        29 => Operation::Edge(random.pick(&[None, Some(Edge::Rising), Some(Edge::Falling)])),
        30 => Operation::Coil(coil(random)),
        31..33 => Operation::Address(address(random)),
        33 => Operation::Line(
            random.below(3),
            random.pick(&[None, Some(7), Some(7901), Some(-1)]),
        ),
        34 => match random.below(3) {
            0 => Operation::Replace(draft(random)),
            1 => Operation::Point(random.pick(&[None, Some(1), Some(3), Some(9)])),
            _ => Operation::Split,
        },
        35 => Operation::InsertRung(along(random)),
        36 => Operation::MoveRung(along(random)),
        37 => Operation::Join,
        38 => match random.below(4) {
            0 => Operation::Comment(vec![format!("rung {}", random.below(9))]),
            1 => Operation::Labels(random.pick(&[&[][..], &[1], &[1, 2]]).to_vec()),
            2 => Operation::Begin(random.pick(&[
                Begin::Rung,
                Begin::NewRung,
                Begin::Else,
                Begin::EndIf,
            ])),
            _ => Operation::Title(vec!["title".to_owned()]),
        },
        _ => Operation::Name(
            address(random).unwrap_or(Address::Timer(1)),
            Row {
                name: random.pick(&["", "start", "lamp"]).to_owned(),
                comment: String::new(),
            },
        ),
    }
}

fn ids(document: &Document) -> Vec<Id> {
    let mut ids = Vec::new();
    for rung in document.rungs() {
        ids.push(rung.id);
        visit(&rung.series, &mut |node| {
            ids.push(node.id());
            ids.extend(node.paths().iter().map(|path| path.id));
        });
    }
    ids
}

fn id(random: &mut Random, document: &Document) -> Id {
    random.pick(&ids(document))
}

fn cursor(random: &mut Random, document: &Document) -> Cursor {
    let from = id(random, document);
    let to = if random.percent(70) {
        from
    } else {
        id(random, document)
    };
    Cursor { from, to }
}

fn along(random: &mut Random) -> Along {
    random.pick(&[Along::Back, Along::Forth])
}

fn place(random: &mut Random) -> Place {
    random.pick(&[Place::Before, Place::Behind, Place::Beside])
}

fn coil(random: &mut Random) -> Coil {
    random.pick(&[
        Coil::Normal,
        Coil::Negated,
        Coil::Set,
        Coil::Reset,
        Coil::Load,
    ])
}

fn address(random: &mut Random) -> Option<Address> {
    let number = 1 + random.below(4) as u8;
    let point = random.pick(&[
        Address::Input,
        Address::Output,
        Address::Marker,
        Address::System,
        Address::Timer,
        Address::Counter,
        Address::Register,
        Address::Analogue,
        Address::Label,
    ]);
    random.percent(90).then(|| point(number))
}

/// Mostly what people draw, and now and then any instruction.
fn draft(random: &mut Random) -> Draft {
    let drawn = match random.below(10) {
        0..5 => Draft::contact(address(random), random.percent(30)),
        5..7 => Draft::coil(address(random), coil(random)),
        7 => Draft::timer(
            random.pick(&[Opcode::OnDelay, Opcode::OffDelay, Opcode::Pulse]),
            Some(random.below(1_000) as i32),
            Some(unoclp_core::Target::Marker(1 + random.below(4) as u8)),
        ),
        8 => Ok(Draft::counter(random.percent(50), Some(1), Some(5))),
        _ => Draft::comparison(
            Some(Step::new(Opcode::LoadAnalogue).with_number(random.below(5) as u8)),
            Step::new(Opcode::Greater)
                .with_number(0)
                .with_lines([Some(500)]),
        ),
    };
    match drawn {
        Ok(draft) if random.percent(90) => draft,
        _ => any(random).into(),
    }
}

fn any(random: &mut Random) -> Step {
    let opcode = random.pick(Opcode::ALL);
    let step = Step::new(opcode).with_number(1 + random.below(3) as u8);
    let missing = random.percent(10);
    let lines = match opcode.class() {
        Class::Timer => vec![Some(5), Some(7901)],
        _ => vec![(!missing).then_some(1); 40],
    };
    step.with_lines(lines)
}
