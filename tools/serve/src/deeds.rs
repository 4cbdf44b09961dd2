//! What was done to boards, and by whom, for the record.
//!
//! Owns which requests are deeds, and in which words they are recorded. Must not know whether they were allowed.

use crate::guard::Who;
use crate::written::{command, overlaps, written};
use std::collections::BTreeMap;
use std::net::IpAddr;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use unoclp_modbus::Table;
use unoclp_modbus::client::Request;
use unoclp_modbus::map::{Command, holding};
use unoclp_record::{Deed, Record, now};

/// As many values of a request are recorded.
const VALUES: usize = 8;
/// Of each place so many values a minute are recorded; more are counted, and told with the next one.
const EACH_MINUTE: u32 = 20;
const MINUTE: Duration = Duration::from_secs(60);
/// Of so many places that machines write it is known what they wrote last.
const PLACES: usize = 10_000;
/// What forcing takes: from the first of these registers to the last.
const FORCING: Range<u16> = holding::FORCED_INPUTS.first..holding::MORE_TO.first + 1;

/// A machine that writes: no user is called so.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum By {
    /// A client of Modbus TCP.
    Modbus,
    /// A broker.
    Broker,
}

/// As whom a broker is recorded.
pub(crate) const BROKER: &str = "$mqtt";

/// Where deeds are recorded, if they are.
#[derive(Debug, Default)]
pub(crate) struct Deeds {
    record: Option<Arc<Record>>,
    /// What machines wrote last, by board and place: they write the same again and again.
    last: Mutex<BTreeMap<(By, String, String), Last>>,
}

/// What was written last at a place.
#[derive(Debug)]
struct Last {
    values: String,
    /// Since when so many values were recorded.
    since: Instant,
    recorded: u32,
    /// Values since the last one that was recorded.
    more: u64,
}

impl Deeds {
    /// Where this record takes them.
    pub fn new(record: Option<Arc<Record>>) -> Deeds {
        Deeds {
            record,
            last: Mutex::default(),
        }
    }

    /// A board has done what a visitor from this address asked for.
    pub fn visitor(&self, who: &Who, from: IpAddr, board: &str, request: &Request) {
        if let Some((what, place, values)) = deed(request) {
            self.put(&who.name, Some(from), board, what, detail(&place, &values));
        }
    }

    /// A board has taken what a client of Modbus TCP wrote.
    pub fn client(&self, from: IpAddr, board: &str, request: &Request) {
        if let Some((what, place, values)) = deed(request)
            && let Some(more) = self.is_new(By::Modbus, board, &place, &values)
        {
            let detail = detail_after(&place, &values, more);
            self.put("$modbus", Some(from), board, what, detail);
        }
    }

    /// A board has taken the value of a point that a broker brought.
    pub fn broker(&self, board: &str, point: &str, value: f64) {
        let values = value.to_string();
        if let Some(more) = self.is_new(By::Broker, board, point, &values) {
            let detail = detail_after(point, &values, more);
            self.put(BROKER, None, board, "write", detail);
        }
    }

    /// A board has taken the value of a point that somebody has set on a panel.
    pub fn panel(&self, who: &Who, from: IpAddr, board: &str, point: &str, value: f64) {
        let detail = detail(point, &value.to_string());
        self.put(&who.name, Some(from), board, "write", detail);
    }

    /// A button that somebody has pressed was let go by the gateway.
    pub fn let_go(&self, who: &str, board: &str, point: &str) {
        self.put(who, None, board, "release", detail(point, "0"));
    }

    /// Somebody has acknowledged an alarm.
    pub fn acknowledged(&self, who: &Who, from: IpAddr, alarm: &str) {
        self.put(&who.name, Some(from), alarm, "acknowledge", String::new());
    }

    /// A broker has brought that an alarm is acknowledged.
    pub fn broker_acknowledged(&self, alarm: &str) {
        self.put(BROKER, None, alarm, "acknowledge", String::new());
    }

    /// Waits until what was done is in the file, or the file takes nothing. What boards do never waits for this.
    pub async fn settle(&self) {
        if let Some(record) = self.record.clone() {
            // One that has failed has said so.
            let _ = tokio::task::spawn_blocking(move || record.settle()).await;
        }
    }

