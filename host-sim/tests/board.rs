//! Uploading to and watching a board, over a pseudo-terminal.
#![cfg(unix)]

mod fake;

use fake::{Board, FAULT, Fake, Fate, IMPATIENT, PATIENT, RUN, STOP};
use std::sync::mpsc::Receiver;
use unoclp_host_sim::board::client::{Client, Failure, Table};
use unoclp_host_sim::board::map::{BLOCK_BYTES, Command, State, cause};
use unoclp_host_sim::board::settings::Settings;
use unoclp_host_sim::board::start::{NotFound, find};
use unoclp_host_sim::board::upload::{Behind, Broken, Pass, Progress, go_on, stop, upload};
use unoclp_host_sim::board::watch::{Diagnostics, Forces, Kept, Meter, Reading, Scope, Side, Wish};
use unoclp_host_sim::board::{NotOpened, Parity, Patience};
use unoclp_host_sim::monitor::{News, watch};
use unoclp_modbus::Exception;

const FOLLOW: &str = "0\n787600\n827301\n847978\n3\n7901\n";

fn client(fake: &Fake) -> Client {
    find(&fake.line(), PATIENT).unwrap().client
}

/// A program of several blocks.
fn long() -> String {
    format!("{}/{}\n", FOLLOW, "comment ".repeat(200))
}

/// Uploads without a look at the progress.
fn send(client: &mut Client, text: &str) -> Result<(), Broken> {
    let kept = Kept::of(text.as_bytes()).unwrap_or_default();
    upload(client, text.as_bytes(), kept, &mut |_| ())
}

