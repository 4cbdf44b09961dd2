//! The pictures, as they are drawn and as power flows through them.

mod blocks;
mod edit;
mod picture;
mod structure;
