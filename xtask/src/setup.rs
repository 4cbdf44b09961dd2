//! Finds out what is missing, and installs it where it can: on Debian and Ubuntu, as root.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};

use crate::node;
use crate::shell::{self, exists, output, say};
use crate::toolchain::Toolchain;
use crate::toolset::{Pinned, installed};

/// Something that must be there: a Debian package, what it is for, and how to find it.
pub struct Need {
    /// The Debian package that brings it.
    pub package: &'static str,
    /// What it is for, to follow "for".
    pub purpose: &'static str,
    /// Whether it is there.
    found: fn(&Need) -> bool,
}

const fn need(package: &'static str, purpose: &'static str, found: fn(&Need) -> bool) -> Need {
    Need {
        package,
        purpose,
        found,
    }
}

/// What the firmware is built with, beside Rust.
const AVR: &[Need] = &[
    need("gcc-avr", "linking the firmware", |_| exists("avr-gcc")),
    need("avr-libc", "the firmware's start-up code", |_| {
        has_avr_libc()
    }),
    need("binutils-avr", "the hex file", |_| exists("avr-objcopy")),
];

/// Rust with the source of its `core`. Where rustup does not have it, Debian does.
const RUST: &[Need] = &[
    need("rustc-web", "compiling for AVR", |_| has_rust()),
    need("cargo-web", "compiling for AVR", |_| has_rust()),
    need("rust-web-src", "compiling for AVR", |_| has_rust()),
];

/// The Rust that has built the tested firmware. Where it is out of reach, a test says what its lack means.
const PINNED_RUST: &[Need] = &[
    need("rustc-web", TESTED, has_pinned_rust),
    need("cargo-web", TESTED, has_pinned_rust),
    need("rust-web-src", TESTED, has_pinned_rust),
];
const TESTED: &str = "building the tested firmware";

/// What looks at the source. rustup brings both by itself, as rust-toolchain.toml asks.
const CHECKS: &[Need] = &[
    need("rustfmt-web", "checking the format of the source", |_| {
        output(shell::cargo().args(["fmt", "--version"])).is_some()
    }),
    need(
        "rust-web-clippy",
        "checking the firmware's source",
        |need| {
            Toolchain::find().map_or_else(
                || installed(need.package).is_some(),
                |rust| rust.has_clippy(),
            )
        },
    ),
];

/// What simavr and its binding are built with.
const SIMAVR: &[Need] = &[
    need("gcc", "compiling simavr", |_| exists("gcc")),
    need("make", "compiling simavr", |_| exists("make")),
    need("pkg-config", "finding simavr's libraries", |_| {
        exists("pkg-config")
    }),
    need("libelf-dev", "simavr", |_| has_library("libelf")),
    need("zlib1g-dev", "simavr", |_| has_library("zlib")),
    need("libzstd-dev", "simavr", |_| has_library("libzstd")),
    need("libclang-dev", "reading simavr's headers", |need| {
        installed(need.package).is_some()
            || std::env::var_os("LIBCLANG_PATH").is_some()
            || !has_apt()
    }),
];

/// What the tests on the simulated board call.
const TESTS: &[Need] = &[
    need(
        "dosfstools",
        "checking the file systems of card images",
        |_| has_fsck(),
    ),
    need(
        "arduino-core-avr",
        "writing the firmware through the real boot loaders",
        |_| Path::new(BOOT_LOADERS).is_dir(),
    ),
    need("mbpoll", "asking the Modbus server", |_| {
        output(Command::new("mbpoll").arg("-V")).is_some()
    }),
    need("mosquitto", "reporting to a broker", |_| {
        // Debian puts it where only root's path leads.
        Path::new("/usr/sbin/mosquitto").is_file() || exists("mosquitto")
    }),
    need("mosquitto-clients", "receiving reports", |_| {
        // Its `--version` says that it has failed.
        output(Command::new("sh").args(["-c", "command -v mosquitto_sub"])).is_some()
    }),
    need("libfaketime", "setting a gateway's clock back", |_| {
        let machines = std::fs::read_dir("/usr/lib").into_iter().flatten();
        let library = |of: std::fs::DirEntry| of.path().join("faketime/libfaketimeMT.so.1");
        machines.flatten().any(|of| library(of).is_file())
    }),
    need("curl", "requesting an encrypted page", |_| exists("curl")),
    need("postgresql", "keeping a history in a database", |_| {
        // No path leads to its programs.
        Path::new("/usr/lib/postgresql").is_dir() && exists("psql")
    }),
    need(
        "python3-venv",
        "asking the Modbus server with pymodbus",
        |_| output(Command::new("python3").args(["-c", "import ensurepip, venv"])).is_some(),
    ),
];

