//! The editor without a screen.

mod canvas;
mod cases;
mod meaning;
mod random;
mod together;
