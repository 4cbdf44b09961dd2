//! The limits of the board that a text is compiled for.

use unoclp_core::Board;

/// Markers M 01 to this number.
pub(crate) const MARKERS: u8 = Board::UNO.markers;
/// Counters C 01 to this number.
pub(crate) const COUNTERS: u8 = Board::UNO.counters;
/// Registers D 01 to this number are always there; those beyond take run memory.
pub(crate) const NEAR_REGISTERS: u8 = Board::UNO.engine.near_registers;
/// Labels 01 to this number.
pub(crate) const LABELS: u8 = Board::UNO.labels;
