//! The lines of a site file, and the boards at them.

use crate::files::Files;
use crate::keys::{Amiss, At, Keys, number, time};
use crate::mistake::Wrong;
use crate::points::Points;
use crate::site::{Board, Line, Way};
use std::time::Duration;
use unoclp_client::AT_A_LINE;
use unoclp_client::settings::RATES;
use unoclp_core::Board as Kind;
use unoclp_modbus::map::{Parity, setting};
use unoclp_program::Written;

/// How often a board is read, unless the file says otherwise.
const EVERY: Duration = Duration::from_millis(500);
const ADDRESSES: std::ops::Range<i64> =
    setting::ADDRESS.least as i64..setting::ADDRESS.most as i64 + 1;

/// All lines, as far as they are right.
pub(crate) fn lines(keys: &Keys<'_>, files: &dyn Files) -> Vec<Line> {
    let tables = keys.tables("line", "[{ port = \"/dev/ttyACM0\" }]");
    if tables.as_ref().is_some_and(Vec::is_empty) {
        keys.notes.wrong(&keys.place, Wrong::NoLine);
    }
    let mut seen = Seen::default();
    let mut lines: Vec<Line> = Vec::new();
    for table in &tables.unwrap_or_default() {
        table.known(&["port", "tcp", "rate", "parity", "board"]);
        let way = way(table);
        let boards = seen.boards(table, files);
        let Some(way) = way else { continue };
        if lines.iter().any(|line| line.way.name() == way.name()) {
            let way = way.name().to_owned();
            keys.notes.wrong(&table.place, Wrong::TwoLines { way });
        }
        lines.push(Line { way, boards });
    }
    lines
}

fn way(table: &Keys<'_>) -> Option<Way> {
    let port = table.text("port", "\"/dev/ttyACM0\"");
    let server = table.text("tcp", "\"10.0.0.7:502\"");
    let rate = rate(table);
    let parity = parity(table);
    match (port, server) {
        (Some(port), None) => Some(Way::Serial {
            port: port.value,
            rate,
            parity,
        }),
        (None, Some(At { value, place })) => {
            for key in ["rate", "parity"] {
                if let Some(place) = table.at(key) {
                    table.notes.wrong(&place, Wrong::FormatOfTcp { key });
                }
            }
            if !is_host(&value) {
                table.notes.wrong(&place, Wrong::NoHost { given: value });
                return None;
            }
            Some(Way::Tcp { server: value })
        }
        (port, server) => {
            // What is of another kind has been told.
            let told = table.has("port") != table.has("tcp");
            if port.is_some() == server.is_some() && !told {
                table.notes.wrong(&table.place, Wrong::WayOfLine);
            }
            None
        }
    }
}

/// Whether this is a host and a port.
fn is_host(text: &str) -> bool {
    let parts = text.rsplit_once(':');
    parts.is_some_and(|(host, port)| {
        !host.is_empty() && port.parse::<u16>().is_ok_and(|port| port > 0)
    })
}

fn rate(table: &Keys<'_>) -> u32 {
    let usual = u32::from(setting::RATE.default) * 100;
    let Some(At { value, place }) = number(table, "rate", "115200", 0..i64::from(u32::MAX)) else {
        return usual;
    };
    if !RATES.contains(&value) {
        let known = RATES.map(|rate| rate.to_string()).join(", ");
        let given = value.to_string();
        let key = "rate".to_owned();
        table
            .notes
            .wrong(&place, Amiss::Choice { key, given, known });
    }
    value
}

fn parity(table: &Keys<'_>) -> Parity {
    let Some(At { value, place }) = table.text("parity", "\"none\"") else {
        return Parity::None;
    };
    match &*value {
        "none" => Parity::None,
        "even" => Parity::Even,
        "odd" => Parity::Odd,
        _ => {
            let wrong = Amiss::Choice {
                key: "parity".to_owned(),
                given: value,
                known: "\"none\", \"even\", \"odd\"".to_owned(),
            };
            table.notes.wrong(&place, wrong);
            Parity::None
        }
    }
}

/// The boards so far: names and units are those of one board each.
#[derive(Default)]
struct Seen(Vec<(String, u8)>);

