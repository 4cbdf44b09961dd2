//! The unoclp firmware for the Arduino UNO.
//!
//! Start-up: outputs off, the clock, the card; `PROGRAM.TXT` goes byte by byte through the loader,
//! is kept in the EEPROM, and taken from there into run memory; the card is released. Then scans
//! for ever, watched by the diagnosis and the watchdog, or a fault with everything off; and beside either
//! the Modbus server.
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
mod server;
mod settings;
mod state;
mod store;

// What the compiler calls: products, and blocks of memory.
core::arch::global_asm!(include_str!("runtime.s"));

use board::Board;
use board::watchdog::{self, Start};
use card::StateFile;
use diagnosis::{Diagnosis, Turn};
use engine::Linked;
use server::upload;
use server::{Command, Server};
use state::{Images, State};
use unoclp_card::Block;
use unoclp_core::{Cause, Fault, Image, Profile};

/// Run memory: the code of the program and the data of its timers, and a byte for the end.
const RUN_MEMORY: usize = Profile::UNO.linked_bytes as usize + 1;

#[avr_device::entry]
fn main() -> ! {
    static mut MEMORY: [u8; RUN_MEMORY] = [0; RUN_MEMORY];
    static mut PAGE: Block = [0; 512];

    let board = Board::take();
    report::banner(&board);
    let mut file = StateFile::Missing;
    let outcome = start(&board, PAGE, MEMORY, &mut file);
    board.release_card();
    // From now on the page is the server's.
    match PAGE.first_chunk_mut() {
        Some(frame) => {
            let mut server = Server::new(frame, board.settings);
            serve(&board, MEMORY, file, outcome, &mut server)
        }
        None => unreachable!(),
    }
}

/// RUN, STOP and FAULT, for ever.
#[inline(never)]
fn serve(
    board: &Board,
    memory: &mut [u8],
    file: StateFile,
    outcome: Result<(), Fault>,
    server: &mut Server,
) -> ! {
    let mut fault = None;
    if let Err(first) = outcome {
        fault = Some(first.cause);
        fail(board, server, first);
        report::fault(&board.serial, first);
    } else {
        report::state_file(&board.serial, &file);
        report::ready(&board.serial, board.pins.stop());
    }
    let mut state = State::new(match file {
        StateFile::Found(place) => Some(place),
        _ => None,
    });
    server.start(board);
    loop {
        if let Some(cause) = fault {
            indicator::show(&board.pins, cause, || {
                server.panel.images.inputs = board.pins.inputs();
                server.step(board, None, server::AT_ONCE);
                server.panel.command == Some(Command::Upload)
            });
        } else {
            fault = run(board, memory, &mut state, server);
            board.pins.write_outputs(Image::default());
            board.watchdog.stop();
            if let Some(cause) = fault {
                fail(board, server, Fault::without_line(cause));
            }
        }
        upload::receive(board, server, memory);
    }
}

/// FAULT begins, and lasts until the next start.
#[inline(never)]
fn fail(board: &Board, server: &mut Server, fault: Fault) {
    board.release_card();
    board.watchdog.count_fault();
    server.panel.state = server::State::Fault;
    server.panel.fault = Some(fault);
    server.panel.images.outputs = Image::default();
}

