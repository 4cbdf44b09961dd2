//! RUN, STOP and FAULT.
//!
//! Owns which of them it is, and what goes on in each, beside the scans too; must not know how any of it is done.

use crate::board::watchdog;
use crate::board::{Board, clock};
use crate::card::StateFile;
use crate::diagnosis::Diagnosis;
use crate::engine::memory::Memory;
use crate::engine::{Data, Linked};
use crate::numbers::Numbers;
use crate::operation::{Command, Operation, State};
use crate::page::Running;
use crate::retentive::Retentive;
use crate::scan::Scans;
use crate::server::{self, Server};
use crate::settings::Settings;
use crate::state::Keeper;
use crate::store::{self, Kept};
use crate::{indicator, report};
use unoclp_core::{Cause, Fault, Image};

/// The board at work: the scans with their operation, and what goes on beside them.
struct Work<'b> {
    board: &'b Board,
    scans: Scans<'b>,
    server: Server,
    state: Keeper,
    retentive: Retentive,
}

/// RUN, STOP and FAULT, for ever.
// Apart from `main`, whose frame is there while a card is read.
#[inline(never)]
pub fn serve(
    board: &Board,
    page: &'static mut Running,
    memory: &mut [u8],
    settings: Settings,
    file: StateFile,
    mut program: Result<Kept, Fault>,
) -> ! {
    let Running { frame, data } = page;
    if let Err(fault) = program {
        // At once: a reset may cut the report off.
        board.watchdog.count_fault();
        report::fault(&board.serial, fault);
    } else {
        report::state_file(&board.serial, &file);
        report::ready(&board.serial, board.pins.stop());
    }
    let work = &mut Work {
        board,
        scans: Scans::new(board),
        server: Server::new(frame, settings),
        state: Keeper::new(match file {
            StateFile::Found(place) => Some(place),
            _ => None,
        }),
        retentive: Retentive::find(&board.eeprom, clock::now() as u16),
    };
    data.retain(work.retentive.markers());
    if let Err(fault) = program {
        work.enter_fault(fault);
    }
    work.server.start(board);
    loop {
        match &program {
            Ok(kept) => {
                let outcome = run(work, memory, kept, data);
                board.switch_outputs_off();
                board.watchdog.stop();
                if let Err(fault) = outcome {
                    work.fail(fault);
                    program = Err(fault);
                }
            }
            Err(fault) => show(work, fault.cause, data),
        }
        let operation = &mut work.scans.operation;
        work.server.receive(board, operation, memory, data);
        if program.is_ok() {
            program = check(board, memory);
            if let Err(fault) = program {
                work.fail(fault);
            }
        }
    }
}

/// The program that is kept.
#[inline(never)]
pub fn check(board: &Board, memory: &mut [u8]) -> Result<Kept, Fault> {
    store::load(&board.eeprom, memory).ok_or(Fault::without_line(Cause::NoStoredProgram))
}

impl Work<'_> {
    /// FAULT begins, and is counted.
    #[inline(never)]
    fn fail(&mut self, fault: Fault) {
        self.board.watchdog.count_fault();
        self.enter_fault(fault);
    }

    /// FAULT, which lasts until the next start.
    #[inline(never)]
    fn enter_fault(&mut self, fault: Fault) {
        self.board.release_card();
        let operation = &mut self.scans.operation;
        operation.state = State::Fault;
        operation.fault = Some(fault);
        operation.images.set_outputs(Image::default());
    }

    /// What goes on in RUN, STOP and FAULT: analogue inputs are measured, and retentive markers kept. Tells whether
    /// another minute has passed.
    #[inline(never)]
    fn look_after(&mut self, data: &mut Data) -> bool {
        let board = self.board;
        board.analogue.step(&mut data.analogue);
        let now = clock::now() as u16;
        self.retentive.step(&board.eeprom, data.retained(), now)
    }

    /// The same where a program is there, whose numbers are kept too.
    #[inline(never)]
    fn look_after_all(&mut self, plc: &mut Linked<'_>, numbers: &mut Numbers) {
        if self.look_after(plc.data()) {
            numbers.minute();
        }
        let runs = self.scans.operation.state == State::Run;
        numbers.step(plc, &self.board.eeprom, runs);
    }

    /// A slice of a request.
    fn answer(&mut self, memory: Memory<'_>, most: u8) {
        let operation = &mut self.scans.operation;
        self.server.step(self.board, operation, memory, None, most);
    }
}