impl Seen {
    fn boards(&mut self, line: &Keys<'_>, files: &dyn Files) -> Vec<Board> {
        let tables = line.tables("board", "[{ name = \"estufa\" }]");
        if tables.as_ref().is_some_and(Vec::is_empty) {
            line.notes.wrong(&line.place, Wrong::NoBoard);
        }
        let mut boards: Vec<Board> = Vec::new();
        for table in &tables.unwrap_or_default() {
            table.known(&["address", "unit", "name", "kind", "program", "every"]);
            let address = number::<u8>(table, "address", "1", ADDRESSES);
            let address = match (address, table.at("address")) {
                (Some(address), _) => address,
                (None, place) => At {
                    value: setting::ADDRESS.default as u8,
                    place: place.unwrap_or(table.place.clone()),
                },
            };
            let other = boards.iter().find(|board| board.address == address.value);
            if let Some(other) = other {
                let wrong = Wrong::TwoAddresses {
                    address: address.value,
                    other: other.name.clone(),
                };
                table.notes.wrong(&address.place, wrong);
            }
            let unit = number::<u8>(table, "unit", "1", ADDRESSES);
            // Without a unit it is the address.
            let unit = unit.unwrap_or(address.clone());
            let name = self.name(table);
            self.unit(table, &unit, &name);
            let kind = kind(table);
            let program = table.text("program", "\"estufa.st\"");
            let points = program
                .as_ref()
                .and_then(|program| points(table, program, kind, files));
            let every = time(table, "every", "\"500ms\"", ["10ms", "1h"]);
            boards.push(Board {
                address: address.value,
                unit: unit.value,
                name,
                program: program.map(|program| program.value),
                points: points.unwrap_or_else(|| Points::alone(kind)),
                every: every.map_or(EVERY, |every| every.value),
            });
        }
        boards
    }

    fn name(&self, table: &Keys<'_>) -> String {
        let Some(At { value, place }) = table.needed("name", "\"estufa\"") else {
            return String::new();
        };
        if !is_name(&value) {
            let given = value.clone();
            table.notes.wrong(&place, Wrong::Name { given });
        } else if self
            .0
            .iter()
            .any(|(name, _)| name.eq_ignore_ascii_case(&value))
        {
            let name = value.clone();
            table.notes.wrong(&place, Wrong::TwoNames { name });
        }
        value
    }

    fn unit(&mut self, table: &Keys<'_>, unit: &At<u8>, name: &str) {
        if let Some((other, _)) = self.0.iter().find(|(_, of)| *of == unit.value) {
            let wrong = Wrong::TwoUnits {
                unit: unit.value,
                other: other.clone(),
            };
            table.notes.wrong(&unit.place, wrong);
        }
        self.0.push((name.to_owned(), unit.value));
    }
}

/// Names stand in addresses of pages, in topics and in paths.
fn is_name(text: &str) -> bool {
    let of_name = |ch: char| ch.is_ascii_alphanumeric() || matches!(ch, '-' | '_');
    text.len() <= 32
        && text.starts_with(|ch: char| ch.is_ascii_alphabetic())
        && text.chars().all(of_name)
}

/// Which board it is.
fn kind(table: &Keys<'_>) -> Kind {
    let Some(At { value, place }) = table.text("kind", "\"mega\"") else {
        return AT_A_LINE;
    };
    let named = Kind::named(&value).filter(Kind::has_firmware);
    named.unwrap_or_else(|| {
        let kinds = Kind::ALL.into_iter().filter(Kind::has_firmware);
        let names: Vec<_> = kinds.map(|kind| format!("\"{}\"", kind.id())).collect();
        let wrong = Amiss::Choice {
            key: "kind".to_owned(),
            given: value,
            known: names.join(", "),
        };
        table.notes.wrong(&place, wrong);
        AT_A_LINE
    })
}

fn points(table: &Keys<'_>, program: &At<String>, kind: Kind, files: &dyn Files) -> Option<Points> {
    let file = program.value.clone();
    let wrong = match files.bytes(&file) {
        Err(why) => Wrong::Unreadable { file, why },
        Ok(bytes) => match Written::new(file.clone(), bytes, kind).check(None) {
            Ok(source) => return Some(Points::of(&source)),
            Err(_) => Wrong::Faulty { file },
        },
    };
    table.notes.wrong(&program.place, wrong);
    None
}
