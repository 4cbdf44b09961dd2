//! The unoclp firmware for the Arduino UNO.
//!
//! Start-up: outputs off, the clock, the card; `PROGRAM.TXT` goes byte by byte through the loader
//! into run memory; the card is released. Then scans for ever, or a fault with everything off.
//!
//! Only `board` touches registers. What can go wrong is a value until it is shown; nothing here
//! panics, and if the compiler's checks ever found otherwise, [`halt`] turns the outputs off.

#![no_std]
#![no_main]
#![feature(abi_avr_interrupt, asm_experimental_arch)]
#![allow(
    static_mut_refs,
    reason = "avr_device::entry lends main's statics once, to main"
)]

mod board;
mod card;
mod halt;
mod indicator;
mod report;

use board::Board;
use board::pins::Pins;
use unoclp_core::{Plc, Profile};

/// Run memory: the code of the program and the data of its timers.
const RUN_MEMORY: usize = Profile::UNO.linked_bytes as usize;

#[avr_device::entry]
fn main() -> ! {
    static mut MEMORY: [u8; RUN_MEMORY] = [0; RUN_MEMORY];

    let mut board = Board::take();
    report::banner(&mut board.serial);
    let loaded = card::load(&board, MEMORY);
    board.release_card();
    match loaded {
        Ok(program) => {
            report::program(&mut board.serial, &program);
            let mut plc = Plc::new(program);
            board.pins.led(true);
            loop {
                scan(&board.pins, &mut plc);
            }
        }
        Err(fault) => {
            report::fault(&mut board.serial, fault);
            indicator::show(&board.pins, fault.cause)
        }
    }
}

/// One scan (NC-5): one reading of the inputs, one time stamp, one writing of the outputs.
///
/// A simulator stops the firmware at this symbol to set pins and clock before each scan.
#[unsafe(export_name = "scan_begin")]
#[inline(never)]
fn scan(pins: &Pins, plc: &mut Plc<'_>) {
    // In this order: an input is never seen with a time stamp from before it changed.
    let inputs = pins.inputs();
    let now = board::clock::now();
    let outputs = plc.scan(inputs, now);
    pins.write_outputs(outputs);
}
