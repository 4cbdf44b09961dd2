//! A firmware file, and the boot loader at the other end of a line that writes it: STK500v1 as Optiboot and the boot
//! loader of older Nanos speak it, and STK500v2 as that of the Mega 2560 does, as a state machine without I/O, threads or
//! clock.
//!
//! - [`Model`]: the boards, each with its rate and its room
//! - [`Image`]: a file in Intel HEX, checked for a board
//! - [`Writer`]: bytes and times in, bytes and times out; writes an image, reads it back, compares
//! - [`Unfit`], [`Failure`]: why there is no image, or why it is not on the board; each with a number
//!   (`docs/flash.md`) and its words in both languages
//!
//! Owns the form of firmware files and the talk with a boot loader. Must not know ports, screens.

#![forbid(unsafe_code)]

mod failure;
mod image;
mod message;
mod model;
mod script;
mod stage;
mod words;
mod writer;

pub use failure::{Failure, Trouble, Unfit};
pub use image::Image;
pub use model::Model;
pub use stage::Stage;
pub use writer::{Next, Progress, Step, Writer};
