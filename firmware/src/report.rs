//! What the serial port says at setup (NC-11).

use crate::board::Board;
use crate::board::flash::{Codes, FlashText, flash_codes, flash_text};
use crate::board::serial::Serial;
use crate::board::watchdog::{self, Start};
use crate::card::StateFile;
use crate::decimal::{DIGITS, decimal};
use crate::instructions::BOARD;
use crate::store::Kept;
use unoclp_core::{Cause, Fault};

/// Below this the supply is worth a warning, hundredths of a volt.
const WEAK: u16 = 460;

/// Name and version; why the board has started, where that was not power; the supply.
pub fn banner(board: &Board) {
    let serial = &board.serial;
    serial.text(flash_text!(concat!(
        "\r\nunoclp ",
        env!("CARGO_PKG_VERSION"),
        "\r\n"
    )));
    if watchdog::started() != Start::Power {
        value(serial, flash_text!("restart "), board.watchdog.restarts());
        serial.text(flash_text!(" since power-up, "));
        serial.text(match watchdog::started() {
            Start::Watchdog => flash_text!("by the watchdog, "),
            Start::Astray => flash_text!("without a reset, "),
            Start::Command => flash_text!("by command, "),
            _ => flash_text!("by reset, "),
        });
        count(serial, board.watchdog.faults(), flash_text!(" fault"));
        end_line(serial);
    }
    let centivolts = board.analogue.centivolts();
    if centivolts < WEAK {
        value(
            serial,
            flash_text!("warning: the supply is weak, "),
            centivolts * 10,
        );
        serial.text(flash_text!(" mV\r\n"));
    }
}

/// What set-up ends with, where there is no fault: from now on the port serves Modbus.
pub fn ready(serial: &Serial, stop: bool) {
    serial.text(if stop {
        flash_text!("STOP\r\n")
    } else {
        flash_text!("RUN\r\n")
    });
}

/// Why the program comes from program memory and not from a card.
pub fn without_card(serial: &Serial, cause: Cause) {
    serial.text(flash_text!("card: "));
    text(serial, cause);
    serial.text(flash_text!("\r\nthe program that was stored runs\r\n"));
}

/// The size of the program.
pub fn program(serial: &Serial, kept: &Kept) {
    let used = kept.length;
    serial.text(flash_text!("program: "));
    count(serial, kept.codes, flash_text!(" code"));
    serial.text(flash_text!(", "));
    count(serial, used, flash_text!(" byte"));
    let free = BOARD.stored_bytes.saturating_sub(used);
    value(serial, flash_text!(" used, "), free);
    serial.text(flash_text!(" free, "));
    count(serial, kept.timers.into(), flash_text!(" timer"));
    end_line(serial);
}

/// Whether the state is kept on the card.
pub fn state_file(serial: &Serial, file: &StateFile) {
    let what = match file {
        StateFile::Missing => return,
        StateFile::Found(_) => flash_text!("kept in STATE.TXT"),
        StateFile::Unfit => {
            flash_text!("STATE.TXT is read-only or under 512 B, not kept")
        }
        StateFile::Unreadable => flash_text!("STATE.TXT cannot be read, not kept"),
    };
    serial.text(flash_text!("state: "));
    serial.text(what);
    end_line(serial);
}

#[inline(never)]
fn end_line(serial: &Serial) {
    serial.text(flash_text!("\r\n"));
}

/// `, least 17`
#[inline(never)]
fn value(serial: &Serial, what: FlashText, number: u16) {
    serial.text(what);
    decimals(serial, number.into());
}

/// `1 code`, `2 codes`
fn count(serial: &Serial, number: u16, what: FlashText) {
    decimals(serial, number.into());
    serial.text(what);
    if number != 1 {
        serial.byte(b's');
    }
}

/// `fault 24, line 7: no such code`
pub fn fault(serial: &Serial, fault: &Fault) {
    serial.text(flash_text!("fault "));
    decimals(serial, fault.cause.number().into());
    if let Some(line) = fault.line {
        serial.text(flash_text!(", line "));
        decimals(serial, line);
    }
    serial.text(flash_text!(": "));
    text(serial, fault.cause);
    end_line(serial);
}

/// Sends a number in decimal.
fn decimals(serial: &Serial, number: u32) {
    let mut digits = [0; DIGITS];
    decimal(number, &mut digits);
    for &digit in &digits {
        if digit != b' ' {
            serial.byte(digit);
        }
    }
}

/// Sends the text of a cause.
fn text(serial: &Serial, cause: Cause) {
    let mut texts = flash_codes!(Codes::faults());
    while let Some(number) = texts.next() {
        for code in texts.by_ref().take_while(|code| *code != b'\n') {
            if number == cause.number() {
                serial.code(code);
            }
        }
    }
}
