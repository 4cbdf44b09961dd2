//! `unoclp upload`, `unoclp monitor` and `unoclp settings` on the firmware, over a pseudo-terminal.

mod common;

use common::{card, firmware};
use std::time::Duration;
use unoclp_board::client::{Client, Failure};
use unoclp_board::diagnostics::Kept;
use unoclp_board::map::{Command, State};
use unoclp_board::settings::Settings;
use unoclp_board::start::{NotFound, find};
use unoclp_board::upload::{Behind, Broken, await_start, go_on, stop, upload};
use unoclp_board::watch::{Forces, Reading, Scope, Side, Wish};
use unoclp_board::{Line, Parity, Patience};
use unoclp_modbus::Exception;
use unoclp_uno_sim::port::{Options, Port};
use unoclp_uno_sim::{Line as Wire, Slot};

/// Input 01 is output 01; output 02 is its opposite.
const PROGRAM: &str = "0\n827301\n877901\n787600\n-827301\n877902\n";

/// Input 02 is output 03.
const OTHER: &str = "0\n827302\n877903\n";

/// So much that no machine is too slow for it.
const PATIENT: Patience = Patience {
    answer: Duration::from_secs(5),
    attempts: 20,
    start: Duration::from_secs(100),
    store: Duration::from_secs(60),
};

/// A board with this program on its card.
fn board(program: &str) -> Port {
    Port::open(firmware(), Slot::Card(card(program)), Options::default()).unwrap()
}

fn line(port: &Port) -> Line {
    Line {
        port: port.path().to_str().unwrap().to_owned(),
        address: 1,
        rate: 115_200,
        parity: Parity::None,
    }
}

/// The client of a board that has started.
fn client(port: &Port) -> Client {
    let found = find(&line(port), PATIENT).unwrap();
    assert_eq!(found.identity.product, "unoclp UNO");
    found.client
}

fn read(client: &mut Client) -> Reading {
    Reading::read(client, Scope::default()).unwrap()
}

/// Runs for so long, faster than the clock on the wall.
fn pass(port: &Port, ms: u64) {
    port.with(move |uno| uno.run_ms(ms)).unwrap().unwrap();
}

fn outputs(port: &Port) -> u8 {
    port.with(|uno| uno.outputs()).unwrap()
}

fn set_inputs(port: &Port, inputs: u8) {
    port.with(move |uno| uno.set_inputs(inputs)).unwrap();
    pass(port, 20);
}

#[test]
fn a_board_shows_what_it_does() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    let reading = read(&mut client);
    let board = reading.diagnostics;
    assert_eq!((board.state, board.trouble), (Some(State::Run), None));
    assert_eq!(board.program, Kept::of(PROGRAM.as_bytes()).unwrap());
    assert!((4900..5100).contains(&board.supply), "{} mV", board.supply);
    assert!(board.free_stack > 0 && board.scan_times[0] > 0, "{board:?}");
    assert_eq!((reading.inputs, reading.outputs), (0, 0b10));
    set_inputs(&port, 1);
    let later = read(&mut client);
    assert_eq!((later.inputs, later.outputs), (1, 0b01));
    assert!(later.diagnostics.uptime > board.uptime);
}

#[test]
fn forces_move_pins_until_they_are_let_go() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    let mut wish = |wish: Wish| {
        wish.fulfil(&mut client).unwrap();
        pass(&port, 20);
        (outputs(&port), read(&mut client))
    };
    let (pins, reading) = wish(Wish::Force(Side::Inputs, 0, Some(true)));
    assert_eq!((pins, reading.inputs, reading.outputs), (0b01, 1, 0b01));
    let (pins, reading) = wish(Wish::Force(Side::Outputs, 1, Some(true)));
    assert_eq!((pins, reading.outputs), (0b11, 0b11));
    let forced = Forces { points: 2, to: 2 };
    assert_eq!(reading.forced_outputs, forced);
    let (pins, reading) = wish(Wish::Command(Command::Stop));
    assert_eq!((pins, reading.diagnostics.state), (0, Some(State::Stop)));
    assert_eq!(reading.forced_outputs, forced, "STOP keeps forces");
    let (pins, _) = wish(Wish::Command(Command::Run));
    assert_eq!(pins, 0b11);
    let (pins, reading) = wish(Wish::Release);
    assert_eq!((pins, reading.forced_inputs), (0b10, Forces::default()));
}

