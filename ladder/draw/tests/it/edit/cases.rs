//! What operations make of a document: the cases of `cases.txt`.
//!
//! A case is a heading, `# …`; the operations, each on a line that begins with `>`; the codes that they come to; and the
//! picture. It begins with an empty rung, or with the codes after `> codes`.

use super::canvas::of_codes;
use std::fmt::Write;
use unoclp_core::isa::{Opcode, REGISTER_OPERAND};
use unoclp_core::{Board, Target};
use unoclp_draw::edit::{
    Along, Coil, Cursor, Direction, Document, Draft, Drawn, Edge, Editor, Gate, Id, Mistake, Node,
    Operation, Place, Refusal, Row, Step, Way,
};
use unoclp_draw::{Element, Names, Symbol};
use unoclp_point::Address;

#[test]
fn operations_come_to_these_codes_and_pictures() {
    let mut cases = 0;
    for case in include_str!("cases.txt").split("\n# ").skip(1) {
        let what = case.lines().next().unwrap();
        let told = carry_out(case);
        let wanted = format!("{}\n", case.trim_end());
        assert_eq!(told, wanted, "{what}\n{told}");
        cases += 1;
    }
    assert!(cases > 20, "{cases}");
}

/// Each branch stands beside the last element of the path before: the 65th would be too deep to be drawn.
#[test]
fn branches_stand_only_so_deep_in_each_other() {
    let mut editor = Editor::new(Document::new());
    let deep = (0..99).take_while(|_| {
        for element in ["behind I1", "behind I2"] {
            editor.apply(&read(element, &editor)).unwrap();
        }
        match editor.apply(&Operation::Branch) {
            Ok(()) => true,
            Err(refusal) => {
                assert_eq!(refusal, Refusal::TooDeep);
                false
            }
        }
    });
    assert_eq!(deep.count(), 64);
}

/// The case as it turns out: its heading and its operations, and what they come to.
fn carry_out(case: &str) -> String {
    let mut editor = Editor::new(Document::new());
    let mut told = format!("{}\n", case.lines().next().unwrap());
    for line in case.lines().filter(|line| line.starts_with('>')) {
        let operation = line[1..].split('!').next().unwrap().trim();
        write!(told, "> {operation}").unwrap();
        if let Some(codes) = operation.strip_prefix("codes ") {
            editor = Editor::new(of_codes(codes));
            told.push('\n');
            continue;
        }
        match operation {
            "undo" => editor.undo(),
            "redo" => editor.redo(),
            operation => editor.apply(&read(operation, &editor)),
        }
        .unwrap_or_else(|refusal: Refusal| write!(told, " ! {refusal:?}").unwrap());
        told.push('\n');
    }
    let document = editor.document();
    match document.codes() {
        Ok(codes) => {
            let codes: Vec<String> = codes[1..].iter().map(i32::to_string).collect();
            writeln!(told, "{}", codes.join(" ").trim()).unwrap();
        }
        Err(mistakes) => writeln!(told, "incomplete: {}", mistakes.len()).unwrap(),
    }
    for Mistake { at, what } in document.check(Board::UNO) {
        let index = at.map(|id| symbol(document, id));
        writeln!(told, "{what:?} at {}", index.unwrap_or_default()).unwrap();
    }
    for (rung, picture) in document
        .rungs()
        .zip(Drawn::of(document).draw(56, &Names::new()).rungs)
    {
        rung.comment
            .iter()
            .for_each(|line| writeln!(told, "{line}").unwrap());
        write!(told, "{picture}").unwrap();
    }
    for (point, Row { name, .. }) in document.table().rows() {
        writeln!(told, "{point}: {name}").unwrap();
    }
    told
}

/// What an element shows; of a timer the box, of a comparison all of it.
fn symbol(document: &Document, id: Id) -> String {
    let drawn = Drawn::of(document);
    let elements = drawn.elements.iter().zip(&drawn.ladder.elements);
    let own = elements.filter(|(other, element)| **other == id && !element.steps.is_empty());
    match own.map(|(_, element)| text(element)).next() {
        Some(text) => text,
        None if document.position(id).is_some() => "the rung".to_owned(),
        None => "a wire".to_owned(),
    }
}

