//! What `unoclp upload`, `unoclp monitor` and `unoclp settings` say to a board, said to the firmware.

use crate::common::line::{meet, talk, talk_at};
use crate::common::{card, uno};
use unoclp_client::diagnostics::{Kept, Trouble};
use unoclp_client::map::{Command, State};
use unoclp_client::settings::{Settings, read_lock};
use unoclp_client::start::{NotFound, find};
use unoclp_client::upload::{Behind, Broken, await_start, go_on, stop, upload};
use unoclp_client::watch::{self, Forces, Reading, Scope, Side};
use unoclp_client::{Failure, Line, Order, Parity, lock};
use unoclp_core::{Board, Loader};
use unoclp_modbus::Exception;
use unoclp_uno_sim::{Line as Wire, Slot, Uno};

/// Input 01 is output 01; output 02 is its opposite.
const PROGRAM: &str = "0\n827301\n877901\n787600\n-827301\n877902\n";

/// Input 02 is output 03.
const OTHER: &str = "0\n827302\n877903\n";

/// A board with this program on its card, which has been found.
fn board(program: &str) -> Uno {
    let mut uno = uno(Slot::Card(card(program)));
    meet(&mut uno);
    uno
}

/// How a board keeps the program of this text.
fn kept(text: &str) -> Kept {
    let mut memory = vec![0; Board::UNO.linked_bytes.into()];
    let mut loader = Loader::new(&mut memory, Board::UNO);
    text.bytes().for_each(|byte| loader.push(byte).unwrap());
    Kept::of(&loader.finish().unwrap())
}

fn read(uno: &mut Uno) -> Reading {
    talk(uno, async |client| {
        Reading::read(client, Scope::default()).await
    })
    .unwrap()
}

fn command(uno: &mut Uno, command: Command) -> Result<(), Failure> {
    talk(uno, async |client| watch::command(client, command).await)
}

fn send(uno: &mut Uno, text: &str, sent: Kept) -> Result<Kept, Broken> {
    talk(uno, async |client| {
        upload(client, text.as_bytes(), sent, &mut |_| ()).await
    })
}

fn set_inputs(uno: &mut Uno, inputs: u8) {
    uno.set_inputs(inputs);
    uno.run_ms(20).unwrap();
}

#[test]
fn a_board_shows_what_it_does() {
    let mut uno = board(PROGRAM);
    let reading = read(&mut uno);
    let board = reading.diagnostics;
    assert_eq!((board.state, board.trouble), (Some(State::Run), None));
    assert_eq!(board.program, kept(PROGRAM));
    assert!((4900..5100).contains(&board.supply), "{} mV", board.supply);
    assert!(board.free_stack > 0 && board.scan_times[0] > 0, "{board:?}");
    assert_eq!((reading.inputs, reading.outputs), (0, 0b10));
    set_inputs(&mut uno, 1);
    let later = read(&mut uno);
    assert_eq!((later.inputs, later.outputs), (1, 0b01));
    assert!(later.diagnostics.uptime > board.uptime);
}

#[test]
fn forces_move_pins_until_they_are_let_go() {
    let mut uno = board(PROGRAM);
    let mut order = |order: Order| {
        let done = talk(&mut uno, async |client| {
            order.fulfil(client, None, &mut |_| ()).await
        });
        done.unwrap();
        uno.run_ms(20).unwrap();
        (uno.outputs(), read(&mut uno))
    };
    let (pins, reading) = order(Order::Force(Side::Inputs, 0, Some(true)));
    assert_eq!((pins, reading.inputs, reading.outputs), (0b01, 1, 0b01));
    let (pins, reading) = order(Order::Force(Side::Outputs, 1, Some(true)));
    assert_eq!((pins, reading.outputs), (0b11, 0b11));
    let forced = Forces { points: 2, to: 2 };
    assert_eq!(reading.forced_outputs, forced);
    let (pins, reading) = order(Order::Command(Command::Stop));
    assert_eq!((pins, reading.diagnostics.state), (0, Some(State::Stop)));
    assert_eq!(reading.forced_outputs, forced, "STOP keeps forces");
    let (pins, _) = order(Order::Command(Command::Run));
    assert_eq!(pins, 0b11);
    let (pins, reading) = order(Order::Release);
    assert_eq!((pins, reading.forced_inputs), (0b10, Forces::default()));
}

#[test]
fn commands_do_what_the_page_says() {
    let mut uno = board(PROGRAM);
    let refused = Err(Failure::Refused(Exception::ServerDeviceFailure));
    command(&mut uno, Command::Stop).unwrap();
    set_inputs(&mut uno, 1);
    command(&mut uno, Command::SingleScan).unwrap();
    uno.run_ms(20).unwrap();
    assert_eq!(read(&mut uno).outputs, 0b01, "in the image");
    assert_eq!(uno.outputs(), 0, "on no pin");

    uno.set_stop(true);
    uno.run_ms(50).unwrap();
    assert_eq!(command(&mut uno, Command::Run), refused);
    assert!(read(&mut uno).diagnostics.is_switched_off());
    uno.set_stop(false);
    uno.run_ms(50).unwrap();

    command(&mut uno, Command::Restart).unwrap();
    let after = talk(&mut uno, await_start).unwrap();
    assert_eq!((after.state, after.cause), (Some(State::Run), 5));
    assert_eq!(uno.outputs(), 0b01);
}

