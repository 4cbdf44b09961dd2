//! The scan: inputs, program, outputs (NC-5), over and over.
//!
//! Owns the order within a scan, and how long scans take; must not know what goes on beside them. That is
//! due when a millisecond has begun, so a short scan has next to nothing of it.

use crate::board::clock::{self, Moment};
use crate::board::{Board, watchdog};
use crate::engine::Linked;
use crate::operation::{Images, Operation, ScanTimes, State};
use core::arch::asm;
use core::mem::{self, offset_of};
use unoclp_core::Millis;

#[cfg(not(mega))]
macro_rules! usual_scan {
    () => {
        include_str!("scan.s")
    };
}
#[cfg(mega)]
macro_rules! usual_scan {
    () => {
        include_str!("mega/scan.s")
    };
}

/// How far a scan is: it is to begin; what comes before the program is done, or to be done; the same of what comes
/// after it.
const BEGINS: u8 = 0;
const PREPARED: u8 = 1;

/// A scan has made too many jumps back (NC-19).
// A fault with its line would be another pointer that each scan keeps.
pub struct TooManyJumps;

/// The scans, and the operation that they are part of.
pub struct Scans {
    /// What they are to do, and what comes of them.
    pub operation: Operation,
    /// When the last one began.
    begun: Moment,
    /// What there is to do before the program but to read inputs 01 to 04: [`FIRST`] and [`PREPARES`].
    before: u8,
    /// What there is to do after it but to write outputs: [`DUE`] and [`FINISHES`].
    behind: u8,
}

/// No time is measured from the scan before.
const FIRST: u8 = 1;
/// A scan begins with more than inputs 01 to 04.
const PREPARES: u8 = 2;
/// What goes on beside the scans is due.
const DUE: u8 = 1;
/// A scan ends with more than outputs.
const FINISHES: u8 = 2;

impl Scans {
    /// Before the first of them.
    pub fn new() -> Scans {
        Scans {
            operation: Operation::new(),
            begun: Moment::default(),
            before: FIRST,
            behind: 0,
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
        self.before = FIRST;
    }

    /// What goes on beside the scans is due after the next one.
    pub fn hurry(&mut self) {
        self.behind |= DUE;
    }

    /// Scans once, and again until something else is to be done: STOP, the serial port, or what goes on
    /// beside the scans; gives whether that is due.
    ///
    /// # Errors
    /// Where a scan has made too many jumps back: no outputs are written then.
    #[inline(never)]
    #[allow(
        named_asm_labels,
        reason = "a simulator stops at one of them, and this function is there once"
    )]
    pub fn go_on(&mut self, board: &Board, plc: &mut Linked<'_>) -> Result<bool, TooManyJumps> {
        let operation = &self.operation;
        let forced = operation.forces.any();
        let runs = operation.state == State::Run;
        let finishes = forced || !runs || plc.jumps_back() || plc.needs().pwm != 0;
        self.behind = self.behind & DUE | if finishes { FINISHES } else { 0 };
        let prepares = forced || plc.has_to_prepare();
        self.before = self.before & FIRST | if prepares { PREPARES } else { 0 };
        // Good as long as no millisecond has begun since the watchdog was fed.
        let mut millis = clock::now();
        let mut stage = BEGINS;
        loop {
            let (code, timers) = plc.entry();
            let (millis_low, millis_high) = (millis as u16, (millis >> 16) as u16);
            let count: u16;
            // SAFETY: the code is as the head of `engine` says, and the handlers do what `Linked::entry` says with
            // what is reached from `plc`, which is why that is named here. They change only the registers that
            // are named here, and Y, which is saved because it cannot be named. What is written of `self` are
            // the points and the times of scans; any bits are values of these.
            unsafe {
                asm!(
                    usual_scan!(),
                    inout("r24") stage,
                    in("r7r6") &raw mut *self,
                    inout("r17r16") self.begun.count,
                    in("r3r2") millis_low,
                    in("r5r4") millis_high,
                    inout("X") code => _,
                    inout("r21r20") timers => _,
                    inout("Z") &raw mut *plc => _,
                    out("r18") _,
                    out("r19") _,
                    out("r23r22") count,
                    out("r25") _,
                    out("r9r8") _,
                    out("r11r10") _,
                    out("r13r12") _,
                    out("r15r14") _,
                    POINTS = const offset_of!(Scans, operation.images.points),
                    LAST = const offset_of!(Scans, operation.times.last),
                    LEAST = const offset_of!(Scans, operation.times.least),
                    MOST = const offset_of!(Scans, operation.times.most),
                    BEFORE = const offset_of!(Scans, before),
                    BEHIND = const offset_of!(Scans, behind),
                    DUE = const DUE,
                    FINISHES = const FINISHES,
                    INPUTS = const Images::INPUTS,
                    OUTPUTS = const !Images::INPUTS,
                    #[cfg(mega)]
                    PORTS = const offset_of!(Scans, operation.images.ports),
                    #[cfg(mega)]
                    REST = const offset_of!(Scans, operation.images.rest),
                );
            }
            match stage {
                BEGINS => return Ok(mem::take(&mut self.behind) & DUE != 0),
                PREPARED => millis = self.prepare(board, plc, count),
                _ => self.finish(board, plc)?,
            }
        }
    }

    /// What comes before the program where that is more than to read inputs 01 to 04, or a millisecond has begun:
    /// gives the time stamp. Timer 1 stood at this count when the scan began.
    #[inline(never)]
    fn prepare(&mut self, board: &Board, plc: &mut Linked<'_>, count: u16) -> Millis {
        // In this order: an input is never seen with a time stamp from before it changed (NC-5).
        let levels = board.pins.levels();
        // Fed only then, the watchdog sees too that the clock goes on. Before the clock is read: a millisecond that
        // begins after that is one for the next scan.
        if watchdog::is_hungry() {
            watchdog::feed();
            self.behind |= DUE;
        }
        let (millis, now) = board.moment();
        let now = now.back_to(count);
        let begun = mem::replace(&mut self.begun, now);
        // The last one lasted from its beginning to this one's.
        if self.before & FIRST == 0
            && let Some(time) = now.since(begun)
        {
            self.operation.times.take(time);
        }
        let inputs = plc.filter(levels.all_inputs(plc.needs().inputs), millis);
        let forces = self.operation.forces;
        let inputs = forces.inputs(inputs);
        self.operation.images.set_inputs(inputs);
        plc.prepare(inputs, millis);
        self.before &= !FIRST;
        millis
    }

    /// What comes after it.
    #[inline(never)]
    fn finish(&mut self, board: &Board, plc: &mut Linked<'_>) -> Result<(), TooManyJumps> {
        if plc.jumps_too_often() {
            return Err(TooManyJumps);
        }
        let Operation {
            forces,
            images,
            state,
            ..
        } = &mut self.operation;
        #[cfg(mega)]
        plc.gather_outputs(images);
        let outputs = forces.outputs(images.outputs());
        plc.take_outputs(images, outputs);
        if *state == State::Run {
            board.pins.write_outputs(outputs);
            let pwm = plc.needs().pwm;
            let forced = forces.forced_outputs();
            board.write_pwm(pwm & !forced, &plc.data().pwm);
            #[cfg(mega)]
            board.end_pwm(pwm & forced);
            #[cfg(not(mega))]
            board.write_pwm(pwm & forced, &[0; 4]);
        } else {
            // A single scan.
            self.behind |= DUE;
        }
        Ok(())
    }
}
