//! The same PLC on a PC, against fake pins and a virtual clock.
//!
//! - [`engine`]: what runs programs and can be compared; the PLC of `unoclp-core` as one
//! - [`random`], [`torture`]: random programs, and damaged ones for the loader
//!
//! Owns what runs a program on a PC, and the programs that compare engines. Must not know the text of a program, what is
//! expected of it, a command line, a port. The PLC itself is `unoclp-core`; nothing here decides what a program means.

#![forbid(unsafe_code)]

pub mod engine;
pub mod random;
pub mod torture;
