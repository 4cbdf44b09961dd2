//! The unoclp firmware for the Arduino UNO, and for the Arduino Mega 2560.
//!
//! Start-up: outputs off, the clock, the card; `PROGRAM.TXT` goes byte by byte through the loader,
//! is kept in the EEPROM, and taken from there into run memory; the card is released. Then scans
//! forever, watched by the diagnosis and the watchdog, or a fault with everything off; and beside either
//! the Modbus server.
//!
//! Owns what runs on the chip; only `board` touches registers. Must not know the text of a program. What can go wrong is a
//! value until it is shown; if the compiler's checks ever found a panic, [`halt`] turns the outputs off.

#![no_std]
#![no_main]
#![feature(asm_experimental_arch)]
// What has a bit for each point is cut to a byte where that is enough; on a small chip it is one.
#![cfg_attr(not(mega), allow(clippy::unnecessary_cast))]
#![allow(
    static_mut_refs,
    reason = "avr_device::entry lends main's statics once, to main"
)]

#[cfg_attr(mega, path = "mega/mod.rs")]
mod board;
mod card;
mod decimal;
mod diagnosis;
mod engine;
mod halt;
mod indicator;
mod instructions;
mod modes;
mod numbers;
mod operation;
mod page;
mod report;
mod retentive;
mod scan;
mod server;
mod settings;
mod state;
mod store;
#[cfg(mega)]
mod wide;

// What the compiler calls: products, and blocks of memory.
core::arch::global_asm!(include_str!("runtime.s"));

use board::Board;
use board::watchdog::{self, Start};
use card::StateFile;
use settings::Settings;
use store::Kept;
use unoclp_card::Block;
use unoclp_core::{Cause, Fault};

#[avr_device::entry]
fn main() -> ! {
    // SAFETY: once.
    let (page, memory) = unsafe { page::take() };
    let mut board = Board::take();
    let defaults = open_line(&mut board);
    report::banner(&board);
    let mut file = StateFile::Missing;
    let program = start(&board, page, memory, &mut file);
    board.release_card();
    modes::serve(&board, page::running(page), memory, defaults, file, program)
}

/// The serial line, as the settings have it; says whether the pins ask for the defaults.
#[inline(never)]
fn open_line(board: &mut Board) -> bool {
    let defaults = board.pins.ask_for_defaults();
    let mut settings = Settings::new();
    settings.load(&board.eeprom, defaults);
    board.serial.open(&settings.line());
    #[cfg(mega)]
    board.bus.open(&settings.line());
    defaults
}

/// Takes the program into program memory: what the card holds is kept there, and what is kept there is what
/// runs; so it runs too where there is no card, or none with a program on it. Any other failure is a
/// fault: what the user wants now was refused, or cannot be known.
fn start(
    board: &Board,
    page: &mut Block,
    memory: &mut [u8],
    file: &mut StateFile,
) -> Result<Kept, Fault> {
    match watchdog::started() {
        Start::Watchdog => return Err(Fault::without_line(Cause::ScanTooLong)),
        Start::Astray => return Err(Fault::without_line(Cause::ProgramDamaged)),
        Start::Power | Start::Reset | Start::Command => {}
    }
    if board.analogue.is_low() {
        return Err(Fault::without_line(Cause::SupplyLow));
    }
    let missing = match card::load(board, page, memory, file) {
        Ok(program) => {
            store::save(&board.eeprom, program.stored()).map_err(Fault::without_line)?;
            None
        }
        // Neither has a line.
        Err(Fault {
            cause: cause @ (Cause::NoCard | Cause::NoProgramFile),
            ..
        }) => Some(cause),
        Err(fault) => return Err(fault),
    };
    match missing {
        Some(cause) if store::is_blank(&board.eeprom) => return Err(Fault::without_line(cause)),
        Some(cause) => report::without_card(&board.serial, cause),
        None => {}
    }
    let program = modes::check(board, memory);
    if let Ok(kept) = &program {
        report::program(&board.serial, kept);
    }
    program
}
