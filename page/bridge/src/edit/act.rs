//! What may be done to a drawing, as a request gives it.

use crate::ask::{OrNull, said};
use crate::given::Given;
use crate::program::written;
use crate::words::{No, both};
use unoclp_core::Board;
use unoclp_draw::edit::{Along, Coil, Cursor, Direction, Edge, Id, Operation, Place, Row, Way};
use unoclp_edit::{Amiss, Field, no_address};
use unoclp_point::Address;
use unoclp_program::Written;

/// What may be done.
pub enum Act {
    /// What the editor does as it is.
    Do(Operation),
    /// Moves the cursor.
    Move(Direction),
    /// Selects what stands around the cursor.
    Out,
    /// Inserts an element of the palette at the cursor.
    Insert(String, Place),
    /// Inserts it at something else.
    Put(String, Id, Place),
    /// Changes the fields of the element at the cursor; a person who is sure is not asked.
    Edit(Vec<Field>, bool),
    /// Says what a point is called and what it is for; likewise.
    Name(Address, Row, bool),
    /// Another text.
    Text(Written),
    Undo,
    Redo,
}

impl Act {
    /// As a request gives it.
    ///
    /// # Errors
    /// Where there is no such act, or it lacks something.
    pub fn of(mut given: Given, board: Board) -> Result<Act, No> {
        acts::read(&mut given, board)
    }
}

said! {
    /// What may be done to a drawing.
    pub mod acts as "Act";
    (board: Board) -> Act;
    "undo" {} => Act::Undo;
    "redo" {} => Act::Redo;
    /// Selects what stands around the cursor.
    "out" {} => Act::Out;
    "move" { to: Direction } => Act::Move(to);
    "select" { from: Id, to: Id } => Act::Do(Operation::Select(Cursor { from, to }));
    "extend" { along: Along } => Act::Do(Operation::Extend(along));
    /// Inserts an element of the palette at the cursor.
    "insert" { what: String, place: Place } => Act::Insert(what, place);
    /// Inserts it at something else.
    "put" { what: String, at: Id, place: Place } => Act::Put(what, at, place);
    "branch" {} => Act::Do(Operation::Branch);
    "stretch" { along: Along, out: Way } => Act::Do(Operation::Stretch(along, out));
    "delete" {} => Act::Do(Operation::Delete);
    "copy" {} => Act::Do(Operation::Copy);
    "cut" {} => Act::Do(Operation::Cut);
    "paste" { place: Place } => Act::Do(Operation::Paste(place));
    "carry" { at: Id, place: Place } => Act::Do(Operation::Carry(at, place));
    "toggle" {} => Act::Do(Operation::Toggle);
    "edge" { edge: OrNull<Edge> } => Act::Do(Operation::Edge(edge.0));
    "coil" { coil: Coil } => Act::Do(Operation::Coil(coil));
    "insertRung" { along: Along } => Act::Do(Operation::InsertRung(along));
    "moveRung" { along: Along } => Act::Do(Operation::MoveRung(along));
    "split" {} => Act::Do(Operation::Split);
    "join" {} => Act::Do(Operation::Join);
    /// Changes the fields of the element at the cursor; a person who is sure is not asked.
    "edit" { fields: Vec<Field>, sure: Option<bool> } => Act::Edit(fields, sure.unwrap_or_default());
    /// Says what a point is called and what it is for; likewise.
    "name" { point: String, name: String, comment: String, sure: Option<bool> } => {
        let none = || Amiss::from(both(|lang| no_address(lang, &point)));
        let point = Address::parse(&point).ok_or_else(|| none().at("point", Vec::new()))?;
        Act::Name(point, Row { name, comment }, sure.unwrap_or_default())
    };
    "comment" { text: String } => Act::Do(Operation::Comment(lines(&text)));
    "title" { text: String } => Act::Do(Operation::Title(lines(&text)));
    /// Another text in place of this one.
    "text" { name: String, text: String } => Act::Text(written(name, text, board)?);
}

fn lines(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| line.trim().to_owned());
    lines.filter(|line| !line.is_empty()).collect()
}
