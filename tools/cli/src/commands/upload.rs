//! `unoclp upload`.

use super::interrupt::{Interrupt, Interrupted};
use super::meet;
use super::open::{Shown, checked, faulty, read, running};
use super::progress::{hide, show};
use super::wording::Wording;
use crate::messages;
use crate::outcome::Outcome;
use crate::port::{Place, Port};
use anyhow::{anyhow, bail};
use clap::Args;
use std::cell::Cell;
use std::ops::ControlFlow;
use std::path::Path;
use unoclp_client::diagnostics::{Diagnostics, Kept};
use unoclp_client::map::{State, flag};
use unoclp_client::order::Undone;
use unoclp_client::session::Event;
use unoclp_client::upload::{self, Behind, Broken, FIRST_SCANS, Progress, end};
use unoclp_client::watch::Forced;
use unoclp_core::Board;
use unoclp_exercise::scenario::ProgramFile;
use unoclp_program::not_sent;
use unoclp_workspace::Ready;

/// How the board is left.
#[derive(Args)]
pub struct Leave {
    /// Leave the board in STOP
    #[arg(long)]
    stop: bool,
    /// Keep forced points forced; by default, they are released once the program is stored
    #[arg(long)]
    keep_forces: bool,
}

/// Checks a program, and puts it on a board.
pub fn upload(path: &Path, place: &Place, leave: &Leave, wording: &Wording) -> Outcome {
    let ProgramFile { name, bytes } = read(path)?;
    let written = |wording: &Wording| wording.of(name.clone(), bytes.clone());
    let mut texts = wording.workspace();
    let mut opened = |wording: &Wording| texts.open(written(wording));
    let mut wording = wording.clone();
    let mut met = None;
    // A program that is too much for a UNO may be right for the board that is there.
    let mut others = Board::ALL.into_iter().filter(Board::has_firmware);
    if !wording.names_board()
        && opened(&wording).source().is_none()
        && others.any(|board| opened(&wording.on(board)).source().is_some())
    {
        let port = meet(place)?;
        wording = wording.on(port.board());
        met = Some(port);
    }
    let Some(mut program) = checked(&opened(&wording), &wording, Shown::Here)? else {
        return Ok(false);
    };
    if let Some(why) = not_sent(&program, messages::spoken()) {
        bail!("{}: {why}", program.name);
    }
    say!("{}: OK: {}", program.name, messages::size(&program.size));
    let port = match met {
        Some(port) => port,
        None => meet(place)?,
    };
    if port.board() != wording.board() {
        wording = wording.on(port.board());
        match checked(&opened(&wording), &wording, Shown::Here)? {
            Some(again) => {
                program = again;
                say!("{}: OK: {}", program.name, messages::size(&program.size));
            }
            None => bail!(messages::not_for(port.board().name)),
        }
    }
    let mut upload = Upload {
        port,
        interrupt: Interrupt::new()?,
        program,
        stored: Cell::new(None),
    };
    let outcome = upload.run(leave);
    hide();
    let outcome = match outcome {
        Err(error) if error.is::<Interrupted>() => Err(anyhow!(upload.left())),
        other => other,
    };
    // Whatever has happened, a machine may move by what is forced.
    if let Ok(forced) = upload.port.talk(Forced::read)
        && forced.any()
    {
        say!("{}", messages::left_forced(forced));
    }
    outcome
}

/// An upload, as far as it has come.
struct Upload {
    port: Port,
    interrupt: Interrupt,
    program: Ready,
    /// What the board has stored of it.
    stored: Cell<Option<Kept>>,
}

