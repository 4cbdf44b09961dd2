//! What `cargo xtask` can do, one module for each subcommand, and what they share:
//! [`shell`] runs other programs, [`setup`] sees to it that they are there, [`toolchain`] is the
//! Rust that compiles for AVR.
//!
//! Owns how everything is built, tested, measured and handed out. Must not know the language.

pub mod arguments;
pub mod bench;
pub mod budget;
pub mod card;
pub mod count;
pub mod deb;
pub mod demo;
pub mod dist;
pub mod firmware;
pub mod flash;
pub mod fuzz;
pub mod lab;
pub mod link;
mod long;
pub mod modules;
pub mod mulcheck;
pub mod mutants;
pub mod node;
pub mod notice;
pub mod parts;
pub mod programs;
pub mod rulings;
pub mod sbom;
pub mod setup;
pub mod shell;
pub mod steps;
pub mod test;
pub mod tested;
pub mod toolchain;
pub mod toolset;
pub mod vsix;
pub mod wasm;
pub mod wiring;