/// What the lab is built with, and what runs its simulated board.
const LAB: &[Need] = &[
    need("nodejs", "building and testing the lab", |_| exists("node")),
    need("npm", "the packages of the lab", |_| exists(node::NPM)),
];

/// Where Debian's Arduino core has its boot loaders; `proof/uno-sim/tests/it/boot_loaders.rs` reads two of them.
const BOOT_LOADERS: &str = "/usr/share/arduino/hardware/arduino/avr/bootloaders";

/// What the tests of the page drive.
const BROWSER: &[Need] = &[
    need("chromium-headless-shell", "testing the page", |_| {
        has_chromium()
    }),
    need(
        "firefox-esr",
        "testing the page in a second browser",
        |_| has_firefox(),
    ),
];

/// What Python brings, for a folder of its own: the clients of Modbus and of Sparkplug B that are not of Debian.
const PYTHON: [&str; 4] = [
    "pygls==2.0.0",
    "pymodbus==3.16.1",
    "pyserial==3.5",
    "pysparkplug==0.6.1",
];

/// Sees to it that the firmware can be built.
///
/// # Errors
/// If something is missing and cannot be installed from here; the text says what to do.
pub fn for_firmware() -> Result<Toolchain> {
    provide(&[AVR, RUST])
}

/// Sees to it that the firmware can be built and simulated.
///
/// # Errors
/// As [`for_firmware`].
pub fn for_simulator() -> Result<Toolchain> {
    provide(&[AVR, RUST, SIMAVR])
}

/// Sees to it that a firmware can be simulated.
///
/// # Errors
/// As [`for_firmware`].
pub fn for_demo() -> Result<()> {
    install_missing(&[SIMAVR])
}

/// Sees to it that everything can be built and checked; the tested firmware too, unless that is `kept`.
///
/// # Errors
/// As [`for_firmware`].
pub fn for_tests(kept: bool) -> Result<Toolchain> {
    let pinned = if kept { &[] } else { PINNED_RUST };
    let toolchain = provide(&[AVR, RUST, pinned, CHECKS, SIMAVR, TESTS, LAB, BROWSER])?;
    provide_python()?;
    node::install()?;
    Ok(toolchain)
}

/// Sees to it that the page can be built: the firmware in it is the one of the repository.
///
/// # Errors
/// As [`for_firmware`].
pub fn for_lab() -> Result<Toolchain> {
    let toolchain = provide(&[RUST, LAB])?;
    node::install()?;
    Ok(toolchain)
}

/// A Python with these clients, under `target/python`.
fn provide_python() -> Result<()> {
    let folder = shell::root().join("target/python");
    let python = folder.join("bin/python3");
    if output(Command::new(&python).args(["-c", "import pygls, pymodbus, serial, pysparkplug"]))
        .is_some()
    {
        return Ok(());
    }
    say("setup: installing pygls, pymodbus and pysparkplug in target/python");
    shell::run(Command::new("python3").args(["-m", "venv"]).arg(&folder))?;
    let pip = ["-m", "pip", "--quiet", "install"];
    shell::run(Command::new(&python).args(pip).args(PYTHON))
}

/// `cargo xtask setup`
///
/// # Errors
/// As [`for_firmware`].
pub fn run() -> Result<()> {
    for_tests(false).map(drop)
}

