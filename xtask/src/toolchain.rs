//! The Rust that compiles for AVR and WebAssembly.
//!
//! `avr-none` comes without a compiled `core`: cargo builds it (`-Z build-std`) from the source
//! that must be of the compiler's own version. rustup brings it as the component `rust-src`,
//! which `rust-toolchain.toml` asks for; Debian has a newer Rust whose source is a package, and it
//! stands beside rustup's in `/usr/bin`. The same compiles for WebAssembly where rustup has no such target.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell;
use crate::toolset::{Pinned, Tools};

/// A Rust with the source of its `core`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Toolchain {
    /// The one that runs this.
    Active,
    /// The one in a folder of its own, as Debian's in `/usr/bin`.
    Folder(PathBuf),
}

/// What runs in a browser.
const TARGET: &str = "wasm32-unknown-unknown";

/// They would replace the flags that `.cargo/config.toml` has for AVR.
const FLAGS: &[&str] = &["CARGO_ENCODED_RUSTFLAGS", "RUSTFLAGS"];

/// cargo and rustup set these for the programs that they run; another cargo would be led back.
const FOREIGN: &[&str] = &[
    "CARGO",
    "LD_LIBRARY_PATH",
    "RUSTC",
    "RUSTDOC",
    "RUSTUP_TOOLCHAIN",
];

impl Toolchain {
    /// Finds one that this workspace can be built with: the one that has built the tested firmware, else any.
    pub fn find() -> Option<Self> {
        Toolchain::pinned().or_else(|| Toolchain::usable().next())
    }

    /// The one that has built the tested firmware.
    pub fn pinned() -> Option<Self> {
        let pinned = Pinned::read().ok()?;
        let is_pinned = |version: String| pinned.has_rustc(&version);
        Toolchain::usable().find(|found| found.version().is_some_and(is_pinned))
    }

    fn usable() -> impl Iterator<Item = Self> {
        let here = [Toolchain::Active, Toolchain::Folder("/usr/bin".into())];
        here.into_iter().filter(Toolchain::is_usable)
    }

    fn is_usable(&self) -> bool {
        let sysroot = shell::output(self.rustc().args(["--print", "sysroot"]));
        let (Some(sysroot), Some(version)) = (sysroot, self.version()) else {
            return false;
        };
        let core = Path::new(&sysroot).join("lib/rustlib/src/rust/library/core");
        core.is_dir() && is_new_enough(&version, env!("CARGO_PKG_RUST_VERSION"))
    }

    /// What its rustc says that it is: name, version, commit and day.
    pub fn version(&self) -> Option<String> {
        shell::output(self.rustc().arg("--version"))
    }

    /// All that turns the source into a firmware.
    ///
    /// # Errors
    /// If a part of it does not say what it is.
    pub fn tools(&self) -> Result<Tools> {
        Tools::with(self.version().context("rustc does not print its version")?)
    }

    /// Whether it comes with clippy.
    pub fn has_clippy(&self) -> bool {
        shell::output(self.bare_cargo("clippy").args(["clippy", "--version"])).is_some()
    }

    fn rustc(&self) -> Command {
        let mut rustc = match self {
            Toolchain::Active => Command::new("rustc"),
            Toolchain::Folder(folder) => Command::new(folder.join("rustc")),
        };
        rustc.current_dir(shell::root());
        rustc
    }

    /// A cargo command of this toolchain for AVR, with `core` built from source.
    ///
    /// `-Z build-std` is unstable; RUSTC_BOOTSTRAP lets a stable compiler take it.
    pub fn cargo(&self, subcommand: &str) -> Command {
        let mut command = self.bare_cargo(subcommand);
        for variable in FLAGS {
            command.env_remove(variable);
        }
        command.env("RUSTC_BOOTSTRAP", "1").args([
            subcommand,
            "-Zbuild-std=core",
            "--target=avr-none",
        ]);
        command
    }

    /// Whether rustup has installed the target for WebAssembly.
    pub fn has_wasm() -> bool {
        let sysroot = shell::output(Toolchain::Active.rustc().args(["--print", "sysroot"]));
        let installed = |sysroot: String| Path::new(&sysroot).join("lib/rustlib").join(TARGET);
        sysroot.map(installed).is_some_and(|folder| folder.is_dir())
    }

    /// A cargo command for `wasm32-unknown-unknown`: of the active toolchain where rustup has the target, else of
    /// this one, with `std` built from source.
    pub fn cargo_for_wasm(&self, subcommand: &str) -> Command {
        let is_installed = Toolchain::has_wasm();
        let mut command = match is_installed {
            true => Toolchain::Active.bare_cargo(subcommand),
            false => self.bare_cargo(subcommand),
        };
        command.args([subcommand, "--target", TARGET]);
        if !is_installed {
            command
                .env("RUSTC_BOOTSTRAP", "1")
                .arg("-Zbuild-std=std,panic_abort");
        }
        command
    }

    /// The program that knows the subcommand.
    fn bare_cargo(&self, subcommand: &str) -> Command {
        match self {
            Toolchain::Active => shell::cargo(),
            Toolchain::Folder(folder) => foreign_cargo(folder, subcommand),
        }
    }
}

/// The linker that comes with the active toolchain: Debian's comes without one for WebAssembly.
pub fn own_linker() -> Option<PathBuf> {
    let mut print = Toolchain::Active.rustc();
    let libraries = shell::output(print.args(["--print", "target-libdir"]))?;
    let linker = Path::new(&libraries).parent()?.join("bin/rust-lld");
    linker.is_file().then_some(linker)
}

fn foreign_cargo(folder: &Path, subcommand: &str) -> Command {
    let cargo = folder.join("cargo");
    // Told to run clippy, this cargo would look where rustup keeps its own.
    let mut command = match subcommand {
        "clippy" => Command::new(folder.join("cargo-clippy")),
        _ => Command::new(&cargo),
    };
    for variable in FOREIGN {
        command.env_remove(variable);
    }
    command
        .current_dir(shell::root())
        .env("CARGO", cargo)
        .env("RUSTC", folder.join("rustc"));
    command
}

/// Whether `rustc --version` has printed at least the version `least`, as in `1.95`.
fn is_new_enough(printed: &str, least: &str) -> bool {
    let numbers = |version: &str| -> Option<(u32, u32)> {
        let mut parts = version.split('.').map(str::parse);
        Some((parts.next()?.ok()?, parts.next()?.ok()?))
    };
    let version = printed.split_whitespace().nth(1).and_then(numbers);
    version.is_some() && version >= numbers(least)
}

#[cfg(test)]
mod tests {
    use super::is_new_enough;

    #[test]
    fn the_version_is_compared_by_its_numbers() {
        let cases = [
            (
                "rustc 1.96.0 (ac68faa20 2026-05-25) (built from a source tarball)",
                true,
            ),
            ("rustc 1.95.0 (59807616e 2026-04-14)", true),
            ("rustc 1.100.0-nightly (59807616e 2026-04-14)", true),
            ("rustc 2.0.0", true),
            ("rustc 1.94.1 (59807616e 2026-04-14)", false),
            ("rustc 1.9.0", false),
            ("rustc", false),
            ("", false),
        ];
        for (printed, expected) in cases {
            assert_eq!(is_new_enough(printed, "1.95"), expected, "{printed}");
        }
    }
}
