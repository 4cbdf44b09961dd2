//! The scan: inputs, program, outputs (NC-5), over and over.
//!
//! Owns the order within a scan, and how long scans take; must not know what goes on beside them. That is
//! due when a millisecond has begun, so a short scan has next to nothing of it.

use crate::board::clock::{self, Moment};
use crate::board::pins::Levels;
use crate::board::{Board, watchdog};
use crate::engine::Linked;
use crate::operation::{Operation, ScanTimes, State};
use core::hint::cold_path;
use core::mem;
use unoclp_core::{Image, Millis};

/// A scan has made too many jumps back (NC-19).
// A fault with its line would be another pointer that each scan keeps.
pub struct TooManyJumps;

/// The scans, and the operation that they are part of.
pub struct Scans<'b> {
    board: &'b Board,
    /// What they are to do, and what comes of them.
    pub operation: Operation,
    /// When the last one began.
    begun: Moment,
    /// Whether what goes on beside the scans is due.
    due: bool,
    /// Whether there is more to do before the program than to read inputs 01 to 04.
    prepares: bool,
    /// Whether there is more to do behind it than to write outputs.
    finishes: bool,
}

impl<'b> Scans<'b> {
    /// Before the first of them.
    pub fn new(board: &'b Board) -> Scans<'b> {
        Scans {
            board,
            operation: Operation::new(),
            begun: board.forgotten(),
            due: false,
            prepares: false,
            finishes: false,
        }
    }

    /// RUN begins, with the first scan of a program.
    pub fn begin(&mut self) {
        self.operation.state = State::Run;
        self.operation.times = ScanTimes::default();
        self.pause();
    }

    /// The time since the last scan is no scan's.
    pub fn pause(&mut self) {
        self.begun = self.board.forgotten();
    }

    /// What goes on beside the scans is due after the next one.
    pub fn hurry(&mut self) {
        self.due = true;
    }

    /// Scans once, and again until something else is to be done: STOP, the serial port, or what goes on
    /// beside the scans; gives whether that is due.
    ///
    /// # Errors
    /// Where a scan has made too many jumps back: no outputs are written then.
    // Apart from what goes on beside: `self` and `plc` are all that is kept in registers over a scan.
    #[inline(never)]
    pub fn go_on(&mut self, plc: &mut Linked<'_>) -> Result<bool, TooManyJumps> {
        let operation = &self.operation;
        let forced = operation.forces.any();
        let runs = operation.state == State::Run;
        self.prepares = forced || plc.has_to_prepare();
        self.finishes = forced || !runs || plc.jumps_back() || plc.needs().pwm != 0;
        loop {
            watchdog::scan_begins();
            // In this order: an input is never seen with a time stamp from before it changed (NC-5).
            let levels = self.board.pins.levels();
            let (millis, now) = self.board.moment();
            self.note(now);
            let mut inputs = levels.inputs();
            if self.prepares {
                cold_path();
                inputs = self.prepare(plc, levels, millis);
            }
            let outputs = plc.scan(&mut self.operation.images, inputs, millis);
            if self.finishes {
                cold_path();
                self.finish(plc)?;
            } else {
                self.board.pins.write_outputs(outputs);
            }
            if self.due || self.board.pins.stop() || !self.board.serial.is_quiet() {
                return Ok(mem::take(&mut self.due));
            }
        }
    }

    /// What comes before the program: gives the input image that it sees.
    #[inline(never)]
    fn prepare(&mut self, plc: &mut Linked<'_>, levels: Levels, millis: Millis) -> Image {
        let inputs = plc.filter(levels.all_inputs(plc.needs().inputs), millis);
        let inputs = self.operation.forces.inputs(inputs);
        self.operation.images.set_inputs(inputs);
        plc.prepare(inputs, millis);
        inputs
    }

    /// What comes behind it.
    #[inline(never)]
    fn finish(&mut self, plc: &mut Linked<'_>) -> Result<(), TooManyJumps> {
        if plc.jumps_too_often() {
            return Err(TooManyJumps);
        }
        let Operation {
            forces,
            images,
            state,
            ..
        } = &mut self.operation;
        let outputs = forces.outputs(images.outputs());
        plc.take_outputs(images, outputs);
        if *state == State::Run {
            self.board.pins.write_outputs(outputs);
            let pwm = plc.needs().pwm;
            let forced = forces.forced_outputs();
            self.board.write_pwm(pwm & !forced, &plc.data().pwm);
            self.board.write_pwm(pwm & forced, &[0; 4]);
        } else {
            // A single scan.
            self.due = true;
        }
        Ok(())
    }

    /// A scan has ended, and the next begins now: the last one lasted from its beginning to this one's.
    #[inline(always)]
    fn note(&mut self, now: Moment) {
        let begun = mem::replace(&mut self.begun, now);
        let Some(time) = now.since_in_millisecond(begun) else {
            return self.note_millisecond(now.since(begun));
        };
        if !self.operation.times.take_usual(time) {
            self.note_unusual(time);
        }
    }

    /// A millisecond has begun since the scan did that has ended. Fed only then, the watchdog sees too that
    /// the clock goes on.
    #[cold]
    #[inline(never)]
    fn note_millisecond(&mut self, time: Option<u16>) {
        watchdog::feed();
        self.due = true;
        if let Some(time) = time {
            self.operation.times.take(time);
        }
    }

    /// The shortest or longest scan so far; or one at whose end the clock should have gone on, and has not:
    /// it stands, and the watchdog will bite.
    #[cold]
    #[inline(never)]
    fn note_unusual(&mut self, time: u16) {
        if clock::is_in_millisecond(time) {
            self.operation.times.take(time);
        } else {
            self.due = true;
        }
    }
}
