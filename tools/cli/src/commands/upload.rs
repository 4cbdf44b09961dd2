//! `unoclp upload`.

use super::interrupt::{Interrupt, Interrupted};
use super::open::{Shown, check_written, faulty, read, running};
use super::progress::{hide, show};
use super::wording::Wording;
use super::{failed, meet, not_stopped};
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
use unoclp_client::settings::read_lock;
use unoclp_client::upload::{
    Behind, Broken, FIRST_SCANS, Progress, end, go_on, needs, stop, upload_program as send,
};
use unoclp_client::watch::{Forced, Wish};
use unoclp_client::{Client, lock};
use unoclp_core::Board;
use unoclp_exercise::scenario::ProgramFile;
use unoclp_program::{Source, not_sent};

/// How the board is left.
#[derive(Args)]
pub struct Leave {
    /// Leave the board in STOP
    #[arg(long)]
    stop: bool,
    /// Leave forced what is forced; else it is let go once the program is stored
    #[arg(long)]
    keep_forces: bool,
}

/// Checks a program, and puts it on a board.
pub fn upload(path: &Path, place: &Place, leave: &Leave, wording: &Wording) -> Outcome {
    let ProgramFile { name, bytes } = read(path)?;
    let written = |wording: &Wording| wording.of(name.clone(), bytes.clone());
    let is_right = |wording: &Wording| written(wording).check(wording.dialect).is_ok();
    let mut wording = wording.clone();
    let mut met = None;
    // A program that is too much for an UNO may be right for the board that is there.
    let mut others = Board::ALL.into_iter().filter(Board::has_firmware);
    if !wording.names_board()
        && !is_right(&wording)
        && others.any(|board| is_right(&wording.on(board)))
    {
        let port = meet(place)?;
        wording = wording.on(port.board());
        met = Some(port);
    }
    let Some(mut program) = check_written(written(&wording), &wording, Shown::Here)? else {
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
        match check_written(written(&wording), &wording, Shown::Here)? {
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
        stored: None,
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

/// The form in which the oldest firmware keeps programs.
const OLDEST_FORM: u8 = 1;

/// An upload, as far as it has come.
struct Upload {
    port: Port,
    interrupt: Interrupt,
    program: Source,
    /// What the board has stored of it.
    stored: Option<Kept>,
}

impl Upload {
    fn run(&mut self, leave: &Leave) -> Outcome {
        // A board that takes no upload is not stopped for one.
        if self.talk(read_lock)?.map_err(failed)? & lock::UPLOAD != 0 {
            bail!(messages::broken(&Broken::Locked));
        }
        let needs = needs(self.program.program());
        if needs > OLDEST_FORM {
            let board = self.talk(Diagnostics::read)?.map_err(failed)?;
            let board = board.program.version;
            if board < needs {
                bail!(messages::broken(&Broken::TooOld { board, needs }));
            }
        }
        let forced = self.talk(Forced::read)?.map_err(failed)?;
        let before = self.talk(stop)?.map_err(not_stopped)?;
        let Some(state) = before.state else {
            bail!(messages::unknown_state());
        };
        match state {
            State::Run => say!("STOP"),
            State::Stop if before.has(flag::STOP_SWITCH) => {
                say!("{}", messages::in_stop_by_switch())
            }
            State::Stop => say!("{}", messages::in_stop()),
            State::Fault if before.waits_for_program() => say!("{}", messages::empty_board()),
            State::Fault => match before.trouble {
                Some(trouble) => {
                    say!("{}, {}", messages::in_fault(), messages::trouble(trouble))
                }
                None => say!("{}", messages::in_fault()),
            },
        }
        if forced.any() {
            say!("{}", messages::forced(forced));
        }

        let kept = match self.send()? {
            Ok(kept) => kept,
            Err(Broken::Fault(trouble)) => {
                let Some(fault) = trouble.fault() else {
                    bail!(messages::board_says(messages::trouble(trouble)));
                };
                say!("{}", messages::refused_program());
                say!("{}", faulty(&self.program, fault));
                return Ok(false);
            }
            Err(broken) => bail!(messages::broken(&broken)),
        };
        self.stored = Some(kept);
        say!(
            "{}",
            messages::stored(kept.bytes, format!("{:04X}", kept.sum))
        );
        if forced.any() && !leave.keep_forces {
            self.talk(async |client| Wish::Release.fulfil(client).await)?
                .map_err(failed)?;
            say!("{}", messages::let_go(forced));
        }

        let stays = leave.stop;
        let behind = self.talk(async |client| go_on(client, state, kept, stays).await)?;
        let not_started = |why| anyhow!(messages::not_started(messages::failure(&why)));
        let behind = behind.map_err(not_started)?;
        match behind {
            Behind::Run => say!("RUN"),
            Behind::Stop => say!("{}", messages::in_stop()),
            Behind::Switch => say!("{}", messages::in_stop_until()),
            Behind::Faulty => say!("{}", messages::in_fault_until()),
            Behind::Card => bail!(messages::card_wins()),
            Behind::Trouble(trouble) => {
                bail!(messages::restarted_with(messages::trouble(trouble)))
            }
            Behind::Failing(trouble) => {
                say!("{}", messages::in_fault_later(FIRST_SCANS.as_millis()));
                match trouble.map(|trouble| (trouble, trouble.fault())) {
                    Some((_, Some(fault))) => say!("{}", running(&self.program, fault)),
                    Some((trouble, None)) => say!("{}", messages::trouble(trouble)),
                    None => {}
                }
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Sends the program. Once the board stores it, that is waited for.
    fn send(&mut self) -> Result<Result<Kept, Broken>, Interrupted> {
        let (program, text) = (self.program.program(), &self.program.code);
        let storing = Cell::new(false);
        let mut show = |progress| {
            storing.set(progress == Progress::Storing);
            show(|| told(progress));
        };
        let attend = || match storing.get() {
            true => ControlFlow::Continue(()),
            false => self.interrupt.attend(),
        };
        let talk = async |client: &mut _| send(client, program, text, &mut show).await;
        let sent = whole(self.port.attended(talk, attend))?;
        hide();
        Ok(sent)
    }

    /// A conversation that Ctrl-C ends.
    fn talk<T>(&mut self, talk: impl AsyncFnOnce(&mut Client) -> T) -> Result<T, Interrupted> {
        let attend = || self.interrupt.attend();
        whole(self.port.attended(talk, attend))
    }

    /// How the board was left by Ctrl-C.
    fn left(&mut self) -> String {
        match self.port.talk(end) {
            Ok(board) => {
                let state = board.state.map_or("?", State::name);
                match self.stored {
                    Some(_) => messages::interrupted_with_new(state),
                    None => messages::interrupted_with_old(state),
                }
            }
            Err(failure) => messages::interrupted_unknown(messages::failure(&failure)),
        }
    }
}

fn whole<T>(talked: ControlFlow<Interrupted, T>) -> Result<T, Interrupted> {
    match talked {
        ControlFlow::Continue(outcome) => Ok(outcome),
        ControlFlow::Break(interrupted) => Err(interrupted),
    }
}

/// How far it is.
fn told(progress: Progress) -> String {
    match progress {
        Progress::Sent { pass, bytes, of } => messages::sent(messages::pass(pass), bytes, of),
        Progress::Storing => messages::writing(),
    }
}