fn is_block(request: &[u8]) -> bool {
    request.starts_with(&[1, 16, 1000_u16.to_be_bytes()[0], 1000_u16.to_be_bytes()[1]])
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
fn a_program_is_sent_twice_and_stored() {
    for text in [FOLLOW.to_owned(), long(), "0\n877901\n/".to_owned()] {
        let fake = Fake::new(Board::default());
        let mut client = client(&fake);
        let before = stop(&mut client).unwrap();
        assert_eq!((before.state, fake.board().state), (Some(State::Run), STOP));
        let kept = Kept::of(text.as_bytes()).unwrap();
        let mut shown = Vec::new();
        upload(&mut client, text.as_bytes(), kept, &mut |step| {
            shown.push(step)
        })
        .unwrap();
        assert_eq!(fake.board().text, text.as_bytes());
        assert_eq!(fake.board().kept, kept);
        for pass in [Pass::Check, Pass::Store] {
            let (bytes, of) = (text.len(), text.len());
            assert!(shown.contains(&Progress::Sent { pass, bytes, of }));
        }
        assert!(shown.contains(&Progress::Storing));
        let behind = go_on(&mut client, State::Run, kept, false).unwrap();
        assert_eq!((behind, fake.board().state), (Behind::Run, RUN));
    }
}

#[test]
fn block_numbers_go_round() {
    let text = format!("{FOLLOW}/{}\n", "x".repeat(140 * BLOCK_BYTES));
    let fake = Fake::new(Board::in_state(STOP));
    send(&mut client(&fake), &text).unwrap();
    assert_eq!(fake.board().text.len(), text.len());
}

#[test]
fn a_block_whose_answer_is_lost_is_sent_again_and_taken_once() {
    let text = long();
    let mut blocks = 0;
    let fake = Fake::with(Board::in_state(STOP), move |_, request| {
        blocks += u32::from(is_block(request));
        match (is_block(request), blocks % 4) {
            (true, 2) => Fate::Garbled,
            _ => Fate::Answered,
        }
    });
    send(&mut client(&fake), &text).unwrap();
    assert_eq!(fake.board().text, text.as_bytes());
}

#[test]
fn an_end_that_was_stored_and_whose_answer_is_lost_is_an_upload() {
    let fake = Fake::with(Board::in_state(STOP), |board, request| {
        let end = is_block(request) && request[8] == 0;
        // The second one: the board stores, and will refuse the repetition.
        if end && request[7] == 3 && board.is_uploading() {
            Fate::Garbled
        } else {
            Fate::Answered
        }
    });
    send(&mut client(&fake), FOLLOW).unwrap();
    assert_eq!(fake.board().text, FOLLOW.as_bytes());
}

#[test]
fn the_board_tells_a_fault_with_its_line() {
    // As by a board of another version: its loader knows less than this one.
    let fault = |text: &str, board: Board| {
        let fake = Fake::new(board);
        let kept = fake.board().kept;
        let error = send(&mut client(&fake), text).unwrap_err();
        assert_eq!(fake.board().kept, kept, "it keeps what it had");
        error.to_string()
    };
    let stop = || Board::in_state(STOP);
    assert_eq!(
        fault("0\n787600\n123\n", stop()),
        "fault 24, line 3: no such code"
    );
    let late = format!("{}40\n", long());
    let line = late.lines().count();
    assert_eq!(
        fault(&late, stop()),
        format!("fault 32, line {line}: this 40 is not closed by 41 in its rung (NC-8)")
    );
    assert_eq!(fault("", stop()), "fault 21: the file holds no code");
    let differs = Board {
        second_differs: true,
        ..stop()
    };
    assert!(fault(FOLLOW, differs).starts_with("fault 57: the card gave another program"));
}

#[test]
fn an_upload_does_not_begin_in_run() {
    let fake = Fake::new(Board::in_state(RUN));
    let error = send(&mut client(&fake), FOLLOW).unwrap_err();
    assert!(matches!(error, Broken::NotBegun), "{error}");
    assert!(!fake.board().is_uploading());
}

#[test]
fn an_upload_that_another_client_ends_says_so() {
    let fake = Fake::with(Board::in_state(STOP), |board, request| {
        if is_block(request) && request[7] == 2 {
            unoclp_modbus::Device::set_word(board, 400, 2);
        }
        Fate::Answered
    });
    let error = send(&mut client(&fake), &long()).unwrap_err();
    assert!(matches!(error, Broken::Ended), "{error}");
}

#[test]
fn an_upload_that_is_broken_off_says_where_and_what_the_board_keeps() {
    for (number, while_, keeps) in [
        (
            2,
            "checking, at byte 488 of ",
            "it keeps the program that it had",
        ),
        (
            9,
            "storing, at byte 244 of ",
            "it keeps the program that it had",
        ),
        (
            15,
            "storing, at byte ",
            "whether it keeps the new program is open",
        ),
    ] {
        let text = long();
        assert_eq!(text.len().div_ceil(BLOCK_BYTES), 7);
        let fake = Fake::with(Board::in_state(STOP), move |_, request| {
            if is_block(request) && request[7] == number {
                Fate::Unplugged
            } else {
                Fate::Answered
            }
        });
        let kept = fake.board().kept;
        let error = send(&mut client(&fake), &text).unwrap_err().to_string();
        let begin = format!("the upload was broken off while {while_}");
        assert!(error.starts_with(&begin), "{error}");
        assert!(error.contains("the port is gone"), "{error}");
        assert!(error.contains(keeps), "{error}");
        assert_eq!(fake.board().kept, kept);
    }
}

#[test]
fn a_board_that_keeps_something_else_is_found_out() {
    let fake = Fake::new(Board::in_state(STOP));
    let kept = Kept { bytes: 1, crc: 2 };
    let text = FOLLOW.as_bytes();
    let error = upload(&mut client(&fake), text, kept, &mut |_| ()).unwrap_err();
    assert!(
        error.to_string().contains("not the 1 bytes with 0002"),
        "{error}"
    );
}

#[test]
fn what_comes_behind_an_upload_depends_on_where_the_board_was() {
    let kept = Kept::of(FOLLOW.as_bytes()).unwrap();
    let uploaded = |board: Board, stays: bool| {
        let fake = Fake::new(board);
        let mut client = client(&fake);
        let before = stop(&mut client).unwrap().state.unwrap();
        send(&mut client, FOLLOW).unwrap();
        let behind = go_on(&mut client, before, kept, stays).unwrap();
        let state = fake.board().state;
        (behind, state)
    };
    assert_eq!(uploaded(Board::in_state(RUN), true), (Behind::Stop, STOP));
    assert_eq!(uploaded(Board::in_state(STOP), false), (Behind::Run, RUN));
    let switched = |state| Board {
        switch: true,
        ..Board::in_state(state)
    };
    assert_eq!(uploaded(switched(STOP), false), (Behind::Switch, STOP));
    assert_eq!(uploaded(Board::in_state(FAULT), false), (Behind::Run, RUN));
    assert_eq!(
        uploaded(Board::in_state(FAULT), true),
        (Behind::Faulty, FAULT)
    );
    assert_eq!(uploaded(switched(FAULT), false), (Behind::Switch, STOP));
    let card = Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..Board::in_state(FAULT)
    };
    assert_eq!(uploaded(card, false), (Behind::Card, RUN));
    let broken = Board {
        fault_at_restart: 64,
        ..Board::in_state(FAULT)
    };
    let (behind, state) = uploaded(broken, false);
    let Behind::Trouble(trouble) = behind else {
        panic!("{behind:?}");
    };
    assert_eq!((trouble.number, trouble.line, state), (64, None, FAULT));
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