#[test]
fn an_uploaded_program_runs() {
    let mut uno = board(PROGRAM);
    // Several blocks.
    let text = format!("/{}\n{OTHER}", "comment ".repeat(100));
    let before = talk(&mut uno, stop).unwrap().state.unwrap();
    let stored = send(&mut uno, &text, kept(&text)).unwrap();
    assert_eq!(stored, kept(&text));
    let behind = talk(&mut uno, async |client| {
        go_on(client, before, stored, false).await
    });
    assert_eq!(behind.unwrap(), Behind::Run);
    set_inputs(&mut uno, 0b10);
    assert_eq!(uno.outputs(), 0b100);
    let board = read(&mut uno).diagnostics;
    assert_eq!((board.state, board.program), (Some(State::Run), stored));
}

#[test]
fn a_fault_in_an_upload_has_its_line_and_leaves_the_old_program() {
    let mut uno = board(PROGRAM);
    talk(&mut uno, stop).unwrap();
    let nothing = Kept::default();
    let text = format!("/{}\n0\n123\n", "comment ".repeat(100));
    let error = send(&mut uno, &text, nothing).unwrap_err();
    let (number, line) = (24, Some(3));
    assert_eq!(error, Broken::Fault(Trouble { number, line }));
    assert_eq!(read(&mut uno).diagnostics.program, kept(PROGRAM));
    command(&mut uno, Command::Run).unwrap();
    uno.run_ms(20).unwrap();
    assert_eq!(uno.outputs(), 0b10);

    let error = send(&mut uno, &text, nothing).unwrap_err();
    assert_eq!(error, Broken::NotBegun, "it is in RUN");
}

#[test]
fn a_board_in_fault_is_healed_by_an_upload() {
    let mut uno = uno(Slot::Empty);
    meet(&mut uno);
    let before = talk(&mut uno, stop).unwrap();
    assert_eq!(before.state, Some(State::Fault));
    let trouble = before.trouble.unwrap();
    assert!(
        trouble.fault().is_some() && trouble.line.is_none(),
        "{trouble:?}"
    );
    let stored = send(&mut uno, PROGRAM, kept(PROGRAM)).unwrap();
    let behind = talk(&mut uno, async |client| {
        go_on(client, State::Fault, stored, false).await
    });
    assert_eq!(behind.unwrap(), Behind::Run);
    uno.run_ms(20).unwrap();
    assert_eq!(uno.outputs(), 0b10);
}

#[test]
fn a_lock_is_set_and_holds_at_once() {
    let mut uno = board(PROGRAM);
    talk(&mut uno, stop).unwrap();
    let old = talk(&mut uno, Settings::read).unwrap();
    let new = Settings {
        lock: Some(lock::UPLOAD | lock::SETTINGS),
        ..old
    };
    talk(&mut uno, async |client| new.write(old, client).await).unwrap();
    assert_eq!(talk(&mut uno, read_lock), Ok(lock::UPLOAD | lock::SETTINGS));
    assert_eq!(send(&mut uno, OTHER, kept(OTHER)), Err(Broken::Locked));
    // The same once more is refused, as where an answer was lost, and is taken for done.
    let again = talk(&mut uno, async |client| new.write(old, client).await);
    assert_eq!(again, Ok(()));
    command(&mut uno, Command::Run).unwrap();
    assert_eq!(read(&mut uno).forcing_ends, Some(0));
}

#[test]
fn new_settings_are_used_from_the_restart_on() {
    let mut uno = board(PROGRAM);
    let old = talk(&mut uno, Settings::read).unwrap();
    let first = Settings {
        address: 1,
        rate: 115_200,
        parity: Parity::None,
        direction: false,
        lock: Some(0),
    };
    assert_eq!(old, first);
    let new = Settings {
        address: 9,
        rate: 19_200,
        ..old
    };
    talk(&mut uno, stop).unwrap();
    talk(&mut uno, async |client| new.write(old, client).await).unwrap();
    assert_eq!(talk(&mut uno, Settings::read).unwrap(), new);
    command(&mut uno, Command::Restart).unwrap();
    let wire = uno.serial_line();
    uno.set_serial_line(Wire {
        baud: 19_200,
        ..wire
    });
    let at = Line {
        address: 9,
        rate: 19_200,
        ..Line::default()
    };
    talk_at(&mut uno, at, async |client| find(client, true).await).unwrap();
    let reading = talk_at(&mut uno, at, async |client| {
        Reading::read(client, Scope::default()).await
    });
    let board = reading.unwrap().diagnostics;
    assert_eq!(board.state, Some(State::Run));
    let elsewhere = Line { address: 1, ..at };
    let nobody = talk_at(&mut uno, elsewhere, async |client| {
        find(client, false).await
    });
    assert_eq!(nobody, Err(NotFound::Silent));
}
