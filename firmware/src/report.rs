//! What the serial port says at setup (NC-11).

use crate::board::Board;
use crate::board::flash::{FlashText, flash_text};
use crate::board::serial::Serial;
use crate::board::watchdog::Start;
use crate::card::StateFile;
use crate::diagnosis::ScanTimes;
use crate::state::State;
use unoclp_core::{Cause, Fault, Profile, Program, faults};

/// Below this the supply is worth a warning, hundredths of a volt.
const WEAK: u16 = 460;

/// Name and version; why the board has started, where that was not power; the supply.
pub fn banner(board: &mut Board) {
    let serial = &mut board.serial;
    serial.text(flash_text!(concat!(
        "\r\nunoclp ",
        env!("CARGO_PKG_VERSION"),
        "\r\n"
    )));
    if board.start != Start::Power {
        serial.text(flash_text!("restart "));
        serial.number(board.watchdog.restarts().into());
        serial.text(match board.start {
            Start::Watchdog => flash_text!(" since power-up, by the watchdog, "),
            Start::Astray => flash_text!(" since power-up, without a reset, "),
            _ => flash_text!(" since power-up, by reset, "),
        });
        count(serial, board.watchdog.faults(), flash_text!(" fault"));
        serial.text(flash_text!("\r\n"));
    }
    let centivolts = board.supply.centivolts();
    if centivolts < WEAK {
        serial.text(flash_text!("warning: the supply is weak, "));
        serial.number(u32::from(centivolts) * 10);
        serial.text(flash_text!(" mV\r\n"));
    }
}

/// STOP is closed; and what the diagnosis knows: how long scans took, the supply, restarts and faults
/// since power-up, whether the state is no longer kept.
pub fn stop(board: &mut Board, times: ScanTimes, state: &State) {
    let serial = &mut board.serial;
    serial.text(flash_text!("STOP, scan time: last "));
    serial.number(times.last.into());
    serial.text(flash_text!(", least "));
    serial.number(times.least.into());
    serial.text(flash_text!(", most "));
    serial.number(times.most.into());
    serial.text(flash_text!(" us\r\nsupply: "));
    let centivolts = board.supply.centivolts();
    serial.number(u32::from(centivolts) * 10);
    serial.text(flash_text!(" mV"));
    if centivolts < WEAK {
        serial.text(flash_text!(", weak"));
    }
    serial.text(flash_text!("; since power-up: "));
    count(serial, board.watchdog.restarts(), flash_text!(" restart"));
    serial.text(flash_text!(", "));
    count(serial, board.watchdog.faults(), flash_text!(" fault"));
    serial.text(flash_text!("\r\n"));
    if state.has_failed() {
        serial.text(flash_text!("state: the card failed, no longer kept\r\n"));
    }
}

/// Scanning begins, or goes on.
pub fn run(serial: &mut Serial) {
    serial.text(flash_text!("RUN\r\n"));
}

/// Why the program comes from program memory and not from a card.
pub fn without_card(serial: &mut Serial, cause: Cause) {
    serial.text(flash_text!("card: "));
    text(serial, cause);
    serial.text(flash_text!("\r\nthe program that was stored runs\r\n"));
}

/// The size of the program.
pub fn program(serial: &mut Serial, program: &Program<'_>) {
    let used = program.stored_bytes() as u16;
    serial.text(flash_text!("program: "));
    count(serial, program.codes(), flash_text!(" code"));
    serial.text(flash_text!(", "));
    count(serial, used, flash_text!(" byte"));
    serial.text(flash_text!(" used, "));
    let free = Profile::UNO.stored_bytes.saturating_sub(used);
    serial.number(free.into());
    serial.text(flash_text!(" free, "));
    count(serial, program.timers() as u16, flash_text!(" timer"));
    serial.text(flash_text!("\r\n"));
}

/// Whether the state is kept on the card.
pub fn state_file(serial: &mut Serial, file: &StateFile) {
    let what = match file {
        StateFile::Missing => return,
        StateFile::Found(_) => flash_text!("kept in STATE.TXT"),
        StateFile::Unfit => {
            flash_text!("STATE.TXT is read-only or shorter than 512 bytes, not kept")
        }
        StateFile::Unreadable => flash_text!("STATE.TXT cannot be read, not kept"),
    };
    serial.text(flash_text!("state: "));
    serial.text(what);
    serial.text(flash_text!("\r\n"));
}

/// `1 code`, `2 codes`
fn count(serial: &mut Serial, number: u16, what: FlashText) {
    serial.number(number.into());
    serial.text(what);
    if number != 1 {
        serial.byte(b's');
    }
}

/// `fault 24, line 7: no such code`
pub fn fault(serial: &mut Serial, fault: Fault) {
    serial.text(flash_text!("fault "));
    serial.number(fault.cause.number().into());
    if let Some(line) = fault.line {
        serial.text(flash_text!(", line "));
        serial.number(line);
    }
    serial.text(flash_text!(": "));
    text(serial, fault.cause);
    serial.text(flash_text!("\r\n"));
}

macro_rules! texts {
    ($($number:literal $name:ident $text:literal;)*) => {
        /// Every fault's number, text and a NUL. One text, because a table of pointers to texts
        /// would stand in RAM.
        const TEXTS: &str = concat!($($number, $text, "\0"),*);
    };
}
faults!(texts);

/// Sends the text of a cause.
fn text(serial: &mut Serial, cause: Cause) {
    let mut texts = flash_text!(TEXTS).bytes();
    while let (Some(tens), Some(units)) = (texts.next(), texts.next()) {
        let number = (tens - b'0') * 10 + (units - b'0');
        for byte in texts.by_ref().take_while(|byte| *byte != 0) {
            if number == cause.number() {
                serial.byte(byte);
            }
        }
    }
}
