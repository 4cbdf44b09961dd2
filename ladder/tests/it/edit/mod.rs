//! The editor without a screen.

mod cases;
mod meaning;
mod random;
