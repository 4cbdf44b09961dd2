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
mod instructions;
mod page;
mod report;
mod retentive;
mod scan;
mod server;
mod settings;
mod state;
mod store;

// What the compiler calls: products, and blocks of memory.
core::arch::global_asm!(include_str!("runtime.s"));

use board::watchdog::{self, Start};
use board::{Board, clock};
use card::StateFile;
use diagnosis::Diagnosis;
use engine::memory::Memory;
use engine::{Data, Linked};
use page::Running;
use retentive::Retentive;
use scan::Scans;
use server::upload;
use server::{Command, Server};
use settings::Settings;
use state::{Images, State};
use store::Kept;
use unoclp_card::Block;
use unoclp_core::{Cause, Fault, Image, Profile};

/// Run memory: the code of the program and the data of its instructions, and a byte for the end.
const RUN_MEMORY: usize = Profile::UNO.linked_bytes as usize + 1;

#[avr_device::entry]
fn main() -> ! {
    static mut MEMORY: [u8; RUN_MEMORY] = [0; RUN_MEMORY];

    // SAFETY: once.
    let page = unsafe { page::take() };
    let mut board = Board::take();
    let settings = open_line(&mut board);
    report::banner(&board);
    let mut file = StateFile::Missing;
    let outcome = start(&board, page, MEMORY, &mut file);
    board.release_card();
    let Running { frame, data } = page::running(page);
    serve(
        &board,
        MEMORY,
        file,
        outcome,
        &mut Server::new(frame, settings),
        data,
    )
}

/// The serial line, as the settings have it.
#[inline(never)]
fn open_line(board: &mut Board) -> Settings {
    let settings = Settings::load(&board.eeprom, board.pins.ask_for_defaults());
    board.serial.open(&settings.line());
    settings
}

/// RUN, STOP and FAULT, for ever.
// Apart from `main`, whose frame is there while a card is read.
#[inline(never)]
fn serve(
    board: &Board,
    memory: &mut [u8],
    file: StateFile,
    mut outcome: Result<Kept, Fault>,
    server: &mut Server,
    data: &mut Data,
) -> ! {
    let mut retentive = Retentive::find(&board.eeprom, clock::now() as u16);
    data.retain(retentive.markers());
    if let Err(fault) = outcome {
        fail(board, server, fault);
        report::fault(&board.serial, fault);
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
        match &outcome {
            Ok(kept) => {
                let fault = run(
                    board,
                    memory,
                    kept,
                    data,
                    &mut state,
                    &mut retentive,
                    server,
                );
                board.switch_outputs_off();
                board.watchdog.stop();
                if let Some(fault) = fault {
                    fail(board, server, fault);
                    outcome = Err(fault);
                }
            }
            Err(fault) => indicator::show(&board.pins, fault.cause, || {
                // Which of the others are digital, a program would tell.
                let inputs = board.pins.levels().inputs();
                server.panel.images.inputs = server.panel.forces.inputs(inputs);
                look_after(board, data, &mut retentive);
                server.step(board, Memory::idle(data), None, server::AT_ONCE);
                server.panel.command == Some(Command::Upload)
            }),
        }
        upload::receive(board, server, memory, data);
        if outcome.is_ok() {
            outcome = check(board, memory);
            if let Err(fault) = outcome {
                fail(board, server, fault);
            }
        }
    }
}

