//! What may be ordered of a board, and how it is done.

use crate::client::{Client, Failure};
use crate::diagnostics::Diagnostics;
#[cfg(feature = "more")]
use crate::download::download;
use crate::event::Event;
pub use crate::event::{Done, Refusal, Undone};
#[cfg(feature = "more")]
use crate::flash::flash;
use crate::map::{Command, State, flag};
use crate::point;
use crate::settings::Settings;
#[cfg(feature = "more")]
use crate::settle::settle;
use crate::upload::Upload;
use crate::watch::{Side, command, force, release};
#[cfg(feature = "more")]
use unoclp_boot::{Image, Writer};
use unoclp_modbus::Exception;
use unoclp_point::Address;

/// What may be ordered of a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Order {
    /// One of the commands.
    Command(Command),
    /// Force the point with this index, from 0, or let it go.
    Force(Side, u8, Option<bool>),
    /// Let all points go.
    Release,
    /// Set an output, a marker, a register or a preset once.
    Set(Address, i32),
    /// Put a program on it.
    Upload(Box<Upload>),
    /// Tell the program that it keeps.
    #[cfg(feature = "more")]
    Fetch,
    /// Tell its settings.
    Settings,
    /// Keep these settings: the lock holds at once, all else from the next start on.
    #[cfg(feature = "more")]
    Settle(Settings),
    /// Write a firmware by its boot loader. It is sought again then.
    #[cfg(feature = "more")]
    Flash(Box<Image>),
}

/// What an order may have changed of a reading.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Change {
    /// Points: what is forced, or a preset.
    Points,
    /// Anything.
    All,
}

impl Order {
    /// Whether it is written by a boot loader, which takes no requests.
    pub(crate) fn is_firmware(&self) -> bool {
        #[cfg(feature = "more")]
        return matches!(self, Order::Flash(_));
        #[cfg(not(feature = "more"))]
        false
    }

    pub(crate) fn change(&self) -> Change {
        match self {
            Order::Force(..) | Order::Release | Order::Set(..) => Change::Points,
            _ => Change::All,
        }
    }

    /// Does it, and tells what there is to say meanwhile. What it forces ends at the board after so many seconds without a
    /// request, 1 to 254, where its firmware has an end of forcing.
    ///
    /// # Errors
    /// [`Undone`].
    pub async fn fulfil(
        &self,
        client: &mut Client,
        ends: Option<u8>,
        tell: &mut dyn FnMut(Event<'_>),
    ) -> Result<Done, Undone> {
        let plain = match self {
            Order::Command(what) => command(client, *what).await,
            Order::Force(side, index, to) => force(client, *side, *index, *to, ends).await,
            Order::Release => release(client).await,
            Order::Set(point, _) if !point::is_written(*point) => {
                return Err(Undone::NoPoint(*point));
            }
            Order::Set(point, value) => point::set(client, *point, *value).await,
            Order::Upload(upload) => return upload.put(client, tell).await.map(Done::Uploaded),
            #[cfg(feature = "more")]
            Order::Fetch => {
                let board = client.board();
                let code = download(client, board).await;
                tell(Event::Fetched(&code.map_err(Undone::from)?));
                Ok(())
            }
            Order::Settings => {
                tell(Event::Settings(Settings::read(client).await?));
                Ok(())
            }
            #[cfg(feature = "more")]
            Order::Settle(new) => {
                let settled = settle(client, *new).await?;
                tell(Event::Settings(*new));
                return Ok(Done::Settled(settled));
            }
            #[cfg(feature = "more")]
            Order::Flash(image) => {
                let written = flash(client, &mut Writer::new(image), tell).await;
                return written.map(|()| Done::Flashed).map_err(Undone::NotFlashed);
            }
        };
        match plain {
            Ok(()) => Ok(Done::Plainly),
            Err(Failure::Refused(exception)) => {
                let board = Diagnostics::read(client).await?;
                Err(Undone::Refused(refusal(self, exception, &board)))
            }
            Err(why) => Err(Undone::Lost(why)),
        }
    }
}

/// Why a board refuses an order by this exception, as it stands.
fn refusal(order: &Order, exception: Exception, board: &Diagnostics) -> Refusal {
    match exception {
        Exception::IllegalFunction => match order {
            Order::Command(_) => Refusal::CommandsLocked,
            _ => Refusal::WritingLocked,
        },
        Exception::ServerDeviceFailure if board.state == Some(State::Fault) => Refusal::InFault,
        Exception::ServerDeviceFailure if board.has(flag::STOP_SWITCH) => Refusal::Switch,
        Exception::ServerDeviceFailure if board.has(flag::UPLOAD) => Refusal::InUpload,
        Exception::ServerDeviceFailure if *order == Order::Command(Command::SingleScan) => {
            Refusal::NotInStop
        }
        other => Refusal::Other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refusal_tells_what_stands_in_its_way() {
        let board = |state, flags| Diagnostics {
            state: Some(state),
            flags,
            ..Diagnostics::default()
        };
        let now = Exception::ServerDeviceFailure;
        for (command, board, expected) in [
            (Command::Run, board(State::Fault, 0), Refusal::InFault),
            (
                Command::Run,
                board(State::Stop, flag::STOP_SWITCH),
                Refusal::Switch,
            ),
            (
                Command::SingleScan,
                board(State::Stop, flag::UPLOAD),
                Refusal::InUpload,
            ),
            (
                Command::SingleScan,
                board(State::Run, 0),
                Refusal::NotInStop,
            ),
            (Command::Run, board(State::Stop, 0), Refusal::Other(now)),
        ] {
            assert_eq!(refusal(&Order::Command(command), now, &board), expected);
        }
        let locked = Exception::IllegalFunction;
        let board = board(State::Run, 0);
        let refused = |order: Order| refusal(&order, locked, &board);
        assert_eq!(refused(Order::Release), Refusal::WritingLocked);
        let stop = Order::Command(Command::Stop);
        assert_eq!(refused(stop), Refusal::CommandsLocked);
    }
}
