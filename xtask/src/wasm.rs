//! Compiles for WebAssembly what a page in a browser is made of.
//!
//! Where rustup has installed the target, with the active toolchain; else with Debian's, which builds the
//! standard library from source. Libraries need no linker.

use std::process::Command;

use crate::toolchain::Toolchain;

/// What a page needs: none of it knows a port, a thread, a terminal or a file.
const CRATES: &[&str] = &[
    "unoclp-board",
    "unoclp-card",
    "unoclp-checked",
    "unoclp-core",
    "unoclp-host-sim",
    "unoclp-ladder",
    "unoclp-lang",
    "unoclp-modbus",
    "unoclp-source",
];

/// The command that compiles them, into a folder of its own: another cargo may be at work in the usual one.
pub fn build(toolchain: &Toolchain) -> Command {
    let mut build = toolchain.cargo_for_wasm("build");
    for package in CRATES {
        build.args(["--package", package]);
    }
    build.args(["--target-dir", "target/wasm"]);
    build
}
