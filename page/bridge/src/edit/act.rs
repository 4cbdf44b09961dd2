//! What may be done to a drawing, as a request gives it.

use crate::given::{Given, wrong};
use crate::program::written;
use crate::words::{Both, No, both};
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
        let what = given.text("do")?;
        Ok(Act::Do(match what.as_str() {
            "undo" => return Ok(Act::Undo),
            "redo" => return Ok(Act::Redo),
            "out" => return Ok(Act::Out),
            "move" => return Ok(Act::Move(direction(&mut given)?)),
            "text" => {
                let (name, text) = (given.text("name")?, given.text("text")?);
                return Ok(Act::Text(written(name, text, board)?));
            }
            "insert" => return Ok(Act::Insert(given.text("what")?, place(&mut given)?)),
            "put" => {
                let (what, at) = (given.text("what")?, id(&mut given, "at")?);
                return Ok(Act::Put(what, at, place(&mut given)?));
            }
            "edit" => {
                let sure = given.truth_if("sure")?.unwrap_or_default();
                return Ok(Act::Edit(fields(&mut given)?, sure));
            }
            "name" => {
                let point = given.text("point")?;
                let none = || Amiss::from(both(|lang| no_address(lang, &point)));
                let point = Address::parse(&point).ok_or_else(|| none().at("point", Vec::new()))?;
                let row = Row {
                    name: given.text("name")?,
                    comment: given.text("comment")?,
                };
                let sure = given.truth_if("sure")?.unwrap_or_default();
                return Ok(Act::Name(point, row, sure));
            }
            "select" => Operation::Select(Cursor {
                from: id(&mut given, "from")?,
                to: id(&mut given, "to")?,
            }),
            "extend" => Operation::Extend(along(&mut given)?),
            "branch" => Operation::Branch,
            "stretch" => {
                let way = match given.truth("out")? {
                    true => Way::Out,
                    false => Way::In,
                };
                Operation::Stretch(along(&mut given)?, way)
            }
            "delete" => Operation::Delete,
            "copy" => Operation::Copy,
            "cut" => Operation::Cut,
            "paste" => Operation::Paste(place(&mut given)?),
            "carry" => Operation::Carry(id(&mut given, "at")?, place(&mut given)?),
            "toggle" => Operation::Toggle,
            "edge" => Operation::Edge(edge(&mut given)?),
            "coil" => Operation::Coil(coil(&mut given)?),
            "insertRung" => Operation::InsertRung(along(&mut given)?),
            "moveRung" => Operation::MoveRung(along(&mut given)?),
            "split" => Operation::Split,
            "join" => Operation::Join,
            "comment" => Operation::Comment(lines(&given.text("text")?)),
            "title" => Operation::Title(lines(&given.text("text")?)),
            other => return Err(wrong(other).into()),
        }))
    }
}

fn fields(given: &mut Given) -> Result<Vec<Field>, Both> {
    let fields = given.list("fields")?.into_iter();
    let field = |value| {
        let mut given = Given::of(value).ok_or_else(|| wrong("fields"))?;
        Ok(Field {
            key: given.text("key")?,
            value: given.text("value")?.trim().to_owned(),
        })
    };
    fields.map(field).collect()
}

fn lines(text: &str) -> Vec<String> {
    let lines = text.lines().map(|line| line.trim().to_owned());
    lines.filter(|line| !line.is_empty()).collect()
}

fn id(given: &mut Given, key: &str) -> Result<Id, Both> {
    given.number(key).map(Id)
}

fn along(given: &mut Given) -> Result<Along, Both> {
    Ok(match given.text("along")?.as_str() {
        "back" => Along::Back,
        "forth" => Along::Forth,
        _ => return Err(wrong("along")),
    })
}

fn direction(given: &mut Given) -> Result<Direction, Both> {
    Ok(match given.text("to")?.as_str() {
        "left" => Direction::Left,
        "right" => Direction::Right,
        "up" => Direction::Up,
        "down" => Direction::Down,
        _ => return Err(wrong("to")),
    })
}

fn edge(given: &mut Given) -> Result<Option<Edge>, Both> {
    Ok(match given.text_if("edge")?.as_deref() {
        None => None,
        Some("rising") => Some(Edge::Rising),
        Some("falling") => Some(Edge::Falling),
        Some(_) => return Err(wrong("edge")),
    })
}

fn coil(given: &mut Given) -> Result<Coil, Both> {
    Ok(match given.text("coil")?.as_str() {
        "normal" => Coil::Normal,
        "negated" => Coil::Negated,
        "set" => Coil::Set,
        "reset" => Coil::Reset,
        "load" => Coil::Load,
        _ => return Err(wrong("coil")),
    })
}

/// Where a request says that something is inserted.
fn place(given: &mut Given) -> Result<Place, Both> {
    Ok(match given.text("place")?.as_str() {
        "before" => Place::Before,
        "behind" => Place::Behind,
        "beside" => Place::Beside,
        _ => return Err(wrong("place")),
    })
}
