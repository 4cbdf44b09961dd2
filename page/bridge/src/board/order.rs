//! What a page orders: of a board at a line, which the client knows; of what this computer runs in place of one; and of the page
//! itself.

use super::wanted::Wanted;
use crate::ask::{OrNull, said};
use crate::program::{known, source};
use crate::tell::first_error;
use crate::words::{self, Both, No, both};
use std::rc::Rc;
use unoclp_client::map::Command;
use unoclp_client::upload::Upload;
use unoclp_client::watch::Side;
use unoclp_client::{Order, words as told};
use unoclp_point::Address;
use unoclp_program::{Lang, Source};
use unoclp_workspace::{Analysis, Version, Workspace};

/// What a page orders.
pub enum Ordered {
    /// Something of the board; of an upload the text.
    Board(Order, Option<Rc<Analysis>>),
    /// The contact of an input, from 1, closed or open; of the core alone: a board has contacts of its own.
    Press(u8, bool),
    /// The knob of an analogue input, from 0, at a reading; of the core alone.
    Turn(u8, u16),
    /// The program that is said to be on the board.
    Watch(Rc<Analysis>),
}

said! {
    /// What may be ordered of a board.
    pub mod orders as "OrderGiven";
    (workspace: &mut Workspace) -> Ordered;
    /// RUN, from the beginning.
    "run" {} => command(Command::Run);
    "stop" {} => command(Command::Stop);
    /// One single scan; a board in RUN stops for it.
    "scan" {} => command(Command::SingleScan);
    /// The whole start-up again.
    "restart" {} => command(Command::Restart);
    /// Lets all points go.
    "release" {} => Ordered::Board(Order::Release, None);
    /// Tells the program that the board keeps, as numeric code.
    "fetch" {} => fetch()?;
    /// Tells the settings.
    "settings" {} => Ordered::Board(Order::Settings, None);
    /// Forces an input or output, from 1, or lets it go.
    "force" { output: bool, number: u8, to: OrNull<bool> } => {
        let side = if output { Side::Outputs } else { Side::Inputs };
        let none = || both(told::refused_address);
        let index = number.checked_sub(1).ok_or_else(none)?;
        Ordered::Board(Order::Force(side, index, to.0), None)
    };
    /// Of what this computer runs alone: a board has contacts and knobs of its own.
    "press" { input: u8, closed: bool } => Ordered::Press(input, closed);
    "turn" { input: u8, reading: u16 } => Ordered::Turn(input, reading);
    /// Sets an output, a marker, a register or a preset once.
    "set" { point: String, value: i32 } => {
        let none = || both(|lang| told::no_point(lang, &point));
        Ordered::Board(Order::Set(Address::parse(&point).ok_or_else(none)?, value), None)
    };
    /// Puts this program on the board, and watches it from then on. It runs then, unless it stays in STOP.
    "upload" { version: Version, stay: Option<bool> } => {
        let text = known(version, workspace)?;
        let source = fitting(&text)?;
        let mut upload = Upload::of(source.program(), &source.code);
        upload.stays = stay.unwrap_or_default();
        Ordered::Board(Order::Upload(Box::new(upload)), Some(text))
    };
    /// Watches this program from now on; it is said to be on the board.
    "watch" { version: Version } => Ordered::Watch(program(version, workspace)?);
    /// Changes the settings: the lock holds at once, all else from the next start on.
    "settle" { settings: Wanted } => settle(&settings)?;
    /// Writes a firmware, as Intel hex, by the boot loader of this kind of board.
    "flash" { hex: String, model: String } => firmware(&hex, &model)?;
}

fn command(command: Command) -> Ordered {
    Ordered::Board(Order::Command(command), None)
}

/// The program of a text that is to be put on its board; where there is none, the first thing that is wrong there: the page may
/// have checked it for another board.
fn fitting(text: &Analysis) -> Result<&Source, No> {
    if let Some(Err(refused)) = text.check()
        && let Some((line, message)) = first_error(&text.written().text(), refused)
    {
        let board = text.written().board.name;
        let told = Both {
            en: words::unfit(Lang::En, board, line, &message.en),
            pt: words::unfit(Lang::Pt, board, line, &message.pt),
        };
        return Err(told.into());
    }
    source(text)
}

/// A text that is to be on a board.
fn program(version: Version, workspace: &mut Workspace) -> Result<Rc<Analysis>, No> {
    let text = known(version, workspace)?;
    source(&text)?;
    Ok(text)
}

#[cfg(feature = "full")]
fn firmware(hex: &str, model: &str) -> Result<Ordered, No> {
    use unoclp_boot::{Image, Model};
    let model = Model::named(model).ok_or_else(|| both(|lang| words::no_model(lang, model)))?;
    let image = Image::read(hex.as_bytes(), model);
    let image = image.map_err(|unfit| both(|lang| unfit.text(lang)))?;
    Ok(Ordered::Board(Order::Flash(Box::new(image)), None))
}

#[cfg(not(feature = "full"))]
fn firmware(_: &str, _: &str) -> Result<Ordered, No> {
    Err(No::More)
}

#[cfg(feature = "full")]
fn fetch() -> Result<Ordered, No> {
    Ok(Ordered::Board(Order::Fetch, None))
}

#[cfg(not(feature = "full"))]
fn fetch() -> Result<Ordered, No> {
    Err(No::More)
}

#[cfg(feature = "full")]
fn settle(settings: &Wanted) -> Result<Ordered, No> {
    Ok(Ordered::Board(Order::Settle(settings.checked()?), None))
}

#[cfg(not(feature = "full"))]
fn settle(_: &Wanted) -> Result<Ordered, No> {
    Err(No::More)
}
