//! RUN, STOP and FAULT.
//!
//! Owns which of them it is, and what goes on in each, beside the scans too; must not know how any of it is done.

use crate::board::allowance::{self, COST, MARKERS_USED, NUMBERS_USED, SETTINGS_USED};
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
use crate::server::Server;
use crate::settings::Settings;
use crate::state::Keeper;
use crate::store::{self, Kept};
use crate::{indicator, report};
use unoclp_core::{Cause, Fault, Image};
use unoclp_modbus::Frame;

/// The board at work: the scans with their operation, and what goes on beside them.
// In this order: what lies beyond 63 bytes is reached by detours.
#[repr(C)]
struct Work<'b> {
    scans: Scans,
    board: &'b Board,
    server: Server,
    retentive: Retentive,
    /// How many records there are of the numbers that are kept.
    places: u8,
    /// When the last second began, ms since start, wrapping; and how many have, of this minute.
    second: u16,
    seconds: u8,
    state: Keeper,
}

/// Whether nothing goes on at a serial port.
#[cfg(not(mega))]
macro_rules! is_quiet {
    ($board:ident) => {
        $board.serial.is_quiet()
    };
}
#[cfg(mega)]
macro_rules! is_quiet {
    ($board:ident) => {
        $board.is_quiet()
    };
}

/// For how many seconds nobody has asked.
#[cfg(not(mega))]
macro_rules! silence {
    ($server:expr) => {
        &mut $server.silence
    };
}
#[cfg(mega)]
macro_rules! silence {
    ($server:expr) => {
        $server.silence()
    };
}

