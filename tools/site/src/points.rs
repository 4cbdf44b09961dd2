//! The points of a board by name: those of its program, and those that every board has.
//!
//! Owns which addresses hold a point of a name, and how long the name holds. Must not know how a board is read.

use unoclp_client::diagnostics::Kept;
use unoclp_modbus::Table;
use unoclp_modbus::map::{Span, Width, coil, discrete, holding, input};
use unoclp_program::{Holding, Source, Spot, point_names};

/// Where a value stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The table.
    pub table: Table,
    /// Its first address.
    pub first: u16,
    /// What it takes.
    pub width: Width,
}

impl Place {
    /// The value with this number in a span, from 0.
    fn of(span: Span, index: u16) -> Option<Place> {
        let width = span.width;
        let each = match width {
            Width::Bit | Width::Word => 1,
            Width::Long => 2,
        };
        (index < span.values).then_some(Place {
            table: span.table,
            first: span.first + each * index,
            width,
        })
    }

    /// Its addresses: the first, and the one behind the last.
    pub fn addresses(self) -> std::ops::Range<u16> {
        let each = match self.width {
            Width::Bit | Width::Word => 1,
            Width::Long => 2,
        };
        self.first..self.first + each
    }
}

/// A point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Point {
    /// What it is called.
    pub name: String,
    /// Where its value is read.
    pub read: Place,
    /// Where it is written; nowhere, if it cannot be.
    pub write: Vec<Place>,
}

/// The points of a board.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Points {
    /// How a board keeps the program that gives the names: while it keeps another, none of them holds.
    pub program: Option<Kept>,
    /// Those that the program names.
    pub named: Vec<Point>,
}

impl Points {
    /// Those of a board that runs this program.
    pub fn of(source: &Source) -> Points {
        let mut named: Vec<Point> = Vec::new();
        let mut add = |name: &str, own: Option<Point>| {
            let is_new = !named.iter().any(|point| point.name == name);
            if let Some(own) = own.filter(|_| is_new) {
                let name = name.to_owned();
                named.push(Point { name, ..own });
            }
        };
        for variable in &source.variables {
            if let Holding::One((spot, _)) = variable.holding {
                add(&variable.name, at(spot));
            }
        }
        for (own_name, name) in &point_names(source) {
            add(name, own(own_name));
        }
        named.sort_by(|a, b| a.name.cmp(&b.name));
        Points {
            program: Some(Kept::of(source.program())),
            named,
        }
    }

    /// The point of this name in the program.
    pub fn named(&self, name: &str) -> Option<&Point> {
        let is = |point: &&Point| point.name.eq_ignore_ascii_case(name);
        self.named.iter().find(is)
    }
}

/// The point that every board calls so: `I1`, `Q1`, `M1`, `A0`, `D1`; `T1` and `C1`, which are read as what has elapsed or
/// been counted, and written as the preset.
pub(crate) fn own(name: &str) -> Option<Point> {
    let letter = name.chars().next()?;
    let number: u8 = name.get(letter.len_utf8()..)?.parse().ok()?;
    at(match letter {
        'I' => Spot::Input(number),
        'Q' => Spot::Output(number),
        'M' => Spot::Marker(number),
        'A' => Spot::Analogue(number),
        'D' => Spot::Register(number),
        'T' => Spot::Elapsed(number),
        'C' => Spot::Count(number),
        _ => return None,
    })
}

/// The point of a spot, by its own name; none of what a board does not tell.
fn at(spot: Spot) -> Option<Point> {
    let (letter, number, read, write): (_, _, _, &[Span]) = match spot {
        Spot::Input(n) => ('I', n, discrete::INPUTS, &[]),
        Spot::Output(n) => ('Q', n, coil::OUTPUTS, &[coil::OUTPUTS]),
        Spot::Marker(n) => ('M', n, coil::MARKERS, &[coil::MARKERS]),
        Spot::Analogue(n) => ('A', n, input::ANALOGUE, &[]),
        // The first of them stand in two rows.
        Spot::Register(n) => {
            let write = &[holding::REGISTERS, holding::FIRST_REGISTERS];
            ('D', n, holding::REGISTERS, write)
        }
        Spot::Elapsed(n) => ('T', n, input::TIMERS, &[holding::TIMERS]),
        Spot::Count(n) => ('C', n, input::COUNTERS, &[holding::COUNTERS]),
        Spot::System(_) | Spot::TimerQ(_) | Spot::Reached(_) | Spot::AtZero(_) | Spot::Pwm(_) => {
            return None;
        }
    };
    let index = match spot {
        Spot::Analogue(n) => n.into(),
        _ => u16::from(number).checked_sub(1)?,
    };
    Some(Point {
        name: format!("{letter}{number}"),
        read: Place::of(read, index)?,
        write: write
            .iter()
            .filter_map(|&span| Place::of(span, index))
            .collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_program::Written;

    fn points(name: &str, text: &str) -> Points {
        let written = Written::new(name.to_owned(), text.as_bytes().to_vec());
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
            let point = own(name).expect(name);
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
            assert_eq!(own(name), None, "{name}");
        }
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
    }

    #[test]
    fn a_program_without_names_has_a_check_sum() {
        let points = points("p.txt", "0\n787600\n827301\n877901\n");
        assert_eq!(points.named, []);
        assert_eq!(points.program.expect("it is kept").bytes, 3);
    }
}
