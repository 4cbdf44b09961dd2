//! Boards that are read again and again, and what has changed of their points.
//!
//! Owns which requests read the points of a board, and what a change is. Must not know who keeps them.

use crate::gateway::{Gateway, Values, kept_by};
use crate::tokens::Role;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::{Instant, MissedTickBehavior, interval};
use unoclp_modbus::Table;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{self, Span, Width};
use unoclp_record::now;
use unoclp_site::{Kind, Place, Point, Points};

/// The most addresses that one request reads here: whole values of 32 bits.
const MOST: u16 = 124;

/// How often a board that shall keep no certain program is asked what it does.
const TOLD: Duration = Duration::from_secs(1);

/// What is read of a board.
#[derive(Clone, Debug)]
pub struct Watched {
    /// Its points.
    pub points: Points,
    /// From one reading to the next.
    pub every: Duration,
}

/// What a point is from a moment on.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The board.
    pub board: String,
    /// The point.
    pub point: String,
    /// The moment: ms since 1970, by the clock of this PC.
    pub at: i64,
    /// The value; none where it is not known any more.
    pub value: Option<f64>,
}

/// Takes the changes of one reading.
pub type Keep = Arc<dyn Fn(Vec<Change>) + Send + Sync>;

/// Reads the board, forever.
pub(crate) async fn attend(gateway: Arc<Gateway>, watched: Watched, keep: Option<Keep>) {
    let readings = [false, true].map(|holds| {
        let spans = map::of(&watched.points.board);
        Reading::of(watched.points.recorded(holds), spans)
    });
    let mut holds = watched.points.program.is_some();
    let mut every = interval(watched.every);
    let mut told = None::<Instant>;
    every.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        every.tick().await;
        let reading = &readings[usize::from(holds)];
        let read = reading.read(&gateway).await;
        // The names of a program hold while the board keeps it: it is asked once all has been read.
        let keeps = match watched.points.program {
            Some(program) => kept_by(&gateway).await.ok().map(|kept| kept == program),
            None => {
                // What it does is asked less often than what its points are.
                if told.is_none_or(|told| told.elapsed() >= TOLD) {
                    told = Some(Instant::now());
                    // Why it does not tell is known where it is looked for.
                    let _ = kept_by(&gateway).await;
                }
                Some(holds)
            }
        };
        let read = read.filter(|_| keeps == Some(holds));
        holds = keeps.unwrap_or(holds);
        let changes = changes(&mut gateway.values(), &reading.points, read.as_deref());
        if let Some(keep) = keep.as_ref().filter(|_| !changes.is_empty()) {
            let at = now();
            let change = |(point, value)| Change {
                board: gateway.name.clone(),
                point,
                at,
                value,
            };
            keep(changes.into_iter().map(change).collect());
        }
    }
}

/// Takes what these points are now; none where they were not read. Gives what is otherwise than it was: a point that was not
/// read is not known any more.
fn changes(
    known: &mut Values,
    points: &[Point],
    read: Option<&[f64]>,
) -> Vec<(String, Option<f64>)> {
    let is_of_these = |name: &str| points.iter().any(|point| point.name == name);
    let are_others = read.is_none() || known.len() != points.len();
    let mut changed = Vec::new();
    for (name, value) in known.iter_mut().filter(|_| are_others) {
        if value.is_some() && (read.is_none() || !is_of_these(name)) {
            *value = None;
            changed.push((name.clone(), None));
        }
    }
    for (point, value) in points.iter().zip(read.unwrap_or_default()) {
        // What is no number is not known.
        let value = Some(*value).filter(|value| value.is_finite());
        match known.get_mut(&point.name) {
            Some(before) if *before == value => continue,
            Some(before) => *before = value,
            None => drop(known.insert(point.name.clone(), value)),
        }
        changed.push((point.name.clone(), value));
    }
    changed.sort_by(|(one, _), (other, _)| one.cmp(other));
    changed
}

/// Points, and the requests that read them.
struct Reading {
    points: Vec<Point>,
    areas: Vec<Area>,
}

impl Reading {
    fn of(points: Vec<Point>, spans: impl Iterator<Item = Span>) -> Reading {
        let areas = areas(&points, spans);
        Reading { points, areas }
    }

    /// What the points are, in their order; none where the board does not tell all of them.
    async fn read(&self, gateway: &Gateway) -> Option<Vec<f64>> {
        let mut words = Vec::new();
        for area in &self.areas {
            let Area {
                table,
                first,
                count,
            } = *area;
            let request = Request::read(gateway.line.address(), table, first, count);
            let reply = gateway.line.ask(request.clone(), Role::Watch).await;
            let Some(Ok(reply)) = request.answer(&reply) else {
                return None;
            };
            let read: Vec<u16> = match table {
                Table::Coils | Table::DiscreteInputs => reply.bits().map(u16::from).collect(),
                _ => reply.words().collect(),
            };
            words.push((*area, read));
        }
        let points = self.points.iter();
        points.map(|point| value(point, &words)).collect()
    }
}