fn text(element: &Element) -> String {
    match &element.symbol {
        Symbol::Contact { text, .. } | Symbol::Coil { text, .. } => text.clone(),
        Symbol::Box { text, .. } | Symbol::Leave { text, .. } => text.clone(),
        Symbol::Inline(text) => (*text).to_owned(),
    }
}

fn read(text: &str, editor: &Editor) -> Operation {
    let (word, rest) = text.split_once(' ').unwrap_or((text, ""));
    let number = || rest.parse().ok();
    match word {
        "before" => Operation::Insert(draft(rest), Place::Before),
        "behind" => Operation::Insert(draft(rest), Place::Behind),
        "beside" => Operation::Insert(draft(rest), Place::Beside),
        "replace" => Operation::Replace(draft(rest)),
        "branch" => Operation::Branch,
        "left" => Operation::Move(Direction::Left),
        "right" => Operation::Move(Direction::Right),
        "up" => Operation::Move(Direction::Up),
        "down" => Operation::Move(Direction::Down),
        "extend-left" => Operation::Extend(Along::Back),
        "extend-right" => Operation::Extend(Along::Forth),
        "select" => Operation::Select(Cursor::at(find(editor, rest))),
        "around" => Operation::Select(Cursor::at(around(editor))),
        "delete" => Operation::Delete,
        "copy" => Operation::Copy,
        "cut" => Operation::Cut,
        "paste" => Operation::Paste(place(rest)),
        "carry" => {
            let (to, how) = rest.rsplit_once(' ').unwrap();
            Operation::Carry(find(editor, to), place(how))
        }
        "toggle" => Operation::Toggle,
        "rising" => Operation::Edge(Some(Edge::Rising)),
        "falling" => Operation::Edge(Some(Edge::Falling)),
        "level" => Operation::Edge(None),
        "and" => Operation::Enclose(Gate::And),
        "xor" => Operation::Enclose(Gate::Xor),
        "dissolve" => Operation::Dissolve,
        "coil" => Operation::Coil(coil(rest)),
        "address" => Operation::Address(address(rest)),
        "preset" => Operation::Line(0, number()),
        "point" => Operation::Point(number().map(|point| point as u8)),
        "start-out" => Operation::Stretch(Along::Back, Way::Out),
        "start-in" => Operation::Stretch(Along::Back, Way::In),
        "end-out" => Operation::Stretch(Along::Forth, Way::Out),
        "end-in" => Operation::Stretch(Along::Forth, Way::In),
        "rung-above" => Operation::InsertRung(Along::Back),
        "rung-below" => Operation::InsertRung(Along::Forth),
        "rung-up" => Operation::MoveRung(Along::Back),
        "rung-down" => Operation::MoveRung(Along::Forth),
        "split" => Operation::Split,
        "join" => Operation::Join,
        "comment" => Operation::Comment(vec![rest.to_owned()]),
        "labels" => Operation::Labels(
            rest.split(' ')
                .map(|label| label.parse().unwrap())
                .collect(),
        ),
        "name" => {
            let (point, name) = rest.split_once(' ').unwrap();
            let row = Row {
                name: name.to_owned(),
                comment: String::new(),
            };
            Operation::Name(address(point).unwrap(), row)
        }
        word => panic!("{word}: no such operation"),
    }
}

fn place(text: &str) -> Place {
    match text {
        "before" => Place::Before,
        "behind" => Place::Behind,
        "beside" => Place::Beside,
        text => panic!("{text}: no such place"),
    }
}

/// The first element whose symbol says this; or the rung with this number.
fn find(editor: &Editor, text: &str) -> Id {
    let document = editor.document();
    if let Some(number) = text.strip_prefix("rung ") {
        let number: usize = number.parse().unwrap();
        return document.rungs().nth(number - 1).unwrap().id;
    }
    let drawn = Drawn::of(document);
    let mut elements = drawn.ladder.elements.iter();
    let found = elements.position(|element| self::text(element) == text);
    drawn.elements[found.unwrap_or_else(|| panic!("{text}: no such element"))]
}

