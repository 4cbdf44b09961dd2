//! A text of another PLC with its points on this board.
//!
//! Owns which point goes where: those that the board lacks take free ones of their kind, by order of use. Must not know
//! what the text does with them; nothing else of it is touched.

use crate::TextLanguage;
use crate::colour::Colour;
use crate::colours::colours;
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

/// Languages whose points can be told by how they are written.
const ADAPTED: [TextLanguage; 3] = [TextLanguage::St, TextLanguage::Scl, TextLanguage::Il];

/// The text with a free point of this board in the place of each that the board lacks; none in a language whose points are
/// names of its own.
pub fn adapt(text: &str, language: TextLanguage, board: Board) -> Option<Adapted> {
    if !ADAPTED.contains(&language) {
        return None;
    }
    let adapted = adapt_at(text, &written_points(text, language), board);
    let table = adapted.table();
    let table = match table.is_empty() {
        true => table,
        false => format!("(* unoclp adapt, {}:\n{table}*)\n", board.name),
    };
    Some(Adapted {
        text: table + &adapted.text,
        ..adapted
    })
}

/// Where points stand that no board has: where none has a firmware, they are those of nobody's pins. By what is written, in
/// capitals and without blanks.
pub fn moved(text: &str, language: TextLanguage, board: Board) -> HashMap<String, String> {
    if board.has_firmware() || !ADAPTED.contains(&language) {
        return HashMap::new();
    }
    let adapted = adapt_at(text, &written_points(text, language), board);
    adapted.moved.into_iter().collect()
}

/// Where a text in one of these languages writes points.
pub fn written_points(text: &str, language: TextLanguage) -> Vec<Range<usize>> {
    let points = colours(text, language).into_iter();
    points
        .filter(|(_, colour)| *colour == Colour::Point)
        .map(|(span, _)| span.range())
        .collect()
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
/// stands at such a place and names no point stays.
pub fn adapt_at(text: &str, points: &[Range<usize>], board: Board) -> Adapted {
    let keys: Vec<String> = points
        .iter()
        .map(|place| text.get(place.clone()).unwrap_or_default())
        .map(|written| written.to_uppercase().split_whitespace().collect())
        .collect();
    let whole = |key| read(key, Maker::Iec);
    let mut places = Places::new(keys.iter().filter_map(|key| whole(key)), board);
    let (mut adapted, mut behind) = (String::with_capacity(text.len()), 0);
    for (place, key) in points.iter().zip(&keys) {
        // `%MW0.1`: a word within another.
        let part = || key.split_once('.').and_then(|(word, _)| whole(word));
        let new = match whole(key) {
            Some(written) => places.place(&written, written.number, key),
            None => part().and_then(|written| places.place(&written, None, key)),
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

#[cfg(test)]
mod tests {
    use super::*;

    fn adapted(text: &str) -> Adapted {
        adapt(text, TextLanguage::St, Board::UNO).unwrap()
    }

    #[test]
    fn points_that_lack_take_free_ones_by_order_of_use() {
        let made = adapted(
            "VAR a AT %QX1.3 : BOOL; b AT %QX0.0 : BOOL; END_VAR\na := %IX2.0 AND %qx1.3; (* %QX9.9 *)\n",
        );
        let moved = [("%QX1.3", "%QX0.1"), ("%IX2.0", "%IX0.0")];
        assert_eq!(made.moved, moved.map(|(a, b)| (a.to_owned(), b.to_owned())));
        let text = "(* unoclp adapt, UNO:\n   %QX1.3 -> %QX0.1\n   %IX2.0 -> %IX0.0\n*)\n\
                    VAR a AT %QX0.1 : BOOL; b AT %QX0.0 : BOOL; END_VAR\na := %IX0.0 AND %QX0.1; (* %QX9.9 *)\n";
        assert_eq!(made.text, text);
        assert!(made.left.is_empty());
    }

    #[test]
    fn a_pin_is_given_once() {
        // PWM 01 has the pin of output 01, A 00 that of input 05.
        let made = adapted(
            "x := %QX0.0; y := %QW0; z := %IW0; a := %IX5.0; b := %IX5.1; c := %IX5.2; d := %IX5.3; e := %IX5.4;",
        );
        let places: Vec<&str> = made.moved.iter().map(|(_, new)| new.as_str()).collect();
        assert_eq!(
            places,
            ["%QW4", "%IX0.0", "%IX0.1", "%IX0.2", "%IX0.3", "%IX0.5"]
        );
    }

    #[test]
    fn what_finds_no_place_stays_and_is_told() {
        let made = adapted(
            "a := %QX1.0; b := %QX1.1; c := %QX1.2; d := %QX1.3; e := %QX1.4; f := %QX1.4;",
        );
        assert_eq!(made.left, ["%QX1.4"]);
        assert!(made.text.ends_with("e := %QX1.4; f := %QX1.4;"));
    }

    #[test]
    fn a_text_that_lacks_nothing_stays_as_it_is() {
        let text = "VAR a AT %QX0.0 : BOOL; END_VAR\na := NOT a;\n";
        assert_eq!(adapted(text).text, text);
        assert_eq!(adapt(text, TextLanguage::Lce, Board::UNO), None);
    }
}