    /// What was done.
    pub fn past(&self) -> Option<Arc<Record>> {
        self.record.clone()
    }

    /// Whether what a machine writes is recorded: it is another value than before, and not one of too many. Gives how many were not
    /// recorded before it.
    fn is_new(&self, by: By, board: &str, place: &str, values: &str) -> Option<u64> {
        self.record.as_ref()?;
        let now = Instant::now();
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.len() >= PLACES {
            last.clear();
        }
        let key = (by, board.to_owned(), place.to_owned());
        let of = last.entry(key).or_insert(Last {
            values: String::new(),
            since: now,
            recorded: 0,
            more: 0,
        });
        if of.values == values {
            return None;
        }
        of.values = values.to_owned();
        if now - of.since >= MINUTE {
            (of.since, of.recorded) = (now, 0);
        }
        if of.recorded >= EACH_MINUTE {
            of.more += 1;
            return None;
        }
        of.recorded += 1;
        Some(std::mem::take(&mut of.more))
    }

    fn put(&self, who: &str, from: Option<IpAddr>, of: &str, what: &str, detail: String) {
        if let Some(record) = &self.record {
            record.deed(Deed {
                at: now(),
                who: who.to_owned(),
                from: from.map(|from| from.to_canonical().to_string()),
                of: of.to_owned(),
                what: what.to_owned(),
                detail,
            });
        }
    }
}

fn detail(place: &str, values: &str) -> String {
    match place {
        "" => String::new(),
        place => format!("{place} = {values}"),
    }
}

/// The same, where so many values before it were not recorded.
fn detail_after(place: &str, values: &str, more: u64) -> String {
    let told = detail(place, values);
    match more {
        0 => told,
        more => format!("{told}, after {more} more"),
    }
}

/// What a request does, where, and with which values; none of what only reads, and of what follows the beginning of an
/// upload.
fn deed(request: &Request) -> Option<(&'static str, String, String)> {
    let (table, range) = written(request).ok()?;
    let none = String::new;
    match command(request) {
        Some(Command::Run) => return Some(("run", none(), none())),
        Some(Command::Stop) => return Some(("stop", none(), none())),
        Some(Command::SingleScan) => return Some(("single scan", none(), none())),
        Some(Command::Restart) => return Some(("restart", none(), none())),
        Some(Command::Upload) => return Some(("upload", none(), none())),
        None => {}
    }
    let values = values(request, table);
    if table == Table::Coils {
        return Some(("write", format!("coil {}", range.start), values));
    }
    let is = |span| overlaps(span, &range);
    let what = if is(holding::UPLOAD) {
        return None;
    } else if is(holding::SETTINGS) {
        "settings"
    } else if FORCING.start < range.end && range.start < FORCING.end {
        "force"
    } else {
        "write"
    };
    Some((what, format!("register {}", range.start), values))
}

