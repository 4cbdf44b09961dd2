//! A board at a port: finding it, what goes wrong there, and the thread that watches it.

use crate::pty::{Board, Fake, Fate, IMPATIENT, PATIENT, STOP};
use rustix::fs::{Mode, OFlags};
use rustix::termios::{ControlModes, OptionalActions, tcgetattr, tcsetattr};
use std::sync::mpsc::Receiver;
use std::time::Duration;
use unoclp_cli::monitor::{News, watch};
use unoclp_cli::port::{NotFound, NotOpened, find};
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::map::{Command, State};
use unoclp_client::order::Order;
use unoclp_client::watch::{Reading, Scope, Side, command as give};
use unoclp_client::{Patience, lock};

#[test]
fn a_board_says_what_it_is() {
    let fake = Fake::new(Board::default());
    let found = find(&fake.place(), PATIENT).unwrap();
    assert_eq!(found.identity.to_string(), "unoclp UNO 0.1.0");
    assert_eq!(found.identity.vendor, "unoclp");
    assert!(!found.may_be_reset, "no other user has left the port so");
}

#[test]
fn a_port_has_one_conversation_after_the_other() {
    let fake = Fake::new(Board::in_state(STOP));
    let mut port = find(&fake.place(), PATIENT).unwrap().port;
    for (command, state) in [(Command::Run, State::Run), (Command::Stop, State::Stop)] {
        port.talk(async |client| give(client, command).await)
            .unwrap();
        let board = port.talk(Diagnostics::read).unwrap();
        assert_eq!(board.state, Some(state));
    }
}

#[test]
fn a_board_that_opening_the_port_resets_is_waited_for() {
    let mut requests = 0;
    let fake = Fake::with(Board::default(), move |_, _| {
        requests += 1;
        // So long it is still starting.
        if requests < 5 {
            Fate::Lost
        } else {
            Fate::Answered
        }
    });
    let port = rustix::fs::open(fake.path(), OFlags::RDWR | OFlags::NOCTTY, Mode::empty()).unwrap();
    let hangs_up = || {
        tcgetattr(&port)
            .unwrap()
            .control_modes
            .contains(ControlModes::HUPCL)
    };
    let mut modes = tcgetattr(&port).unwrap();
    modes.control_modes.insert(ControlModes::HUPCL);
    tcsetattr(&port, OptionalActions::Now, &modes).unwrap();
    assert!(hangs_up());
    fake.say("\r\nunoclp 0.1.0\r\n3 bytes\r\nRUN\r\n");
    let patience = Patience {
        attempts: 1,
        answer: Duration::from_millis(50),
        ..PATIENT
    };
    assert!(find(&fake.place(), patience).unwrap().may_be_reset);
    assert!(!hangs_up(), "the next time it is not reset");
    assert!(!find(&fake.place(), PATIENT).unwrap().may_be_reset);
}

#[test]
fn what_is_no_board_is_told_apart() {
    let message = |fake: Fake| match find(&fake.place(), IMPATIENT) {
        Ok(_) => panic!("it was found"),
        Err(error) => (error.to_string(), fake.path().to_owned()),
    };
    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Lost));
    let says = format!("no answer from address 1 at 115200 baud, no parity, on {path}");
    assert!(error.starts_with(&says), "{error}");

    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Garbled));
    let says = format!("{path} does not speak Modbus at 115200 baud, no parity");
    assert!(error.starts_with(&says), "{error}");
    let (mistaken, _) = message(Fake::with(Board::default(), |_, _| Fate::Mistaken));
    assert!(
        mistaken.contains(" does not speak Modbus at "),
        "{mistaken}"
    );

    let (error, path) = message(Fake::new(Board {
        identity: ["ACME", "Meter", "3"],
        ..Board::default()
    }));
    let way_on = "; `unoclp flash` installs the firmware";
    assert_eq!(
        error,
        format!("the device at {path} does not run unoclp but \"ACME Meter 3\"{way_on}")
    );

    let (error, path) = message(Fake::new(Board {
        identifies: false,
        ..Board::default()
    }));
    assert_eq!(
        error,
        format!("the device at {path} does not run unoclp{way_on}")
    );

    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Unplugged));
    assert!(
        error.starts_with(&format!("{path}: the connection was lost: ")),
        "{error}"
    );
}

#[test]
fn a_port_that_cannot_be_used_says_why() {
    let fake = Fake::new(Board::default());
    let at = |port: &str| {
        let mut place = fake.place();
        place.port = port.to_owned();
        match find(&place, IMPATIENT) {
            Err(NotFound::Port(error)) => error,
            _ => panic!("{port} was opened"),
        }
    };
    let missing = at("/dev/no-such-port");
    assert!(matches!(missing, NotOpened::Missing { .. }), "{missing}");
    assert!(
        missing
            .to_string()
            .starts_with("there is no port /dev/no-such-port; this PC has ")
    );
    for port in ["/dev/null", "/"] {
        assert_eq!(at(port).to_string(), format!("{port} is not a serial port"));
    }
    let denied = NotOpened::Denied {
        port: "/dev/ttyACM0".to_owned(),
    };
    assert!(
        denied
            .to_string()
            .starts_with("this user has no permission to open /dev/ttyACM0; ")
    );

    let _user = find(&fake.place(), PATIENT).unwrap();
    assert_eq!(
        at(fake.path()).to_string(),
        format!(
            "another program, such as a serial monitor, is using {}; close it",
            fake.path()
        )
    );
}

