use super::*;
use crate::command::WAITING;
use crate::session::Now;
use unoclp_site::Files;

struct Folder;

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Err("no such file".into())
    }
}

fn session(more: &str) -> Plain {
    let text = format!(
        "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"x\"\n[mqtt]\nbroker = \"mqtt://localhost\"\n{more}"
    );
    let site = unoclp_site::read(&text, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    Plain::new(&site, site.mqtt.as_ref().expect("there is one"), 0)
}

fn at(seconds: u64) -> Now {
    Now {
        at: 0,
        since: Duration::from_secs(seconds),
    }
}

/// Reads an entry of the journal, if one is wanted.
fn read(session: &mut Plain, number: u64, point: &str, value: f64) {
    if let Some(after) = session.wants() {
        assert!(after < number);
        let sample = Change {
            board: "x".into(),
            point: point.into(),
            at: 5,
            value: Some(value),
        };
        session.read(&[Entry { number, sample }], number, at(0));
    }
}

/// Once there are no more.
fn read_all(session: &mut Plain) {
    if let Some(after) = session.wants() {
        session.read(&[], after, at(0));
    }
}

fn all(session: &mut Plain) -> Vec<Out> {
    std::iter::from_fn(|| session.next()).collect()
}

fn topics(out: &[Out]) -> Vec<&str> {
    out.iter()
        .filter_map(|out| match out {
            Out::Publish(message) => Some(&*message.topic),
            _ => None,
        })
        .collect()
}

#[test]
fn all_values_are_told_again_at_an_interval_whatever_the_clock_of_the_pc_does() {
    let mut session = session("every = \"10s\"\n");
    session.connected(at(0));
    read(&mut session, 1, "I1", 1.0);
    assert_eq!(
        topics(&all(&mut session)),
        ["unoclp/$status", "unoclp/x/I1"]
    );
    // What the connection begins with.
    read_all(&mut session);
    assert_eq!(topics(&all(&mut session)), ["unoclp/x/I1"]);
    session.tick(at(9));
    read_all(&mut session);
    assert_eq!(all(&mut session), []);
    // An hour back by the clock of the PC.
    session.tick(Now {
        at: -3_600_000,
        ..at(10)
    });
    read_all(&mut session);
    assert_eq!(topics(&all(&mut session)), ["unoclp/x/I1"]);
    session.tick(at(19));
    read_all(&mut session);
    assert_eq!(all(&mut session), []);
}

#[test]
fn while_a_broker_is_away_or_slow_the_journal_is_not_read_on() {
    let mut session = session("write = [\"x.Q1\"]\n");
    for number in 0..1_000_u32 {
        session.presence("x", number.is_multiple_of(2), at(0));
    }
    assert_eq!((session.wants(), session.next()), (None, None));
    session.connected(at(1));
    for number in 1..1_000_u32 {
        read(&mut session, number.into(), "A0", number.into());
    }
    assert_eq!(session.wants(), None);
    assert_eq!(session.told(), None);
    // Each state once, and as many samples as are enough.
    let out = all(&mut session);
    // Commands, alarms and what acknowledges them are asked for, too.
    assert_eq!(out.len(), 2 + 3 + ENOUGH);
    assert_eq!(session.wants(), Some(ENOUGH as u64));
    assert_eq!(session.told(), Some(ENOUGH as u64));
}

#[test]
fn what_a_broker_has_not_confirmed_comes_again_before_all_others() {
    let mut session = session("");
    session.connected(at(0));
    read(&mut session, 1, "A0", 1.0);
    read(&mut session, 2, "A1", 2.0);
    read_all(&mut session);
    let unsure = all(&mut session).into_iter().filter_map(|out| match out {
        Out::Publish(message) => Some(message),
        _ => None,
    });
    let unsure: Vec<Message> = unsure.collect();
    let numbers: Vec<_> = unsure.iter().map(|message| message.number).collect();
    // The state, two samples, and all values once more.
    assert_eq!(numbers, [None, Some(1), Some(2), None, None]);
    session.lost(unsure);
    assert_eq!(session.wants(), None);
    session.connected(at(1));
    read(&mut session, 3, "A2", 3.0);
    read_all(&mut session);
    let out = all(&mut session);
    let samples = ["unoclp/x/A0", "unoclp/x/A1", "unoclp/x/A2"];
    let told = [&["unoclp/$status"], &samples[..], &samples[..]].concat();
    assert_eq!(topics(&out), told);
}

#[test]
fn of_too_many_commands_the_further_ones_are_refused() {
    let mut session = session("write = [\"x.Q1\"]\n");
    session.connected(at(0));
    all(&mut session);
    for _ in 0..WAITING + 2 {
        session.heard("unoclp/x/Q1/set", b"true", false, at(0));
    }
    let out = all(&mut session);
    let commands: Vec<_> = out
        .iter()
        .filter_map(|out| match out {
            Out::Carry(command) => Some(command.clone()),
            _ => None,
        })
        .collect();
    assert_eq!(commands.len(), WAITING);
    assert_eq!(topics(&out), ["unoclp/x/$refused"; 2]);
    session.done(&commands[0], Ok(()), at(0));
    session.heard("unoclp/x/Q1/set", b"true", false, at(0));
    assert!(matches!(session.next(), Some(Out::Carry(_))));
    // Of boards that there are not, nothing is said.
    session.heard("unoclp/nobody/Q1/set", b"true", false, at(0));
    assert_eq!(session.next(), None);
}

#[test]
fn alarms_are_told_to_each_broker_and_those_of_before_are_removed() {
    let mut session = session("[[alarm]]\nname = \"hot\"\nwhen = \"x.A0 > 900\"\ntext = \"hot\"\n");
    let hot = Alarm {
        name: "hot".into(),
        state: "active",
        severity: "medium",
        text: unoclp_site::Text {
            en: "hot".into(),
            pt: "quente".into(),
        },
        since: Some(5),
        who: None,
    };
    session.alarm(&hot, at(0));
    session.connected(at(0));
    let told = all(&mut session);
    assert_eq!(topics(&told), ["unoclp/$status", "unoclp/$alarm/hot"]);
    let Some(Out::Publish(message)) = told.last() else {
        panic!("{told:?}");
    };
    let payload = String::from_utf8_lossy(&message.payload);
    assert_eq!(
        payload,
        r#"{"severity":"medium","state":"active","t":5,"text":{"en":"hot","pt":"quente"},"who":null}"#
    );
    assert!(message.retain && message.sure);
    // What it has said itself comes back, and what a site of before has said.
    session.heard("unoclp/$alarm/hot", &message.payload, true, at(1));
    session.heard("unoclp/$alarm/cold", b"{}", false, at(1));
    assert_eq!(session.next(), None);
    session.heard("unoclp/$alarm/cold", b"{}", true, at(1));
    let told = all(&mut session);
    assert_eq!(topics(&told), ["unoclp/$alarm/cold"]);
    assert!(
        matches!(&told[..], [Out::Publish(message)] if message.payload.is_empty() && message.retain)
    );
    session.heard("unoclp/$alarm/cold", b"", true, at(1));
    assert_eq!(session.next(), None);
}
