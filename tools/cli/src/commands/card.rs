//! `unoclp card`.

use super::open::{Shown, open};
use super::output::{Kind, Over, is_same, write, write_new};
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use anstream::println;
use anyhow::{anyhow, bail};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use unoclp_card::image::{Fat, Image};
use unoclp_program::{not_sent, shown};

/// The file in which the board keeps inputs and outputs, before it has done so.
const STATE: &[u8] = include_bytes!("../../../../programs/STATE.TXT");

/// Puts a program on a card that is mounted as this folder, or on a new image of a card. Of what is there, nothing but
/// a `PROGRAM.TXT` of unoclp's own is overwritten.
pub fn card(target: &Path, file: &Path, state: bool, over: Over, wording: &Wording) -> Outcome {
    let kind = fs::metadata(target).map(|target| target.file_type());
    let name = shown(target);
    let is_folder = match kind {
        Ok(kind) if kind.is_dir() => true,
        Ok(kind) if kind.is_file() => bail!(messages::card_is_there(&name)),
        Ok(_) => bail!(messages::card_is_a_device(&name)),
        Err(error) if error.kind() != ErrorKind::NotFound => {
            bail!(messages::cannot_look_at(&name, messages::io(&error)));
        }
        Err(_)
            if target
                .extension()
                .is_some_and(|end| end.eq_ignore_ascii_case("img")) =>
        {
            false
        }
        Err(_) => bail!(messages::no_folder(&name)),
    };
    if is_same(file, &target.join("PROGRAM.TXT")) {
        bail!(messages::is_read(shown(file)));
    }
    let Some(program) = open(file, wording, Shown::Here)? else {
        return Ok(false);
    };
    if let Some(why) = not_sent(&program, messages::spoken()) {
        bail!("{}: {why}", program.name);
    }
    let code = program.file();
    let bytes = code.len();
    if is_folder {
        into_folder(target, code, state, over)?;
    } else {
        into_image(target, &code, state)?;
    }
    println!("{}", messages::on_card(&program.name, name, bytes));
    Ok(true)
}

fn into_folder(folder: &Path, program: Vec<u8>, state: bool, over: Over) -> anyhow::Result<()> {
    let path = folder.join("PROGRAM.TXT");
    // A link may lead anywhere.
    if fs::symlink_metadata(&path).is_ok_and(|there| !there.is_file()) {
        bail!(messages::no_plain_file(shown(&path)));
    }
    write(&path, program, Kind::Program, &[], over)?;
    let path = folder.join("STATE.TXT");
    match state && fs::symlink_metadata(&path).is_ok() {
        true => println!("{}", messages::state_is_there()),
        false if state => write_new(&path, STATE)?,
        false => {}
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
    write_new(path, &bytes)
}