/// The program that is kept.
#[inline(never)]
fn check(board: &Board, memory: &mut [u8]) -> Result<Kept, Fault> {
    store::load(&board.eeprom, memory).ok_or(Fault::without_line(Cause::NoStoredProgram))
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

/// What goes on in RUN, STOP and FAULT: analogue inputs are measured, and retentive markers kept.
#[inline(never)]
fn look_after(board: &Board, data: &mut Data, retentive: &mut Retentive) {
    board.analogue.step(&mut data.analogue);
    retentive.step(&board.eeprom, data.retained(), clock::now() as u16);
}

/// Scans the program that is kept, until there is a fault, or in STOP an upload is to begin.
#[inline(never)]
fn run(
    board: &Board,
    memory: &mut [u8],
    kept: &Kept,
    data: &mut Data,
    state: &mut State,
    retentive: &mut Retentive,
    server: &mut Server,
) -> Option<Fault> {
    let plc = &mut Linked::new(kept, memory, data);
    if let Err(cause) = plc.link(&board.eeprom) {
        return Some(Fault::without_line(cause));
    }
    let needs = plc.needs();
    board.pins.pull_up(needs.inputs);
    board
        .analogue
        .measure(needs.analogue, &mut plc.data().analogue);
    let mut diagnosis = Diagnosis::new(plc.code());
    board.watchdog.start();
    server.panel.state = server::State::Run;
    let mut scans = Scans::new(board);
    loop {
        if server.panel.stopped || board.pins.stop() {
            server.panel.times = scans.times;
            if let Err(cause) = stop(board, plc, state, retentive, server) {
                return Some(Fault::without_line(cause));
            }
            if server.panel.command == Some(Command::Upload) {
                return None;
            }
            scans.pause();
        }
        let Ok(due) = scans.go_on(plc, &server.panel) else {
            return Some(plc.too_many_jumps());
        };
        let mut images = plc.images();
        images.outputs = server.panel.forces.outputs(images.outputs);
        // The EEPROM is read for an answer, and would keep the scan waiting while it is written.
        if !board.serial.is_quiet() && !board.eeprom.is_busy() {
            let panel = &mut server.panel;
            panel.times = scans.times;
            panel.images = images;
            panel.card_failed = state.has_failed();
            server.step(board, plc.memory(), None, server::SLICE);
            plc.set_outputs(server.panel.images.outputs);
        }
        if due {
            indicator::show_run(&board.pins, server.panel.forces.any());
            plc.data().scan_time(scans.times.last());
            look_after(board, plc.data(), retentive);
            state.step(board, images, &scans.times);
            if state.is_sending() {
                scans.hurry();
            }
            if let Err(cause) = diagnosis.step(board) {
                server.panel.times = scans.times;
                return Some(Fault::without_line(cause));
            }
        }
    }
}

/// STOP, until RUN begins, or a single scan or an upload is to be made: outputs off, program kept.
///
/// # Errors
/// Where the program cannot begin anew.
#[inline(never)]
fn stop(
    board: &Board,
    plc: &mut Linked<'_>,
    state: &mut State,
    retentive: &mut Retentive,
    server: &mut Server,
) -> Result<(), Cause> {
    board.switch_outputs_off();
    if server.panel.state != server::State::Stop {
        server.panel.state = server::State::Stop;
        plc.restart(&board.eeprom)?;
    }
    server.panel.images.outputs = plc.outputs();
    let pins = &board.pins;
    indicator::show_stop(pins, || {
        watchdog::feed();
        let panel = &mut server.panel;
        let inputs = panel
            .forces
            .inputs(pins.levels().all_inputs(plc.needs().inputs));
        panel.images.inputs = inputs;
        panel.card_failed = state.has_failed();
        let images = Images {
            inputs,
            outputs: Image::default(),
        };
        state.step(board, images, &panel.times);
        look_after(board, plc.data(), retentive);
        server.step(board, plc.memory(), None, server::AT_ONCE);
        let panel = &mut server.panel;
        plc.set_outputs(panel.images.outputs);
        panel.takes(Command::SingleScan)
            || panel.command == Some(Command::Upload)
            || !panel.stopped && !pins.stop()
    });
    if !server.panel.stopped && !pins.stop() {
        server.panel.state = server::State::Run;
        plc.restart(&board.eeprom)?;
    }
    Ok(())
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
    match board.start {
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
        Err(fault) if matches!(fault.cause, Cause::NoCard | Cause::NoProgramFile) => Some(fault),
        Err(fault) => return Err(fault),
    };
    match missing {
        Some(fault) if store::is_blank(&board.eeprom) => return Err(fault),
        Some(fault) => report::without_card(&board.serial, fault.cause),
        None => {}
    }
    let kept = check(board, memory)?;
    report::program(&board.serial, &kept);
    Ok(kept)
}
