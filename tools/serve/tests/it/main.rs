//! Visitors of a server, with a board in memory.

mod attacks;
mod common;
mod pages;
mod visitors;
