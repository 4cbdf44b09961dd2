//! What the serial port says at setup (NC-11).

use crate::board::flash::{FlashText, flash_text};
use crate::board::serial::Serial;
use unoclp_core::{Cause, Fault, Profile, Program, faults};

/// Name and version.
pub fn banner(serial: &mut Serial) {
    serial.text(flash_text!(concat!(
        "\r\nunoclp ",
        env!("CARGO_PKG_VERSION"),
        "\r\n"
    )));
}

/// The size of the program, and that it runs.
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
    serial.text(flash_text!("\r\nRUN\r\n"));
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
