//! Modbus RTU, server and client, and what a board's addresses stand for. No I/O, no clock.
//!
//! - [`Exchange`], [`Device`] or [`Points`]: the server, below
//! - [`client`]: requests, and what is an answer to them
//! - [`map`]: every address that a board has
//! - [`lock`]: what a board may refuse, whoever asks
//! - [`eeprom`]: what a board keeps, where, and in what form
//!
//! The way of a request through the server:
//!
//! 1. The serial driver receives a frame, checks its CRC by [`Crc`] and its address, and leaves it
//!    in a [`Frame`] without the CRC.
//! 2. [`Exchange::begin`] validates it, and checks what it writes.
//! 3. [`Exchange::fill`] reads or writes in slices, so that no scan waits for a whole request.
//! 4. The reply stands in the same [`Frame`], from its address on; the driver appends the CRC.
//!
//! What there is to read and write, a [`Device`] says.
//!
//! ```
//! # use unoclp_modbus::{Access, Exception, Exchange, FRAME_BYTES, Points, Table};
//! # struct Plc;
//! # impl Points for Plc {
//! #     fn has(&self, _: Table, first: u16, count: u16, _: Access) -> bool { first + (count - 1) < 8 }
//! #     fn bit(&self, _: Table, _: u16) -> bool { false }
//! #     fn word(&self, _: Table, address: u16) -> u16 { 0x1200 + address }
//! #     fn set_bit(&mut self, _: u16, _: bool) {}
//! #     fn check_word(&self, _: u16, _: u16) -> Result<(), Exception> { Ok(()) }
//! #     fn set_word(&mut self, _: u16, _: u16) {}
//! #     fn identification(&self, _: u8, _: u8) -> Option<u8> { None }
//! # }
//! # let mut plc = Plc;
//! let mut frame = [0; FRAME_BYTES];
//! frame[..6].copy_from_slice(&[1, 3, 0, 5, 0, 2]); // of server 1: 2 holding registers from 5 on
//! let mut exchange = Exchange::default();
//! let mut length = exchange.begin(&mut frame, 6, &mut plc);
//! while length.is_none() {
//!     // One slice; a scan would run between two of them.
//!     length = exchange.fill(&mut frame, &mut plc);
//! }
//! let length = length.unwrap_or_default();
//! assert_eq!(frame[..length.into()], [1, 3, 4, 0x12, 0x05, 0x12, 0x06]);
//! ```
//!
//! Function codes: 1 to 6, 15, 16, and 43/14 ([`identification`](Device::identification)). Section
//! numbers are those of the *MODBUS Application Protocol Specification V1.1b3*.
//!
//! # Rulings
//!
//! - **Exceptions** come in the order of the specification's state diagrams: function code (01),
//!   then quantity, value, byte count and length (03), then addresses (02), then what the device
//!   says to the values ([`Device::check_words`], [`Device::take`]).
//! - **A request that is shorter or longer than its function and its byte count demand** is refused
//!   with 03: "the implied length is incorrect" (section 7). Other function codes are 01 whatever their
//!   length. A frame without a function code gets silence.
//! - **A write of several is checked as a whole first**, and only then is anything written.
//! - **Address 0 is a broadcast**: writes are done and never answered, reads are ignored.
//!
//! Owns frames, addresses and the form of the EEPROM. Must not know a serial port, a clock, and its server no memory map.
//! It needs neither `std` nor an allocator, contains no `unsafe`, and no frame makes it panic.

#![no_std]
#![forbid(unsafe_code)]

pub mod client;
mod crc;
mod device;
pub mod eeprom;
mod exchange;
mod frame;
mod identification;
pub mod lock;
pub mod map;
mod points;
mod request;

pub use crc::Crc;
pub use device::{Access, Addresses, Device, Exception, Table, Word};
pub use exchange::Exchange;
pub use frame::{FRAME_BYTES, Frame, refuse};
pub use points::Points;
