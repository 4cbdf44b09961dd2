//! The points of a board by name: those of its program, and those that every board has.
//!
//! Owns which addresses hold a point of a name, and how long the name holds. Must not know how a board is read.

use unoclp_client::AT_A_LINE;
use unoclp_client::diagnostics::Kept;
use unoclp_core::Board;
use unoclp_lang::typed::Width;
use unoclp_modbus::Table;
use unoclp_modbus::map::{Span, Width as Takes, coil, discrete, holding, input};
use unoclp_point::Address;
use unoclp_program::{Holding, Source, point_names};

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The table.
    pub table: Table,
    /// Its first address.
    pub first: u16,
    /// What it takes.
    pub width: Takes,
}

impl Place {
    /// The value with this number in a span, from 0.
    fn of(span: Span, index: u16) -> Option<Place> {
        let width = span.width;
        let each = match width {
            Takes::Bit | Takes::Word => 1,
            Takes::Long => 2,
        };
        (index < span.values).then_some(Place {
            table: span.table,
            first: span.first + each * index,
            width,
        })
    }

    /// Its addresses: the first, and the one after the last.
    pub fn addresses(self) -> std::ops::Range<u16> {
        let each = match self.width {
            Takes::Bit | Takes::Word => 1,
            Takes::Long => 2,
        };
        self.first..self.first + each
    }
}

/// How the words of a place make its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 0 or 1, or a number without a sign.
    Unsigned,
    /// A number with a sign.
    Signed,
    /// IEEE 754 single.
    Real,
}

/// A point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// What it is called.
    pub name: String,
    /// How its value is read.
    pub kind: Kind,
    /// Where its value is read.
    pub read: Place,
    /// Where it is written; nowhere, if it cannot be.
    pub write: Vec<Place>,
}

/// The points of a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Points {
    /// What the board has.
    pub board: Board,
    /// How a board keeps the program that gives the names: while it keeps another, none of them holds.
    pub program: Option<Kept>,
    /// Those that the program names.
    pub named: Vec<Point>,
}

impl Default for Points {
    /// Those of a board without a program, of the kind that one is taken for.
    fn default() -> Points {
        Points::alone(AT_A_LINE)
    }
}

impl Points {
    /// Those of a board without a program.
    pub fn alone(board: Board) -> Points {
        Points {
            board,
            program: None,
            named: Vec::new(),
        }
    }

    /// Those of a board that runs this program.
    pub fn of(source: &Source) -> Points {
        let used = &source.size.used;
        let board = &source.board();
        // Whatever a text calls it, the program computes with it as a REAL.
        let is_real = |point: &Point| {
            let registers = used
                .reals
                .iter()
                .filter_map(|&register| at(board, Address::Register(register)));
            registers
                .map(|real| real.read)
                .any(|read| read == point.read)
        };
        let mut named: Vec<Point> = Vec::new();
        let mut add = |name: &str, own: Option<Point>| {
            let is_new = !named.iter().any(|point| point.name == name);
            if let Some(own) = own.filter(|_| is_new) {
                let kind = if is_real(&own) { Kind::Real } else { own.kind };
                let name = name.to_owned();
                named.push(Point { name, kind, ..own });
            }
        };
        for variable in &source.variables {
            if let Holding::One((address, base)) = variable.holding {
                let kind = match base.width() {
                    Width::Single => Kind::Real,
                    Width::Bit | Width::Unsigned => Kind::Unsigned,
                    _ => Kind::Signed,
                };
                add(
                    &variable.name,
                    at(board, address).map(|point| Point { kind, ..point }),
                );
            }
        }
        for (own_name, name) in &point_names(source) {
            add(name, own(board, own_name));
        }
        named.sort_by(|a, b| a.name.cmp(&b.name));
        Points {
            board: *board,
            program: Some(Kept::of(source.program())),
            named,
        }
    }

