//! Conversations with boards, simulated or real: bytes and times in, bytes and news out.
//!
//! - `watched`: the program that a board is said to run, and what of it is shown live
//! - `order`, `wanted`: what a page may order; how it is done is the client's
//! - `news`: what a page is told
//! - `core`: a board that is none: the core runs the program, and there is no line
//! - `desk`: what lies between a conversation and its page: a view of the client's session
//!
//! A conversation goes on until it is closed: a board that is lost is sought again.

mod core;
mod desk;
#[cfg_attr(
    not(feature = "full"),
    allow(
        dead_code,
        reason = "the first module has neither firmwares nor settings"
    )
)]
mod news;
mod order;
#[cfg(feature = "full")]
mod slowly;
#[cfg(feature = "full")]
mod under_way;
#[cfg_attr(
    not(feature = "full"),
    allow(
        dead_code,
        reason = "the first module has neither firmwares nor settings"
    )
)]
mod wanted;
mod watched;

pub use order::{Ordered, orders};
#[cfg(feature = "full")]
pub use watched::{Live, Watched};

use crate::answer::answer;
use crate::clock::{NEVER, time, whole_ms};
use crate::program::source;
#[cfg(feature = "full")]
use crate::slow::{self, Left, Stood};
use crate::words::{self, Both, No, both};
use core::Core;
use desk::Desk;
use news::News;
use std::collections::BTreeMap;
use std::rc::Rc;
use unoclp_client::session::talk;
use unoclp_client::{Conversation, Line, Next, Parity, Patience};
use unoclp_core::Board;
use unoclp_program::{Lang, Source, not_sent};
#[cfg(feature = "full")]
use unoclp_workspace::Version;
use unoclp_workspace::{Analysis, Workspace};
#[cfg(not(feature = "full"))]
use watched::Watched;

/// A conversation that is to begin.
pub struct Open {
    /// The board whose programs the core runs; none: there is a line to a board.
    pub core: Option<Board>,
    /// The program that the board is said to run; none: any.
    pub program: Option<Rc<Analysis>>,
    /// Whether opening the line has probably reset the board.
    pub reset: bool,
    pub address: Option<u8>,
    pub rate: Option<u32>,
    /// 0 none, 1 even, 2 odd.
    pub parity: Option<u16>,
}

answer! {
    /// A step of a conversation.
    pub struct Step as "Step" {
        /// How bytes are sent from now on, bits per second,
        rate: u32,
        /// and 0 without parity, 1 even, 2 odd.
        parity: u16,
        /// First reset the board, and throw away what has come before.
        reset: bool,
        /// Then send this.
        send: Vec<u8>,
        /// The next step comes at this time, in whole ms, or as soon as bytes have come or something is ordered.
        until: u64,
        news: Vec<News>,
    }
}

struct Session {
    with: With,
    desk: Rc<Desk>,
}

/// Whom a page speaks to.
enum With {
    Line(Conversation<'static, ()>),
    Core(Box<Core>),
}

/// All conversations.
pub struct Boards {
    /// The texts of the page.
    pub(crate) workspace: Workspace,
    sessions: BTreeMap<u32, Session>,
    /// Conversations and orders are numbered by this.
    last: u32,
    /// A page has one machine. The core gives it its outputs, and takes its inputs.
    #[cfg(feature = "full")]
    pub(crate) machine: Option<crate::machine::Machine>,
    /// The program that was shown in slow motion last.
    #[cfg(feature = "full")]
    slow: Option<(Version, Watched)>,
    /// A page has one drawing.
    #[cfg(feature = "full")]
    pub(crate) drawing: Option<crate::edit::Drawing>,
}

impl Default for Boards {
    fn default() -> Boards {
        #[cfg(feature = "full")]
        let compilers = unoclp_workspace::All::default();
        #[cfg(not(feature = "full"))]
        let compilers = crate::start::First;
        Boards {
            workspace: Workspace::new(Rc::new(compilers)),
            sessions: BTreeMap::new(),
            last: 0,
            #[cfg(feature = "full")]
            machine: None,
            #[cfg(feature = "full")]
            slow: None,
            #[cfg(feature = "full")]
            drawing: None,
        }
    }
}

/// Conversations that may go on at one time: a page has one.
const MOST: usize = 16;

impl Boards {
    fn number(&mut self) -> u32 {
        self.last = self.last.wrapping_add(1);
        self.last
    }

    /// Begins a conversation; gives its number.
    ///
    /// # Errors
    /// Where the program has errors.
    pub fn open(&mut self, open: Open) -> Result<u32, No> {
        let usual = Line::default();
        let line = Line {
            address: open.address.unwrap_or(usual.address),
            rate: open.rate.unwrap_or(usual.rate),
            parity: open.parity.and_then(Parity::of).unwrap_or(usual.parity),
        };
        let program = open.program.as_deref().map(Watched::new).transpose()?;
        let desk = Rc::new(Desk::default());
        desk.watched.replace(program);
        let talks = desk.clone();
        let reset = open.reset;
        let talk = async move |client: &mut _| talk(client, &*talks, reset).await;
        let with = match open.core {
            Some(board) => {
                desk.tell(News::Found {
                    identity: board.name.to_owned(),
                    board: Some(board.id()),
                });
                With::Core(Box::new(Core::new(board)))
            }
            None => With::Line(Conversation::new(line, Patience::default(), talk)),
        };
        let number = self.number();
        if self.sessions.len() >= MOST {
            self.sessions.pop_first();
        }
        self.sessions.insert(number, Session { with, desk });
        Ok(number)
    }

