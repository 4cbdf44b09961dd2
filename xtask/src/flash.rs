//! `cargo xtask flash`: writes the tested firmware to a board, by `unoclp flash`; or one that is built for it.

use std::path::PathBuf;

use anyhow::Result;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use unoclp_boot::Model;

use crate::shell::{self, cargo};
use crate::{firmware, setup};

/// `cargo xtask flash`
#[derive(clap::Args)]
pub struct Args {
    /// The serial port of the board: /dev/ttyACM0 or /dev/ttyUSB0 on Linux, /dev/cu.usbmodem… on
    /// macOS, COM3 or the like on Windows
    #[arg(long)]
    port: String,
    /// The board; nano-old is a Nano with the boot loader used until 2018, and mega is a Mega 2560
    #[arg(long, default_value = "uno", value_parser = models())]
    board: Model,
    /// Build the firmware and write it, instead of the tested one
    #[arg(long)]
    build: bool,
    /// Write this file
    #[arg(long, value_name = "FILE", conflicts_with = "build")]
    hex: Option<PathBuf>,
}

fn models() -> impl TypedValueParser<Value = Model> {
    PossibleValuesParser::new(Model::ALL.map(Model::name))
        .map(|name| Model::named(&name).unwrap_or_default())
}

/// Writes the firmware, and builds it before where that is asked for.
///
/// # Errors
/// If the build fails, or the firmware is not on the board; the text says why.
pub fn run(args: &Args) -> Result<()> {
    let hex = match args.build {
        true => {
            let toolchain = setup::for_firmware()?;
            Some(firmware::build(&toolchain, args.board.firmware())?.hex)
        }
        false => args.hex.clone(),
    };
    let mut unoclp = cargo();
    unoclp.args(["run", "--quiet", "--package=unoclp-cli", "--", "flash"]);
    unoclp.args(["--port", &args.port, "--board", args.board.name()]);
    shell::run(unoclp.args(hex))
}