    /// What is recorded of a board: what its program names while it keeps that program, else what every board has.
    pub fn recorded(&self, keeps_program: bool) -> Vec<Point> {
        match keeps_program && !self.named.is_empty() {
            true => self.named.clone(),
            false => {
                let board = &self.board;
                let inputs = (1..=board.inputs).map(|n| format!("I{n}"));
                let outputs = (1..=board.outputs).map(|n| format!("Q{n}"));
                let analogue = (0..board.analogue).map(|n| format!("A{n}"));
                let names = inputs.chain(outputs).chain(analogue);
                names.filter_map(|name| own(board, &name)).collect()
            }
        }
    }

    /// The point of this name in the program.
    pub fn named(&self, name: &str) -> Option<&Point> {
        let is = |point: &&Point| point.name.eq_ignore_ascii_case(name);
        self.named.iter().find(is)
    }
}

/// The point that this board calls so: `I1`, `Q1`, `M1`, `A0`, `D1`; `T1` and `C1`, which are read as what has elapsed or
/// been counted, and written as the preset.
pub(crate) fn own(board: &Board, name: &str) -> Option<Point> {
    // Lower case is left to names of a program.
    let written = name.starts_with(|first: char| first.is_ascii_uppercase());
    let address = match Address::parse(name).filter(|_| written)? {
        Address::Timer(number) => Address::Elapsed(number),
        Address::Counter(number) => Address::Count(number),
        other => other,
    };
    at(board, address)
}

