//! Visitors of a server, with a board in memory.

mod common;
mod pages;
mod visitors;
