//! What was told before an end stands in the file.

use unoclp_record::{Asked, Deed, Failure, Happening, Record};

const ALL: Asked = Asked {
    from: 0,
    to: i64::MAX,
    most: 1_000,
};

fn happening(at: i64, alarm: &str, state: &str) -> Happening {
    Happening {
        at,
        alarm: alarm.into(),
        change: "came".into(),
        state: state.into(),
        who: None,
    }
}

#[test]
fn what_was_last_is_known_to_who_comes_after() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("site.record");
    let record = Record::begin(&path, u64::MAX, Box::new(|_| ())).unwrap();
    record.alarm(happening(1, "hot", "active"));
    record.alarm(happening(2, "cold", "active"));
    record.alarm(happening(3, "hot", "normal"));
    // An hour back by the clock of the PC: the order of writing counts.
    record.alarm(happening(-3_600_000, "cold", "gone"));
    record.deed(Deed {
        at: 4,
        who: "ana".into(),
        from: None,
        of: "hot".into(),
        what: "acknowledge".into(),
        detail: String::new(),
    });
    record.end();
    assert_eq!(record.state().written, 5);
    record.alarm(happening(9, "hot", "active"));
    assert_eq!(record.state().dropped, 1, "nobody writes any more");
    let record = Record::begin(&path, u64::MAX, Box::new(|_| ())).unwrap();
    let last = record.last().unwrap();
    let last: Vec<_> = last.iter().map(|of| (&*of.alarm, &*of.state)).collect();
    assert_eq!(last, [("hot", "normal"), ("cold", "gone")]);
    assert_eq!(record.alarms(&ALL).unwrap().len(), 3);
    assert_eq!(record.deeds(&ALL).unwrap()[0].who, "ana");
}

#[test]
fn a_file_of_something_else_is_refused_and_left_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x");
    let begin = || Record::begin(&path, u64::MAX, Box::new(|_| ())).map(drop);
    let text = "not a database ".repeat(100);
    std::fs::write(&path, &text).unwrap();
    assert_eq!(begin(), Err(Failure::Foreign));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
    std::fs::remove_file(&path).unwrap();
    let other = rusqlite::Connection::open(&path).unwrap();
    other.execute_batch("CREATE TABLE x (y)").unwrap();
    assert_eq!(begin(), Err(Failure::Foreign));
    std::fs::remove_file(&path).unwrap();
    begin().unwrap();
    let other = rusqlite::Connection::open(&path).unwrap();
    other.pragma_update(None, "user_version", 9).unwrap();
    assert_eq!(begin(), Err(Failure::Version(9)));
}
