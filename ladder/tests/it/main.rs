//! The pictures, as they are drawn and as power flows through them.

mod picture;
mod structure;
