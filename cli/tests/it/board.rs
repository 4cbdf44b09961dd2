//! Finding and watching a board, over a pseudo-terminal.

use crate::fake::{Board, FAULT, Fake, Fate, IMPATIENT, PATIENT, RUN, STOP};
use rustix::fs::{Mode, OFlags};
use rustix::termios::{ControlModes, OptionalActions, tcgetattr, tcsetattr};
use std::sync::mpsc::Receiver;
use std::time::Duration;
use unoclp_board::client::{Client, Failure, Table};
use unoclp_board::diagnostics::{Diagnostics, Kept};
use unoclp_board::map::{Command, State, cause};
use unoclp_board::settings::Settings;
use unoclp_board::start::{NotFound, find};
use unoclp_board::watch::{Forces, Meter, Reading, Scope, Side, Wish};
use unoclp_board::{NotOpened, Parity, Patience};
use unoclp_cli::monitor::{News, watch};
use unoclp_modbus::Exception;

fn client(fake: &Fake) -> Client {
    find(&fake.line(), PATIENT).unwrap().client
}

#[test]
fn a_board_says_what_it_is() {
    let fake = Fake::new(Board::default());
    let found = find(&fake.line(), PATIENT).unwrap();
    assert_eq!(found.identity.to_string(), "unoclp UNO 0.1.0");
    assert_eq!(found.identity.vendor, "unoclp");
    assert!(!found.may_be_reset, "no other user has left the port so");
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
    assert!(find(&fake.line(), patience).unwrap().may_be_reset);
    assert!(!hangs_up(), "the next time it is not reset");
    assert!(!find(&fake.line(), PATIENT).unwrap().may_be_reset);
}

#[test]
fn what_is_no_board_is_told_apart() {
    let message = |fake: Fake| match find(&fake.line(), IMPATIENT) {
        Ok(_) => panic!("it was found"),
        Err(error) => (error.to_string(), fake.path().to_owned()),
    };
    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Lost));
    let says = format!("no answer from address 1 at 115200 baud, no parity, on {path}");
    assert!(error.starts_with(&says), "{error}");

    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Garbled));
    let says = format!("what comes from {path} is no Modbus at 115200 baud, no parity");
    assert!(error.starts_with(&says), "{error}");
    let (mistaken, _) = message(Fake::with(Board::default(), |_, _| Fate::Mistaken));
    assert!(mistaken.starts_with("what comes from"), "{mistaken}");

    let (error, path) = message(Fake::new(Board {
        identity: ["ACME", "Meter", "3"],
        ..Board::default()
    }));
    assert_eq!(
        error,
        format!("what answers at {path} is no unoclp but \"ACME Meter 3\"")
    );

    let (error, path) = message(Fake::new(Board {
        identifies: false,
        ..Board::default()
    }));
    assert_eq!(error, format!("what answers at {path} is no unoclp"));

    let (error, path) = message(Fake::with(Board::default(), |_, _| Fate::Unplugged));
    assert!(
        error.starts_with(&format!("{path}: the port is gone: ")),
        "{error}"
    );
}

