//! A program over the line in place of the card.
//!
//! The text is sent twice: the board checks it the first time, and compares and stores it the second time. Of a program the
//! codes are sent, and no comments.

use crate::client::{Client, Failure};
use crate::diagnostics::{Diagnostics, Kept, Trouble};
pub use crate::event::{Behind, Broken, Pass, Progress};
use crate::event::{Event, Undone};
use crate::lock;
use crate::map::{BLOCK_BYTES, Command, State, flag, holding};
use crate::settings::read_lock;
use crate::watch::{Forced, command, release};
use std::time::Duration;
use unoclp_core::isa::{Opcode, Operand, POPPED, Value};
use unoclp_core::{Instruction, Program};
use unoclp_modbus::Exception;

/// The first form of stored programs whose boards know all instructions of this one.
pub fn needs(program: &Program<'_>) -> u8 {
    let near = program.board().engine.near_registers;
    let is_new = |step: Instruction<'_>| {
        let value = match step.operand {
            Operand::Value(Value::Popped) => Some(POPPED),
            Operand::Value(Value::Register(register)) => Some(register),
            _ => None,
        };
        step.opcode as u8 >= Opcode::Push as u8 || value > Some(near)
    };
    let many = program.registers() > usize::from(near);
    match many || program.steps().any(is_new) {
        true => 2,
        false => 1,
    }
}

/// What of a program's text is sent: its codes, each on a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Codes {
    bytes: Vec<u8>,
    /// The line of the text that each line of `bytes` stands in, from 1; the first is that of no line.
    lines: Vec<u32>,
}

impl Codes {
    /// Those of a program whose text is known. A jump is stored with the number of its line, so where there is one all lines
    /// keep theirs.
    pub fn of(program: &Program<'_>, text: &[u8]) -> Codes {
        let has_jumps = program
            .steps()
            .any(|step| matches!(step.operand, Operand::Jump { .. }));
        let mut codes = Codes {
            bytes: Vec::new(),
            lines: vec![0],
        };
        let text = text.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(text);
        let mut blank = 0;
        for (line, number) in text.split(|&byte| byte == b'\n').zip(1..) {
            let code = line.split(|&byte| byte == b'/').next().unwrap_or_default();
            let code = code.trim_ascii();
            if code.is_empty() {
                blank += 1;
                continue;
            }
            if has_jumps {
                for before in number - blank..number {
                    codes.line(before, &[]);
                }
            }
            blank = 0;
            codes.line(number, code);
        }
        codes
    }

    fn line(&mut self, number: u32, code: &[u8]) {
        self.lines.push(number);
        self.bytes.extend(code);
        self.bytes.push(b'\n');
    }

    /// What is sent in each pass.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// A fault that a board has found in them, by its line in the text.
    pub fn in_text(&self, trouble: Trouble) -> Trouble {
        let line = trouble.line.map(|line| {
            let known = self.lines.get(line as usize);
            known.copied().unwrap_or(line)
        });
        Trouble { line, ..trouble }
    }
}

/// A program that is to be put on a board, as it is ordered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Upload {
    codes: Codes,
    /// How a board of this version keeps it.
    kept: Kept,
    /// The first form of stored programs that has all of its instructions.
    needs: u8,
    /// The board stays in STOP then.
    pub stays: bool,
    /// What is forced is let go, once the program is stored.
    pub releases: bool,
}

/// The form in which the oldest firmware keeps programs.
const OLDEST_FORM: u8 = 1;

impl Upload {
    /// Of a program whose text is known. The board runs it then, and what is forced stays so.
    pub fn of(program: &Program<'_>, text: &[u8]) -> Upload {
        Upload {
            codes: Codes::of(program, text),
            kept: Kept::of(program),
            needs: needs(program),
            stays: false,
            releases: false,
        }
    }

