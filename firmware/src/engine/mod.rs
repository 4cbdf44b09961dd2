//! The scan in assembly: direct threading, with the images in a register.
//!
//! Owns the linked form of a program and what runs it; must not know pins or clocks. Its `unsafe` is
//! the call of the linker in [`link`]. A [scan](crate::scan) relies on this of linked code, which [`link`] alone
//! makes, out of a checked program whose checksum it compares:
//!
//! - **Each byte is that of a handler, or one of the operands that the handler before it takes.**
//!   Points are cut to those that have a handler.
//! - **Each address among the operands is that of what the checked program names**, in [`Data`] or in the
//!   data of its timers, counters and other instructions; those of jumps are of labels.
//! - **The last byte is that of the end.**
//!
//! Run memory holds the registers beyond those of [`Data`], which stand right before it, then the linked code; and
//! from its end the data of timers, counters and other instructions.
//!
//! That the handlers stand where a byte can name them is checked when the firmware is linked; their
//! rules are at the head of `handlers.s`.

mod assembly;
pub mod data;
mod layout;
mod link;
pub mod memory;
mod rows;

pub use data::Data;

use crate::board::eeprom::Eeprom;
use crate::instructions::BOARD;
use crate::operation::Images;
use crate::store::Kept;
use core::mem;
use data::{Cell, ON};
use layout::{ADDRESS_BYTES, Layout, POINTS, SNAPSHOT_BYTES};
use memory::Memory;
use unoclp_core::isa::{COUNTER_DATA, JUMP_BUDGET, REGISTER_BYTES, TIMER_DATA};
use unoclp_core::{Cause, Clocks, Debounce, Fault, Image, Millis, Needs};

const _: () = {
    assert!(BOARD.engine.fast_inputs == POINTS);
    #[cfg(mega)]
    assert!(BOARD.engine.fast_outputs == POINTS);
    #[cfg(not(mega))]
    assert!(BOARD.outputs <= POINTS && BOARD.inputs as usize <= POINTS as usize + 4);
    assert!(JUMP_BUDGET < i16::MAX as u16);
};

// SAFETY: `keep.s` defines it so.
unsafe extern "C" {
    fn engine_keep(addresses: *const u8, snapshot: *mut u8, count: u8, take: bool) -> bool;
}

/// A program in its linked form, with everything that it needs to run.
pub struct Linked<'m> {
    code: &'m [u8],
    /// Data of edges, filters and integrations; until it is linked, run memory for both of these.
    own: &'m mut [u8],
    layout: Layout<'m>,
    /// Whether a scan needs more than the images of inputs 01 to 04.
    prepares: bool,
    /// Whether no scan has been made yet.
    first: bool,
    clocks: Clocks,
    debounce: Debounce,
}

