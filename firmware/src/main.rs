//! The unoclp firmware for the Arduino UNO.
//!
//! Start-up: outputs off, the clock, the card; `PROGRAM.TXT` goes byte by byte through the loader,
//! is kept in the EEPROM, and taken from there into run memory; the card is released. Then scans
//! for ever, watched by the diagnosis and the watchdog, or a fault with everything off.
//!
//! Only `board` touches registers. What can go wrong is a value until it is shown; nothing here
//! panics, and if the compiler's checks ever found otherwise, [`halt`] turns the outputs off.

#![no_std]
#![no_main]
#![feature(asm_experimental_arch)]
#![allow(
    static_mut_refs,
    reason = "avr_device::entry lends main's statics once, to main"
)]

mod board;
mod card;
mod decimal;
mod diagnosis;
mod engine;
mod halt;
mod indicator;
mod report;
mod state;
mod store;

// What the compiler calls: products, and blocks of memory.
core::arch::global_asm!(include_str!("runtime.s"));

use board::Board;
use board::watchdog::{self, Start};
use card::StateFile;
use diagnosis::{Diagnosis, Turn};
use engine::Linked;
use state::{Images, State};
use unoclp_card::Block;
use unoclp_core::{Cause, Fault, Image, Profile, Program};

/// Run memory: the code of the program and the data of its timers, and a byte for the end.
const RUN_MEMORY: usize = Profile::UNO.linked_bytes as usize + 1;

#[avr_device::entry]
fn main() -> ! {
    static mut MEMORY: [u8; RUN_MEMORY] = [0; RUN_MEMORY];
    static mut PAGE: Block = [0; 512];

    let mut board = Board::take();
    report::banner(&mut board);
    let mut state = StateFile::Missing;
    let program = start(&mut board, PAGE, MEMORY, &mut state);
    board.release_card();
    let fault = match program {
        Ok(program) => {
            report::program(&mut board.serial, &program);
            report::state_file(&mut board.serial, &state);
            report::run(&mut board.serial);
            Fault::without_line(run(&mut board, program, state))
        }
        Err(fault) => fault,
    };
    board.pins.write_outputs(Image::default());
    board.release_card();
    board.watchdog.stop();
    board.watchdog.count_fault();
    report::fault(&mut board.serial, fault);
    indicator::show(&board.pins, fault.cause)
}

/// Scans until the diagnosis finds a fault; while STOP is closed the outputs are off.
#[inline(never)]
fn run(board: &mut Board, program: Program<'_>, state: StateFile) -> Cause {
    let Some(mut plc) = Linked::link(program) else {
        return Cause::RunMemoryFull;
    };
    let mut diagnosis = Diagnosis::new(plc.code());
    let mut state = State::new(match state {
        StateFile::Found(place) => Some(place),
        _ => None,
    });
    board.watchdog.start();
    board.pins.led(true);
    let mut begun = board.moment().forgotten();
    loop {
        if board.pins.stop() {
            stop(board, &diagnosis, &mut state);
            plc.restart();
            begun = board.moment().forgotten();
        }
        watchdog::scan_begins();
        // In this order: an input is never seen with a time stamp from before it changed (NC-5).
        let inputs = board.pins.inputs();
        let now = board.moment();
        diagnosis.scanned(begun, now);
        begun = now;
        let outputs = plc.scan(inputs, now.millis);
        board.pins.write_outputs(outputs);
        match diagnosis.slice(board) {
            Ok(Turn::Free) if state.is_kept() => {
                state.step(board, Images { inputs, outputs }, diagnosis.times());
            }
            Ok(_) => {}
            Err(cause) => return cause,
        }
    }
}

/// STOP, until A5 is open again: outputs off, program kept.
#[inline(never)]
fn stop(board: &mut Board, diagnosis: &Diagnosis<'_>, state: &mut State) {
    board.pins.write_outputs(Image::default());
    report::stop(board, diagnosis.times(), state);
    indicator::show_stop(&board.pins, || {
        watchdog::feed();
        let images = Images {
            inputs: board.pins.inputs(),
            outputs: Image::default(),
        };
        state.step(board, images, diagnosis.times());
    });
    board.pins.led(true);
    report::run(&mut board.serial);
}

/// The program to run. What the card holds is kept in program memory, and what is kept there is
/// what runs; so it runs too where there is no card, or none with a program on it. Any other
/// failure is a fault: what the user wants now was refused, or cannot be known.
fn start<'m>(
    board: &mut Board,
    page: &mut Block,
    memory: &'m mut [u8],
    state: &mut StateFile,
) -> Result<Program<'m>, Fault> {
    match board.start {
        Start::Watchdog => return Err(Fault::without_line(Cause::ScanTooLong)),
        Start::Astray => return Err(Fault::without_line(Cause::ProgramDamaged)),
        Start::Power | Start::Reset => {}
    }
    if board.supply.is_low() {
        return Err(Fault::without_line(Cause::SupplyLow));
    }
    let missing = match card::load(board, page, memory, state) {
        Ok(program) => {
            store::save(&board.eeprom, program.stored()).map_err(Fault::without_line)?;
            None
        }
        Err(fault) if matches!(fault.cause, Cause::NoCard | Cause::NoProgramFile) => Some(fault),
        Err(fault) => return Err(fault),
    };
    match missing {
        Some(fault) if store::is_blank(&board.eeprom) => return Err(fault),
        Some(fault) => report::without_card(&mut board.serial, fault.cause),
        None => {}
    }
    store::load(&board.eeprom, memory).ok_or(Fault::without_line(Cause::NoStoredProgram))
}
