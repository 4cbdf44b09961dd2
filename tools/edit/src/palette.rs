//! The elements that can be inserted.

use crate::Amiss;
use crate::words as say;
use serde::Serialize;
use unoclp_core::isa::{Class, Opcode};
use unoclp_draw::edit::{Coil, Draft, Edge, Operation, Place, Step};
use unoclp_draw::picture;
use unoclp_words::{Both, Lang, both};

/// What a person calls something.
type Say = fn(Lang) -> String;

/// An element of the palette.
struct Item {
    /// What a request calls it.
    id: &'static str,
    /// What a person calls it.
    name: Say,
    /// The key that inserts it.
    key: &'static str,
    /// What is on its button.
    face: &'static str,
    group: Group,
    what: What,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    Contacts,
    Coils,
    Timers,
    Counters,
    Comparisons,
    Arithmetic,
}

/// What is inserted.
#[derive(Clone, Copy)]
enum What {
    Contact { closed: bool },
    Change(Edge),
    Coil(Coil),
    Counter { down: bool },
    Step(Opcode),
}

macro_rules! items {
    ($($group:ident: $id:literal $name:ident $key:literal $face:literal $what:expr;)*) => {
        &[$(Item { id: $id, name: say::$name, key: $key, face: $face, group: Group::$group, what: $what },)*]
    };
}

/// In the order in which they are shown. The keys are those of LDmicro where it has some.
const ITEMS: &[Item] = items! {
    Contacts: "contact" contact "c" "┤ ├" What::Contact { closed: false };
    Contacts: "closed" closed "k" "┤/├" What::Contact { closed: true };
    Contacts: "rising" rising "/" "┤P├" What::Change(Edge::Rising);
    Contacts: "falling" falling "\\" "┤N├" What::Change(Edge::Falling);
    Contacts: "not" not "!" "┤NOT├" What::Step(Opcode::Not);
    Coils: "coil" coil "l" "( )" What::Coil(Coil::Normal);
    Coils: "negated" negated "" "(/)" What::Coil(Coil::Negated);
    Coils: "set" set "" "(S)" What::Coil(Coil::Set);
    Coils: "reset" reset "" "(R)" What::Coil(Coil::Reset);
    Timers: "ton" ton "o" "TON" What::Step(Opcode::OnDelay);
    Timers: "tof" tof "f" "TOF" What::Step(Opcode::OffDelay);
    Timers: "tp" tp "y" "TP" What::Step(Opcode::Pulse);
    Timers: "tonr" tonr "t" "TONR" What::Step(Opcode::RetentiveOnDelay);
    Counters: "ctu" ctu "u" "CTU" What::Counter { down: false };
    Counters: "ctd" ctd "i" "CTD" What::Counter { down: true };
    Comparisons: "gt" gt ">" ">" What::Step(Opcode::Greater);
    Comparisons: "ge" ge "." "≥" What::Step(Opcode::GreaterOrEqual);
    Comparisons: "eq" eq "=" "=" What::Step(Opcode::Equal);
    Comparisons: "ne" ne "#" "≠" What::Step(Opcode::NotEqual);
    Comparisons: "le" le "," "≤" What::Step(Opcode::LessOrEqual);
    Comparisons: "lt" lt "<" "<" What::Step(Opcode::Less);
    Arithmetic: "value" value "v" "LD" What::Step(Opcode::Load);
    Arithmetic: "add" add "+" "+" What::Step(Opcode::Add);
    Arithmetic: "sub" sub "-" "−" What::Step(Opcode::Subtract);
    Arithmetic: "mul" mul "*" "×" What::Step(Opcode::Multiply);
    Arithmetic: "div" div "d" "÷" What::Step(Opcode::Divide);
    Arithmetic: "mod" modulo "%" "MOD" What::Step(Opcode::Modulo);
    Arithmetic: "store" store "m" "ST" What::Step(Opcode::Store);
};