    fn session(&mut self, board: u32) -> Result<&mut Session, Both> {
        let session = self.sessions.get_mut(&board);
        session.ok_or_else(|| both(|lang| words::no_board(lang, board)))
    }

    /// Goes on with a conversation.
    ///
    /// # Errors
    /// Where there is none.
    pub fn step(&mut self, board: u32, now: f64, came: &[u8]) -> Result<Step, Both> {
        #[cfg(feature = "full")]
        let machine = &mut self.machine;
        #[cfg(not(feature = "full"))]
        let machine = &mut None;
        let session = self.sessions.get_mut(&board);
        let session = session.ok_or_else(|| both(|lang| words::no_board(lang, board)))?;
        let now = time(now);
        let (step, until) = match &mut session.with {
            With::Line(conversation) => {
                let step = conversation.step(now, came);
                let until = match step.next {
                    Next::Wait(until) => whole_ms(until),
                    Next::Done(()) => NEVER,
                };
                (Some(step), until)
            }
            With::Core(core) => (None, core.step(whole_ms(now), &session.desk, machine)),
        };
        let format = step
            .as_ref()
            .map_or(Line::default().format(), |step| step.format);
        Ok(Step {
            rate: format.rate,
            parity: format.parity as u16,
            reset: step.as_ref().is_some_and(|step| step.reset),
            send: step.map(|step| step.send).unwrap_or_default(),
            until,
            news: session.desk.news.take(),
        })
    }

    /// Has something done by the board, as soon as it is its turn; gives the number by which the news speak of it.
    ///
    /// # Errors
    /// Where there is no conversation, or what is ordered is nothing for that board.
    pub fn order(&mut self, board: u32, ordered: Ordered) -> Result<u32, No> {
        let number = self.number();
        let session = self.session(board)?;
        let desk = &session.desk;
        match (&mut session.with, ordered) {
            (With::Core(core), ordered) => core.order(number, ordered),
            (With::Line(_), Ordered::Board(order, text)) => {
                if let Some(text) = &text {
                    sent(source(text)?)?;
                }
                desk.order(number, order, text);
            }
            (With::Line(_), Ordered::Watch(text)) => {
                desk.watched.replace(Some(Watched::new(&text)?));
                let (order, said) = (number, None);
                desk.tell(News::Done { order, said });
            }
            (With::Line(_), Ordered::Press(..) | Ordered::Turn(..)) => {
                return Err(both(words::own_contacts).into());
            }
        }
        Ok(number)
    }

    /// Goes on with the scan of the core; `Core::slowly` says how.
    ///
    /// # Errors
    /// Where there is no conversation with the core, or it runs no program.
    #[cfg(feature = "full")]
    pub fn slowly(
        &mut self,
        board: u32,
        to: Option<&[usize]>,
        through: bool,
    ) -> Result<Option<Stood>, Both> {
        let session = self.sessions.get_mut(&board);
        let session = session.ok_or_else(|| both(|lang| words::no_board(lang, board)))?;
        match &mut session.with {
            With::Core(core) => core.slowly(to, through, &mut self.machine),
            With::Line(_) => Err(both(words::none_runs)),
        }
    }

    /// What there is to show of a program whose scan has come so far on a board.
    ///
    /// # Errors
    /// Where the text is no program.
    #[cfg(feature = "full")]
    pub fn stood(&mut self, version: Version, left: &[Left]) -> Result<Live, No> {
        let mut slow = self.slow.take().filter(|(known, _)| *known == version);
        if slow.is_none() {
            let text = crate::program::known(version, &mut self.workspace)?;
            slow = Some((version, Watched::new(&text)?));
        }
        let (_, watched) = self.slow.insert(slow.ok_or_else(|| both(words::faulty))?);
        Ok(slow::live(watched, left))
    }

    /// The line is gone, and why.
    ///
    /// # Errors
    /// Where there is no conversation.
    pub fn lose(&mut self, board: u32, why: String) -> Result<(), Both> {
        if let With::Line(conversation) = &mut self.session(board)?.with {
            conversation.lose(why);
        }
        Ok(())
    }

    /// Ends a conversation.
    pub fn close(&mut self, board: u32) {
        self.sessions.remove(&board);
    }
}

/// Sees that a program may go to a board.
fn sent(source: &Source) -> Result<(), Both> {
    match not_sent(source, Lang::En) {
        Some(_) => Err(both(|lang| not_sent(source, lang).unwrap_or_default())),
        None => Ok(()),
    }
}
