//! The tested firmware: the files in `firmware/` that users write to their boards, and what has built them.
//!
//! Another compiler makes another firmware, and only this one is what the suite has run on. So the sums stand beside
//! it with the compiler's name, a test builds it anew, and `cargo xtask firmware` says where the compiler is another.

use std::fmt;
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Context, Result};
use sha2::{Digest, Sha256};
use unoclp_boot::Model;

use crate::firmware::{self, BOARDS, Firmware};
use crate::shell::{self, say};
use crate::toolchain::Toolchain;

/// What turns the source into a firmware: rustc, and what assembles and links, with their versions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compiler(String);

impl Compiler {
    /// That of this machine.
    ///
    /// # Errors
    /// If a part of it does not say what it is.
    pub fn of(toolchain: &Toolchain) -> Result<Compiler> {
        let rustc = toolchain
            .version()
            .context("rustc does not say what it is")?;
        let gcc = first_line("avr-gcc")?;
        let binutils = first_line("avr-as")?;
        let libc = avr_libc()?;
        Ok(Compiler(format!("{rustc}; {gcc}; {binutils}; {libc}")))
    }

    /// That which has built `target/firmware`.
    ///
    /// # Errors
    /// If nothing was built.
    pub fn of_build() -> Result<Compiler> {
        let text = fs::read_to_string(noted());
        Ok(Compiler(text.context("`cargo xtask firmware` notes it")?))
    }
}

impl fmt::Display for Compiler {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

fn first_line(program: &str) -> Result<String> {
    let text = shell::output(Command::new(program).arg("--version"));
    let text = text.with_context(|| format!("{program} is not installed, or not in PATH"))?;
    Ok(text.lines().next().unwrap_or_default().to_owned())
}

/// `avr-libc 2.0.0`
fn avr_libc() -> Result<String> {
    const NAME: &str = "__AVR_LIBC_VERSION_STRING__";
    let mut gcc = Command::new("avr-gcc");
    gcc.args(["-E", "-dM", "-include", "avr/version.h", "-xc", "-"]);
    let text = shell::output(gcc.stdin(Stdio::null()));
    let version = text.as_deref().and_then(|text| {
        let line = text.lines().find(|line| line.contains(NAME))?;
        line.split('"').nth(1)
    });
    let version = version.context("avr-libc does not say what it is")?;
    Ok(format!("avr-libc {version}"))
}

/// Where the compiler of the last build is noted.
fn noted() -> PathBuf {
    firmware::folder().join("compiler")
}

/// Notes what has built `target/firmware`.
///
/// # Errors
/// If that is not possible.
pub fn note(compiler: &Compiler) -> Result<()> {
    let path = noted();
    fs::write(&path, &compiler.0).with_context(|| format!("cannot write {}", path.display()))
}

/// The tested firmware of a board: `firmware/unoclp-uno.hex`.
pub fn hex(board: Model) -> PathBuf {
    shell::root().join("firmware").join(name(board))
}

fn name(board: Model) -> String {
    format!("unoclp-{}.hex", board.firmware().name())
}

/// The sums, in the form of `sha256sum`, and the compiler in a comment above them.
fn sums() -> PathBuf {
    shell::root().join("firmware/SHA256SUMS")
}

/// What stands before the compiler's name.
const BUILT_BY: &str = "# Built by ";

/// The text of the file of sums for these files.
///
/// # Errors
/// If a file is not there.
pub fn text(compiler: &Compiler, hex: impl Fn(Model) -> PathBuf) -> Result<String> {
    let mut text = format!("{BUILT_BY}{compiler}\n");
    for board in BOARDS {
        let path = hex(board);
        let bytes = fs::read(&path).with_context(|| format!("cannot read {}", path.display()))?;
        text += &format!("{:x}  {}\n", Sha256::digest(&bytes), name(board));
    }
    Ok(text)
}

/// The compiler that has built the tested firmware, and the text that names it.
///
/// # Errors
/// If the file of sums is not there or does not begin with it.
pub fn kept() -> Result<(Compiler, String)> {
    let path = sums();
    let text =
        fs::read_to_string(&path).with_context(|| format!("cannot read {}", path.display()))?;
    let first = text
        .lines()
        .next()
        .and_then(|line| line.strip_prefix(BUILT_BY));
    let compiler = first.with_context(|| format!("{} names no compiler", path.display()))?;
    Ok((Compiler(compiler.to_owned()), text))
}

/// Takes what was just built for the tested firmware.
///
/// # Errors
/// If a file cannot be written.
pub fn keep(compiler: &Compiler) -> Result<()> {
    for board in BOARDS {
        let (from, to) = (Firmware::of(board).hex, hex(board));
        fs::copy(&from, &to).with_context(|| format!("cannot write {}", to.display()))?;
        say(&format!("firmware: kept as {}", to.display()));
    }
    let path = sums();
    fs::write(&path, text(compiler, hex)?)
        .with_context(|| format!("cannot write {}", path.display()))
}

/// How what was just built compares with the tested firmware, in a sentence.
///
/// # Errors
/// If there is no tested firmware.
pub fn verdict(compiler: &Compiler) -> Result<String> {
    let (tested, kept) = kept()?;
    let built = text(&tested, |board| Firmware::of(board).hex)?;
    Ok(sentence(built == kept, compiler, &tested))
}

fn sentence(is_same: bool, here: &Compiler, tested: &Compiler) -> String {
    match (is_same, here == tested) {
        (true, _) => "this is the tested firmware, byte for byte".to_owned(),
        (false, true) => {
            "this is not the tested firmware: the source has changed. Once `cargo xtask test` has \
             passed otherwise, `cargo xtask firmware --keep` makes it the tested one"
                .to_owned()
        }
        (false, false) => format!(
            "warning: this compiler is not the tested one, so the suite has not run on what it makes.\n  \
             tested: {tested}\n  here:   {here}\n\
             `cargo xtask flash` writes the tested firmware; `cargo xtask test` runs the suite on this one"
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::{Compiler, sentence};

    #[test]
    fn another_compiler_is_told_where_it_makes_another_firmware() {
        let compiler = |name: &str| Compiler(name.to_owned());
        let (tested, other) = (compiler("rustc 1.96.0"), compiler("rustc 1.97.0"));
        let told = sentence(false, &other, &tested);
        assert!(told.contains("tested: rustc 1.96.0"), "{told}");
        assert!(told.contains("here:   rustc 1.97.0"), "{told}");
        assert!(sentence(false, &tested, &tested).contains("--keep"));
        for compiler in [&tested, &other] {
            let told = sentence(true, compiler, &tested);
            assert_eq!(told, "this is the tested firmware, byte for byte");
        }
    }
}
