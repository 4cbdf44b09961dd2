//! `cargo xtask card`: puts a program on the image of a memory card, with a place for the state.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::ValueEnum;
use unoclp_card::image::{Fat, Image};

use crate::shell::{self, say};

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../programs/STATE.TXT");

/// `cargo xtask card`
#[derive(clap::Args)]
pub struct Args {
    /// The program: a text file of numeric codes. On the card it is named PROGRAM.TXT
    program: PathBuf,
    /// The image file to write
    #[arg(short, long, value_name = "FILE", default_value = "card.img")]
    output: PathBuf,
    /// The file system, FAT16 or FAT32
    #[arg(long, value_enum, default_value = "16")]
    fat: Kind,
    /// Without a partition table
    #[arg(long)]
    bare: bool,
    /// Without STATE.TXT: the board then writes nothing to the card
    #[arg(long)]
    no_state: bool,
}

/// FAT16 or FAT32, as on the command line.
#[derive(Clone, Copy, ValueEnum)]
pub enum Kind {
    /// Small cards
    #[value(name = "16")]
    Fat16,
    /// Cards of more than 2 GB
    #[value(name = "32")]
    Fat32,
}

/// Writes the image.
///
/// # Errors
/// If the program cannot be read or the image cannot be written.
pub fn run(args: &Args) -> Result<()> {
    write(
        &args.program,
        &args.output,
        args.fat,
        args.bare,
        !args.no_state,
    )?;
    say(&format!(
        "card: {} on {} as PROGRAM.TXT{}",
        args.program.display(),
        args.output.display(),
        if args.no_state {
            ""
        } else {
            ", with a STATE.TXT for inputs and outputs"
        }
    ));
    println!(
        "The program was not checked; `cargo run -- check {}` checks it.",
        args.program.display()
    );
    Ok(())
}

/// Puts the program into a new image file, with `STATE.TXT` or without.
///
/// # Errors
/// If the program cannot be read or the image cannot be written.
pub fn write(program: &Path, output: &Path, fat: Kind, bare: bool, state: bool) -> Result<()> {
    let text = fs::read(program).with_context(|| {
        format!(
            "cannot read the program {} (is its name right?)",
            program.display()
        )
    })?;
    let fat = match fat {
        Kind::Fat16 => Fat::Fat16,
        Kind::Fat32 => Fat::Fat32,
    };
    let image = Image::new(fat).file("PROGRAM.TXT", text);
    let image = if state {
        image.file("STATE.TXT", STATE)
    } else {
        image
    };
    let image = if bare { image.bare() } else { image };
    let image = image.build().context("cannot build the card image")?;
    shell::make_folder_of(output)?;
    fs::write(output, image).with_context(|| format!("cannot write {}", output.display()))
}
