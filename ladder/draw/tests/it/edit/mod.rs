//! The editor without a screen.

mod canvas;
mod cases;
mod meaning;
mod operations;
mod random;
mod together;