/// The value of a point by what was read.
fn value(point: &Point, words: &[(Area, Vec<u16>)]) -> Option<f64> {
    let Place { table, first, .. } = point.read;
    let word = |address: u16| {
        let mut all = words.iter().filter(|(area, _)| area.table == table);
        all.find_map(|(area, words)| words.get(usize::from(address.checked_sub(area.first)?)))
    };
    let word = |address: u16| word(address).copied();
    let bits = match point.read.width {
        Width::Bit | Width::Word => u32::from(word(first)?),
        Width::Long => map::long(word(first)?, word(first + 1)?),
    };
    Some(match point.kind {
        Kind::Unsigned => bits.into(),
        Kind::Signed => bits.cast_signed().into(),
        Kind::Real => f32::from_bits(bits).into(),
    })
}

/// Addresses that one request reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Area {
    table: Table,
    first: u16,
    count: u16,
}

/// As few requests as read these points: of each span that has some, from the first to the last of them.
fn areas(points: &[Point], spans: impl Iterator<Item = Span>) -> Vec<Area> {
    let mut areas = Vec::new();
    for span in spans {
        let is_there = |place: &Place| {
            place.table == span.table && (span.first..span.end()).contains(&place.first)
        };
        let places = points.iter().map(|point| point.read).filter(is_there);
        let ranges: Vec<_> = places.map(Place::addresses).collect();
        let first = ranges.iter().map(|range| range.start).min();
        let end = ranges.iter().map(|range| range.end).max();
        let (Some(mut first), Some(end)) = (first, end) else {
            continue;
        };
        while first < end {
            let count = (end - first).min(MOST);
            areas.push(Area {
                table: span.table,
                first,
                count,
            });
            first += count;
        }
    }
    areas
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_client::AT_A_LINE;

    fn point(table: Table, first: u16, width: Width) -> Point {
        Point {
            name: format!("{first}"),
            kind: Kind::Signed,
            read: Place {
                table,
                first,
                width,
            },
            write: Vec::new(),
        }
    }

    #[test]
    fn few_requests_read_many_points_and_none_reads_what_is_not_there() {
        let points = [
            point(Table::Coils, 3, Width::Bit),
            point(Table::Coils, 1, Width::Bit),
            point(Table::Coils, 79, Width::Bit),
            point(Table::HoldingRegisters, 2000, Width::Long),
            point(Table::HoldingRegisters, 2194, Width::Long),
            point(Table::InputRegisters, 130, Width::Long),
        ];
        let areas: Vec<_> = areas(&points, map::of(&AT_A_LINE))
            .into_iter()
            .map(|area| (area.table, area.first, area.count))
            .collect();
        let expected = [
            (Table::Coils, 1, 3),
            (Table::Coils, 79, 1),
            (Table::InputRegisters, 130, 2),
            (Table::HoldingRegisters, 2000, 124),
            (Table::HoldingRegisters, 2124, 72),
        ];
        assert_eq!(areas, expected);
        for (table, first, count) in areas {
            assert!(map::has(table, first, count));
        }
    }

    #[test]
    fn what_changes_is_told_once() {
        let named = |name: &str| Point {
            name: name.into(),
            ..point(Table::Coils, 0, Width::Bit)
        };
        let (one, two) = ([named("a")], [named("b"), named("a")]);
        let told = |value| vec![("a".to_owned(), value)];
        let mut known = Values::new();
        let mut of_a = |value: Option<f64>| {
            let read = value.map(|value| [value]);
            changes(&mut known, &one, read.as_ref().map(|read| &read[..]))
        };
        assert_eq!(of_a(Some(1.0)), told(Some(1.0)));
        assert_eq!(of_a(Some(1.0)), []);
        assert_eq!(of_a(None), told(None));
        assert_eq!(of_a(None), []);
        assert_eq!(of_a(Some(1.0)), told(Some(1.0)));
        assert_eq!(of_a(Some(f64::NAN)), told(None));
        assert_eq!(of_a(Some(f64::NAN)), []);
        let both = changes(&mut known, &two, Some(&[3.0, 2.0]));
        let all = [("a".to_owned(), Some(2.0)), ("b".to_owned(), Some(3.0))];
        assert_eq!(both, all);
        // The names are others now.
        let other = changes(&mut known, &[named("b")], Some(&[3.0]));
        assert_eq!(other, told(None));
    }
}
