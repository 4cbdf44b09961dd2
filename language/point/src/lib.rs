//! A point of a board, and each way in which a text writes one.
//!
//! Owns what byte and bit, letters and numbers mean, and which point an instruction names; said here, once, for all. Must
//! not know a language, a screen, nor how many points a board has: that is the board's to say.
//!
//! | written | point |
//! | --- | --- |
//! | `I1` `I.1` `IX1` | the input with this number |
//! | `I0.0` … `I0.7`, `I1.0` … | inputs 01 … 08, 09 …: a byte has eight bits, and both count from 0 |
//! | `Q0.0` …, `M0.0` … | outputs and markers likewise |
//! | `M0` of a Twido or Mitsubishi | marker 01: theirs count from 0, and so do their registers |
//! | `X0` `Y0` of Mitsubishi | input 01, output 01; octal |
//! | `0.00`, `10.00`, `100.00`, `W0.00` of OMRON | input 01, output 01, output 01, marker 01; sixteen to a word |
//! | `IW4`; `AIW4` | analogue input 04; analogue input 02, since each takes two bytes |
//! | `AIW4` of SimuPLC | analogue input 04 |

#![forbid(unsafe_code)]

mod address;
mod code;
mod notation;
mod read;

pub use address::{Address, Kind, UNKNOWN};
pub use notation::{Count, Maker};
pub use read::{LETTERS, Spelling, Written, is_block, read};