/// Scans the program that is kept, until the diagnosis finds a fault, or in STOP an upload is to begin.
#[inline(never)]
fn run(board: &Board, memory: &mut [u8], state: &mut State, server: &mut Server) -> Option<Cause> {
    let Some(program) = store::load(&board.eeprom, memory) else {
        return Some(Cause::NoStoredProgram);
    };
    let Some(mut plc) = Linked::link(program) else {
        return Some(Cause::RunMemoryFull);
    };
    let mut diagnosis = Diagnosis::new(plc.code());
    board.watchdog.start();
    server.panel.state = server::State::Run;
    let mut begun = board.forgotten();
    loop {
        if server.panel.stopped || board.pins.stop() {
            server.panel.times = diagnosis.times();
            stop(board, &mut plc, state, server);
            if server.panel.command == Some(Command::Upload) {
                return None;
            }
            begun = board.forgotten();
        }
        watchdog::scan_begins();
        // In this order: an input is never seen with a time stamp from before it changed (NC-5).
        let inputs = server.panel.forces.inputs(board.pins.inputs());
        let now = board.moment();
        diagnosis.scanned(begun, now);
        begun = now;
        let outputs = server.panel.forces.outputs(plc.scan(inputs, now.millis));
        plc.set_outputs(outputs);
        if server.panel.state == server::State::Run {
            board.pins.write_outputs(outputs);
        }
        let images = Images { inputs, outputs };
        if !board.serial.is_quiet() {
            server.panel.times = diagnosis.times();
            server.panel.images = images;
            server.panel.card_failed = state.has_failed();
            server.step(board, None, server::SLICE);
            plc.set_outputs(server.panel.images.outputs);
        }
        match diagnosis.slice(board) {
            Ok(Turn::Free) => {
                indicator::show_run(&board.pins, server.panel.forces.any());
                if state.is_kept() {
                    state.step(board, images, diagnosis.times());
                }
            }
            Ok(Turn::Taken) => {}
            Err(cause) => {
                server.panel.times = diagnosis.times();
                return Some(cause);
            }
        }
    }
}

/// STOP, until RUN begins, or a single scan or an upload is to be made: outputs off, program kept.
#[inline(never)]
fn stop(board: &Board, plc: &mut Linked<'_>, state: &mut State, server: &mut Server) {
    board.pins.write_outputs(Image::default());
    if server.panel.state != server::State::Stop {
        server.panel.state = server::State::Stop;
        plc.restart();
    }
    server.panel.images.outputs = plc.outputs();
    let pins = &board.pins;
    indicator::show_stop(pins, || {
        watchdog::feed();
        let panel = &mut server.panel;
        let inputs = panel.forces.inputs(pins.inputs());
        panel.images.inputs = inputs;
        panel.card_failed = state.has_failed();
        let images = Images {
            inputs,
            outputs: Image::default(),
        };
        state.step(board, images, panel.times);
        server.step(board, None, server::AT_ONCE);
        let panel = &mut server.panel;
        plc.set_outputs(panel.images.outputs);
        if panel.takes(Command::SingleScan) || panel.command == Some(Command::Upload) {
            return true;
        }
        let over = !panel.stopped && !pins.stop();
        if over {
            plc.restart();
            panel.state = server::State::Run;
        }
        over
    });
}

/// Takes the program into program memory: what the card holds is kept there, and what is kept there is what
/// runs; so it runs too where there is no card, or none with a program on it. Any other failure is a
/// fault: what the user wants now was refused, or cannot be known.
fn start(
    board: &Board,
    page: &mut Block,
    memory: &mut [u8],
    file: &mut StateFile,
) -> Result<(), Fault> {
    match board.start {
        Start::Watchdog => return Err(Fault::without_line(Cause::ScanTooLong)),
        Start::Astray => return Err(Fault::without_line(Cause::ProgramDamaged)),
        Start::Power | Start::Reset | Start::Command => {}
    }
    if board.supply.is_low() {
        return Err(Fault::without_line(Cause::SupplyLow));
    }
    let missing = match card::load(board, page, memory, file) {
        Ok(program) => {
            store::save(&board.eeprom, program.stored()).map_err(Fault::without_line)?;
            None
        }
        Err(fault) if matches!(fault.cause, Cause::NoCard | Cause::NoProgramFile) => Some(fault),
        Err(fault) => return Err(fault),
    };
    match missing {
        Some(fault) if store::is_blank(&board.eeprom) => return Err(fault),
        Some(fault) => report::without_card(&board.serial, fault.cause),
        None => {}
    }
    let program =
        store::load(&board.eeprom, memory).ok_or(Fault::without_line(Cause::NoStoredProgram))?;
    report::program(&board.serial, &program);
    Ok(())
}
