//! What the serial port says at setup (NC-11).

use crate::board::flash::flash_text;
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
    serial.number(program.codes().into());
    serial.text(flash_text!(" codes, "));
    serial.number(used.into());
    serial.text(flash_text!(" bytes used, "));
    serial.number(Profile::UNO.stored_bytes.saturating_sub(used).into());
    serial.text(flash_text!(" free, "));
    serial.number(program.timers() as u32);
    serial.text(flash_text!(" timers\r\nRUN\r\n"));
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
