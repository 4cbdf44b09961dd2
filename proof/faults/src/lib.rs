//! What a schedule of faults needs: a gateway that counts, and a tap on its way to the broker.
//!
//! - [`count`]: journal, history and reports of a gateway, whose one point is a counter
//! - [`Tap`]: passes on what a gateway and a broker say, and notes what the broker has confirmed
//!
//! Owns what is killed, and what is noted. Must not know schedules, nor what has to come out.

#![forbid(unsafe_code)]

mod gateway;
mod tap;

pub use gateway::{Place, count};
pub use tap::Tap;