/// The node around the cursor.
fn around(editor: &Editor) -> Id {
    let mut found = None;
    for rung in editor.document().rungs() {
        unoclp_draw::edit::visit(&rung.series, &mut |node: &Node| {
            let on = |node: &Node| node.id() == editor.cursor().from;
            if node.paths().iter().any(|path| path.series.iter().any(on)) {
                found = Some(node.id());
            }
        });
    }
    found.unwrap()
}

fn coil(text: &str) -> Coil {
    match text {
        "/" => Coil::Negated,
        "S" => Coil::Set,
        "R" => Coil::Reset,
        "L" => Coil::Load,
        _ => Coil::Normal,
    }
}

fn address(text: &str) -> Option<Address> {
    let (letter, number) = text.split_at_checked(1)?;
    let number = number.parse().ok()?;
    Some(match letter {
        "I" => Address::Input(number),
        "Q" => Address::Output(number),
        "M" => Address::Marker(number),
        "S" => Address::System(number),
        "T" => Address::Timer(number),
        "C" => Address::Counter(number),
        "D" => Address::Register(number),
        "A" => Address::Analogue(number),
        _ => Address::Label(number),
    })
}

/// `I1`, `/I1`, `(Q1)`, `(S Q1)`, `TON 5000 Q1`, `CTU 1 10`, `A0 > 500`, `NOT`, `D1 + 2`, `LD D1`, `ST D1`, `IF`.
fn draft(text: &str) -> Draft {
    let words: Vec<&str> = text.split(' ').collect();
    let line = |at: usize| words.get(at).and_then(|word| word.parse::<i32>().ok());
    let target = |at: usize| match words.get(at).and_then(|word| address(word)) {
        Some(Address::Output(number)) => Some(Target::Output(number)),
        Some(Address::Marker(number)) => Some(Target::Marker(number)),
        _ => None,
    };
    let load = |word: &str| match address(word) {
        Some(Address::Analogue(number)) => Step::new(Opcode::LoadAnalogue).with_number(number),
        Some(Address::Counter(number)) => Step::new(Opcode::LoadCount).with_number(number),
        point => Step::new(Opcode::Load).with_number(point.map(Address::number)),
    };
    let operand = |opcode: Opcode, word: &str| match address(word) {
        Some(point) => Step::new(opcode).with_number(point.number()),
        None => Step::new(opcode)
            .with_number(0)
            .with_lines([word.parse().ok()]),
    };
    match words[..] {
        ["TON", ..] => Draft::timer(Opcode::OnDelay, line(1), target(2)).unwrap(),
        ["TOF", ..] => Draft::timer(Opcode::OffDelay, line(1), target(2)).unwrap(),
        ["CTU", ..] => Draft::counter(false, line(1).map(|number| number as u8), line(2)),
        ["CTD", ..] => Draft::counter(true, line(1).map(|number| number as u8), line(2)),
        ["NOT"] => Step::new(Opcode::Not).into(),
        ["IF"] => Step::new(Opcode::If).into(),
        ["XOR"] => Step::new(Opcode::OpenXor).into(),
        ["LD", word] => load(word).into(),
        ["ADD", word] => operand(Opcode::Add, word).into(),
        ["ST", word] => Step::new(Opcode::Store)
            .with_number(address(word).map(Address::number))
            .into(),
        ["MOV", from, to, count] => Step::new(Opcode::Move)
            .with_number(address(from).map(Address::number))
            .with_lines([
                address(to).map(|to| REGISTER_OPERAND + i32::from(to.number())),
                count.parse().ok(),
            ])
            .into(),
        [left, ">", right] => {
            Draft::comparison(Some(load(left)), operand(Opcode::Greater, right)).unwrap()
        }
        [one] if one.starts_with('(') => {
            Draft::coil(address(one.trim_matches(['(', ')'])), Coil::Normal).unwrap()
        }
        [one, two] if one.starts_with('(') => {
            Draft::coil(address(two.trim_matches(')')), coil(&one[1..])).unwrap()
        }
        [one] => {
            Draft::contact(address(one.trim_start_matches('/')), one.starts_with('/')).unwrap()
        }
        _ => panic!("{text}: no such element"),
    }
}
