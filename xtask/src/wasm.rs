//! Checks that what a page in a browser is made of compiles for WebAssembly.
//!
//! Where rustup has installed the target, with the active toolchain; else with Debian's, which builds the
//! standard library from source. Nothing is linked, and no code is made: that takes an eighth of the time.

use std::process::Command;

use crate::toolchain::Toolchain;

/// What a page needs: none of it knows a port, a thread or a terminal.
const CRATES: &[&str] = &[
    "unoclp-board",
    "unoclp-boot",
    "unoclp-card",
    "unoclp-checked",
    "unoclp-core",
    "unoclp-host-sim",
    "unoclp-ladder",
    "unoclp-lang",
    "unoclp-modbus",
    "unoclp-source",
];

/// The command that checks them, in a folder of its own: another cargo may be at work in the usual one.
pub fn check(toolchain: &Toolchain) -> Command {
    let mut check = toolchain.cargo_for_wasm("check");
    for package in CRATES {
        check.args(["--package", package]);
    }
    check.args(["--target-dir", "target/wasm"]);
    check
}
