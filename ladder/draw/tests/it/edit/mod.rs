//! The editor without a screen.

mod canvas;
mod cases;
mod made;
mod meaning;
mod operations;
mod random;
mod together;
