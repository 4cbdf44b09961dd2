//! WebAssembly: builds the page's modules, and with them every library that a page needs.
//!
//! Where rustup has installed the target, with the active toolchain; else with Debian's, which builds the
//! standard library from source.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result};

use crate::node;
use crate::shell;
use crate::toolchain::{Toolchain, own_linker};

/// How small the standard library becomes where it is built anyway: a panic, which nothing reaches, stops the module
/// without a word.
const SMALL: &str =
    "-Clinker-flavor=wasm-ld -Zunstable-options -Cpanic=immediate-abort -Zlocation-detail=none";

/// The modules of the page: what cargo is told, and the file that a page loads. The second takes the place of the first
/// as soon as somebody needs what only it has.
const MODULES: [(&[&str], &str); 2] = [
    (
        &[
            "--no-default-features",
            // It draws what a visitor sees first; who changes the drawing has the second.
            "--config=profile.page.package.unoclp-draw.opt-level=\"z\"",
        ],
        "unoclp.wasm",
    ),
    (&[], "unoclp-full.wasm"),
];

/// Builds the modules of the page, in this folder.
///
/// # Errors
/// If one does not compile.
pub fn build(toolchain: &Toolchain, folder: &Path) -> Result<()> {
    for (features, file) in MODULES {
        let mut build = toolchain.cargo_for_wasm("rustc");
        build.args(["--package", "unoclp-bridge", "--lib", "--profile", "page"]);
        // Beside an rlib cargo would optimize nothing across crates.
        build.args(["--crate-type", "cdylib"]);
        build.args(["--target-dir", "target/wasm"]).args(features);
        // A cdylib has no fingerprint of its own features else, and each module would be linked again after the other.
        build.env("__CARGO_DEFAULT_LIB_METADATA", "page");
        if !Toolchain::has_wasm() {
            build.arg("-Zbuild-std-features=optimize_for_size");
            build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", SMALL);
            if let Some(linker) = own_linker() {
                build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker);
            }
        }
        shell::run(&mut build)?;
        let built = "target/wasm/wasm32-unknown-unknown/page/unoclp_bridge.wasm";
        let to = folder.join(file);
        shell::make_folder_of(&to)?;
        shrink(&shell::root().join(built), &to)?;
    }
    Ok(())
}

/// What rustc takes every browser to have. The module itself no longer says so: it is stripped.
const FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
];

/// How a module becomes smaller. Large functions that are called once stay apart: in the place of their call they compress
/// worse.
const SHRINK: [&str; 2] = ["-Oz", "--one-caller-inline-max-function-size=30"];

/// Writes a module in fewer bytes, by the Binaryen among the packages of the lab, unless it did so with this one before:
/// that takes longer than all else where nothing has changed.
fn shrink(module: &Path, to: &Path) -> Result<()> {
    let packages = node::page().join("node_modules/binaryen");
    let mut from = [SHRINK.as_slice(), &FEATURES]
        .concat()
        .concat()
        .into_bytes();
    for file in [packages.join("package.json"), module.to_owned()] {
        from.extend(fs::read(&file).with_context(|| format!("cannot read {}", file.display()))?);
    }
    let before = to.with_extension("from");
    if to.exists() && fs::read(&before).is_ok_and(|before| before == from) {
        return Ok(());
    }
    let mut shrink = Command::new("node");
    shrink.arg(packages.join("bin/wasm-opt")).args(SHRINK);
    shell::run(shrink.args(FEATURES).arg(module).arg("-o").arg(to))?;
    fs::write(&before, from).with_context(|| format!("cannot write {}", before.display()))
}
