//! Checks a linked AVR ELF for an error of LLVM's AVR back end.
//!
//! `mul` leaves its product in r1:r0. LLVM may keep the low byte in r0 while it uses r0 to save
//! the status register around an access to a far stack slot; the product is lost. What is wrong,
//! why, and what avoids it stands in `docs/avr-codegen.md`. No compiler flag proves that a build
//! is free of it, so every build is checked: this module decodes all code that can be reached
//! (`decode`, `opcodes`), and follows r0 along every path (`flow`).

mod decode;
mod elf;
mod flow;
mod opcodes;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::fmt;
use std::path::PathBuf;

use anyhow::{Context, Result, ensure};

use self::elf::Code;
pub use self::flow::Origin;

/// `cargo xtask r0check`
#[derive(clap::Args)]
pub struct Args {
    /// The ELF files to check
    #[arg(required = true)]
    elf: Vec<PathBuf>,
}

/// Checks the files named on the command line.
///
/// # Errors
/// If one of them cannot be read or is hit by the error.
pub fn run(args: &Args) -> Result<()> {
    for path in &args.elf {
        let bytes =
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        println!("{}:", path.display());
        accept(&bytes)?;
    }
    Ok(())
}

/// The least share of the code, in per cent, that must have been followed: what the check has not seen it
/// cannot vouch for. The rest is code that nothing leads to.
const FOLLOWED: usize = 98;

/// Checks an ELF and prints the result.
///
/// # Errors
/// If it is hit by the error, or is not an AVR ELF with symbols, or too much of its code leads nowhere
/// that is known.
pub fn accept(elf: &[u8]) -> Result<()> {
    let report = check(elf)?;
    println!("{report}");
    ensure!(
        report.findings.is_empty(),
        "the compiler made wrong code: see docs/avr-codegen.md. Do not run this build; build it \
         with the flags of .cargo/config.toml"
    );
    ensure!(
        100 * report.followed >= FOLLOWED * report.code,
        "the check has followed less than {FOLLOWED} % of the code, so its verdict says too little"
    );
    Ok(())
}

/// Checks an ELF.
///
/// # Errors
/// If it is not an AVR ELF with symbols, or code leads to where there is none.
pub fn check(elf: &[u8]) -> Result<Report> {
    // A reset begins at address 0, where the vectors are.
    flow::check(&Code::from_elf(elf)?, 0)
}

/// What the check has seen and found.
#[derive(Debug, Default)]
pub struct Report {
    /// Functions and handlers followed, by symbol, because they are called, or behind an `ijmp`.
    pub functions: usize,
    /// Instructions on their paths, each counted once.
    pub instructions: usize,
    /// The bytes of these instructions.
    pub followed: usize,
    /// The bytes of all code: what is in flash and is no constant.
    pub code: usize,
    /// Multiplications among them.
    pub products: usize,
    /// The instructions that get a wrong value from r0.
    pub findings: BTreeSet<Finding>,
}

/// An instruction that gets a wrong value from r0.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Finding {
    /// Its byte address in flash.
    pub address: u32,
    /// The function or label that it belongs to.
    pub function: String,
    /// The instruction, without operands other than registers.
    pub instruction: String,
    /// Where the wrong value may come from.
    pub origins: Vec<Origin>,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for finding in &self.findings {
            writeln!(f, "{finding}")?;
        }
        let verdict = match self.findings.len() {
            0 => "no value in r0 is lost".to_owned(),
            1 => "1 value in r0 IS LOST".to_owned(),
            n => format!("{n} values in r0 ARE LOST"),
        };
        write!(
            f,
            "r0 check: {} functions, {} instructions, {} of them mul; {} of {} B followed: {verdict}",
            self.functions, self.instructions, self.products, self.followed, self.code
        )
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{:#06x} in {}: `{}` reads r0, which by then holds",
            self.address, self.function, self.instruction
        )?;
        for (n, origin) in self.origins.iter().enumerate() {
            write!(f, "{} {origin}", if n == 0 { "" } else { " or" })?;
        }
        Ok(())
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Origin::Entry => write!(f, "what the caller left there"),
            Origin::Product(at) => write!(f, "the product of {at:#06x}"),
            Origin::Status(at) => write!(f, "the status register, saved at {at:#06x}"),
            Origin::Call(at) => write!(f, "what the call at {at:#06x} left there"),
            Origin::Other(at) => write!(f, "the value of {at:#06x}"),
        }
    }
}