/// A group of the palette.
#[derive(Debug, Serialize)]
pub struct Shelf {
    /// What a person calls it.
    pub name: Both,
    /// Its elements.
    pub items: Vec<Entry>,
}

/// An element of the palette.
#[derive(Debug, Serialize)]
pub struct Entry {
    /// What [`insertion`] takes.
    pub id: String,
    /// What a person calls it.
    pub name: Both,
    /// The key that inserts it; empty without one.
    pub key: String,
    /// What is on its button.
    pub face: String,
}

/// All that can be inserted; the last group has what no other has.
pub fn palette() -> Vec<Shelf> {
    let groups: [(Group, Say); 6] = [
        (Group::Contacts, say::contacts),
        (Group::Coils, say::coils),
        (Group::Timers, say::timers),
        (Group::Counters, say::counters),
        (Group::Comparisons, say::comparisons),
        (Group::Arithmetic, say::arithmetic),
    ];
    let offer = |item: &Item| Entry {
        id: item.id.to_owned(),
        name: both(item.name),
        key: item.key.to_owned(),
        face: item.face.to_owned(),
    };
    let shelf = |(group, name): &(Group, Say)| Shelf {
        name: both(name),
        items: ITEMS
            .iter()
            .filter(|item| item.group == *group)
            .map(offer)
            .collect(),
    };
    let mut shelves: Vec<Shelf> = groups.iter().map(shelf).collect();
    shelves.push(Shelf {
        name: both(say::others),
        items: Opcode::ALL
            .iter()
            .filter(|opcode| is_other(**opcode))
            .map(other)
            .collect(),
    });
    shelves
}

fn other(opcode: &Opcode) -> Entry {
    let letters = opcode.row().letters;
    let name = format!("{letters}: {}", picture(*opcode));
    Entry {
        id: format!("op:{letters}"),
        name: both(|_| name.clone()),
        key: String::new(),
        face: letters.to_owned(),
    }
}

/// Whether it is an element, and no other group has it or what it becomes with another point.
fn is_other(opcode: Opcode) -> bool {
    let is_wire = match opcode.class() {
        Class::Rung | Class::Label | Class::Part | Class::Close => true,
        Class::StorePoint | Class::RecallPoint | Class::Timer | Class::Count => true,
        Class::Contact | Class::Coil => true,
        class => class.opens(),
    };
    let has = |item: &Item| matches!(item.what, What::Step(own) if own == opcode);
    !is_wire && !ITEMS.iter().any(has)
}

/// What has to be done to insert this.
///
/// # Errors
/// Where the palette has no such element.
pub fn insertion(id: &str, place: Place) -> Result<Vec<Operation>, Amiss> {
    let none = || Amiss::from(both(|lang| say::no_element(lang, id)));
    let what = match id.strip_prefix("op:") {
        Some(letters) => {
            let named = |opcode: &&Opcode| opcode.row().letters == letters && is_other(**opcode);
            What::Step(*Opcode::ALL.iter().find(named).ok_or_else(none)?)
        }
        None => {
            ITEMS
                .iter()
                .find(|item| item.id == id)
                .ok_or_else(none)?
                .what
        }
    };
    let insert = |draft| Operation::Insert(draft, place);
    Ok(match what {
        What::Contact { closed } => vec![insert(Draft::contact(None, closed)?)],
        What::Change(edge) => vec![
            insert(Draft::contact(None, false)?),
            Operation::Edge(Some(edge)),
        ],
        What::Coil(coil) => vec![insert(Draft::coil(None, coil)?)],
        What::Counter { down } => vec![insert(Draft::counter(down, None, None))],
        What::Step(opcode) if opcode.class() == Class::Comparison => {
            let load = Some(Step::new(Opcode::Load));
            let step = Step::new(opcode).with_number(0);
            vec![insert(Draft::comparison(load, step)?)]
        }
        What::Step(opcode) if opcode.row().kind.is_value() => {
            vec![insert(Step::new(opcode).with_number(0).into())]
        }
        What::Step(opcode) => vec![insert(Step::new(opcode).into())],
    })
}