/// A frame for each line.
#[cfg(not(mega))]
type Frames = &'static mut Frame;
#[cfg(mega)]
type Frames = [&'static mut Frame; 2];

/// ms.
const SECOND: u16 = 1000;

/// RUN, STOP and FAULT, forever.
// Apart from `main`, whose frame is there while a card is read.
#[inline(never)]
pub fn serve(
    board: &Board,
    page: &'static mut Running,
    memory: &mut [u8],
    defaults: bool,
    file: StateFile,
    mut program: Result<Kept, Fault>,
) -> ! {
    #[cfg(not(mega))]
    let Running {
        frame,
        data,
        settings,
        ..
    } = page;
    #[cfg(mega)]
    let Running { data, settings, .. } = page;
    // SAFETY: once.
    #[cfg(mega)]
    let [frame, frame_of_bus] = unsafe { crate::page::frames() };
    settings.load(&board.eeprom, defaults);
    if program.is_ok() {
        report::state_file(&board.serial, &file);
    }
    #[cfg(mega)]
    let frame = [frame, frame_of_bus];
    let work = &mut Work::new(board, frame, settings, file);
    data.retain(work.retentive.markers());
    // Last of all: whoever reads that the board is ready may ask it at once.
    if let Err(fault) = &program {
        work.fail(fault);
        report::fault(&board.serial, fault);
    } else {
        report::ready(&board.serial, board.pins.stop());
    }
    work.server.start(board);
    loop {
        match &program {
            Ok(kept) => {
                let outcome = run(work, memory, kept, data);
                board.switch_outputs_off();
                board.watchdog.stop();
                if let Err(fault) = outcome {
                    work.fail(&fault);
                    program = Err(fault);
                }
            }
            Err(fault) => show(work, fault.cause, data),
        }
        let operation = &mut work.scans.operation;
        work.server.receive(board, operation, memory, data);
        if program.is_ok() {
            program = check(board, memory);
            if let Err(fault) = &program {
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
    /// Before the first scan.
    // Apart from who makes it, whose frame is large: what lies beyond 63 bytes is reached by detours.
    #[inline(never)]
    fn new<'b>(
        board: &'b Board,
        frame: Frames,
        settings: &'static mut Settings,
        file: StateFile,
    ) -> Work<'b> {
        Work {
            board,
            scans: Scans::new(),
            server: Server::new(frame, settings),
            state: Keeper::new(match file {
                StateFile::Found(place) => Some(place),
                _ => None,
            }),
            retentive: Retentive::find(&board.eeprom),
            places: 0,
            second: clock::now() as u16,
            seconds: 0,
        }
    }

    /// FAULT begins, and lasts until the next start.
    #[inline(never)]
    fn fail(&mut self, fault: &Fault) {
        self.board.watchdog.count_fault();
        self.board.release_card();
        let operation = &mut self.scans.operation;
        operation.state = State::Fault;
        operation.fault = Some(*fault);
        operation.images.set_outputs(Image::default());
    }

    /// What goes on in RUN, STOP and FAULT: analogue inputs are measured, retentive markers kept, and forcing ends
    /// where nobody asks any more.
    #[inline(never)]
    fn look_after(&mut self, data: &mut Data) {
        let board = self.board;
        board.analogue.step(&mut data.analogue);
        self.retentive.step(&board.eeprom, data.retained());
        let now = clock::now() as u16;
        if now.wrapping_sub(self.second) >= SECOND {
            self.second = self.second.wrapping_add(SECOND);
            self.each_second();
        }
    }

    /// The same where a program is there, whose numbers are kept too.
    #[inline(never)]
    fn look_after_all(&mut self, plc: &mut Linked<'_>, numbers: &mut Numbers) {
        self.look_after(plc.data());
        let runs = self.scans.operation.state == State::Run;
        numbers.step(plc, &self.board.eeprom, runs);
    }

    /// Another second has passed.
    fn each_second(&mut self) {
        let silence = silence!(self.server);
        *silence = silence.saturating_add(1);
        self.scans.operation.silence(*silence);
        self.seconds += 1;
        if self.seconds == 60 {
            self.seconds = 0;
            allowance::give(&MARKERS_USED, COST);
            allowance::give(&SETTINGS_USED, 1);
            allowance::give(&NUMBERS_USED, self.places.into());
        }
    }

    /// A slice of a request.
    fn answer(&mut self, memory: &mut Memory<'_>) {
        let operation = &mut self.scans.operation;
        self.server.step(self.board, operation, memory, None);
    }
}

/// Scans the program that is kept, until in STOP an upload is to begin.
///
/// # Errors
/// The fault that ends it.
#[inline(never)]
fn run(work: &mut Work<'_>, memory: &mut [u8], kept: &Kept, data: &mut Data) -> Result<(), Fault> {
    let plc = &mut Linked::new(kept, memory, data);
    scan(work, plc).map_err(|cause| match cause {
        Cause::TooManyJumps => plc.too_many_jumps(),
        _ => Fault::without_line(cause),
    })
}

/// The same for a program that has its memory.
///
/// # Errors
/// The cause of the fault that ends it.
// Apart, so that neither frame is too large to be reached directly.
#[inline(never)]
fn scan(work: &mut Work<'_>, plc: &mut Linked<'_>) -> Result<(), Cause> {
    let board = work.board;
    plc.link(&board.eeprom, &mut work.scans.operation.images)?;
    let numbers = &mut Numbers::find(plc, &board.eeprom);
    work.places = numbers.places();
    let needs = plc.needs();
    board.pins.pull_up(needs.inputs);
    board
        .analogue
        .measure(needs.analogue as u8, &mut plc.data().analogue);
    let mut diagnosis = Diagnosis::new(plc.code());
    board.watchdog.start();
    work.scans.begin();
    loop {
        if work.scans.operation.stopped || board.pins.stop() {
            stop(work, plc, numbers)?;
            if work.scans.operation.command == Some(Command::Upload) {
                numbers.finish(plc, &board.eeprom);
                return Ok(());
            }
            take_coils(work, plc);
            work.scans.pause();
        }
        let Ok(due) = work.scans.go_on(board, plc) else {
            return Err(Cause::TooManyJumps);
        };
        // The EEPROM is read for an answer, and would keep the scan waiting while it is written.
        if !is_quiet!(board) && !board.eeprom.is_busy() {
            work.answer(plc.memory());
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
            diagnosis.step(board, plc.code())?;
        }
    }
}

/// The next scan takes the coils that were written.
#[inline(never)]
#[cfg(not(mega))]
fn take_coils(work: &mut Work<'_>, plc: &Linked<'_>) {
    let images = &mut work.scans.operation.images;
    let outputs = images.outputs();
    plc.take_outputs(images, outputs);
}

/// The next scan takes the coils that were written.
#[cfg(mega)]
#[inline(never)]
fn take_coils(work: &mut Work<'_>, plc: &mut Linked<'_>) {
    let images = &mut work.scans.operation.images;
    let outputs = images.outputs();
    plc.take_outputs(images, outputs);
}

/// STOP, until RUN begins, or a single scan or an upload is to be made: outputs off, program kept.
///
/// # Errors
/// Where the program cannot begin again.
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
        work.answer(plc.memory());
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

/// Begins RUN or STOP, with the program as after power-up, unless that has begun. A single scan that ends RUN goes on from
/// where the program is.
///
/// # Errors
/// Where the program cannot begin again.
#[inline(never)]
fn enter(
    work: &mut Work<'_>,
    plc: &mut Linked<'_>,
    numbers: &mut Numbers,
    state: State,
) -> Result<(), Cause> {
    let Operation {
        state: now,
        images,
        command,
        ..
    } = &mut work.scans.operation;
    if *now == state {
        return Ok(());
    }
    *now = state;
    numbers.finish(plc, &work.board.eeprom);
    if *command == Some(Command::SingleScan) {
        return Ok(());
    }
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
        work.answer(&mut Memory::idle(data));
        work.scans.operation.command == Some(Command::Upload)
    });
}
