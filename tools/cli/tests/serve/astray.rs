//! What goes wrong around a gateway: a port that is another's, a board that is unplugged, a clock that is set back.

use crate::broker::{Broker, Listener};
use crate::pty::{Board, Fake, Fate};
use crate::{Server, forget, http, site, unoclp_site};
use std::os::unix::fs::symlink;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What `/metrics` says of this one.
fn metric(server: &Server, name: &str) -> String {
    let metrics = http(&server.address, "/metrics");
    let line = metrics.lines().find_map(|line| line.strip_prefix(name));
    line.unwrap_or_default().trim().to_owned()
}

/// A gateway of the board at this port alone, with a history that begins.
fn alone(name: &str, port: &str) -> Server {
    let lines = format!(
        "[history]\nstore = \"{name}.db\"\n[[line]]\nport = {port:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n"
    );
    let file = site(name, &lines);
    forget(&file);
    Server::of(&mut unoclp_site(&file))
}

const UP: &str = "unoclp_board_up{board=\"one\"}";

#[test]
fn a_port_that_another_program_has_is_told_and_taken_once_it_is_free() {
    let fake = Fake::new(Board::default());
    fake.board().outputs = 5;
    let monitor = serialport::new(fake.path(), 9600).open().unwrap();
    let mut server = alone("busy", fake.path());
    let busy = format!(
        "one: not reachable: another program, such as a serial monitor, is using {}; close it",
        fake.path()
    );
    while !server.line().starts_with(&*busy) {}
    assert_eq!(metric(&server, UP), "0");
    let boards = http(&server.address, "/api/boards");
    assert!(
        boards.contains("another program, such as a serial monitor, is using"),
        "{boards}"
    );
    drop(monitor);
    while server.line() != "one: found" {}
    while metric(&server, UP) != "1" {}
    assert_eq!(fake.board().outputs, 5);
}

#[test]
fn a_board_that_is_unplugged_has_a_gap_in_its_history_and_goes_on_after_it() {
    let broker = Broker::new();
    let is_unplugged = Arc::new(AtomicBool::new(false));
    let unplugged = is_unplugged.clone();
    let plugged = |outputs: u16, unplugged: Arc<AtomicBool>| {
        let board = Board {
            outputs,
            ..Board::default()
        };
        Fake::with(board, move |_, _| match unplugged.load(Ordering::Relaxed) {
            true => Fate::Unplugged,
            false => Fate::Answered,
        })
    };
    let port = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("unplugged.port");
    let plug = |fake: &Fake| {
        let _ = std::fs::remove_file(&port);
        symlink(fake.path(), &port).unwrap();
    };
    let _ = std::fs::remove_file(&port);
    let lines = format!(
        "[history]\nstore = \"unplugged.db\"\n[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n\
         [[line]]\nport = {port:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        broker.port
    );
    let file = site("unplugged", &lines);
    forget(&file);
    let listener = Listener::new(&broker, "unoclp/one/+");
    let mut server = Server::of(&mut unoclp_site(&file));
    // A program that begins later would hold the other end of its port open.
    let first = plugged(4, unplugged);
    plug(&first);
    listener.until("one/Q3", "\"v\":true");
    while server.line() != "one: found" {}
    is_unplugged.store(true, Ordering::Relaxed);
    listener.until("one/Q3", "\"v\":null");
    while !server.line().starts_with("one: ") {}
    assert_eq!(metric(&server, UP), "0");
    drop(first);
    // As it was when it was plugged in elsewhere: nothing has moved it.
    let second = plugged(6, Arc::default());
    plug(&second);
    listener.until("one/Q3", "\"v\":true");
    while metric(&server, UP) != "1" {}
    assert_eq!(second.board().outputs, 6);
    let csv = || http(&server.address, "/api/history.csv?board=one&point=Q3");
    let values = |csv: &str| -> Vec<String> {
        let rows = csv.lines().filter(|line| line.contains('Z'));
        let last = rows.filter_map(|row| row.rsplit(',').next());
        last.map(str::to_owned).collect()
    };
    while values(&csv()).len() < 3 {}
    assert_eq!(values(&csv()), ["1", "", "1"]);
}

