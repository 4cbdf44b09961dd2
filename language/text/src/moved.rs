//! Points that a board lacks, and which of its own take their place.
//!
//! Owns which point goes where: those that the board lacks take free ones of their kind, by order of use. Must not know
//! what the text does with them; nothing else of it is touched.

use crate::points::{exists, range};
use std::collections::{BTreeSet, HashMap};
use std::ops::Range;
use unoclp_core::Board;
use unoclp_point::{Address, Kind, Maker, Written, read};

/// A text with its points on a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Adapted {
    /// The text, with a table of what went where as a comment before it.
    pub text: String,
    /// Each point that the board lacks and the one in its place, both as the text writes them, by order of use.
    pub moved: Vec<(String, String)>,
    /// Those for which the board has no place left.
    pub left: Vec<String>,
}

impl Adapted {
    /// What went where, a line each.
    pub fn table(&self) -> String {
        let moved = self.moved.iter();
        let lines = moved.map(|(old, new)| format!("   {old} -> {new}\n"));
        lines.collect()
    }
}

/// The text with a free point of this board in the place of each at these places that the board lacks, and no table. What
/// is at such a place and names no point stays.
pub fn adapt_at(text: &str, points: &[Range<usize>], board: Board) -> Adapted {
    let keys: Vec<String> = points
        .iter()
        .map(|place| text.get(place.clone()).unwrap_or_default())
        .map(|written| written.to_uppercase().split_whitespace().collect())
        .collect();
    fn whole(key: &str) -> Option<Written<'_>> {
        read(key, Maker::Iec)
    }
    let mut places = Places::new(keys.iter().filter_map(|key| whole(key)), board);
    let (mut adapted, mut behind) = (String::with_capacity(text.len()), 0);
    for (place, key) in points.iter().zip(&keys) {
        // `%MW0.1`, `%ID0.0.0`: one within another.
        let first = key.split_once('.').map(|(first, _)| first);
        let double = double_word(first.unwrap_or(key));
        let other = || double.as_deref().or(first).and_then(whole);
        let new = match whole(key) {
            Some(written) => places.place(&written, written.number, key),
            None => other().and_then(|written| places.place(&written, None, key)),
        };
        if let Some(new) = new {
            adapted.push_str(text.get(behind..place.start).unwrap_or_default());
            adapted.push_str(&new);
            behind = place.end;
        }
    }
    adapted.push_str(text.get(behind..).unwrap_or_default());
    Adapted {
        text: adapted,
        moved: places.moved,
        left: places.left,
    }
}

/// A register in the place of an input or output of 32 bits, which no board has: `%MD7` for `%QD7`.
fn double_word(key: &str) -> Option<String> {
    let digits = key
        .strip_prefix("%ID")
        .or_else(|| key.strip_prefix("%QD"))?;
    Some(format!("%MD{digits}"))
}

/// Which points of a board are free, and what has gone where.
struct Places {
    board: Board,
    used: BTreeSet<Address>,
    /// Those that the text names itself.
    named: BTreeSet<Address>,
    /// What a point is called now, by its kind and number; none where no place was left.
    known: HashMap<(Kind, Result<u16, String>), Option<u8>>,
    moved: Vec<(String, String)>,
    left: Vec<String>,
}

impl Places {
    /// Of a text that names these points.
    fn new<'t>(points: impl Iterator<Item = Written<'t>>, board: Board) -> Places {
        let named = points.filter_map(|written| written.address);
        let mut places = Places {
            board,
            used: BTreeSet::new(),
            named: BTreeSet::new(),
            known: HashMap::new(),
            moved: Vec::new(),
            left: Vec::new(),
        };
        for address in named.filter(|address| exists(*address, board)) {
            places.take(address);
            places.named.insert(address);
        }
        places
    }

    /// Takes a point, and the one with which it shares a pin.
    fn take(&mut self, address: Address) {
        self.used.insert(address);
        self.used.extend(self.beside(address));
    }

    /// The point that has the same pin.
    fn beside(&self, address: Address) -> Option<Address> {
        match address {
            Address::Analogue(number) => self.board.shares(number).map(Address::Input),
            Address::Pwm(number) => Some(Address::Output(number)),
            _ => None,
        }
    }

    /// What to write in the place of this point, which has this number; none where it stays as it is.
    fn place(&mut self, written: &Written, number: Option<u16>, key: &str) -> Option<String> {
        let kind = written.kind;
        let address = written.address.filter(|_| number.is_some());
        // Where no pin is shared, an output and a PWM are two, whatever their numbers.
        let is_shared = address.and_then(|one| self.beside(one)).is_some_and(|one| {
            !self.board.has_firmware() && kind == Kind::Pwm && self.named.contains(&one)
        });
        let is_there = address.is_some_and(|one| exists(one, self.board)) && !is_shared;
        let counted = range(kind, self.board).is_some() || kind == Kind::Pwm;
        if is_there || !counted || matches!(kind, Kind::System | Kind::Group) {
            return None;
        }
        let point = (kind, number.ok_or_else(|| key.to_owned()));
        let new = match self.known.get(&point) {
            Some(new) => *new,
            None => {
                let new = self.free(kind);
                self.known.insert(point, new);
                match new.and_then(|new| written.like(new.into())) {
                    Some(like) => self.moved.push((key.to_owned(), like)),
                    None => self.left.push(key.to_owned()),
                }
                new
            }
        };
        written.like(new?.into())
    }

    /// The first free point of a kind, which is free no longer.
    fn free(&mut self, kind: Kind) -> Option<u8> {
        let numbers: Vec<u8> = match range(kind, self.board) {
            Some((first, last)) => (first..=last).filter_map(|n| n.try_into().ok()).collect(),
            None => self.board.pwm_outputs().collect(),
        };
        let points = numbers.into_iter().map(|n| Address::new(kind, n));
        let is_free = |point: &Address| {
            let beside = self.beside(*point);
            !self.used.contains(point) && beside.is_none_or(|one| !self.used.contains(&one))
        };
        let point = points.into_iter().find(is_free)?;
        self.take(point);
        Some(point.number())
    }
}