/// What stands at an address, by its own name; none of what this board does not tell.
fn at(board: &Board, address: Address) -> Option<Point> {
    let (read, write): (_, &[Span]) = match address {
        Address::Input(_) => (discrete::INPUTS, &[]),
        Address::Output(_) => (coil::OUTPUTS, &[coil::OUTPUTS]),
        Address::Marker(_) => (coil::MARKERS, &[coil::MARKERS]),
        Address::Analogue(_) => (input::ANALOGUE, &[]),
        // The first of them stand in two rows.
        Address::Register(_) => {
            let write = &[holding::REGISTERS, holding::FIRST_REGISTERS];
            (holding::REGISTERS, write)
        }
        Address::Elapsed(_) => (input::TIMERS, &[holding::TIMERS]),
        Address::Count(_) => (input::COUNTERS, &[holding::COUNTERS]),
        _ => return None,
    };
    let index = match address {
        Address::Analogue(number) => number.into(),
        _ => u16::from(address.number()).checked_sub(1)?,
    };
    let is_number = matches!(address, Address::Register(_) | Address::Count(_));
    Some(Point {
        kind: match is_number {
            true => Kind::Signed,
            false => Kind::Unsigned,
        },
        name: address.to_string(),
        read: Place::of(read.on(board), index)?,
        write: write
            .iter()
            .filter_map(|&span| Place::of(span.on(board), index))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_program::Written;

    fn points(name: &str, text: &str) -> Points {
        let written = Written::new(name.to_owned(), text.as_bytes().to_vec(), AT_A_LINE);
        Points::of(&written.check(None).expect("it is right"))
    }

    #[test]
    fn each_board_has_its_own_names() {
        for (name, table, first, writes) in [
            ("I8", Table::DiscreteInputs, 7, &[][..]),
            ("Q1", Table::Coils, 0, &[0]),
            ("M64", Table::Coils, 79, &[79]),
            ("A0", Table::InputRegisters, 0, &[]),
            ("D1", Table::HoldingRegisters, 2000, &[2000, 0]),
            ("D98", Table::HoldingRegisters, 2194, &[2194]),
            ("T2", Table::InputRegisters, 130, &[130]),
            ("C1", Table::InputRegisters, 320, &[320]),
        ] {
            let point = own(&AT_A_LINE, name).expect(name);
            assert_eq!(
                (point.read.table, point.read.first),
                (table, first),
                "{name}"
            );
            let firsts: Vec<u16> = point.write.iter().map(|place| place.first).collect();
            assert_eq!(firsts, writes, "{name}");
        }
        for name in [
            "", "I0", "I9", "Q5", "M65", "A5", "D99", "D0", "X1", "Q", "Q1x", "é1", "Q256",
        ] {
            assert_eq!(own(&AT_A_LINE, name), None, "{name}");
        }
    }

    #[test]
    fn a_mega_has_more_of_them() {
        for (name, table, first) in [
            ("I24", Table::DiscreteInputs, 23),
            ("Q16", Table::Coils, 15),
            ("M1", Table::Coils, 16),
            ("A7", Table::InputRegisters, 7),
        ] {
            let point = own(&Board::MEGA, name).expect(name);
            let place = (point.read.table, point.read.first);
            assert_eq!(place, (table, first), "{name}");
        }
        for name in ["I25", "Q17", "A8"] {
            assert_eq!(own(&Board::MEGA, name), None, "{name}");
        }
        let own = Points::alone(Board::MEGA).recorded(false);
        assert_eq!(own.len(), 24 + 16 + 8);
        let text = "LD I24\nST Q16\n".as_bytes().to_vec();
        let of_mega = Written::new("far.il".to_owned(), text, Board::MEGA);
        let points = Points::of(&of_mega.check(None).expect("it is right"));
        assert_eq!(points.board, Board::MEGA);
    }

    #[test]
    fn a_program_names_its_points_in_every_language() {
        let list =
            "VAR start AT %IX0.0 : BOOL; lamp AT %QX0.0 : BOOL; END_VAR\nLD start\nST lamp\n";
        let text = "PROGRAM p VAR start AT %IX0.0 : BOOL; lamp AT %QX0.0 : BOOL; setpoint : DINT; END_VAR\n\
            lamp := start AND setpoint > 5; setpoint := setpoint + 1; END_PROGRAM\n";
        for (file, text) in [("p.il", list), ("p.st", text)] {
            let points = points(file, text);
            let start = points.named("START").expect("names have no case");
            assert_eq!(
                (start.read.table, start.read.first),
                (Table::DiscreteInputs, 0)
            );
            assert!(start.write.is_empty());
            assert_eq!(points.named("lamp").expect("lamp").write.len(), 1, "{file}");
            assert!(points.program.is_some());
        }
        let points = points("p.st", text);
        let setpoint = points.named("setpoint").expect("setpoint");
        assert_eq!(setpoint.read.table, Table::HoldingRegisters);
        assert_eq!(setpoint.write.len(), 2);
        assert_eq!(setpoint.kind, Kind::Signed);
    }

    #[test]
    fn a_real_is_told_from_an_integer() {
        for at in ["", " AT %MD1"] {
            let text = format!(
                "PROGRAM p VAR level{at} : REAL; count : DINT; END_VAR \
                 level := level + 0.5; count := count + 1; END_PROGRAM\n"
            );
            let points = points("p.st", &text);
            let kind = |name| points.named(name).expect(name).kind;
            assert_eq!(
                [kind("level"), kind("count")],
                [Kind::Real, Kind::Signed],
                "{at}"
            );
        }
    }

    #[test]
    fn what_is_recorded_are_the_names_while_they_hold() {
        let points = points(
            "p.il",
            "VAR lamp AT %QX0.0 : BOOL; END_VAR\nLD I1\nST lamp\n",
        );
        let names = |holds| -> Vec<String> {
            let recorded = points.recorded(holds).into_iter();
            recorded.map(|point| point.name).collect()
        };
        assert_eq!(names(true), ["lamp"]);
        let own = names(false);
        assert_eq!(own.len(), 17);
        assert!(
            ["I1", "I8", "Q4", "A0", "A4"]
                .iter()
                .all(|name| own.contains(&(*name).to_owned()))
        );
    }

    #[test]
    fn a_program_without_names_has_a_check_sum() {
        let points = points("p.txt", "0\n787600\n827301\n877901\n");
        assert_eq!(points.named, []);
        assert_eq!(points.program.expect("it is kept").bytes, 3);
    }
}
