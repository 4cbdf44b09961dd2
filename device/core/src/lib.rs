//! The PLC itself, for every machine that unoclp runs on.
//!
//! The way of a program through this crate is also its map:
//!
//! 1. **Claim** — the bytes of a file. [`Loader`] takes them one at a time.
//! 2. **Checked** — a [`Program`]: every point exists on the board, every branch is balanced,
//!    every timer has its memory. There is no other way to get one.
//! 3. **Running** — a [`Plc`]: a program with its images and timers. [`Plc::scan`] cannot fail.
//!
//! A board with an engine of its own links the program's stored form instead of making a `Plc`.
//!
//! What an instruction is — its code, letters, stored byte and effect — is said once, in [`isa`].
//! What can be wrong with a program or a card is said once, in [`fault`].
//!
//! Owns the numeric code and what it does. Must not know a pin, a file system, printing. It needs
//! neither `std` nor an allocator, contains no `unsafe`, and no input makes it panic.
//!
//! The language is defined in `docs/numeric-code.md`; its rulings are cited here as NC-1 … NC-28.

#![no_std]
#![forbid(unsafe_code)]

pub mod fault;
pub mod isa;
pub mod real;

mod board;
mod crc;
mod held;
mod image;
mod kept;
mod loader;
mod needs;
mod plc;
mod program;
mod rung;
mod text;
mod timer;
mod width;

pub use board::{Board, Engine, Facts};
pub use crc::Crc16;
pub use fault::{Cause, Fault};
pub use image::{Image, Point};
pub use isa::Instruction;
pub use kept::{KEPT, NUMBER_BYTES, Number, RECORD_BYTES, RECORDED};
pub use loader::Loader;
pub use needs::Needs;
pub use plc::{After, Clocks, CounterState, Debounce, Inputs, Plc, Scan, Snapshot, TimerState};
pub use program::{Program, Steps};
pub use text::Part;
pub use timer::{Delay, Millis, Target, TimerBlock};
pub use width::{Bits, ImageBits};
