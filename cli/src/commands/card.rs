//! `unoclp card`.

use super::open::{Il, Shown, open};
use super::output::is_same;
use crate::{Outcome, cannot_write};
use anstream::println;
use anyhow::{Context, bail};
use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_cli::messages;

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../../programs/STATE.TXT");

/// Puts a program on a card that is mounted as this folder, or on a new image of a card. Of what is there,
/// nothing but a `PROGRAM.TXT` is overwritten.
pub fn card(target: &Path, file: &Path, state: bool, il: &Il) -> Outcome {
    let kind = fs::metadata(target).map(|target| target.file_type());
    let name = target.display();
    let is_folder = match kind {
        Ok(kind) if kind.is_dir() => true,
        Ok(kind) if kind.is_file() => bail!(
            "{name} is there already, and only PROGRAM.TXT on a card is overwritten; name a new image file, or \
             the folder of a mounted card"
        ),
        Ok(_) => bail!("{name} is a device; mount the card, and name its folder"),
        Err(error) if error.kind() != ErrorKind::NotFound => {
            return Err(error).with_context(|| format!("{name} cannot be looked at"));
        }
        Err(_)
            if target
                .extension()
                .is_some_and(|end| end.eq_ignore_ascii_case("img")) =>
        {
            false
        }
        Err(_) => bail!(
            "there is no folder {name}; is the card mounted? For an image of a card, name a file that ends \
             in .img"
        ),
    };
    if is_same(file, &target.join("PROGRAM.TXT")) {
        bail!(messages::is_read(file.display()));
    }
    let Some(program) = open(file, il, Shown::Here)? else {
        return Ok(false);
    };
    if is_folder {
        into_folder(target, &program.code, state)?;
    } else {
        into_image(target, &program.code, state)?;
    }
    println!(
        "{}: on {name} as PROGRAM.TXT, {} bytes",
        program.name,
        program.code.len()
    );
    Ok(true)
}

fn into_folder(folder: &Path, program: &[u8], state: bool) -> anyhow::Result<()> {
    let path = folder.join("PROGRAM.TXT");
    // A link may lead anywhere.
    if fs::symlink_metadata(&path).is_ok_and(|there| !there.is_file()) {
        bail!(
            "{} is not a plain file; take it off the card first",
            path.display()
        );
    }
    // The card may be pulled out as soon as this ends.
    let put = |mut file: File, bytes| file.write_all(bytes).and_then(|()| file.sync_all());
    File::create(&path)
        .and_then(|file| put(file, program))
        .with_context(|| cannot_write(&path))?;
    let path = folder.join("STATE.TXT");
    if state {
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => put(file, STATE).with_context(|| cannot_write(&path))?,
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                println!("STATE.TXT: there already, and left as it is");
            }
            Err(error) => return Err(error).with_context(|| cannot_write(&path)),
        }
    }
    Ok(())
}

fn into_image(path: &Path, program: &[u8], state: bool) -> anyhow::Result<()> {
    let mut image = Image::new(Fat::Fat16).file("PROGRAM.TXT", program);
    if state {
        image = image.file("STATE.TXT", STATE);
    }
    let bytes = image.build().context("the card image cannot be built")?;
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    file.and_then(|mut file| file.write_all(&bytes))
        .with_context(|| cannot_write(path))
}
