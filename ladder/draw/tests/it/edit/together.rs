//! Several operations as one change, another document in place of this one, and what a cursor selects.

use unoclp_draw::edit::{Cursor, Document, Draft, Editor, Operation, Place, Refusal, Row};
use unoclp_point::Address;

fn contact(number: u8) -> Operation {
    let draft = Draft::contact(Some(Address::Input(number)), false).unwrap();
    Operation::Insert(draft, Place::Behind)
}

#[test]
fn operations_together_are_undone_together_and_refused_together() {
    let mut editor = Editor::new(Document::new());
    let begun = editor.state().clone();
    editor
        .apply_all(&[contact(1), contact(2), Operation::Toggle])
        .unwrap();
    assert_eq!(editor.document().codes().unwrap(), [0, 827_301, -827_302]);
    assert_eq!(editor.depth(), (1, 0));
    let refused = editor.apply_all(&[contact(3), Operation::Join]);
    assert_eq!(refused, Err(Refusal::CannotJoin));
    assert_eq!(editor.document().codes().unwrap(), [0, 827_301, -827_302]);
    editor.undo().unwrap();
    assert_eq!(*editor.state(), begun);
}

#[test]
fn what_changes_nothing_is_not_undone() {
    let mut editor = Editor::new(Document::new());
    editor.apply(&contact(1)).unwrap();
    editor.apply(&Operation::Comment(Vec::new())).unwrap();
    assert_eq!(editor.depth(), (1, 0));
}

#[test]
fn another_document_in_its_place_is_a_change() {
    let mut editor = Editor::new(Document::new());
    editor.apply_all(&[contact(1), Operation::Copy]).unwrap();
    let before = editor.document().clone();
    let row = Row {
        name: "start".to_owned(),
        comment: String::new(),
    };
    editor.replace(Document::new().with_rows([(Address::Input(1), row)]));
    assert_eq!(
        editor.document().table().point("start"),
        Some(Address::Input(1))
    );
    // What was copied before can still be pasted.
    editor.apply(&Operation::Paste(Place::Behind)).unwrap();
    assert_eq!(editor.document().codes().unwrap(), [0, 827_301]);
    editor.undo().unwrap();
    editor.undo().unwrap();
    assert_eq!(*editor.document(), before);
}

#[test]
fn a_cursor_selects_what_it_holds_and_something_stands_around_it() {
    let mut editor = Editor::new(Document::new());
    editor.apply_all(&[contact(1), Operation::Branch]).unwrap();
    let (document, path) = (editor.document(), editor.cursor().to);
    assert_eq!(document.within(editor.cursor()), [path]);
    let branch = document.around(path).unwrap();
    // The branch, its two paths, and the contact on the first.
    assert_eq!(document.within(Cursor::at(branch)).len(), 4);
    let rung = document.around(branch).unwrap();
    assert_eq!(document.position(rung), Some(0));
    assert_eq!(document.around(rung), None);
    assert_eq!(document.within(Cursor::at(rung)), [rung]);
}