impl<'m> Linked<'m> {
    /// The program that is kept, with this run memory, to be [linked](Linked::link) in its place: what
    /// comes back would be a copy on a stack that has no room for one.
    #[inline(always)]
    pub fn new(kept: &Kept, memory: &'m mut [u8], data: &'m mut Data) -> Linked<'m> {
        Linked {
            layout: Layout {
                memory: Memory::idle(data),
                begin: 0,
                kept: &mut [],
                snapshot: &mut [],
                stored: *kept,
                jumps_back: false,
            },
            code: &[],
            own: memory,
            prepares: false,
            first: true,
            clocks: Clocks::new(),
            debounce: Debounce::new(),
        }
    }

    /// Links it into its run memory, which needs one byte beyond those of the profile: all outputs 0
    /// (NC-7), no timer started. Called once, before the first scan.
    ///
    /// # Errors
    /// [`Cause::NoStoredProgram`] where that byte is missing, or the EEPROM has another program now.
    #[inline(never)]
    pub fn link(&mut self, eeprom: &Eeprom, images: &mut Images) -> Result<(), Cause> {
        let layout = &mut self.layout;
        let Kept {
            timers,
            counters,
            registers,
            numbers,
            ..
        } = layout.stored;
        let numbers = usize::from(numbers);
        let far = usize::from(registers - BOARD.engine.near_registers) * REGISTER_BYTES;
        let (far, rest) = mem::take(&mut self.own)
            .split_at_mut_checked(far)
            .unwrap_or_default();
        layout.memory.far = far;
        layout.begin = rest.as_ptr() as usize as u16;
        self.own = rest;
        layout.memory.timers = cut_end(&mut self.own, usize::from(timers) * TIMER_DATA);
        layout.memory.counters = cut_end(&mut self.own, usize::from(counters) * COUNTER_DATA);
        layout.snapshot = cut_end(&mut self.own, numbers * SNAPSHOT_BYTES);
        layout.kept = cut_end(&mut self.own, numbers * ADDRESS_BYTES);
        let memory = mem::take(&mut self.own);
        link::forget_labels(layout.memory.data);
        let mut size = link::pass(layout, eeprom, memory)?;
        if link::has_labels(layout.memory.data) {
            // Those that stand further on are known now.
            size = link::pass(layout, eeprom, memory)?;
        }
        let (code, mut rest) = memory
            .split_at_mut_checked(size.code.into())
            .ok_or(Cause::NoStoredProgram)?;
        self.own = cut_end(&mut rest, size.own.into());
        self.code = code;
        let needs = layout.stored.needs;
        #[cfg(not(mega))]
        let more = needs.inputs >> POINTS;
        // The usual scan has them all.
        #[cfg(mega)]
        let more = 0;
        self.prepares = needs.system | needs.filter | more != 0 || layout.jumps_back;
        self.clear(images);
        Ok(())
    }

    /// The linked code: it changes no more.
    pub fn code(&self) -> &'m [u8] {
        self.code
    }

    /// What the program asks of the board's pins.
    pub fn needs(&self) -> Needs {
        self.layout.stored.needs
    }

    /// Images, markers, registers and readings.
    pub fn data(&mut self) -> &mut Data {
        self.layout.memory.data
    }

    /// What a program works on, for one step of the server.
    pub fn memory(&mut self) -> &mut Memory<'m> {
        &mut self.layout.memory
    }

    /// Starts again, as after power-up: all outputs 0 (NC-7), no timer started, presets as the program has
    /// them; but retentive markers keep their states, and the numbers of the snapshot come back.
    ///
    /// # Errors
    /// [`Cause::NoStoredProgram`] where the EEPROM has another program now.
    #[inline(never)]
    pub fn restart(&mut self, eeprom: &Eeprom, images: &mut Images) -> Result<(), Cause> {
        link::forget_labels(self.layout.memory.data);
        link::pass(&mut self.layout, eeprom, &mut [])?;
        self.clear(images);
        self.keep(false);
        Ok(())
    }

    /// The program.
    pub fn stored(&self) -> &Kept {
        &self.layout.stored
    }

    /// The snapshot of the numbers that are kept, in the program's order.
    pub fn snapshot(&mut self) -> &mut [u8] {
        self.layout.snapshot
    }

    /// Takes the snapshot, or brings it back; says whether anything has changed by that.
    #[inline(never)]
    pub fn keep(&mut self, take: bool) -> bool {
        let Layout {
            kept,
            snapshot,
            stored,
            ..
        } = &mut self.layout;
        // SAFETY: so many addresses and numbers stand there; each address is that of a register or a counter,
        // since `link` has put it there.
        unsafe { engine_keep(kept.as_ptr(), snapshot.as_mut_ptr(), stored.numbers, take) }
    }

    fn clear(&mut self, images: &mut Images) {
        self.own.fill(0);
        self.layout.memory.data.restart();
        self.layout.memory.far.fill(0);
        *images = Images::default();
        self.first = true;
        self.clocks = Clocks::new();
    }

    /// Whether a scan needs to [`prepare`](Linked::prepare).
    pub fn has_to_prepare(&self) -> bool {
        // Inputs from 05 on that were forced, and are no more, are still to be forgotten.
        #[cfg(not(mega))]
        return self.prepares || self.layout.memory.data.more_inputs != 0;
        #[cfg(mega)]
        self.prepares
    }

    /// The input image as the input filter of the program has it (NC-18).
    pub fn filter(&mut self, inputs: Image, now: Millis) -> Image {
        match self.needs().filter {
            0 => inputs,
            _ => self.filtered(inputs, now),
        }
    }

    /// What comes before the program in a scan that needs more than the image of inputs 01 to 04.
    pub fn prepare(&mut self, inputs: Image, now: Millis) {
        let needs = self.needs();
        let data = &mut *self.layout.memory.data;
        #[cfg(not(mega))]
        let bits = inputs.0 as u8;
        #[cfg(not(mega))]
        {
            data.more_inputs = bits & !Images::INPUTS;
        }
        #[cfg(mega)]
        {
            let [first, second, third, _] = inputs.0.to_le_bytes();
            data.more_inputs = [first, second, third];
            spread(inputs.0 >> POINTS, &mut data.inputs);
        }
        #[cfg(not(mega))]
        if needs.inputs >> POINTS != 0 {
            // The bit of each comes to where a cell has it.
            data.inputs = [bits << 3 & ON, bits << 2 & ON, bits << 1 & ON, bits & ON];
        }
        data.budget = JUMP_BUDGET as i16;
        if needs.system != 0 {
            self.prepare_system(now);
        }
        self.first = false;
    }

    // Apart, as the next one, so that scans without it do not save registers for it.
    #[inline(never)]
    fn filtered(&mut self, inputs: Image, now: Millis) -> Image {
        let filter = self.layout.stored.needs.filter;
        self.debounce.scan(inputs, filter, self.first, now);
        self.debounce.image()
    }

    /// System markers, and the time stamp as a reading.
    #[inline(never)]
    fn prepare_system(&mut self, now: Millis) {
        self.clocks.scan(self.first, now);
        let data = &mut *self.layout.memory.data;
        data.system = [
            on(self.first),
            on(self.clocks.slow()),
            on(self.clocks.fast()),
            0,
        ];
        data.readings[1] = now;
    }

    /// Writes the output image for the next scan. Outputs that are PWM stay 0 there (NC-18).
    #[cfg(not(mega))]
    pub fn take_outputs(&self, images: &mut Images, outputs: Image) {
        images.set_outputs(Image(outputs.0 & !u16::from(self.needs().pwm)));
    }

    /// The same; those from 05 on are bits of their own.
    #[cfg(mega)]
    pub fn take_outputs(&mut self, images: &mut Images, outputs: Image) {
        let outputs = Image(outputs.0 & !self.needs().pwm);
        images.set_outputs(outputs);
        spread(outputs.0 >> POINTS, &mut self.layout.memory.data.outputs);
    }

    /// Has the image of the outputs tell those from 05 on, which the last scan has left as bits of their own.
    #[cfg(mega)]
    pub fn gather_outputs(&self, images: &mut Images) {
        let cells = self.layout.memory.data.outputs.iter();
        let more = cells
            .rev()
            .fold(0, |bits, cell| bits << 1 | u32::from(cell & ON != 0));
        images.set_outputs(Image(images.near_outputs() | more << POINTS));
    }

    /// What a scan runs: the linked code, and the data of its first timer. The handlers go from one to the next
    /// until that of the end returns; they read the code and no byte after it, and write the data of its
    /// timers, counters and other instructions, and `Data`: all are reached from `self`.
    #[inline(always)]
    pub fn entry(&mut self) -> (*const u8, *mut u8) {
        (self.code.as_ptr(), self.layout.memory.timers.as_mut_ptr())
    }

    /// Whether the program jumps back: a scan may do that [too often](Linked::jumps_too_often).
    pub fn jumps_back(&self) -> bool {
        self.layout.jumps_back
    }

    /// Whether the last scan has made too many jumps back (NC-19).
    pub fn jumps_too_often(&self) -> bool {
        self.layout.memory.data.budget < 0
    }

    /// The fault that this is, with the line of the jump.
    pub fn too_many_jumps(&self) -> Fault {
        Fault {
            cause: Cause::TooManyJumps,
            line: Some(self.layout.memory.data.line.into()),
        }
    }
}

/// Takes so much from the end of the memory; nothing, and leaves nothing, where there is less.
#[inline(never)]
fn cut_end<'m>(memory: &mut &'m mut [u8], length: usize) -> &'m mut [u8] {
    let middle = memory.len().wrapping_sub(length);
    let (rest, end) = mem::take(memory)
        .split_at_mut_checked(middle)
        .unwrap_or_default();
    *memory = rest;
    end
}

/// The cell of a bit.
fn on(state: bool) -> Cell {
    if state { ON } else { 0 }
}

/// A bit for each cell, the lowest first.
#[cfg(mega)]
#[inline(never)]
fn spread(mut bits: u32, cells: &mut [Cell]) {
    for cell in cells {
        *cell = on(bits & 1 != 0);
        bits >>= 1;
    }
}