#[test]
fn commands_do_what_the_page_says() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    let refused = |outcome| {
        matches!(
            outcome,
            Err(Failure::Refused(Exception::ServerDeviceFailure))
        )
    };
    assert!(refused(Wish::Command(Command::Scan).fulfil(&mut client)));
    Wish::Command(Command::Stop).fulfil(&mut client).unwrap();
    set_inputs(&port, 1);
    Wish::Command(Command::Scan).fulfil(&mut client).unwrap();
    pass(&port, 20);
    assert_eq!(read(&mut client).outputs, 0b01, "in the image");
    assert_eq!(outputs(&port), 0, "on no pin");

    port.with(|uno| uno.set_stop(true)).unwrap();
    pass(&port, 50);
    assert!(refused(Wish::Command(Command::Run).fulfil(&mut client)));
    assert!(read(&mut client).diagnostics.is_switched_off());
    port.with(|uno| uno.set_stop(false)).unwrap();
    pass(&port, 50);

    let restart = Wish::Command(Command::Restart);
    restart.fulfil(&mut client).unwrap();
    pass(&port, 200);
    let after = await_start(&mut client).unwrap();
    assert_eq!((after.state, after.cause), (Some(State::Run), 5));
    assert_eq!(outputs(&port), 0b01);
}

#[test]
fn an_uploaded_program_runs() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    // Several blocks.
    let text = format!("/{}\n{OTHER}", "comment ".repeat(100));
    let kept = Kept::of(text.as_bytes()).unwrap();
    let before = stop(&mut client).unwrap().state.unwrap();
    upload(&mut client, text.as_bytes(), kept, &mut |_| ()).unwrap();
    assert_eq!(
        go_on(&mut client, before, kept, false).unwrap(),
        Behind::Run
    );
    set_inputs(&port, 0b10);
    assert_eq!(outputs(&port), 0b100);
    let board = read(&mut client).diagnostics;
    assert_eq!((board.state, board.program), (Some(State::Run), kept));
}

#[test]
fn a_fault_in_an_upload_has_its_line_and_leaves_the_old_program() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    stop(&mut client).unwrap();
    let nothing = Kept::default();
    let text = format!("/{}\n0\n123\n", "comment ".repeat(100));
    let error = upload(&mut client, text.as_bytes(), nothing, &mut |_| ()).unwrap_err();
    assert_eq!(error.to_string(), "fault 24, line 3: no such code");
    let kept = Kept::of(PROGRAM.as_bytes()).unwrap();
    assert_eq!(read(&mut client).diagnostics.program, kept);
    Wish::Command(Command::Run).fulfil(&mut client).unwrap();
    pass(&port, 20);
    assert_eq!(outputs(&port), 0b10);

    let error = upload(&mut client, text.as_bytes(), nothing, &mut |_| ()).unwrap_err();
    assert!(matches!(error, Broken::NotBegun), "it is in RUN: {error}");
}

#[test]
fn a_board_in_fault_is_healed_by_an_upload() {
    let port = Port::open(firmware(), Slot::Empty, Options::default()).unwrap();
    let mut client = client(&port);
    let before = stop(&mut client).unwrap();
    assert_eq!(before.state, Some(State::Fault));
    let trouble = before.trouble.unwrap();
    assert!(
        trouble.fault().is_some() && trouble.line.is_none(),
        "{trouble}"
    );
    let kept = Kept::of(PROGRAM.as_bytes()).unwrap();
    upload(&mut client, PROGRAM.as_bytes(), kept, &mut |_| ()).unwrap();
    let behind = go_on(&mut client, State::Fault, kept, false).unwrap();
    assert_eq!(behind, Behind::Run);
    pass(&port, 20);
    assert_eq!(outputs(&port), 0b10);
}

#[test]
fn new_settings_are_used_from_the_restart_on() {
    let port = board(PROGRAM);
    let mut client = client(&port);
    let old = Settings::read(&mut client).unwrap();
    assert_eq!(
        old.to_string(),
        "address 1, 115200 baud, no parity, direction pin off"
    );
    let new = Settings {
        address: 9,
        rate: 19_200,
        ..old
    };
    stop(&mut client).unwrap();
    new.write(&mut client).unwrap();
    assert_eq!(Settings::read(&mut client).unwrap(), new);
    Wish::Command(Command::Restart).fulfil(&mut client).unwrap();
    drop(client);
    port.with(|uno| {
        let wire = uno.serial_line();
        uno.set_serial_line(Wire {
            baud: 19_200,
            ..wire
        });
    })
    .unwrap();
    let at = Line {
        address: 9,
        rate: 19_200,
        ..line(&port)
    };
    let mut client = find(&at, PATIENT).unwrap().client;
    assert_eq!(read(&mut client).diagnostics.state, Some(State::Run));
    drop(client);
    let once = Patience {
        answer: Duration::from_millis(50),
        attempts: 1,
        ..PATIENT
    };
    let elsewhere = Line { address: 1, ..at };
    let nobody = find(&elsewhere, once).err().unwrap();
    assert!(matches!(nobody, NotFound::Silent { .. }), "{nobody}");
}
