//! What a tree says of codes, labels and places of its text.

use super::tests::{LARGE, compiled_of};
use super::writer::{assign, expr, place, read, statement, whole};
use unoclp_lang::run::{Machine, Stop};
use unoclp_lang::typed::{
    Base, Binary, Cell, Codes, Expr, ExprKind, Stmt, StmtKind, Tree, Unit, UnitKind, Value,
};
use unoclp_lang::{Lines, Span, TextLanguage, compile_text};
use unoclp_point::Address;

/// I1, I2, Q1 and a bit of the program's own, and a register.
fn tree(body: Vec<Stmt>) -> Tree {
    let mut tree = Tree::default();
    let points = [
        Some(Address::Input(1)),
        Some(Address::Input(2)),
        Some(Address::Output(1)),
        None,
        Some(Address::Register(1)),
    ];
    for (cell, point) in (0..).zip(points) {
        tree.points.extend(point.map(|point| (cell, point)));
        tree.cells.push(Cell {
            base: if cell == 4 { Base::Dint } else { Base::Bool },
            initial: Value::Int(0),
            retain: false,
            scratch: false,
        });
    }
    tree.units.push(Unit {
        name: "main".to_owned(),
        kind: UnitKind::Program,
        own: Vec::new(),
        locals: Vec::new(),
        references: 0,
        body,
        at: Span::default(),
    });
    tree.programs.push(0);
    tree
}

fn codes(before: Option<Expr>, codes: &[i32], behind: Option<u32>) -> Stmt {
    let at = Span::default();
    let codes = codes.iter().map(|code| (*code, at)).collect();
    let behind = behind.map(place);
    statement(StmtKind::Codes(Box::new(Codes {
        before,
        codes,
        behind,
    })))
}

fn is_as_older(text: &str, tree: &Tree) {
    let older = compile_text(text, TextLanguage::Il, LARGE);
    let made = compiled_of(text, tree);
    let numbers = |lines: &[unoclp_lang::CodeLine]| -> Vec<i32> {
        lines.iter().map(|line| line.code).collect()
    };
    assert!(!older.has_errors(), "{:?}", older.diagnostics);
    assert_eq!(numbers(&made.lines), numbers(&older.lines), "{text}");
    assert!(made.program.is_some(), "{:?}", made.diagnostics);
}

#[test]
fn an_instruction_of_the_board_stands_as_it_is() {
    let i1 = || read(0, Base::Bool);
    let one = codes(Some(i1()), &[877701], None);
    is_as_older("LD I1\nCODE 877701\n", &tree(vec![one]));
    // acc behind it goes where the next statement uses it.
    let body = vec![
        codes(Some(i1()), &[787984], Some(3)),
        assign(2, read(3, Base::Bool)),
    ];
    is_as_older("LD I1\nCODE 787984\nST Q1\n", &tree(body));
    // Its timers count, and a rung that it begins is one.
    let body = vec![
        codes(Some(i1()), &[847978, 500, 7703], None),
        codes(None, &[787600], None),
        assign(2, read(1, Base::Bool)),
    ];
    let text = "LD I1\nCODE 847978, 500, 7703\nCODE 787600\nLD I2\nST Q1\n";
    is_as_older(text, &tree(body));
}

#[test]
fn a_pc_stops_at_an_instruction_of_the_board() {
    let tree = tree(vec![codes(None, &[787600], None)]);
    let ended = Machine::new(&tree).scan(0);
    assert_eq!(ended, Err(Stop::Codes(Span::default())));
}

#[test]
fn a_label_has_a_number_that_no_code_of_the_text_has() {
    let jump = |to| statement(StmtKind::Jump(Some(read(0, Base::Bool)), to));
    let q1 = |by: u32| assign(2, read(by, Base::Bool));
    let body = vec![jump(3), jump(5), q1(1), q1(0), q1(1), q1(1)];
    let labels = |made: &unoclp_lang::CompiledText| -> Vec<i32> {
        let labels = made.lines.iter();
        let labels = labels.filter(|line| line.letters.starts_with("LB"));
        labels.map(|line| line.code - 766600).collect()
    };
    assert_eq!(labels(&compiled_of("", &tree(body.clone()))), [1, 2]);
    let mut coded = body;
    coded.push(codes(None, &[766601], None));
    assert_eq!(labels(&compiled_of("", &tree(coded))), [2, 3]);
}

#[test]
fn each_step_stands_where_the_text_says_it() {
    let text = "LD I1\nAND I2\nST Q1\nLD D1\nADD 5\nST D1\n";
    let at = |word: &str| {
        let start = text.find(word).unwrap() as u32;
        let end = start + word.len() as u32;
        Span { start, end }
    };
    let on = |of: Expr, word: &str| Expr { at: at(word), ..of };
    let mut stored = assign(
        2,
        on(
            expr(
                ExprKind::Binary(
                    Binary::And,
                    on(read(0, Base::Bool), "I1").into(),
                    on(read(1, Base::Bool), "I2").into(),
                ),
                Base::Bool,
            ),
            "AND I2",
        ),
    );
    let mut number = assign(
        4,
        on(
            expr(
                ExprKind::Binary(
                    Binary::Add,
                    on(read(4, Base::Dint), "D1").into(),
                    on(whole(5, Base::Dint), "5").into(),
                ),
                Base::Dint,
            ),
            "ADD 5",
        ),
    );
    for (statement, words) in [(&mut stored, "ST Q1"), (&mut number, "ST D1")] {
        statement.at = at(words);
        if let StmtKind::Assign(to, ..) = &mut statement.kind {
            to.at = at(words);
            to.at.start += 3;
        }
    }
    let made = compiled_of(text, &tree(vec![stored, number]));
    let (_, map) = made.program.unwrap();
    let places = map.steps.iter().map(|step| (step.line, step.column));
    let starts = Lines::new(text);
    let wanted = ["I1", "I2", "Q1", "Q1", "D1", "ADD 5"].map(|word| {
        let (line, column) = starts.place(text, at(word).start);
        (line as usize, column as usize)
    });
    let places: Vec<(usize, usize)> = places.collect();
    // The rung that begins for the number comes from its statement.
    assert_eq!(places[..3], wanted[..3], "{places:?}");
    assert!(
        places.contains(&wanted[4]) && places.contains(&wanted[5]),
        "{places:?}"
    );
    assert_eq!(places.last(), Some(&(6, 4)), "{places:?}");
}
