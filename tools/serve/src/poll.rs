//! Boards that are read again and again, and what has changed of their points.
//!
//! Owns which requests read the points of a board, and what a change is. Must not know who keeps them.

use crate::gateway::{Gateway, Values, kept_by};
use crate::tokens::Role;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::{Instant, MissedTickBehavior, interval};
use unoclp_modbus::Table;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{self, Width};
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

/// Reads the board, for ever.
pub(crate) async fn attend(gateway: Arc<Gateway>, watched: Watched, keep: Option<Keep>) {
    let mut known = Known::default();
    let mut holds = watched.points.program.is_some();
    let mut every = interval(watched.every);
    let mut told = None::<Instant>;
    every.set_missed_tick_behavior(MissedTickBehavior::Delay);
    loop {
        every.tick().await;
        let points = watched.points.recorded(holds);
        let read = read(&gateway, &points).await;
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
        let changes = known.changes(read.unwrap_or_default());
        if !changes.is_empty() {
            gateway.values().clone_from(&known.0);
            if let Some(keep) = &keep {
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
}

/// What the points were when they were last read.
#[derive(Default)]
struct Known(Values);

impl Known {
    /// What is otherwise now. A point that was not read is not known any more.
    fn changes(&mut self, read: Vec<(String, f64)>) -> Vec<(String, Option<f64>)> {
        // What is no number is not known.
        let mut now: Values = read
            .into_iter()
            .map(|(point, value)| (point, Some(value).filter(|value| value.is_finite())))
            .collect();
        for point in self.0.keys() {
            now.entry(point.clone()).or_insert(None);
        }
        let changed = now
            .iter()
            .filter(|(point, value)| self.0.get(*point) != Some(value));
        let changes = changed
            .map(|(point, value)| (point.clone(), *value))
            .collect();
        self.0 = now;
        changes
    }
}

/// What these points are; none where the board does not tell all of them.
async fn read(gateway: &Gateway, points: &[Point]) -> Option<Vec<(String, f64)>> {
    let mut words = BTreeMap::new();
    for Area {
        table,
        first,
        count,
    } in areas(points)
    {
        let request = Request::read(gateway.line.address(), table, first, count);
        let reply = gateway.line.ask(request.clone(), Role::Watch).await;
        let Some(Ok(reply)) = request.answer(&reply) else {
            return None;
        };
        let read: Vec<u16> = match table {
            Table::Coils | Table::DiscreteInputs => reply.bits().map(u16::from).collect(),
            _ => reply.words().collect(),
        };
        let addresses = (first..first + count).map(|address| (table as u8, address));
        words.extend(addresses.zip(read));
    }
    let value = |point: &Point| {
        let Place { table, first, .. } = point.read;
        let word = |address: u16| words.get(&(table as u8, address)).copied();
        let bits = match point.read.width {
            Width::Bit | Width::Word => u32::from(word(first)?),
            Width::Long => map::long(word(first)?, word(first + 1)?),
        };
        let value = match point.kind {
            Kind::Unsigned => bits.into(),
            Kind::Signed => bits.cast_signed().into(),
            Kind::Real => f32::from_bits(bits).into(),
        };
        Some((point.name.clone(), value))
    };
    points.iter().map(value).collect()
}

/// Addresses that one request reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Area {
    table: Table,
    first: u16,
    count: u16,
}

/// As few requests as read these points: of each span that has some, from the first to the last of them.
fn areas(points: &[Point]) -> Vec<Area> {
    let mut areas = Vec::new();
    for span in map::ALL {
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
        let areas: Vec<_> = areas(&points)
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
        let mut known = Known::default();
        let value = |value: f64| ("a".to_owned(), value);
        let told = |value| vec![("a".to_owned(), value)];
        assert_eq!(known.changes(vec![value(1.0)]), told(Some(1.0)));
        assert_eq!(known.changes(vec![value(1.0)]), []);
        assert_eq!(known.changes(Vec::new()), told(None));
        assert_eq!(known.changes(Vec::new()), []);
        assert_eq!(known.changes(vec![value(1.0)]), told(Some(1.0)));
        assert_eq!(known.changes(vec![value(f64::NAN)]), told(None));
        assert_eq!(known.changes(vec![value(f64::NAN)]), []);
        let two = vec![value(2.0), ("b".to_owned(), 3.0)];
        assert_eq!(known.changes(two).len(), 2);
    }
}
