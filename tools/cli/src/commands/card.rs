//! `unoclp card`.

use super::open::{Shown, open};
use super::output::{cannot_write, is_same};
use super::wording::Wording;
use crate::outcome::Outcome;
use anstream::println;
use anyhow::{anyhow, bail};
use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_cli::messages;

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../../../programs/STATE.TXT");

/// Puts a program on a card that is mounted as this folder, or on a new image of a card. Of what is there,
/// nothing but a `PROGRAM.TXT` is overwritten.
pub fn card(target: &Path, file: &Path, state: bool, wording: &Wording) -> Outcome {
    let kind = fs::metadata(target).map(|target| target.file_type());
    let name = target.display();
    let is_folder = match kind {
        Ok(kind) if kind.is_dir() => true,
        Ok(kind) if kind.is_file() => bail!(messages::card_is_there(name)),
        Ok(_) => bail!(messages::card_is_a_device(name)),
        Err(error) if error.kind() != ErrorKind::NotFound => {
            bail!(messages::cannot_look_at(name, messages::io(&error)));
        }
        Err(_)
            if target
                .extension()
                .is_some_and(|end| end.eq_ignore_ascii_case("img")) =>
        {
            false
        }
        Err(_) => bail!(messages::no_folder(name)),
    };
    if is_same(file, &target.join("PROGRAM.TXT")) {
        bail!(messages::is_read(file.display()));
    }
    let Some(program) = open(file, wording, Shown::Here)? else {
        return Ok(false);
    };
    if is_folder {
        into_folder(target, &program.code, state)?;
    } else {
        into_image(target, &program.code, state)?;
    }
    let bytes = program.code.len();
    println!("{}", messages::on_card(program.name, name, bytes));
    Ok(true)
}

fn into_folder(folder: &Path, program: &[u8], state: bool) -> anyhow::Result<()> {
    let path = folder.join("PROGRAM.TXT");
    // A link may lead anywhere.
    if fs::symlink_metadata(&path).is_ok_and(|there| !there.is_file()) {
        bail!(messages::no_plain_file(path.display()));
    }
    // The card may be pulled out as soon as this ends.
    let put = |mut file: File, bytes| file.write_all(bytes).and_then(|()| file.sync_all());
    File::create(&path)
        .and_then(|file| put(file, program))
        .map_err(cannot_write(&path))?;
    let path = folder.join("STATE.TXT");
    if state {
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Ok(file) => put(file, STATE).map_err(cannot_write(&path))?,
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                println!("{}", messages::state_is_there());
            }
            Err(error) => return Err(cannot_write(&path)(error)),
        }
    }
    Ok(())
}

fn into_image(path: &Path, program: &[u8], state: bool) -> anyhow::Result<()> {
    let mut image = Image::new(Fat::Fat16).file("PROGRAM.TXT", program);
    if state {
        image = image.file("STATE.TXT", STATE);
    }
    let bytes = image
        .build()
        .map_err(|error| anyhow!(messages::image_not_built(messages::io(&error))))?;
    let file = OpenOptions::new().write(true).create_new(true).open(path);
    file.and_then(|mut file| file.write_all(&bytes))
        .map_err(cannot_write(path))
}
