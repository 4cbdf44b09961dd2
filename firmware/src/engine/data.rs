//! What the engine keeps outside of run memory, at a fixed place in the page: the handlers know it by
//! address.

use crate::instructions::BOARD;
use unoclp_core::isa::{REGISTER_BYTES, RETENTIVE};

/// A bit of its own, as a byte: [`ON`] or 0.
pub type Cell = u8;
/// The only bit of a cell that counts.
pub const ON: Cell = 0x80;

/// Outputs up to the last that can be PWM, or that there is.
pub const PWM: usize = BOARD.outputs as usize;

/// Images, markers, registers and readings.
#[cfg(not(mega))]
#[repr(C)]
pub struct Data {
    /// S 01 … S 04.
    pub system: [Cell; 4],
    /// Inputs 05 … 08.
    pub inputs: [Cell; 4],
    /// Inputs 05 … 08 again, as bits 4 to 7.
    pub more_inputs: u8,
    /// What is left for jumps back in this scan (NC-19); less than 0 where one went beyond.
    pub budget: i16,
    /// The line of that jump.
    pub line: u16,
    /// PWM of the output with this index.
    pub pwm: [u8; PWM],
    /// The readings of A 00 … A 04, 0 to 1023.
    pub analogue: [u16; BOARD.analogue as usize],
    /// How long the last scan took, µs; and the time stamp of this scan, ms.
    pub readings: [u32; 2],
    /// M 01 … M 64.
    pub markers: [Cell; BOARD.markers as usize],
    /// D 01 … D 32, low byte first. Run memory, where the others stand, comes right after.
    pub registers: [[u8; REGISTER_BYTES]; BOARD.engine.near_registers as usize],
}

/// Images, markers, registers and readings; bits of their own and registers come last, where one byte names them.
#[cfg(mega)]
#[repr(C)]
pub struct Data {
    /// Inputs 01 … 24, a byte for each port.
    pub more_inputs: [u8; 3],
    /// PWM of the output with this index.
    pub pwm: [u8; PWM],
    /// The readings of A 00 … A 07, 0 to 1023.
    pub analogue: [u16; BOARD.analogue as usize],
    /// How long the last scan took, µs; and the time stamp of this scan, ms.
    pub readings: [u32; 2],
    /// What is left for jumps back in this scan (NC-19); less than 0 where one went beyond.
    pub budget: i16,
    /// The line of that jump.
    pub line: u16,
    /// The low byte of where the stack stands when a scan ends.
    pub stack: u8,
    /// S 01 … S 04.
    pub system: [Cell; 4],
    /// Inputs 05 … 24.
    pub inputs: [Cell; BOARD.inputs as usize - 4],
    /// Outputs 05 … 16.
    pub outputs: [Cell; BOARD.outputs as usize - 4],
    /// M 01 … M 64.
    pub markers: [Cell; BOARD.markers as usize],
    /// D 01 … D 32, low byte first. Run memory, where the others stand, comes right after.
    pub registers: [[u8; REGISTER_BYTES]; BOARD.engine.near_registers as usize],
}

/// The first of the retentive markers, counted from 0.
const KEPT: usize = RETENTIVE as usize - 1;

const _: () = assert!(size_of::<Data>() <= if cfg!(mega) { 400 } else { 232 });

impl Data {
    /// As before the first scan; but the retentive markers keep their states (NC-12).
    pub fn restart(&mut self) {
        self.budget = 0;
        self.pwm.fill(0);
        #[cfg(mega)]
        self.outputs.fill(0);
        self.markers[..KEPT].fill(0);
        self.registers.as_flattened_mut().fill(0);
    }

    /// How long the last scan took, µs.
    pub fn scan_time(&mut self, time: u16) {
        self.readings[0] = time.into();
    }

    /// The retentive markers, bit 0 M 57.
    pub fn retained(&self) -> u8 {
        let kept = &self.markers[KEPT..];
        kept.iter().fold(0, |bits, cell| bits >> 1 | cell & ON)
    }

    /// Brings back what was kept over a power cut, before the first scan.
    pub fn retain(&mut self, mut bits: u8) {
        for cell in &mut self.markers[KEPT..] {
            *cell = if bits & 1 != 0 { ON } else { 0 };
            bits >>= 1;
        }
    }
}
