//! Nothing of a text is found twice.

use unoclp_checked::Work;
use unoclp_core::Board;
use unoclp_draw::edit::{Coil, Document, Draft, Editor, Emitted, Operation, Place};
use unoclp_point::Address;
use unoclp_program::Written;
use unoclp_program::drawn::WriteAs;
use unoclp_workspace::Workspace;

fn list(text: &str) -> Written {
    Written::new("a.il".to_owned(), text.into(), Board::UNO)
}

#[test]
fn a_text_is_compiled_once_however_much_is_asked_of_it() {
    let mut workspace = Workspace::default();
    let before = Work::done();
    let version = workspace.set_text(list("LD I1\nST Q1\n"));
    for _ in 0..2 {
        assert_eq!(workspace.set_text(list("LD I1\nST Q1\n")), version);
        let analysis = workspace.analysis(version).unwrap();
        assert!(analysis.check().unwrap().is_ok());
        assert_eq!(analysis.map().unwrap().steps.len(), 2);
        assert!(analysis.code().unwrap().starts_with(b"0 "));
        assert_eq!(analysis.ladder().unwrap().rungs.len(), 1);
        assert_eq!(analysis.document().unwrap().rungs().len(), 1);
        assert!(analysis.uses().unwrap().inputs.contains(&1));
        assert!(!analysis.colours().is_empty() && !analysis.is_blank());
    }
    let work = Work::since(before);
    assert_eq!((work.compiles, work.passes), (1, 1));
}

#[test]
fn another_text_name_or_board_is_another_version() {
    let mut workspace = Workspace::default();
    let first = workspace.set_text(list("LD I1\nST Q1\n"));
    let mut others = vec![
        list("LD I2\nST Q1\n"),
        list("LD I1\nST Q1\n"),
        list("LD I1\nST Q1\n"),
    ];
    others[1].name = "b.il".to_owned();
    others[2].board = Board::PC;
    for other in others {
        assert_ne!(workspace.set_text(other), first);
    }
    assert_eq!(workspace.set_text(list("LD I1\nST Q1\n")), first);
}

#[test]
fn what_was_asked_for_last_is_kept() {
    let mut workspace = Workspace::default();
    let first = workspace.set_text(list("LD I1\nST Q1\n"));
    let second = workspace.set_text(list("LD I2\nST Q1\n"));
    for number in 1..8 {
        assert!(workspace.analysis(first).is_some());
        workspace.set_text(list(&format!("LD M{number}\nST Q1\n")));
    }
    assert!(workspace.analysis(first).is_some());
    assert!(workspace.analysis(second).is_none());
}

#[test]
fn a_drawing_is_compiled_once_and_its_text_is_a_version() {
    let mut editor = Editor::new(Document::new());
    let contact = Draft::contact(Some(Address::Input(1)), false).unwrap();
    let coil = Draft::coil(Some(Address::Output(1)), Coil::Normal).unwrap();
    editor
        .apply(&Operation::Insert(contact, Place::Behind))
        .unwrap();
    let mut workspace = Workspace::default();
    let mut set = |editor: &Editor| {
        let before = Work::done();
        let emitted = Emitted::of(editor.document());
        let version = workspace.set_drawing(&emitted, "a.il", WriteAs::Il, Board::UNO);
        let work = Work::since(before);
        let text = version.map(|version| workspace.analysis(version).unwrap().written().text());
        (text, work)
    };
    editor
        .apply(&Operation::Insert(coil, Place::Behind))
        .unwrap();
    let (text, work) = set(&editor);
    assert_eq!(text, Ok("LD    I1\nST    Q1\n".to_owned()));
    assert_eq!((work.emissions, work.compiles, work.passes), (1, 1, 1));
    let (again, work) = set(&editor);
    assert_eq!(again, text);
    assert_eq!((work.compiles, work.passes), (0, 0));
    // What is no program yet is not compiled; the loader says what is wrong with it.
    let open = Draft::contact(None, false).unwrap();
    editor
        .apply(&Operation::Insert(open, Place::Before))
        .unwrap();
    let (text, work) = set(&editor);
    assert_eq!(text.unwrap_err().len(), 1);
    assert_eq!((work.emissions, work.compiles, work.passes), (1, 0, 1));
}