fn provide(groups: &[&'static [Need]]) -> Result<Toolchain> {
    install_missing(groups)?;
    Toolchain::find().context(NO_RUST)
}

fn install_missing(groups: &[&'static [Need]]) -> Result<()> {
    say("setup: looking for the tools");
    let missing = missing(groups);
    match plan(&missing, has_apt(), is_root()) {
        Plan::Nothing => Ok(()),
        Plan::Tell(what) => bail!(what),
        Plan::Install => install(&missing, groups),
    }
}

fn missing(groups: &[&'static [Need]]) -> Vec<&'static Need> {
    let needs = groups.iter().copied().flatten();
    needs.filter(|need| !(need.found)(need)).collect()
}

/// What to do about what is missing.
#[derive(Debug, PartialEq, Eq)]
enum Plan {
    Nothing,
    Install,
    Tell(String),
}

fn plan(missing: &[&Need], apt: bool, root: bool) -> Plan {
    match (missing.is_empty(), apt, root) {
        (true, _, _) => Plan::Nothing,
        (_, true, true) => Plan::Install,
        (_, true, false) => Plan::Tell(format!(
            "some tools are missing:\n{}\nRun this line, and then the same command again:\n\n    \
             sudo apt-get update && sudo apt-get install --no-install-recommends {}\n",
            reasons(missing),
            Vec::from_iter(versions(missing)).join(" ")
        )),
        (_, false, _) => Plan::Tell(format!(
            "some tools are missing (the names are those of Debian's packages):\n{}\nThey are \
             installed automatically on Debian and Ubuntu only. README.md says what to install elsewhere.",
            reasons(missing)
        )),
    }
}

/// A line for each of the needs, and what else would do.
fn reasons(missing: &[&Need]) -> String {
    let mut lines = String::new();
    for need in missing {
        lines += &format!("  {:<16} for {}\n", need.package, need.purpose);
    }
    let of_rust = |need: &&Need| {
        let mut all = RUST.iter().chain(CHECKS);
        all.any(|rust| (rust.package, rust.purpose) == (need.package, need.purpose))
    };
    if missing.iter().any(of_rust) {
        lines += RUSTUP;
    }
    if missing.iter().any(|need| need.purpose == TESTED) {
        lines += KEPT;
    }
    lines
}

/// Each package once, in the version that is pinned where it is pinned and within reach.
fn versions(missing: &[&Need]) -> BTreeSet<String> {
    let pinned = Pinned::read().map(|pinned| pinned.debian);
    let pinned = pinned.unwrap_or_default();
    let named = missing.iter().map(|need| match pinned.get(need.package) {
        Some(version) if is_in_reach(need.package, version) => {
            format!("{}={version}", need.package)
        }
        _ => need.package.to_owned(),
    });
    named.collect()
}

const RUSTUP: &str = "  (With rustup, `rustup component add rust-src clippy rustfmt` in this folder replaces the Rust packages.)\n";

const KEPT: &str = "  (Without them, `cargo xtask test --kept` runs the tests on the tested firmware, and builds no firmware.)\n";

const NO_RUST: &str = concat!(
    "no Rust ",
    env!("CARGO_PKG_RUST_VERSION"),
    " or later with the source of its `core` is installed: run `rustup component add rust-src` in this \
     folder"
);

fn install(told: &[&Need], groups: &[&'static [Need]]) -> Result<()> {
    say("setup: installing what is missing, with apt-get");
    print!("{}", reasons(told));
    // A source of packages that is out of reach need not be the one that has these.
    if let Err(error) = shell::run(apt_get().args(["-qq", "update"])) {
        eprintln!("warning: {error}");
    }
    // apt may know only now what is within reach.
    let missing = &self::missing(groups);
    for need in missing {
        let known = output(Command::new("apt-cache").args(["show", need.package]));
        ensure!(
            known.is_some_and(|text| !text.is_empty()),
            "this system has no package {}, which is needed for {}\n{}",
            need.package,
            need.purpose,
            reasons(&[need])
        );
    }
    // Nothing is removed for it: what is in the way is the user's to decide.
    let options = [
        "-qq",
        "install",
        "-y",
        "--no-install-recommends",
        "--no-remove",
    ];
    shell::run(apt_get().args(options).args(versions(missing)))?;

    let still = self::missing(groups);
    ensure!(
        still.is_empty(),
        "installed, but not found:\n{}",
        reasons(&still)
    );
    Ok(())
}

fn apt_get() -> Command {
    let mut command = Command::new("apt-get");
    command.env("DEBIAN_FRONTEND", "noninteractive");
    command
}

fn has_apt() -> bool {
    exists("apt-get")
}

fn is_root() -> bool {
    output(Command::new("id").arg("-u")).as_deref() == Some("0")
}

/// The tests of the page look in the same places.
fn has_chromium() -> bool {
    let names = ["chromium-headless-shell", "chromium", "google-chrome"];
    let is_there = |name: &&str| Path::new("/usr/bin").join(name).exists();
    std::env::var_os("CHROMIUM").is_some() || names.iter().any(is_there)
}

/// The test of the page in Firefox looks in the same places.
fn has_firefox() -> bool {
    let names = ["firefox-esr", "firefox"];
    let is_there = |name: &&str| Path::new("/usr/bin").join(name).exists();
    std::env::var_os("FIREFOX").is_some() || names.iter().any(is_there)
}

fn has_rust() -> bool {
    Toolchain::find().is_some()
}

/// Whether it is here, or apt does not have it either.
fn has_pinned_rust(need: &Need) -> bool {
    let debian = || Pinned::read().ok()?.debian.remove(need.package);
    Toolchain::pinned().is_some()
        || !debian().is_some_and(|version| is_in_reach(need.package, &version))
}

/// Whether apt knows a package in this version.
fn is_in_reach(package: &str, version: &str) -> bool {
    let known = output(Command::new("apt-cache").args(["madison", package]));
    let versions = known.unwrap_or_default();
    let mut versions = versions.lines().filter_map(|line| line.split('|').nth(1));
    versions.any(|known| known.trim() == version)
}

/// avr-gcc prints a path where it has the file, and its bare name where it does not.
fn has_avr_libc() -> bool {
    const START: &str = "crtatmega328p.o";
    let arguments = ["-mmcu=atmega328p", &format!("-print-file-name={START}")];
    output(Command::new("avr-gcc").args(arguments)).is_some_and(|path| path != START)
}

/// Debian keeps it in a folder that is in the PATH of root alone.
fn has_fsck() -> bool {
    ["fsck.fat", "/usr/sbin/fsck.fat"]
        .iter()
        .any(|program| output(Command::new(program).arg("--help")).is_some())
}

fn has_library(name: &str) -> bool {
    output(Command::new("pkg-config").args(["--exists", name])).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEEDS: &[Need] = &[
        need("gcc-avr", "linking the firmware", |_| false),
        need("make", "compiling simavr", |_| true),
        need("rust-web-src", "compiling for AVR", |_| false),
    ];

    fn told(apt: bool, root: bool) -> String {
        match plan(&missing(&[NEEDS]), apt, root) {
            Plan::Tell(text) => text,
            other => panic!("expected a text, not {other:?}"),
        }
    }

    #[test]
    fn only_what_is_missing_is_installed() {
        let names: Vec<_> = missing(&[NEEDS]).iter().map(|need| need.package).collect();
        assert_eq!(names, ["gcc-avr", "rust-web-src"]);
        assert_eq!(plan(&missing(&[NEEDS]), true, true), Plan::Install);
        assert_eq!(plan(&[], true, true), Plan::Nothing);
        assert_eq!(plan(&[], false, false), Plan::Nothing);
    }

    #[test]
    fn who_is_not_root_gets_the_line_to_run() {
        let text = told(true, false);
        let line = "sudo apt-get update && sudo apt-get install --no-install-recommends gcc-avr";
        assert_eq!(
            text.lines().filter(|l| l.trim().starts_with(line)).count(),
            1,
            "{text}"
        );
        assert!(
            text.contains("gcc-avr          for linking the firmware"),
            "{text}"
        );
        assert!(text.contains("rustup component add rust-src"), "{text}");
    }

    #[test]
    fn who_has_no_apt_is_sent_to_the_readme() {
        for root in [false, true] {
            let text = told(false, root);
            assert!(
                text.contains("gcc-avr") && text.contains("README.md"),
                "{text}"
            );
            assert!(
                !text.contains("apt-get") && !text.contains("make"),
                "{text}"
            );
        }
    }
}