/// The values that a whole request writes.
fn values(request: &Request, table: Table) -> String {
    let frame = request.bytes();
    let body = frame.get(..frame.len().saturating_sub(2));
    let body = body.unwrap_or_default();
    let is_several = matches!(body.get(1), Some(15 | 16));
    let data = body.get(if is_several { 7 } else { 4 }..);
    let data = data.unwrap_or_default();
    let word = |pair: &[u8]| match *pair {
        [high, low] => u16::from_be_bytes([high, low]),
        _ => 0,
    };
    let all: Vec<u16> = match (table, is_several) {
        (Table::Coils, false) => vec![u16::from(data.first().is_some_and(|&byte| byte != 0))],
        (Table::Coils, true) => {
            let count = body.get(4..6).map_or(0, word);
            let bits = data
                .iter()
                .flat_map(|byte| (0..8).map(move |bit| byte >> bit & 1));
            bits.take(count.into()).map(u16::from).collect()
        }
        _ => data.chunks(2).map(word).collect(),
    };
    let mut texts: Vec<String> = all.iter().take(VALUES).map(u16::to_string).collect();
    if all.len() > VALUES {
        texts.push("…".to_owned());
    }
    texts.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use unoclp_modbus::Crc;

    #[test]
    fn a_deed_is_told_in_its_words_and_a_reading_is_none() {
        let words = |first, words: &[u16]| Request::write_words(1, first, words).unwrap();
        let mut coils = vec![1, 15, 0, 16, 0, 3, 1, 5];
        coils.extend(Crc::of(&coils).to_bytes());
        let coils = Request::forwarded(&coils).unwrap();
        for (request, told) in [
            (Request::read(1, Table::Coils, 0, 4), None),
            (Request::write_word(1, 400, 2), Some(("stop", ""))),
            (words(400, &[1]), Some(("run", ""))),
            (Request::write_word(1, 400, 5), Some(("upload", ""))),
            (words(1000, &[1, 0x3100]), None),
            (
                words(402, &[2, 2, 5, 4, 1]),
                Some(("force", "register 402 = 2 2 5 4 1")),
            ),
            (
                Request::write_word(1, 405, 1),
                Some(("force", "register 405 = 1")),
            ),
            (
                Request::write_word(1, 408, 1),
                Some(("force", "register 408 = 1")),
            ),
            (
                Request::write_word(1, 410, 7),
                Some(("settings", "register 410 = 7")),
            ),
            (words(2000, &[0, 5]), Some(("write", "register 2000 = 0 5"))),
            (
                words(0, &[1; 9]),
                Some(("write", "register 0 = 1 1 1 1 1 1 1 1 …")),
            ),
            (
                Request::write_coil(1, 17, true),
                Some(("write", "coil 17 = 1")),
            ),
            (coils, Some(("write", "coil 16 = 1 0 1"))),
        ] {
            let deed = deed(&request).map(|(what, place, values)| (what, detail(&place, &values)));
            let deed = deed.as_ref().map(|(what, detail)| (*what, &**detail));
            assert_eq!(deed, told, "{:?}", request.bytes());
        }
    }

    #[test]
    fn what_a_machine_writes_again_is_recorded_once() {
        let folder = tempfile::tempdir().unwrap();
        let record = Record::begin(&folder.path().join("r"), u64::MAX, Box::new(|_| ())).unwrap();
        let deeds = Deeds::new(Some(Arc::new(record)));
        let from = "10.0.0.7".parse().unwrap();
        for value in [5, 5, 6, 6, 5] {
            deeds.client(from, "one", &Request::write_word(1, 0, value));
            deeds.broker("one", "target", value.into());
        }
        deeds.client(from, "two", &Request::write_word(1, 0, 5));
        let record = deeds.past().unwrap();
        record.end();
        let asked = unoclp_record::Asked {
            from: 0,
            to: i64::MAX,
            most: 100,
        };
        let told: Vec<String> = record
            .deeds(&asked)
            .unwrap()
            .iter()
            .map(|deed| format!("{} {} {}", deed.who, deed.of, deed.detail))
            .collect();
        assert_eq!(
            told,
            [
                "$modbus one register 0 = 5",
                "$mqtt one target = 5",
                "$modbus one register 0 = 6",
                "$mqtt one target = 6",
                "$modbus one register 0 = 5",
                "$mqtt one target = 5",
                "$modbus two register 0 = 5",
            ]
        );
    }

    #[test]
    fn a_machine_that_writes_without_end_fills_no_disk() {
        let folder = tempfile::tempdir().unwrap();
        let record = Record::begin(&folder.path().join("r"), u64::MAX, Box::new(|_| ())).unwrap();
        let deeds = Deeds::new(Some(Arc::new(record)));
        (0..1_000).for_each(|value| deeds.broker("one", "target", value.into()));
        let key = (By::Broker, "one".to_owned(), "target".to_owned());
        // A minute later.
        let earlier = |of: &mut Last| of.since = of.since.checked_sub(MINUTE).unwrap();
        deeds
            .last
            .lock()
            .unwrap()
            .get_mut(&key)
            .map(earlier)
            .unwrap();
        deeds.broker("one", "target", 5.0);
        let record = deeds.past().unwrap();
        record.end();
        let asked = unoclp_record::Asked {
            from: 0,
            to: i64::MAX,
            most: 5_000,
        };
        let told = record.deeds(&asked).unwrap();
        assert_eq!(told.len(), EACH_MINUTE as usize + 1);
        assert_eq!(told.last().unwrap().detail, "target = 5, after 980 more");
    }
}
