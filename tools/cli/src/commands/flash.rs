//! `unoclp flash`.

use super::interrupt::{Interrupt, Interrupted};
use super::open::read;
use super::progress::{self, hide};
use super::words::models;
use crate::messages;
use crate::outcome::Outcome;
use crate::port::Port;
use anyhow::{anyhow, bail};
use clap::Args;
use std::ops::ControlFlow;
use std::path::PathBuf;
use unoclp_boot::{Image, Model, Progress, Writer};
use unoclp_client::flash::flash as write;
use unoclp_client::session::Event;

/// What is written, and where.
#[derive(Args)]
pub struct Firmware {
    /// A firmware file in Intel HEX; by default, the tested firmware that comes with this command
    file: Option<PathBuf>,
    /// The serial port: /dev/ttyACM0, /dev/ttyUSB0, COM3 …
    #[arg(long)]
    port: String,
    /// The board; nano-old is a Nano with the boot loader used until 2018, and mega is a Mega 2560
    #[arg(long, value_name = "BOARD", default_value = "uno", value_parser = models())]
    board: Model,
}

/// The tested firmware of a board (`cargo xtask firmware --keep`).
const fn tested(board: Model) -> &'static [u8] {
    match board.firmware() {
        Model::Uno => include_bytes!("../../../../firmware/unoclp-uno.hex"),
        Model::Mega => include_bytes!("../../../../firmware/unoclp-mega.hex"),
        Model::Nano | Model::NanoOld => include_bytes!("../../../../firmware/unoclp-nano.hex"),
    }
}

/// Writes a firmware to a board, reads it back and compares it.
pub fn flash(firmware: &Firmware) -> Outcome {
    let Firmware { file, port, board } = firmware;
    let (name, hex) = match file {
        Some(path) => {
            let file = read(path)?;
            (file.name, file.bytes)
        }
        None => (messages::tested_firmware(), tested(*board).to_vec()),
    };
    let image = Image::read(&hex, *board)
        .map_err(|unfit| anyhow!("{name}: {}", unfit.text(messages::spoken())))?;
    let bytes = image.bytes().len();
    let mut line = Port::open_for_boot_loader(port, *board)?;
    say!("{}", messages::flashing(&name, bytes, board.name(), port));

    let interrupt = Interrupt::new()?;
    let mut writer = Writer::new(&image);
    let mut shown = None;
    let mut tell = |event: Event<'_>| {
        if let Event::Flashing(progress) = event {
            show(progress, &mut shown);
        }
    };
    let talk = async |client: &mut _| write(client, &mut writer, &mut tell).await;
    let outcome = line.attended(talk, || interrupt.attend());
    hide();
    match outcome {
        ControlFlow::Continue(Ok(())) => say!("{}", messages::flashed(bytes)),
        ControlFlow::Continue(Err(failure)) => {
            bail!("{port}: {}", failure.text(messages::spoken()))
        }
        ControlFlow::Break(Interrupted) => {
            let left = writer.left(messages::spoken());
            bail!("{}. {left}", messages::interrupted())
        }
    }
    Ok(true)
}

/// Shows the progress.
fn show(now: Progress, shown: &mut Option<Progress>) {
    if shown.replace(now) != Some(now) {
        let percent = 100 * now.done / now.of.max(1);
        progress::show(|| messages::flash_progress(messages::stage(now.stage), percent));
    }
}
