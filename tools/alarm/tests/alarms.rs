//! Alarms as a thread judges them, over restarts.

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use unoclp_alarm::{Alarms, NotDone, State, Turn, Value};
use unoclp_record::{Asked, Record};
use unoclp_site::{Alarm, Files};

const ALL: Asked = Asked {
    from: 0,
    to: i64::MAX,
    most: 100,
};

struct Folder;

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Err("no such file".into())
    }
}

fn alarms(text: &str) -> Vec<Alarm> {
    let text =
        format!("[[line]]\nport = \"a\"\n[[line.board]]\nname = \"tank\"\n[[alarm]]\n{text}");
    let site = unoclp_site::read(&text, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    site.alarms
}

type Heard = Receiver<(State, Option<Turn>)>;

fn begin(path: &Path, text: &str) -> (Alarms, Heard) {
    let record = Record::begin(path, u64::MAX, Box::new(|_| ())).unwrap();
    let (send, heard) = channel();
    let hear = move |of: &unoclp_alarm::Standing, turn| {
        // At the end of a test nobody listens.
        let _ = send.send((of.state, turn));
    };
    let alarms = Alarms::begin(alarms(text), Arc::new(record), Box::new(hear)).unwrap();
    (alarms, heard)
}

fn level(value: f64) -> Vec<Value> {
    vec![Value {
        board: "tank".into(),
        point: "A0".into(),
        value: Some(value),
    }]
}

const FULL: &str = "name = \"full\"\nwhen = \"tank.A0 > 900\"\ntext = \"x\"\n";

#[test]
fn an_alarm_outlasts_a_restart_with_its_past() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.record");
    let (alarms, heard) = begin(&path, FULL);
    assert_eq!(heard.recv(), Ok((State::Normal, None)));
    alarms.changed(level(901.0));
    assert_eq!(heard.recv(), Ok((State::Active, Some(Turn::Came))));
    assert_eq!(alarms.acknowledge("full", "ana"), Ok(State::Acknowledged));
    assert_eq!(alarms.acknowledge("full", "eva"), Err(NotDone::Nothing));
    assert_eq!(alarms.acknowledge("empty", "eva"), Err(NotDone::NoAlarm));
    drop(alarms);
    let (alarms, heard) = begin(&path, FULL);
    assert_eq!(heard.recv(), Ok((State::Acknowledged, None)));
    let standing = &alarms.standing()[0];
    assert_eq!(standing.who.as_deref(), Some("ana"));
    assert!(standing.since.is_some_and(|since| since > 0));
    alarms.changed(level(5.0));
    assert_eq!(heard.recv(), Ok((State::Normal, Some(Turn::Gone))));
    alarms.changed(level(950.0));
    assert_eq!(heard.recv(), Ok((State::Active, Some(Turn::Came))));
    assert_eq!(alarms.standing()[0].who, None);
    drop(alarms);
    // An alarm that the file no longer has is left in the record.
    let (alarms, _heard) = begin(&path, &FULL.replace("full", "high"));
    assert_eq!(alarms.standing()[0].state, State::Normal);
    let past = alarms.past(&ALL).unwrap();
    let past: Vec<_> = past
        .iter()
        .map(|of| (&*of.change, &*of.state, of.who.as_deref()))
        .collect();
    assert_eq!(
        past,
        [
            ("came", "active", None),
            ("acknowledged", "acknowledged", Some("ana")),
            ("gone", "normal", None),
            ("came", "active", None),
        ]
    );
    alarms.end();
    assert_eq!(alarms.acknowledge("high", "ana"), Err(NotDone::Ended));
}

#[test]
fn an_alarm_comes_by_itself_once_its_time_is_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.record");
    let (alarms, heard) = begin(&path, &format!("{FULL}for = \"20ms\"\n"));
    assert_eq!(heard.recv(), Ok((State::Normal, None)));
    alarms.changed(level(901.0));
    // Nothing else comes.
    assert_eq!(heard.recv(), Ok((State::Active, Some(Turn::Came))));
}
