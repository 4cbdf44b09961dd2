//! What a person who draws a ladder is offered and told.
//!
//! - [`palette()`]: the elements that can be inserted, and [`insertion`] what has to be done for one
//! - [`shown`]: the fields of an element, as a form has them; [`operations`], [`naming`] and [`ask`] take them back
//! - [`At`]: what is at the cursor
//! - [`find`]: what has some words in it
//! - [`refusal`], [`wrong`]: what the editor refuses, and what it finds wrong, in words
//!
//! Owns what the instructions of a board are to a person with a pen. Must not know screens, keys that are pressed, requests.

#![forbid(unsafe_code)]

mod amiss;
mod at;
mod fields;
mod find;
mod palette;
mod told;
mod words;

pub use amiss::{Amiss, Offer};
pub use at::At;
pub use fields::{Field, Shown, ask, naming, operations, shown};
pub use find::find;
pub use palette::{Entry, Shelf, insertion, palette};
pub use told::{refusal, wrong};
pub use words::{no_address, no_drawing, unfinished};
