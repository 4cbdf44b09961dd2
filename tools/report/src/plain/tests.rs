use super::*;
use crate::session::Now;
use unoclp_site::{Files, read};

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
    let site = read(&text, &Folder).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    Plain::new(&site, site.mqtt.as_ref().expect("there is one"))
}

fn at(seconds: u64) -> Now {
    Now {
        at: 0,
        since: Duration::from_secs(seconds),
    }
}

fn change(point: &str, value: f64) -> Change {
    Change {
        board: "x".into(),
        point: point.into(),
        at: 5,
        value: Some(value),
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
    session.changed(&[change("I1", 1.0)], at(0));
    assert_eq!(
        topics(&all(&mut session)),
        ["unoclp/$status", "unoclp/x/I1"]
    );
    session.tick(at(9));
    assert_eq!(all(&mut session), []);
    // An hour back by the clock of the PC.
    session.tick(Now {
        at: -3_600_000,
        ..at(10)
    });
    assert_eq!(topics(&all(&mut session)), ["unoclp/x/I1"]);
    session.tick(at(19));
    assert_eq!(all(&mut session), []);
}

#[test]
fn while_a_broker_is_away_samples_wait_and_nothing_else() {
    let mut session = session("write = [\"x.Q1\"]\n");
    for number in 0..MOST + 3 {
        session.changed(&[change("A0", number as f64)], at(0));
        session.presence("x", number % 2 == 0, at(0));
    }
    let stand = session.stand();
    assert_eq!((stand.waiting, stand.dropped), (MOST, 3));
    assert_eq!(session.next(), None);
    session.connected(at(1));
    let out = all(&mut session);
    // Those that waited, the value that there is, and each board's state once.
    assert_eq!(out.len(), 1 + 2 + MOST + 1 - 1);
    assert_eq!(
        session.stand().dropped,
        4,
        "the value that there is has no room"
    );
}

#[test]
fn what_a_broker_has_not_confirmed_comes_again_before_all_others() {
    let mut session = session("");
    session.connected(at(0));
    session.changed(&[change("A0", 1.0), change("A1", 2.0)], at(0));
    let unsure = all(&mut session).into_iter().filter_map(|out| match out {
        Out::Publish(message) => Some(message),
        _ => None,
    });
    let unsure = unsure.collect();
    session.lost(unsure);
    session.changed(&[change("A2", 3.0)], at(0));
    session.connected(at(1));
    let out = all(&mut session);
    let samples = ["unoclp/x/A0", "unoclp/x/A1", "unoclp/x/A2"];
    assert_eq!(
        topics(&out)[..4],
        [&["unoclp/$status"], &samples[..]].concat()
    );
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