#[test]
fn a_port_that_cannot_be_used_says_why() {
    let fake = Fake::new(Board::default());
    let at = |port: &str| {
        let mut line = fake.line();
        line.port = port.to_owned();
        match find(&line, IMPATIENT) {
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
        assert_eq!(at(port).to_string(), format!("{port} is no serial port"));
    }
    let denied = NotOpened::Denied {
        port: "/dev/ttyACM0".to_owned(),
    };
    assert!(
        denied
            .to_string()
            .starts_with("/dev/ttyACM0 may not be used by this user; ")
    );

    let _user = client(&fake);
    assert_eq!(
        at(fake.path()).to_string(),
        format!(
            "{} is in use by another program; close its serial monitor",
            fake.path()
        )
    );
}

#[test]
fn an_answer_that_is_lost_or_garbled_is_asked_for_again() {
    let mut requests = 0;
    let fake = Fake::with(Board::default(), move |_, _| {
        requests += 1;
        // No request fails twice in a row.
        match requests % 6 {
            1 => Fate::Garbled,
            3 => Fate::Mistaken,
            _ => Fate::Answered,
        }
    });
    let mut client = client(&fake);
    for _ in 0..20 {
        assert_eq!(client.words(Table::InputRegisters, 16, 1).unwrap(), [RUN]);
    }
    let mut requests = 0;
    let fake = Fake::with(Board::default(), move |_, _| {
        requests += 1;
        if requests % 2 == 1 {
            Fate::Lost
        } else {
            Fate::AnswerLost
        }
    });
    let error = Client::open(&fake.line(), IMPATIENT).unwrap().0.identify();
    assert!(matches!(error, Err(Failure::Silent)), "{error:?}");
}

#[test]
fn what_was_on_the_line_before_is_no_answer() {
    let fake = Fake::new(Board::default());
    let (mut client, _) = Client::open(&fake.line(), PATIENT).unwrap();
    for text in ["\r\nunoclp 0.1.0\r\nRUN\r\n", "\u{1}", "\u{1}\u{2b}"] {
        fake.say(text);
        assert_eq!(client.identify().unwrap().vendor, "unoclp");
    }
}

#[test]
fn every_read_has_its_shape() {
    let fake = Fake::new(Board {
        inputs: 0b1000_0101,
        outputs: 0b0110,
        markers: 0x8000_0000_0000_0005,
        words: [
            ((4, 0), 1023),
            ((4, 4), 7),
            ((3, 62), 0xFFFF),
            ((3, 63), 0xFFFE),
        ]
        .into_iter()
        .chain([((4, 128), 1), ((4, 129), 2), ((3, 128), 3), ((3, 129), 4)])
        .chain([((4, 301), 9), ((4, 351), 5), ((3, 351), 6)])
        .chain([
            ((4, 19), 5),
            ((4, 22), 1),
            ((4, 23), 0),
            ((4, 24), 300),
            ((4, 26), 400),
        ])
        .chain([((4, 27), 120), ((4, 30), 225), ((4, 31), 2), ((4, 32), 1)])
        .collect(),
        ..Board::in_state(STOP)
    });
    let scope = Scope {
        timers: 87,
        counters: 16,
    };
    let reading = Reading::read(&mut client(&fake), scope).unwrap();
    let board = reading.diagnostics;
    assert_eq!(board.state, Some(State::Stop));
    assert_eq!((cause(board.cause), board.uptime), ("command", 65_536));
    assert_eq!((board.scan_times, board.free_stack), ([300, 0, 400], 120));
    assert_eq!((board.supply, board.restarts, board.faults), (5006, 2, 1));
    assert_eq!(board.program, Kept { bytes: 3, crc: 77 });
    assert_eq!((reading.inputs, reading.outputs), (0b1000_0101, 0b0110));
    assert_eq!(reading.markers, Some(0x8000_0000_0000_0005));
    assert_eq!(reading.analogue, [1023, 0, 0, 0, 7]);
    assert_eq!((reading.registers.len(), reading.registers[31]), (32, -2));
    assert_eq!((reading.timers.len(), reading.counters.len()), (87, 16));
    let (value, preset) = (0x1_0002, 0x3_0004);
    assert_eq!(reading.timers[0], Meter { value, preset });
    assert_eq!(
        reading.timers[86],
        Meter {
            value: 9,
            preset: 0
        }
    );
    assert_eq!(
        reading.counters[15],
        Meter {
            value: 5,
            preset: 6
        }
    );
}

#[test]
fn a_board_without_markers_and_registers_is_read_too() {
    let fake = Fake::new(Board {
        is_of_version_1: true,
        ..Board::default()
    });
    let scope = Scope {
        timers: 2,
        counters: 1,
    };
    let reading = Reading::read(&mut client(&fake), scope).unwrap();
    assert_eq!(reading.markers, None);
    assert!(reading.analogue.is_empty() && reading.registers.is_empty());
    assert!(reading.timers.is_empty() && reading.counters.is_empty());
}

#[test]
fn points_are_forced_and_let_go() {
    let fake = Fake::new(Board::default());
    let mut client = client(&fake);
    let mut wish = |wish: Wish| {
        wish.fulfil(&mut client).unwrap();
        Reading::read(&mut client, Scope::default()).unwrap()
    };
    let reading = wish(Wish::Force(Side::Inputs, 7, Some(true)));
    assert_eq!((reading.inputs, reading.forced_inputs.points), (0x80, 0x80));
    let reading = wish(Wish::Force(Side::Inputs, 0, Some(false)));
    let both = Forces {
        points: 0x81,
        to: 0x80,
    };
    assert_eq!(reading.forced_inputs, both);
    wish(Wish::Force(Side::Inputs, 7, None));
    wish(Wish::Force(Side::Outputs, 3, Some(true)));
    assert_eq!(fake.board().forces, [1, 0, 8, 8]);
    wish(Wish::Release);
    assert_eq!(fake.board().forces, [0; 4]);
}

#[test]
fn commands_reach_the_board() {
    let fake = Fake::new(Board::default());
    let mut client = client(&fake);
    let mut command = |command| Wish::Command(command).fulfil(&mut client);
    command(Command::Stop).unwrap();
    assert_eq!(fake.board().state, STOP);
    command(Command::Scan).unwrap();
    assert_eq!(fake.board().single_scans, 1);
    command(Command::Run).unwrap();
    let refused = command(Command::Scan);
    assert!(matches!(
        refused,
        Err(Failure::Refused(Exception::ServerDeviceFailure))
    ));
    command(Command::Restart).unwrap();
    let board = fake.board();
    assert_eq!((board.restarts, board.single_scans), (1, 1));
}

#[test]
fn settings_are_read_and_written() {
    let fake = Fake::new(Board {
        settings: [3, 96, 2, 1],
        ..Board::in_state(STOP)
    });
    let mut client = client(&fake);
    let mut settings = Settings::read(&mut client).unwrap();
    assert_eq!(
        settings.to_string(),
        "address 3, 9600 baud, odd parity, direction pin on"
    );
    (settings.address, settings.rate) = (247, 2400);
    (settings.parity, settings.direction) = (Parity::Even, false);
    settings.write(&mut client).unwrap();
    assert_eq!(fake.board().settings, [247, 24, 1, 0]);
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
fn a_board_that_is_watched_does_what_is_wished() {
    let fake = Fake::new(Board::default());
    let (wish, news) = watch(fake.line(), PATIENT, Scope::default());
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
    wish.send(Wish::Force(Side::Inputs, 0, Some(true))).unwrap();
    until(&news, |reading| reading.inputs == 1);
    wish.send(Wish::Command(Command::Stop)).unwrap();
    until(&news, |reading| {
        reading.diagnostics.state == Some(State::Stop)
    });
    fake.board().switch = true;
    wish.send(Wish::Command(Command::Run)).unwrap();
    let why = next(&news, |news| match news {
        News::Refused(why) => Some(why),
        _ => None,
    });
    assert_eq!(why, "A5 is closed, which holds the board in STOP");
    fake.board().outputs = 4;
    until(&news, |reading| reading.outputs == 4);
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
    let (_wish, news) = watch(fake.line(), patience, Scope::default());
    let lost = |news| match news {
        News::Lost(why) => Some(why),
        _ => None,
    };
    let why = next(&news, lost);
    assert!(why.contains("no Modbus"), "{why}");
    next(&news, |news| {
        matches!(news, News::Found { .. }).then_some(())
    });
    until(&news, |reading| {
        reading.diagnostics.state == Some(State::Run)
    });
}

#[test]
fn a_port_that_is_not_there_is_looked_for() {
    let mut line = Fake::new(Board::default()).line();
    line.port = "/dev/no-such-port".to_owned();
    let (wish, news) = watch(line, IMPATIENT, Scope::default());
    wish.send(Wish::Release).unwrap();
    let News::Lost(why) = news.recv().unwrap() else {
        panic!("it is there");
    };
    assert!(why.starts_with("there is no port"), "{why}");
    let refused = News::Refused("there is no board to do it".to_owned());
    assert_eq!(news.recv().unwrap(), refused);
}

#[test]
fn a_diagnosis_is_complete() {
    let fake = Fake::new(Board {
        fault: 24,
        line: 70_000,
        switch: true,
        ..Board::in_state(FAULT)
    });
    let board = Diagnostics::read(&mut client(&fake)).unwrap();
    assert_eq!(
        board.trouble.unwrap().to_string(),
        "fault 24, line 70000: no such code"
    );
    assert!(board.is_switched_off());
}
