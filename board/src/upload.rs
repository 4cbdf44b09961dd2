//! A program over the line in place of the card.
//!
//! The text is sent twice: the board checks it the first time, and compares and stores it the second time.

use crate::client::{Client, Failure};
use crate::diagnostics::{Diagnostics, Kept, Trouble};
use crate::map::{BLOCK_BYTES, Command, State, flag, holding};
use std::fmt;
use std::time::Instant;
use unoclp_modbus::Exception;

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

impl fmt::Display for Pass {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Pass::Check => "checking",
            Pass::Store => "storing",
        })
    }
}

/// Why a program was not uploaded.
#[derive(Debug, thiserror::Error)]
pub enum Broken {
    /// The board does not begin one.
    #[error("the board does not begin an upload; does another client let it run?")]
    NotBegun,
    /// The board has found a fault in the text.
    #[error("{0}")]
    Fault(Trouble),
    /// Another client has ended it, or begun one of its own.
    #[error("the upload was ended from elsewhere; the board keeps the program that it had")]
    Ended,
    /// The board keeps something else than what was sent.
    #[error(
        "the board keeps {} bytes with check sum {:04X}, not the {} bytes with {:04X} that were sent; \
         is its firmware of another version?", kept.bytes, kept.crc, sent.bytes, sent.crc
    )]
    Other {
        /// What it keeps.
        kept: Kept,
        /// What was sent.
        sent: Kept,
    },
    /// The line has failed before anything was sent.
    #[error("the upload was not begun: {0}")]
    Before(Failure),
    /// The line has failed.
    #[error(
        "the upload was broken off while {pass}, at byte {bytes} of {of}: {failure}. The board is in STOP; \
         {}; upload anew", whats_kept(*.stored)
    )]
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

fn whats_kept(may_be_stored: bool) -> &'static str {
    if may_be_stored {
        "whether it keeps the new program is open"
    } else {
        "it keeps the program that it had"
    }
}

/// Uploads the text of a program, which a board will keep as `sent`. The board must not be in RUN.
///
/// # Errors
/// [`Broken`].
pub fn upload(
    client: &mut Client,
    text: &[u8],
    sent: Kept,
    progress: &mut dyn FnMut(Progress),
) -> Result<(), Broken> {
    match client.set_word(holding::COMMAND, Command::Upload as u16) {
        Ok(()) => {}
        Err(Failure::Refused(_)) => return Err(Broken::NotBegun),
        Err(failure) => return Err(Broken::Before(failure)),
    }
    let mut number = 0_u8;
    for pass in [Pass::Check, Pass::Store] {
        let mut bytes = 0;
        let of = text.len();
        progress(Progress::Sent { pass, bytes, of });
        // A block of no bytes ends the text.
        for block in text.chunks(BLOCK_BYTES).chain([&[][..]]) {
            let stored = pass == Pass::Store && block.is_empty();
            if stored {
                progress(Progress::Storing);
            }
            match send(client, number, block, stored) {
                Ok(()) => {}
                Err(Failure::Refused(_)) => {
                    return explain(client, stored, sent).unwrap_or_else(|failure| {
                        Err(Broken::Off {
                            pass,
                            bytes,
                            of,
                            stored,
                            failure,
                        })
                    });
                }
                Err(failure) => {
                    return Err(Broken::Off {
                        pass,
                        bytes,
                        of,
                        stored,
                        failure,
                    });
                }
            }
            number = number.wrapping_add(1);
            bytes += block.len();
            progress(Progress::Sent { pass, bytes, of });
        }
    }
    let kept = Diagnostics::read(client).map_err(Broken::Before)?.program;
    if kept == sent {
        Ok(())
    } else {
        Err(Broken::Other { kept, sent })
    }
}

/// Sends a block: a word with its number and size, and the text.
fn send(client: &mut Client, number: u8, text: &[u8], last: bool) -> Result<(), Failure> {
    let size = u16::from(number) << 8 | text.len() as u16;
    let pairs = text.chunks(2);
    let words = pairs.map(|pair| match *pair {
        [high, low] => u16::from_be_bytes([high, low]),
        _ => u16::from_be_bytes([pair[0], b'\n']),
    });
    let words: Vec<u16> = [size].into_iter().chain(words).collect();
    let patience = client.patience();
    let answer = if last {
        patience.store
    } else {
        patience.answer
    };
    client.set_words_within(answer, holding::UPLOAD, &words)
}

/// Why a block was refused.
fn explain(client: &mut Client, last: bool, sent: Kept) -> Result<Result<(), Broken>, Failure> {
    let diagnostics = Diagnostics::read(client)?;
    let under_way = diagnostics.has(flag::UPLOAD);
    // The answer to the end was lost, and its repetition came too late.
    if last && !under_way && diagnostics.trouble.is_none() && diagnostics.program == sent {
        return Ok(Ok(()));
    }
    Ok(Err(match diagnostics.trouble {
        Some(trouble) if !under_way => Broken::Fault(trouble),
        _ => Broken::Ended,
    }))
}

/// Brings a board into a state in which it takes an upload; gives what it was in before.
///
/// # Errors
/// [`Failure`].
pub fn stop(client: &mut Client) -> Result<Diagnostics, Failure> {
    let before = Diagnostics::read(client)?;
    if before.state == Some(State::Run) {
        client.set_word(holding::COMMAND, Command::Stop as u16)?;
    }
    Ok(before)
}

/// What became of the board behind an upload.
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
}

/// Lets a board run what it has just taken, unless it `stays`. One that was in FAULT is restarted.
///
/// # Errors
/// [`Failure`].
pub fn go_on(
    client: &mut Client,
    before: State,
    sent: Kept,
    stays: bool,
) -> Result<Behind, Failure> {
    if before == State::Fault {
        if stays {
            return Ok(Behind::Faulty);
        }
        client.set_word(holding::COMMAND, Command::Restart as u16)?;
        let after = await_start(client)?;
        return Ok(match (after.trouble, after.state) {
            (Some(trouble), Some(State::Fault)) => Behind::Trouble(trouble),
            _ if after.program != sent => Behind::Card,
            (_, Some(State::Run)) => Behind::Run,
            _ => Behind::Switch,
        });
    }
    if stays {
        return Ok(Behind::Stop);
    }
    match client.set_word(holding::COMMAND, Command::Run as u16) {
        Ok(()) => Ok(Behind::Run),
        Err(Failure::Refused(Exception::ServerDeviceFailure))
            if Diagnostics::read(client)?.is_switched_off() =>
        {
            Ok(Behind::Switch)
        }
        Err(failure) => Err(failure),
    }
}

/// Waits for a board that was restarted.
///
/// # Errors
/// [`Failure`], once the time that a start may take is over.
pub fn await_start(client: &mut Client) -> Result<Diagnostics, Failure> {
    let until = Instant::now() + client.patience().start;
    loop {
        match Diagnostics::read(client) {
            Err(Failure::Silent | Failure::Garbled) if Instant::now() < until => {}
            other => return other,
        }
    }
}

/// The window is one register and as many as hold a block's text.
const _: () = assert!(1 + BLOCK_BYTES.div_ceil(2) == 123);
