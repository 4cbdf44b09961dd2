//! What somebody asks for by a message, a value for a point or that an alarm is acknowledged, and why it is refused.

use serde_json::Value;
use unoclp_site::{Grant, Mqtt, Site};

/// The longest command, bytes.
const LONGEST: usize = 256;
/// Wishes that wait to be done at a time; more are refused.
pub(crate) const WAITING: usize = 16;

/// A value for a point that may be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// The board.
    pub board: String,
    /// The point, and where it is written.
    pub grant: Grant,
    /// The value, which the point can hold.
    pub value: f64,
}

/// What somebody asks for by a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// That a point has this value.
    Set(Command),
    /// That this alarm is acknowledged.
    Acknowledge(String),
}

/// Why a wish is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It is no value.
    NoValue,
    /// The broker has kept it from before: nobody wants it now.
    Retained,
    /// The site does not let it be written.
    NotAllowed,
    /// The point cannot hold it.
    OutOfRange,
    /// Too many wait.
    TooMany,
    /// Somebody controls the board.
    Controlled,
    /// The board keeps another program.
    OtherProgram,
    /// The board is away.
    Away,
    /// The board refuses it.
    Board,
    /// The site has no such alarm.
    NoAlarm,
    /// The alarm needs no acknowledging.
    Nothing,
    /// The gateway ends.
    Ending,
}

impl Refusal {
    /// As it is published. These words are those of `docs/site.md`.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Refusal::NoValue => "no value",
            Refusal::Retained => "retained",
            Refusal::NotAllowed => "not allowed",
            Refusal::OutOfRange => "out of range",
            Refusal::TooMany => "too many",
            Refusal::Controlled => "controlled",
            Refusal::OtherProgram => "other program",
            Refusal::Away => "away",
            Refusal::Board => "board",
            Refusal::NoAlarm => "no alarm",
            Refusal::Nothing => "nothing to acknowledge",
            Refusal::Ending => "ending",
        }
    }
}

/// What the site lets others do over MQTT.
#[derive(Clone, Debug)]
pub(crate) struct Rights {
    /// What may be written, by board and point.
    write: Vec<(String, Grant)>,
    /// The alarms, and whether they may be acknowledged.
    alarms: Vec<String>,
    pub acknowledge: bool,
}

impl Rights {
    /// Those of this site.
    pub fn new(site: &Site, mqtt: &Mqtt) -> Rights {
        let of = |grant: &Grant| {
            let board = site.boards().find(|board| board.unit == grant.unit)?;
            Some((board.name.clone(), grant.clone()))
        };
        Rights {
            write: mqtt.write.iter().filter_map(of).collect(),
            alarms: site.alarms.iter().map(|alarm| alarm.name.clone()).collect(),
            acknowledge: mqtt.acknowledge,
        }
    }

    /// The right to write this point, if there is one.
    pub fn of(&self, board: &str, point: &str) -> Option<&Grant> {
        let is = |(of, grant): &&(String, Grant)| of == board && grant.point == point;
        self.write.iter().find(is).map(|(_, grant)| grant)
    }

    /// That this alarm is acknowledged.
    pub fn acknowledged(&self, alarm: &str) -> Result<Wish, Refusal> {
        match (self.acknowledge, self.alarms.iter().any(|of| of == alarm)) {
            (false, _) => Err(Refusal::NotAllowed),
            (true, false) => Err(Refusal::NoAlarm),
            (true, true) => Ok(Wish::Acknowledge(alarm.to_owned())),
        }
    }

    /// That a point has a value.
    pub fn set(&self, board: &str, point: &str, value: f64) -> Result<Wish, Refusal> {
        let grant = self.of(board, point).ok_or(Refusal::NotAllowed)?;
        let holds = |place| grant.kind.words(place, value).is_some();
        match grant.places.first().copied().is_some_and(holds) {
            false => Err(Refusal::OutOfRange),
            true => Ok(Wish::Set(Command {
                board: board.to_owned(),
                grant: grant.clone(),
                value,
            })),
        }
    }
}

/// The value of a command: a number, true or false, or an object that has one of these as `v`.
pub(crate) fn value(payload: &[u8]) -> Result<f64, Refusal> {
    let short = Some(payload).filter(|payload| payload.len() <= LONGEST);
    let value = short.and_then(|payload| serde_json::from_slice(payload).ok());
    let value: Value = value.ok_or(Refusal::NoValue)?;
    match value.get("v").unwrap_or(&value) {
        Value::Bool(on) => Ok(f64::from(*on)),
        Value::Number(number) => number.as_f64().ok_or(Refusal::NoValue),
        _ => Err(Refusal::NoValue),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_is_a_number_or_a_truth() {
        for (payload, read) in [
            ("5", Some(5.0)),
            (" -1.5 ", Some(-1.5)),
            ("true", Some(1.0)),
            ("{\"v\": false, \"t\": 1}", Some(0.0)),
            ("", None),
            ("ON", None),
            ("null", None),
            ("[1]", None),
            ("\"1\"", None),
            ("{\"v\": \"1\"}", None),
            ("{\"w\": 1}", None),
            ("1e999", None),
            ("5 5", None),
            ("NaN", None),
        ] {
            assert_eq!(value(payload.as_bytes()).ok(), read, "{payload}");
        }
        assert_eq!(value(&[0xFF, 0xFE]), Err(Refusal::NoValue));
        let long = format!("{:>300}", 5);
        assert_eq!(value(long.as_bytes()), Err(Refusal::NoValue));
        let deep = "[".repeat(256);
        assert_eq!(value(deep.as_bytes()), Err(Refusal::NoValue));
    }
}