impl Upload {
    fn run(&mut self, leave: &Leave) -> Outcome {
        let mut upload = upload::Upload::of(self.program.program(), &self.program.code);
        (upload.stays, upload.releases) = (leave.stop, !leave.keep_forces);
        // Once the board stores it, that is waited for.
        let storing = Cell::new(false);
        let mut tell = |event: Event<'_>| {
            storing.set(matches!(event, Event::Sent(Progress::Storing)));
            if let Event::Stored(kept) = event {
                self.stored.set(Some(kept));
            }
            told(event);
        };
        let attend = || match storing.get() {
            true => ControlFlow::Continue(()),
            false => self.interrupt.attend(),
        };
        let talk = async |client: &mut _| upload.put(client, &mut tell).await;
        match self.port.attended(talk, attend) {
            ControlFlow::Continue(Ok(behind)) => self.became(behind),
            ControlFlow::Continue(Err(undone)) => {
                hide();
                self.failed(&undone)
            }
            ControlFlow::Break(interrupted) => Err(interrupted.into()),
        }
    }

    /// Says what has become of the board.
    fn became(&self, behind: Behind) -> Outcome {
        match behind {
            Behind::Run => say!("RUN"),
            Behind::Stop => say!("{}", messages::in_stop()),
            Behind::Switch => say!("{}", messages::in_stop_until()),
            Behind::Faulty => say!("{}", messages::in_fault_until()),
            Behind::Card | Behind::Trouble(_) => {
                bail!(messages::behind(behind));
            }
            Behind::Failing(trouble) => {
                say!("{}", messages::in_fault_later(FIRST_SCANS.as_millis()));
                match trouble.map(|trouble| (trouble, trouble.fault())) {
                    Some((_, Some(fault))) => say!("{}", running(&self.program, fault)),
                    Some((trouble, None)) => {
                        say!("{}", messages::trouble(trouble));
                    }
                    None => {}
                }
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Says why the program is not on the board; a fault with its place in the text.
    fn failed(&self, undone: &Undone) -> Outcome {
        if let Undone::Broken(Broken::Fault(trouble)) = undone {
            let Some(fault) = trouble.fault() else {
                bail!(messages::board_says(messages::trouble(*trouble)));
            };
            say!("{}", messages::refused_program());
            say!("{}", faulty(&self.program, fault));
            return Ok(false);
        }
        bail!(messages::undone(undone));
    }

    /// How the board was left by Ctrl-C.
    fn left(&mut self) -> String {
        match self.port.talk(end) {
            Ok(board) => {
                let state = board.state.map_or("?", State::name);
                match self.stored.get() {
                    Some(_) => messages::interrupted_with_new(state),
                    None => messages::interrupted_with_old(state),
                }
            }
            Err(failure) => messages::interrupted_unknown(messages::failure(&failure)),
        }
    }
}

/// Says how it goes on.
fn told(event: Event<'_>) {
    match event {
        Event::Stopped { before, forced } => {
            say!("{}", stood(before));
            if forced.any() {
                say!("{}", messages::forced(forced));
            }
        }
        Event::Sent(Progress::Sent { pass, bytes, of }) => {
            let pass = messages::pass(pass);
            show(|| messages::sent(pass, bytes, of));
        }
        Event::Sent(Progress::Storing) => show(messages::writing),
        Event::Stored(kept) => {
            hide();
            let sum = format!("{:04X}", kept.sum);
            say!("{}", messages::stored(kept.bytes, sum));
        }
        Event::Released(forced) => say!("{}", messages::let_go(forced)),
        _ => {}
    }
}

/// How a board was that takes an upload now.
fn stood(board: &Diagnostics) -> String {
    match (board.state, board.trouble) {
        (Some(State::Stop), _) if board.has(flag::STOP_SWITCH) => messages::in_stop_by_switch(),
        (Some(State::Stop), _) => messages::in_stop(),
        (Some(State::Fault), _) if board.waits_for_program() => messages::empty_board(),
        (Some(State::Fault), Some(trouble)) => {
            let trouble = messages::trouble(trouble);
            format!("{}, {trouble}", messages::in_fault())
        }
        (Some(State::Fault), None) => messages::in_fault(),
        // It was stopped.
        _ => State::Stop.name().to_owned(),
    }
}
