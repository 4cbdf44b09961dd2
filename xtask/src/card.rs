//! `cargo xtask card`: puts a program on the image of a memory card.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::ValueEnum;
use unoclp_card::image::{Fat, Image};

use crate::shell::{self, say};

/// `cargo xtask card`
#[derive(clap::Args)]
pub struct Args {
    /// The program: a text file of numeric codes. On the card it is named PROGRAM.TXT
    program: PathBuf,
    /// The image file to write
    #[arg(short, long, value_name = "FILE", default_value = "card.img")]
    output: PathBuf,
    /// The kind of volume
    #[arg(long, value_enum, default_value = "16")]
    fat: Kind,
    /// Without a partition table
    #[arg(long)]
    bare: bool,
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
    write(&args.program, &args.output, args.fat, args.bare)?;
    say(&format!(
        "card: {} on {} as PROGRAM.TXT",
        args.program.display(),
        args.output.display()
    ));
    println!(
        "The program was not looked at: `cargo run -- check {}` says whether it is right.",
        args.program.display()
    );
    Ok(())
}

/// Puts the program into a new image file.
///
/// # Errors
/// If the program cannot be read or the image cannot be written.
pub fn write(program: &Path, output: &Path, fat: Kind, bare: bool) -> Result<()> {
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
    let image = if bare { image.bare() } else { image };
    let image = image.build().context("cannot build the card image")?;
    shell::make_folder_of(output)?;
    fs::write(output, image).with_context(|| format!("cannot write {}", output.display()))
}