#[test]
fn a_board_alone_on_its_line_that_stops_answering_is_away_until_it_answers() {
    let is_silent = Arc::new(AtomicBool::new(false));
    let silent = is_silent.clone();
    let fake = Fake::with(Board::default(), move |_, _| {
        match silent.load(Ordering::Relaxed) {
            true => Fate::Lost,
            false => Fate::Answered,
        }
    });
    let mut server = alone("silent", fake.path());
    while server.line() != "one: found" {}
    is_silent.store(true, Ordering::Relaxed);
    let why = server.line();
    let told = why.starts_with("one: not reachable: ");
    assert!(told, "{why}");
    assert_eq!(metric(&server, UP), "0");
    is_silent.store(false, Ordering::Relaxed);
    while server.line() != "one: found" {}
    while metric(&server, UP) != "1" {}
}

/// Debian's libfaketime, which gives a program the clock that a file says.
fn faketime() -> PathBuf {
    let machines = std::fs::read_dir("/usr/lib").unwrap().flatten();
    let libraries = machines.map(|machine| machine.path().join("faketime/libfaketimeMT.so.1"));
    let found = libraries.into_iter().find(|library| library.is_file());
    found.expect("`cargo xtask setup` brings libfaketime")
}

#[test]
fn a_clock_that_jumps_back_an_hour_loses_nothing_and_moves_nothing() {
    let broker = Broker::new();
    let fake = Fake::new(Board::default());
    let lines = format!(
        "[history]\nstore = \"clock.db\"\n[mqtt]\nbroker = \"mqtt://127.0.0.1:{}\"\n\
         [[alarm]]\nname = \"lit\"\nwhen = \"one.Q3\"\nfor = \"1s\"\ntext = \"the lamp is on\"\n\
         [[line]]\nport = {:?}\n[[line.board]]\nname = \"one\"\nevery = \"20ms\"\n",
        broker.port,
        fake.path()
    );
    let file = site("clock", &lines);
    forget(&file);
    let clock = file.replace(".toml", ".clock");
    let set = |by: &str| std::fs::write(&clock, by).unwrap();
    set("+0");
    let listener = Listener::new(&broker, "unoclp/one/Q3");
    let alarm = Listener::new(&broker, "unoclp/$alarm/lit");
    let mut gateway = unoclp_site(&file);
    gateway
        .env("LD_PRELOAD", faketime())
        .env("FAKETIME_TIMESTAMP_FILE", &clock)
        .env("FAKETIME_NO_CACHE", "1")
        .env("FAKETIME_DONT_FAKE_MONOTONIC", "1");
    let server = Server::of(&mut gateway);
    // What was told of the lamp: value, moment and number.
    let mut told = Vec::new();
    let mut until = |value: bool| {
        loop {
            let heard: serde_json::Value = serde_json::from_str(&listener.next().text()).unwrap();
            let number = |key: &str| heard[key].as_i64().unwrap();
            if told.last().is_none_or(|(_, _, n)| *n < number("n")) {
                told.push((heard["v"].clone(), number("t"), number("n")));
            }
            if heard["v"] == value {
                break;
            }
        }
    };
    until(false);
    fake.board().outputs = 4;
    until(true);
    set("-3600");
    fake.board().outputs = 0;
    until(false);
    // How long an alarm waits is not counted by that clock.
    fake.board().outputs = 4;
    until(true);
    alarm.until("lit", r#""state":"active""#);
    set("+0");
    fake.board().outputs = 0;
    until(false);
    alarm.until("lit", r#""state":"gone""#);
    let values: Vec<bool> = told.iter().map(|(v, _, _)| v.as_bool().unwrap()).collect();
    assert_eq!(values, [false, true, false, true, false]);
    let moments: Vec<i64> = told.iter().map(|(_, at, _)| *at).collect();
    let [_, before, back, still, again] = moments[..] else {
        panic!("{moments:?}");
    };
    for (jump, hours) in [(back - before, -1), (again - still, 1)] {
        let near = (jump - hours * 3_600_000).abs();
        assert!(near < 600_000, "{moments:?}");
    }
    // The history has each of them, in the order of that clock.
    let history = || http(&server.address, "/api/history?board=one&point=Q3&last=3h");
    let rows = || history().matches("\"last\":").count();
    while rows() < 5 {}
    assert_eq!(rows(), 5, "{}", history());
    for at in moments {
        assert!(history().contains(&at.to_string()), "{at}: {}", history());
    }
    let alarms = http(&server.address, "/api/alarms/history.csv");
    for change in ["lit,came", "lit,gone"] {
        assert_eq!(alarms.matches(change).count(), 1, "{alarms}");
    }
    assert_eq!(metric(&server, "unoclp_journal_dropped_total"), "0");
    assert_eq!(metric(&server, "unoclp_history_failing"), "0");
    assert_eq!(fake.board().outputs, 0);
}
