//! Conversations with boards, simulated or real: bytes and times in, bytes and news out.
//!
//! - `watched`: the program that a board is said to run, and what of it is shown live
//! - `talk`: what is said, as a view of the client's session
//! - `order`, `wanted`: what may be ordered; `fulfil`, `settle`, `fetch`: how it is done; `undone`: why not
//! - `news`: what a page is told
//! - `core`: a board that is none: the core runs the program, and there is no line
//! - `desk`: what lies between a conversation and its page
//!
//! A conversation goes on until it is closed: a board that is lost is sought again.

mod core;
mod desk;
#[cfg(feature = "full")]
mod fetch;
mod fulfil;
mod news;
mod order;
#[cfg(feature = "full")]
mod settle;
mod talk;
mod undone;
#[cfg(feature = "full")]
mod wanted;
mod watched;

pub use order::Order;

use crate::answer::answer;
use crate::clock::{NEVER, time, whole_ms};
use crate::words::{self, Both, No, both};
use core::Core;
use desk::Desk;
use news::News;
use std::collections::BTreeMap;
use std::rc::Rc;
use unoclp_client::session::talk;
use unoclp_client::{Conversation, Line, Next, Parity, Patience};
use unoclp_core::Board;
use unoclp_workspace::{Analysis, Workspace};
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
        /// To be sent now.
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
    #[cfg(feature = "full")]
    pub(crate) flash: crate::flash::Flash,
    /// A page has one machine. The core gives it its outputs, and takes its inputs.
    #[cfg(feature = "full")]
    pub(crate) machine: Option<crate::machine::Machine>,
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
            flash: crate::flash::Flash::default(),
            #[cfg(feature = "full")]
            machine: None,
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
        let (send, until) = match &mut session.with {
            With::Line(conversation) => {
                let step = conversation.step(now, came);
                let until = match step.next {
                    Next::Wait(until) => whole_ms(until),
                    Next::Done(()) => NEVER,
                };
                (step.send, until)
            }
            With::Core(core) => (Vec::new(), core.step(whole_ms(now), &session.desk, machine)),
        };
        Ok(Step {
            send,
            until,
            news: session.desk.news.take(),
        })
    }

    /// Has something done by the board, as soon as it is its turn; gives the number by which the news speak of it.
    ///
    /// # Errors
    /// Where there is no conversation.
    pub fn order(&mut self, board: u32, order: Order) -> Result<u32, No> {
        let number = self.number();
        let session = self.session(board)?;
        session.desk.orders.borrow_mut().push_back((number, order));
        Ok(number)
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
