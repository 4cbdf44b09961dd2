//! What can be done to a document.

use super::cursor::Cursor;
use super::document::{Begin, Gate, Id};
use super::draft::Draft;
use super::table::Row;
use super::which::Coil;
use unoclp_point::Address;

/// What can be done to a document, at its cursor. The same operations in the same order always give the same document,
/// so a log of them can be made again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Selects something.
    Select(Cursor),
    /// Moves the cursor to the next thing in the drawing.
    Move(Direction),
    /// Moves the other end of what is selected along its series.
    Extend(Along),
    /// Inserts an element.
    Insert(Draft, Place),
    /// Opens an empty path beside what is selected.
    Branch,
    /// Moves an end of the branch around the cursor, or at it: its paths begin or end one node further out or in.
    Stretch(Along, Way),
    /// Deletes what is selected.
    Delete,
    /// Keeps a copy of what is selected.
    Copy,
    /// Likewise, and deletes it.
    Cut,
    /// Inserts what was copied.
    Paste(Place),
    /// Moves what is selected to this place at something else.
    Carry(Id, Place),
    /// Normally open becomes normally closed, and back; also of coils, comparisons, edges and jumps.
    Toggle,
    /// The contact acts when what it reads rises or falls, or as long as that lasts. The cursor then selects the edge
    /// with it, and changes both.
    Edge(Option<Edge>),
    /// What is selected becomes a block, whose result meets all that stands before it so.
    Enclose(Gate),
    /// What the selected block holds stands in its place, in series.
    Dissolve,
    /// The coil becomes this kind of coil.
    Coil(Coil),
    /// The element reads, writes or drives this point.
    Address(Option<Address>),
    /// An operand line of the element, from 0: the preset of a timer and what it drives, a constant.
    Line(usize, Option<i32>),
    /// The element becomes another one.
    Replace(Draft),
    /// The branch point of a store, a block or a parallel gets this number; of the last none leaves it open.
    Point(Option<u8>),
    /// Inserts an empty rung.
    InsertRung(Along),
    /// Moves what rungs are selected above the one before them, or below the one after them.
    MoveRung(Along),
    /// What stands after the cursor becomes a rung of its own.
    Split,
    /// The rung goes on with the one below it.
    Join,
    /// What the rung is about, line by line.
    Comment(Vec<String>),
    /// The labels at the head of the rung.
    Labels(Vec<u8>),
    /// The code that the rung begins with.
    Begin(Begin),
    /// What a point is called, and what it is for.
    Name(Address, Row),
    /// What the program is about, line by line.
    Title(Vec<String>),
}

/// Where to go in the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Towards the left rail.
    Left,
    /// Towards the right rail.
    Right,
    /// Towards the first rung.
    Up,
    /// Towards the last rung.
    Down,
}

/// Where something is inserted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Place {
    /// In series before what is selected; of a rung or path at its beginning, and of rungs above them.
    Before,
    /// In series after what is selected; of a rung at its end, of a path at its beginning, and of rungs below them.
    Behind,
    /// As a path beside what is selected.
    Beside,
}

/// One of two ways along a series or a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Along {
    /// To the beginning: left, or above.
    Back,
    /// To the end: right, or below.
    Forth,
}

/// Where an end of a branch moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Way {
    /// The branch takes in the node beside it.
    Out,
    /// It leaves out the outermost node of its first path.
    In,
}

/// A change that a contact waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Edge {
    /// From 0 to 1.
    Rising,
    /// From 1 to 0.
    Falling,
}
