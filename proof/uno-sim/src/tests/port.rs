//! A board behind a pseudo-terminal.

use super::assembly::*;
use super::serial::{AT_115200, FORM_8N1, echo_program};
use crate::port::{Options, Pace, Port, PortError};
use crate::{Halt, Program, Slot};
use rustix::fs::{Mode, OFlags};
use rustix::termios::{OptionalActions, OutputModes, SpecialCodeIndex, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

fn port(words: &[u16], options: Options) -> Port {
    Port::open(Program::from_words(words), Slot::Empty, options).expect("a pseudo-terminal")
}

/// The port opened as a program does that talks over it. A read gives up after 5 s.
fn user(port: &Port) -> File {
    user_with(port.path(), OutputModes::empty())
}

fn user_with(path: &Path, output: OutputModes) -> File {
    let flags = OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC;
    let user = rustix::fs::open(path, flags, Mode::empty()).expect("the port");
    let mut modes = tcgetattr(&user).expect("a terminal");
    modes.make_raw();
    modes.output_modes |= output;
    modes.special_codes[SpecialCodeIndex::VMIN] = 0;
    modes.special_codes[SpecialCodeIndex::VTIME] = 50;
    tcsetattr(&user, OptionalActions::Now, &modes).expect("a terminal");
    user.into()
}

/// Lets the program switch its receiver on.
fn start_up(port: &Port) {
    let run = port.with(|uno| uno.run_ms(1));
    run.expect("it runs").expect("it goes on");
}

fn read(user: &mut File, count: usize) -> Vec<u8> {
    let mut bytes = vec![0; count];
    user.read_exact(&mut bytes).expect("bytes in time");
    bytes
}

#[test]
fn a_user_talks_with_the_board() {
    for pace in [Pace::Quiet, Pace::RealTime] {
        let options = Options {
            pace,
            ..Options::default()
        };
        let port = port(&echo_program(AT_115200.0, FORM_8N1), options);
        start_up(&port);
        let bytes: Vec<u8> = (0..=255).cycle().take(600).collect();
        // One after the other, as tools that are called again and again.
        for _ in 0..2 {
            let mut user = user(&port);
            for part in bytes.chunks(200) {
                user.write_all(part).expect("the port");
                assert_eq!(read(&mut user, 200), part);
            }
        }
        port.close().expect("it runs until then");
    }
}

#[test]
fn a_line_feed_of_a_user_stays_one_byte() {
    let port = port(&echo_program(AT_115200.0, FORM_8N1), Options::default());
    start_up(&port);
    let path = port.path().to_owned();
    // Node's raw mode. The board stands until it is set, and then looks.
    let node = OutputModes::OPOST | OutputModes::ONLCR;
    let mut user = port.with(move |_| user_with(&path, node)).expect("it runs");
    port.with(|_| ()).expect("it runs");
    user.write_all(b"a\nb").expect("the port");
    assert_eq!(read(&mut user, 3), b"a\nb");
    port.close().expect("it runs until then");
}

#[test]
fn the_board_can_be_reached_while_it_runs() {
    // Sends the inputs 01 to 04 over and over.
    let mut words = vec![ldi(16, 0x3C), out(PORTD, 16)];
    words.extend(super::serial::set_up(AT_115200.0, FORM_8N1, 0x08));
    words.extend([
        sbi(PORTD, 6), // the loop
        lds(17),
        UCSR0A,
        sbrs(17, 5), // UDRE
        rjmp(-4),
        input(18, PIND),
        sts(18),
        UDR0,
        rjmp(-9),
    ]);
    let port = port(&words, Options::default());
    // What is sent before anybody has the port open is lost.
    port.with(|uno| uno.run_ms(10))
        .expect("it runs")
        .expect("it goes on");
    let mut user = user(&port);
    let before = port.with(|uno| {
        uno.set_input(0, true);
        uno.cycles()
    });
    let mut seen = 0xFF;
    while seen & 0x04 != 0 {
        seen = read(&mut user, 1)[0];
    }
    assert_eq!(seen & 0x3C, 0x38);
    let after = port.with(|uno| uno.cycles()).expect("it runs");
    assert!(after > before.expect("it runs"));
    assert!(port.is_running());
    port.close().expect("it runs until then");
    // The end of the port is the end of the file, or an error.
    let mut rest = Vec::new();
    let _ = user.read_to_end(&mut rest);
    assert_eq!(user.write(b"x").map_err(drop), Err(()));
}

#[test]
fn a_program_that_ends_takes_the_port_with_it() {
    let port = port(&[NOP, HERE], Options::default());
    while port.with(|_| ()).is_ok() {}
    assert!(matches!(port.with(|_| ()), Err(PortError::Ended)));
    let end = port.close();
    assert!(
        matches!(end, Err(PortError::Halt(Halt::Hung { .. }))),
        "{end:?}"
    );
}

#[test]
fn opening_the_port_can_reset_the_board() {
    for (reset_on_open, resets) in [(false, 0), (true, 2)] {
        let options = Options {
            reset_on_open,
            ..Options::default()
        };
        let port = port(&echo_program(AT_115200.0, FORM_8N1), options);
        for opened in 1..=2 {
            let mut user = user(&port);
            let resets = || port.with(|uno| uno.resets()).expect("it runs");
            while reset_on_open && resets() < opened {}
            start_up(&port);
            user.write_all(b"?").expect("the port");
            assert_eq!(read(&mut user, 1), b"?");
            drop(user);
            // Between one job and the next but one, the port is looked at.
            for _ in 0..2 {
                resets();
            }
        }
        assert_eq!(port.with(|uno| uno.resets()).expect("it runs"), resets);
    }
}