    /// Puts it on the board, whatever that does now; tells how far it is, and gives what has become of the board.
    ///
    /// # Errors
    /// [`Undone`]; a fault by its line in the text.
    pub async fn put(
        &self,
        client: &mut Client,
        tell: &mut dyn FnMut(Event<'_>),
    ) -> Result<Behind, Undone> {
        // A board that takes no upload is not stopped for one.
        if read_lock(client).await? & lock::UPLOAD != 0 {
            return Err(Broken::Locked.into());
        }
        if self.needs > OLDEST_FORM {
            let board = Diagnostics::read(client).await?.program.version;
            if board < self.needs {
                let needs = self.needs;
                return Err(Broken::TooOld { board, needs }.into());
            }
        }
        let forced = Forced::read(client).await?;
        let before = stop(client).await.map_err(Undone::NotStopped)?;
        let state = before.state.ok_or(Broken::UnknownState)?;
        tell(Event::Stopped {
            before: &before,
            forced,
        });
        let kept = self
            .send(client, &mut |progress| tell(Event::Sent(progress)))
            .await?;
        tell(Event::Stored(kept));
        if self.releases && forced.any() {
            release(client).await?;
            tell(Event::Released(forced));
        }
        let behind = go_on(client, state, kept, self.stays).await;
        behind.map_err(Undone::NotStarted)
    }

    /// Sends its codes to a board that is not in RUN; gives how the board keeps it.
    ///
    /// # Errors
    /// [`Broken`]; a fault by its line in the text.
    pub async fn send(
        &self,
        client: &mut Client,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Kept, Broken> {
        let kept = upload(client, self.codes.bytes(), self.kept, progress).await;
        kept.map_err(|broken| match broken {
            Broken::Fault(trouble) => Broken::Fault(self.codes.in_text(trouble)),
            other => other,
        })
    }
}

/// Uploads a text as it is, which a board of this version will keep as `sent`; gives how the board keeps it.
/// The board must not be in RUN.
///
/// # Errors
/// [`Broken`].
pub async fn upload(
    client: &mut Client,
    text: &[u8],
    sent: Kept,
    progress: &mut dyn FnMut(Progress),
) -> Result<Kept, Broken> {
    let begun = command(client, Command::Upload);
    match begun.await {
        Ok(()) => {}
        Err(Failure::Refused(Exception::IllegalFunction)) => return Err(Broken::Locked),
        Err(Failure::Refused(_)) => return Err(Broken::NotBegun),
        Err(failure) => return Err(Broken::Before(failure)),
    }
    let mut number = 0_u8;
    for pass in [Pass::Check, Pass::Store] {
        let mut bytes = 0;
        let of = text.len();
        progress(Progress::Sent { pass, bytes, of });
        // A block of no bytes ends the text.
        for block in text.chunks(BLOCK_BYTES.into()).chain([&[][..]]) {
            let stored = pass == Pass::Store && block.is_empty();
            if stored {
                progress(Progress::Storing);
            }
            let off = |failure| Broken::Off {
                pass,
                bytes,
                of,
                stored,
                failure,
            };
            match send(client, number, block, stored.then_some(sent)).await {
                Ok(()) => {}
                Err(Failure::Refused(_)) => {
                    let diagnostics = Diagnostics::read(client).await.map_err(off)?;
                    return explain(&diagnostics, stored, sent);
                }
                Err(failure) => return Err(off(failure)),
            }
            number = number.wrapping_add(1);
            bytes += block.len();
            progress(Progress::Sent { pass, bytes, of });
        }
    }
    let diagnostics = Diagnostics::read(client).await.map_err(Broken::Before)?;
    let kept = diagnostics.program;
    if kept.differs(sent) {
        return Err(Broken::Other { kept, sent });
    }
    Ok(kept)
}

/// What a byte of a program takes until it is stored: 3.4 ms by the chip's datasheet, and some.
const BYTE: Duration = Duration::from_millis(4);

/// Sends a block: a word with its number and size, and the text.
async fn send(
    client: &mut Client,
    number: u8,
    text: &[u8],
    last: Option<Kept>,
) -> Result<(), Failure> {
    let size = u16::from(number) << 8 | text.len() as u16;
    let pairs = text.chunks(2);
    let words = pairs.map(|pair| match *pair {
        [high, low] => u16::from_be_bytes([high, low]),
        _ => u16::from_be_bytes([pair[0], b'\n']),
    });
    let words: Vec<u16> = [size].into_iter().chain(words).collect();
    let patience = client.patience();
    // While a board stores a program, it answers nothing.
    let answer = match last {
        Some(kept) => patience.store + BYTE * u32::from(kept.bytes),
        None => patience.answer,
    };
    let sent = client.set_words_within(answer, holding::UPLOAD, &words);
    sent.await
}

/// Ends an upload that is under way, if there is one; gives how the board stands then.
///
/// # Errors
/// [`Failure`].
pub async fn end(client: &mut Client) -> Result<Diagnostics, Failure> {
    let board = Diagnostics::read(client).await?;
    if !board.has(flag::UPLOAD) {
        return Ok(board);
    }
    let ended = command(client, Command::Stop);
    match ended.await {
        // Where commands are locked it ends by itself, as no more blocks come.
        Ok(()) | Err(Failure::Refused(Exception::IllegalFunction)) => {}
        Err(failure) => return Err(failure),
    }
    Diagnostics::read(client).await
}

/// Why a block was refused.
fn explain(board: &Diagnostics, last: bool, sent: Kept) -> Result<Kept, Broken> {
    let under_way = board.has(flag::UPLOAD);
    match board.trouble {
        // The answer to the end was lost, and its repetition came too late.
        None if last && !under_way && !board.program.differs(sent) => Ok(board.program),
        Some(trouble) if !under_way => Err(Broken::Fault(trouble)),
        _ => Err(Broken::Ended),
    }
}

/// Brings a board into a state in which it takes an upload; gives what it was in before.
///
/// # Errors
/// [`Failure`].
pub async fn stop(client: &mut Client) -> Result<Diagnostics, Failure> {
    let before = Diagnostics::read(client).await?;
    if before.state == Some(State::Run) {
        let stopped = command(client, Command::Stop);
        stopped.await?;
    }
    Ok(before)
}

/// How long a board is given to run a program before it is asked how it does: most of what goes wrong at all does so at
/// once.
pub const FIRST_SCANS: Duration = Duration::from_secs(1);

/// Lets a board run the program that it keeps since an upload, unless it `stays`. One that was in FAULT is restarted.
///
/// # Errors
/// [`Failure`].
pub async fn go_on(
    client: &mut Client,
    before: State,
    kept: Kept,
    stays: bool,
) -> Result<Behind, Failure> {
    if before == State::Fault {
        if stays {
            return Ok(Behind::Faulty);
        }
        let restarted = command(client, Command::Restart);
        restarted.await?;
        let after = await_start(client).await?;
        return Ok(match (after.trouble, after.state) {
            (Some(trouble), Some(State::Fault)) if trouble.is_of_the_run() => {
                Behind::Failing(Some(trouble))
            }
            (Some(trouble), Some(State::Fault)) => Behind::Trouble(trouble),
            _ if after.program != kept => Behind::Card,
            (_, Some(State::Run)) => runs(client).await?,
            _ => Behind::Switch,
        });
    }
    if stays {
        return Ok(Behind::Stop);
    }
    let run = command(client, Command::Run);
    match run.await {
        Ok(()) => runs(client).await,
        // Locked commands are refused before the board looks at A5.
        Err(Failure::Refused(Exception::ServerDeviceFailure | Exception::IllegalFunction))
            if Diagnostics::read(client).await?.is_switched_off() =>
        {
            Ok(Behind::Switch)
        }
        Err(failure) => Err(failure),
    }
}

/// How a board does that has begun to run a program. Its watchdog may restart it meanwhile.
async fn runs(client: &mut Client) -> Result<Behind, Failure> {
    client.pause(FIRST_SCANS, || false).await?;
    let after = await_start(client).await?;
    Ok(match after.state {
        Some(State::Fault) => Behind::Failing(after.trouble),
        _ => Behind::Run,
    })
}

/// Waits for a board that was restarted.
///
/// # Errors
/// [`Failure`], once the time that a start may take is over.
pub async fn await_start(client: &mut Client) -> Result<Diagnostics, Failure> {
    let until = client.now() + client.patience().start;
    loop {
        match Diagnostics::read(client).await {
            Err(Failure::Silent | Failure::Garbled) if client.now() < until => {}
            other => return other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_end_whose_program_is_kept_is_an_upload() {
        let [sent, old] = [5, 6].map(|sum| Kept {
            sum,
            ..Kept::default()
        });
        let board = |flags, program| Diagnostics {
            flags,
            program,
            ..Diagnostics::default()
        };
        let cases = [
            (board(0, sent), true, Ok(sent)),
            (board(0, sent), false, Err(Broken::Ended)),
            (board(0, old), true, Err(Broken::Ended)),
            (board(flag::UPLOAD, sent), true, Err(Broken::Ended)),
        ];
        for (board, last, told) in cases {
            assert_eq!(explain(&board, last, sent), told);
        }
        let trouble = Trouble {
            number: 24,
            line: Some(2),
        };
        let faulty = |flags| Diagnostics {
            trouble: Some(trouble),
            ..board(flags, old)
        };
        let under_way = explain(&faulty(flag::UPLOAD), false, sent);
        assert_eq!(under_way, Err(Broken::Ended));
        let over = explain(&faulty(0), false, sent);
        assert_eq!(over, Err(Broken::Fault(trouble)));
    }
}