/// The next that is of interest.
fn next<T>(news: &Receiver<News>, pick: impl Fn(News) -> Option<T>) -> T {
    loop {
        if let Some(found) = pick(news.recv().unwrap()) {
            return found;
        }
    }
}

/// Readings until one is so.
fn until(news: &Receiver<News>, is_so: impl Fn(&Reading) -> bool) {
    next(news, |news| match news {
        News::Read(reading) if is_so(&reading) => Some(()),
        News::Lost(why) | News::Refused(why) => panic!("{why}"),
        _ => None,
    });
}

#[test]
fn a_board_that_is_watched_does_what_is_ordered() {
    let fake = Fake::new(Board::default());
    let (order, news) = watch(fake.place(), PATIENT, Scope::default(), None);
    let first = news.recv().unwrap();
    assert!(
        matches!(
            first,
            News::Found {
                may_be_reset: false,
                ..
            }
        ),
        "{first:?}"
    );
    until(&news, |reading| {
        reading.diagnostics.state == Some(State::Run)
    });
    order
        .send(Order::Force(Side::Inputs, 0, Some(true)))
        .unwrap();
    until(&news, |reading| reading.inputs == 1);
    order.send(Order::Command(Command::Stop)).unwrap();
    until(&news, |reading| {
        reading.diagnostics.state == Some(State::Stop)
    });
    fake.board().switch = true;
    order.send(Order::Command(Command::Run)).unwrap();
    let why = next(&news, |news| match news {
        News::Refused(why) => Some(why),
        _ => None,
    });
    assert_eq!(why, "the STOP switch holds the board in STOP");
    fake.board().outputs = 4;
    until(&news, |reading| reading.outputs == 4);
}

#[test]
fn what_a_monitor_forces_ends_behind_it() {
    let fake = Fake::new(Board::default());
    let (order, news) = watch(fake.place(), PATIENT, Scope::default(), Some(10));
    order
        .send(Order::Force(Side::Outputs, 0, Some(true)))
        .unwrap();
    until(&news, |reading| reading.forced_outputs.points == 1);
    assert_eq!(fake.board().forces, [0, 0, 1, 1, 10]);
}

#[test]
fn what_is_locked_is_refused_for_that() {
    let locked = Board {
        settings: [1, 1152, 0, 0, (lock::COMMANDS | lock::WRITING).into()],
        ..Board::default()
    };
    let fake = Fake::new(locked);
    let (order, news) = watch(fake.place(), PATIENT, Scope::default(), None);
    let refusal = |ordered| {
        order.send(ordered).unwrap();
        next(&news, |news| match news {
            News::Refused(why) => Some(why),
            _ => None,
        })
    };
    let why = refusal(Order::Command(Command::Stop));
    assert_eq!(why, "commands are locked on this board");
    for ordered in [Order::Force(Side::Inputs, 0, Some(true)), Order::Release] {
        let why = refusal(ordered);
        assert_eq!(why, "writing and forcing are locked on this board");
    }
}

#[test]
fn a_board_that_is_lost_is_found_again() {
    let mut requests = 0;
    let fake = Fake::with(Board::default(), move |_, _| {
        requests += 1;
        if (30..34).contains(&requests) {
            Fate::Garbled
        } else {
            Fate::Answered
        }
    });
    let patience = Patience {
        attempts: 2,
        ..PATIENT
    };
    let (_order, news) = watch(fake.place(), patience, Scope::default(), None);
    let lost = |news| match news {
        News::Lost(why) => Some(why),
        _ => None,
    };
    let why = next(&news, lost);
    assert!(why.contains("unreadable"), "{why}");
    next(&news, |news| {
        matches!(news, News::Found { .. }).then_some(())
    });
    until(&news, |reading| {
        reading.diagnostics.state == Some(State::Run)
    });
}

#[test]
fn a_port_that_is_not_there_is_looked_for() {
    let mut place = Fake::new(Board::default()).place();
    place.port = "/dev/no-such-port".to_owned();
    let (order, news) = watch(place, IMPATIENT, Scope::default(), None);
    order.send(Order::Release).unwrap();
    let News::Lost(why) = news.recv().unwrap() else {
        panic!("it is there");
    };
    assert!(why.starts_with("there is no port"), "{why}");
    let refused = News::Refused("no board is connected".to_owned());
    assert_eq!(news.recv().unwrap(), refused);
}
