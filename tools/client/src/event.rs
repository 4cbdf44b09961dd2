//! What is heard of a board, and what comes of what is ordered of it: values, without a step that leads to them.

use crate::client::Failure;
use crate::diagnostics::{Diagnostics, Kept, Trouble};
#[cfg(feature = "more")]
use crate::download::Unread;
use crate::identity::Identity;
use crate::settings::Settings;
use crate::start::NotFound;
use crate::watch::{Forced, Reading};
use unoclp_modbus::Exception;
use unoclp_point::Address;

/// What there is to say of a board. What an order has to say comes before that it is done, or not: they are done one after
/// the other.
#[derive(Debug)]
pub enum Event<'e> {
    /// It has answered.
    Found(&'e Identity),
    /// All that there is to show.
    Seen(&'e Reading),
    /// There is no board, or no longer one. It is sought on.
    Lost(&'e Away),
    /// It takes an upload from now on.
    Stopped {
        /// How it was before.
        before: &'e Diagnostics,
        /// What was forced then.
        forced: Forced,
    },
    /// An upload goes on.
    Sent(Progress),
    /// What it keeps since an upload.
    Stored(Kept),
    /// This is no longer forced, since an upload.
    Released(Forced),
    /// The program that it keeps, as numeric code.
    #[cfg(feature = "more")]
    Fetched(&'e str),
    /// What it keeps for its next start.
    Settings(Settings),
    /// A firmware is on its way.
    #[cfg(feature = "more")]
    Flashing(unoclp_boot::Progress),
    /// What was ordered is done.
    Done(Done),
    /// What was ordered is not done.
    Undone(&'e Undone),
}

/// Why there is no board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Away {
    /// It was not found.
    NotFound(NotFound),
    /// It was there.
    Gone(Failure),
}

/// What has come of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Done {
    /// What was ordered, and no more.
    Plainly,
    /// A program is on it.
    Uploaded(Behind),
    /// It keeps settings.
    #[cfg(feature = "more")]
    Settled(Settled),
    /// A firmware is on it, and begins.
    #[cfg(feature = "more")]
    Flashed,
}

/// Why an order is not done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undone {
    /// There is no board.
    Away(Away),
    /// The board is lost by it.
    Lost(Failure),
    /// The board refuses it.
    Refused(Refusal),
    /// No client may write this point.
    NoPoint(Address),
    /// The board does not leave RUN, as has to be.
    NotStopped(Failure),
    /// No program was uploaded.
    Broken(Broken),
    /// The program is stored, but the board does not begin it.
    NotStarted(Failure),
    /// The program that it keeps was not read.
    #[cfg(feature = "more")]
    Unread(Unread),
    /// The settings are as they were.
    #[cfg(feature = "more")]
    Unsettled(Unsettled),
    /// The firmware is not on it.
    #[cfg(feature = "more")]
    NotFlashed(unoclp_boot::Failure),
}

/// What stands in the way of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// The board is in FAULT.
    InFault,
    /// A5 holds it in STOP.
    Switch,
    /// An upload is under way.
    InUpload,
    /// It is not in STOP, as a single scan needs.
    NotInStop,
    /// Commands are locked.
    CommandsLocked,
    /// Writing and forcing are locked.
    WritingLocked,
    /// Anything else.
    Other(Exception),
}

impl Undone {
    /// By what the board is lost, where it is.
    pub(crate) fn lost(&self) -> Option<Failure> {
        match self {
            Undone::Lost(why) | Undone::NotStopped(why) | Undone::NotStarted(why)
                if !matches!(why, Failure::Refused(_)) =>
            {
                Some(why.clone())
            }
            _ => None,
        }
    }
}

impl From<Failure> for Undone {
    fn from(why: Failure) -> Undone {
        match why {
            Failure::Refused(exception) => Undone::Refused(Refusal::Other(exception)),
            why => Undone::Lost(why),
        }
    }
}

#[cfg(feature = "more")]
impl From<Unread> for Undone {
    fn from(why: Unread) -> Undone {
        match why {
            Unread::Failed(why) => why.into(),
            why => Undone::Unread(why),
        }
    }
}

impl From<Broken> for Undone {
    fn from(why: Broken) -> Undone {
        Undone::Broken(why)
    }
}

#[cfg(feature = "more")]
impl From<Unsettled> for Undone {
    fn from(why: Unsettled) -> Undone {
        Undone::Unsettled(why)
    }
}

/// How far an upload is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// So many bytes of the text have been sent, for the first or the second time.
    Sent {
        /// The first or the second time.
        pass: Pass,
        /// Bytes.
        bytes: usize,
        /// Of so many.
        of: usize,
    },
    /// The board writes its program memory.
    Storing,
}

/// The text is sent twice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// To be checked.
    Check,
    /// To be stored.
    Store,
}

/// Why a program was not uploaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Broken {
    /// The board does not begin one.
    NotBegun,
    /// The board is in a state that this version does not know.
    UnknownState,
    /// The board is locked against it.
    Locked,
    /// The firmware of the board knows not all instructions of the program.
    TooOld {
        /// The form in which the board keeps programs.
        board: u8,
        /// The first form that has all instructions of the program.
        needs: u8,
    },
    /// The board has found a fault in the text.
    Fault(Trouble),
    /// Another client has ended it, or begun one of its own.
    Ended,
    /// The board keeps something else than what was sent.
    Other {
        /// What it keeps.
        kept: Kept,
        /// What was sent.
        sent: Kept,
    },
    /// The line has failed before anything was sent.
    Before(Failure),
    /// The line has failed.
    Off {
        /// The first or the second time.
        pass: Pass,
        /// Bytes of the text that the board has had.
        bytes: usize,
        /// Of so many.
        of: usize,
        /// The text was complete, so the board may have begun to store it.
        stored: bool,
        /// What has happened.
        failure: Failure,
    },
}

/// What became of the board after an upload.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Behind {
    /// It runs the program.
    Run,
    /// It is in STOP, as was asked for.
    Stop,
    /// It is in STOP by A5.
    Switch,
    /// It is in FAULT, and restarts only with the next reset, as was asked for.
    Faulty,
    /// It has found another program on a card when it was restarted.
    Card,
    /// It was restarted, and has a fault.
    Trouble(Trouble),
    /// It ran the program, and is in FAULT within [`FIRST_SCANS`](crate::upload::FIRST_SCANS); with what the fault is.
    Failing(Option<Trouble>),
}

/// Why a board does not keep settings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unsettled {
    /// No board meets this rate, in bits per second.
    Rate(u32),
    /// A client can only add to a lock.
    LockShrinks,
    /// The settings are locked.
    Locked,
    /// The board has refused them.
    NotTaken(Failure),
    /// It keeps something else.
    NotKept,
}

/// What became of a board whose settings were written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settled {
    /// Some of them are used from the next start on only.
    pub is_for_next: bool,
    /// Whether it goes on.
    pub again: Again,
}

/// Whether a board that was in RUN is again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Again {
    /// It was not.
    WasNot,
    /// It is.
    Runs,
    /// A5 holds it in STOP, or a fault.
    Held,
    /// Its commands are locked.
    Locked,
}
