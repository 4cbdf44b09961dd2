//! What a board has: every limit that is a board's own, as data.
//!
//! [`Board`] holds the limits, [`Engine`] what a program takes of run memory, [`Facts`] is how the loader asks. A further
//! board is a further value.

mod engine;
mod facts;
#[cfg(any(not(target_arch = "avr"), mega))]
mod mega;
#[cfg(not(target_arch = "avr"))]
mod pc;
mod uno;

pub use engine::Engine;
pub use facts::Facts;

use crate::Image;
use crate::isa::{self, Kind, POPPED, SYSTEM_MARKERS};

/// A board: what fits on it is decided from this alone, so host tools and firmware say the same (NC-10).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Board {
    /// What people call it.
    pub name: &'static str,
    /// Inputs 01 to this number exist, at most [`Point::MOST`](crate::Point::MOST).
    pub inputs: u8,
    /// Outputs 01 to this number exist, at most [`Point::MOST`](crate::Point::MOST).
    pub outputs: u8,
    /// Analogue inputs A 00 to below this number exist (NC-18).
    pub analogue: u8,
    /// The input that shares its pin with A 00; those after it share theirs with A 01 and so on. Its number is above
    /// that of every output that can be PWM. 0 where no pin is shared.
    pub shared_from: u8,
    /// The outputs that can be PWM, bit 0 output 01 (NC-18).
    pub pwm: Image,
    /// Markers M 01 to this number exist (NC-12).
    pub markers: u8,
    /// Counters C 01 to this number exist (NC-15).
    pub counters: u8,
    /// Labels 01 to this number exist (NC-19).
    pub labels: u8,
    /// A program has at most so many timers, and no more than its memory holds (NC-14).
    pub timers: u8,
    /// Bytes that a program may take in its stored form.
    pub stored_bytes: u16,
    /// Bytes that a program may take in run memory: its linked form and its data.
    pub linked_bytes: u16,
    /// Whether it has the instructions of REAL numbers (NC-23).
    pub real: bool,
    /// How it runs a program.
    pub engine: &'static Engine,
}

impl Board {
    /// Every board.
    #[cfg(not(target_arch = "avr"))]
    pub const ALL: [Board; 4] = [Board::UNO, Board::NANO, Board::MEGA, Board::PC];

    /// The board that is named so.
    #[cfg(not(target_arch = "avr"))]
    pub fn named(name: &str) -> Option<Board> {
        Board::ALL.into_iter().find(|board| board.id() == name)
    }

    /// How a command line or a request names it: its name in small letters.
    #[cfg(not(target_arch = "avr"))]
    pub fn id(&self) -> &'static str {
        match *self {
            Board::UNO => "uno",
            Board::NANO => "nano",
            Board::MEGA => "mega",
            _ => "pc",
        }
    }

    /// Whether there is a firmware for it; if not, the core runs its programs, on a PC alone.
    pub const fn has_firmware(&self) -> bool {
        self.engine.links
    }

    /// The input that shares its pin with this analogue input, where one does.
    pub fn shares(&self, analogue: u8) -> Option<u8> {
        let input = self.shared_from.checked_add(analogue)?;
        (self.shared_from > 0 && analogue < self.analogue && input <= self.inputs).then_some(input)
    }

    /// Bytes of memory in which a [`Plc`](crate::Plc) runs any program that fits: it keeps the stored form,
    /// which may be longer than the linked form, beside the data.
    pub const fn plc_bytes(&self) -> usize {
        self.stored_bytes as usize + self.linked_bytes as usize
    }

    /// The numbers of the outputs that can be PWM.
    pub fn pwm_outputs(&self) -> impl Iterator<Item = u8> + use<> {
        let pwm = self.pwm.0;
        (1..=self.outputs).filter(move |number| pwm >> (number - 1) & 1 != 0)
    }

    /// The markers that keep their state over a power cut, or the others.
    #[cfg(not(target_arch = "avr"))]
    pub fn markers_that(&self, keep: bool) -> impl DoubleEndedIterator<Item = u8> + use<> {
        let kept = isa::RETENTIVE..isa::RETENTIVE + 8;
        (1..=self.markers).filter(move |marker| kept.contains(marker) == keep)
    }

    /// Groups of eight markers, the last of them with what is left.
    pub const fn groups(&self) -> u8 {
        self.markers.div_ceil(8)
    }

    /// The numbers that XX of a code may be, first and last; the program has fewer timers. None where the code has no XX.
    pub const fn numbers(&self, kind: Kind) -> Option<(u8, u8)> {
        Some(match kind {
            Kind::None | Kind::Timer | Kind::Scale => return None,
            Kind::Input => (1, self.inputs),
            Kind::Output => (1, self.outputs),
            Kind::Branch => (1, isa::BRANCH_POINTS),
            Kind::TimerQ => (1, self.timers),
            Kind::Marker => (1, self.markers),
            Kind::System => (1, SYSTEM_MARKERS),
            Kind::Pwm => (1, self.outputs),
            Kind::Counter | Kind::Count => (1, self.counters),
            Kind::Register | Kind::Move | Kind::Drum | Kind::Table => (1, isa::REGISTERS),
            Kind::Value | Kind::Real => (0, POPPED),
            Kind::Analogue => (0, self.analogue.saturating_sub(1)),
            Kind::Reading => (1, 2),
            Kind::Group => (1, self.groups()),
            Kind::Filter => (1, 8),
            Kind::Bit => (0, 31),
            Kind::Label | Kind::Jump => (1, self.labels),
            Kind::Time => (0, 99),
        })
    }
}