/// Scans the program that is kept, until in STOP an upload is to begin.
///
/// # Errors
/// The fault that ends it.
#[inline(never)]
fn run(work: &mut Work<'_>, memory: &mut [u8], kept: &Kept, data: &mut Data) -> Result<(), Fault> {
    let board = work.board;
    let plc = &mut Linked::new(kept, memory, data);
    plc.link(&board.eeprom, &mut work.scans.operation.images)
        .map_err(Fault::without_line)?;
    let numbers = &mut Numbers::find(plc, &board.eeprom);
    let needs = plc.needs();
    board.pins.pull_up(needs.inputs);
    board
        .analogue
        .measure(needs.analogue, &mut plc.data().analogue);
    let mut diagnosis = Diagnosis::new(plc.code());
    board.watchdog.start();
    work.scans.begin();
    loop {
        if work.scans.operation.stopped || board.pins.stop() {
            stop(work, plc, numbers).map_err(Fault::without_line)?;
            if work.scans.operation.command == Some(Command::Upload) {
                return Ok(());
            }
            take_coils(work, plc);
            work.scans.pause();
        }
        let Ok(due) = work.scans.go_on(plc) else {
            return Err(plc.too_many_jumps());
        };
        // The EEPROM is read for an answer, and would keep the scan waiting while it is written.
        if !board.serial.is_quiet() && !board.eeprom.is_busy() {
            work.answer(plc.memory(), server::SLICE);
            take_coils(work, plc);
        }
        if due {
            let operation = &mut work.scans.operation;
            indicator::show_run(&board.pins, operation.forces.any());
            plc.data().scan_time(operation.times.last());
            work.state.step(board, operation);
            work.look_after_all(plc, numbers);
            if work.state.is_sending() {
                work.scans.hurry();
            }
            diagnosis.step(board).map_err(Fault::without_line)?;
        }
    }
}

/// The next scan takes the coils that were written.
fn take_coils(work: &mut Work<'_>, plc: &Linked<'_>) {
    let images = &mut work.scans.operation.images;
    let outputs = images.outputs();
    plc.take_outputs(images, outputs);
}

/// STOP, until RUN begins, or a single scan or an upload is to be made: outputs off, program kept.
///
/// # Errors
/// Where the program cannot begin anew.
#[inline(never)]
fn stop(work: &mut Work<'_>, plc: &mut Linked<'_>, numbers: &mut Numbers) -> Result<(), Cause> {
    let board = work.board;
    board.switch_outputs_off();
    enter(work, plc, numbers, State::Stop)?;
    let pins = &board.pins;
    indicator::show_stop(pins, || {
        watchdog::feed();
        let operation = &mut work.scans.operation;
        operation.read(pins.levels().all_inputs(plc.needs().inputs));
        work.state.step(board, operation);
        work.look_after_all(plc, numbers);
        work.answer(plc.memory(), server::AT_ONCE);
        let operation = &mut work.scans.operation;
        operation.takes(Command::SingleScan)
            || operation.command == Some(Command::Upload)
            || !operation.stopped && !pins.stop()
    });
    if !work.scans.operation.stopped && !pins.stop() {
        enter(work, plc, numbers, State::Run)?;
    }
    Ok(())
}

/// Begins RUN or STOP, with the program as after power-up, unless that has begun.
///
/// # Errors
/// Where the program cannot begin anew.
#[inline(never)]
fn enter(
    work: &mut Work<'_>,
    plc: &mut Linked<'_>,
    numbers: &mut Numbers,
    state: State,
) -> Result<(), Cause> {
    let Operation {
        state: now, images, ..
    } = &mut work.scans.operation;
    if *now == state {
        return Ok(());
    }
    *now = state;
    numbers.finish(plc, &work.board.eeprom);
    plc.restart(&work.board.eeprom, images)
}

/// FAULT: its number, until an upload is to begin.
#[inline(never)]
fn show(work: &mut Work<'_>, cause: Cause, data: &mut Data) {
    let pins = &work.board.pins;
    indicator::show(pins, cause, || {
        // Which of the others are digital, a program would tell.
        work.scans.operation.read(pins.levels().inputs());
        work.look_after(data);
        work.answer(Memory::idle(data), server::AT_ONCE);
        work.scans.operation.command == Some(Command::Upload)
    });
}
