//! Compiles for WebAssembly what a page in a browser is made of.
//!
//! Where rustup has installed the target, with the active toolchain; else with Debian's, which builds the
//! standard library from source. Libraries need no linker.

use anyhow::Result;

use crate::shell;
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

/// Compiles them, into a folder of its own: another cargo may be at work in the usual one.
///
/// # Errors
/// If one does not compile.
pub fn check(toolchain: &Toolchain) -> Result<()> {
    let mut build = toolchain.cargo_for_wasm("build");
    for package in CRATES {
        build.args(["--package", package]);
    }
    shell::run(build.arg("--target-dir").arg("target/wasm"))
}
