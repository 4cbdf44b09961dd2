//! A board behind a serial port of the host: for `mbpoll`, `unoclp monitor`, and whatever else speaks to the UNO.
//!
//! ```no_run
//! use unoclp_uno_sim::port::{Options, Port};
//! use unoclp_uno_sim::{Program, Slot, firmware_file};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let program = Program::read(&firmware_file()?)?;
//! let port = Port::open(program, Slot::Empty, Options::default())?;
//! println!("{}", port.path().display());
//! port.with(|uno| uno.set_input(0, true))?;
//! port.close()?;
//! # Ok(())
//! # }
//! ```
//!
//! What the host sends enters at the rate and parity of [`Uno::set_serial_line`], back to back; what it sets on its side
//! of the port does not matter. While nobody has the port open, what the board sends is lost.

mod pace;
mod pty;

pub use pace::Pace;

use crate::{CYCLES_PER_MS, Error, Halt, Program, Slot, Uno};
use pace::Pacer;
use pty::Pty;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, Sender, TryRecvError};
use std::thread::{self, JoinHandle};
use std::time::Instant;

/// Cycles for which the board runs before it is looked after.
const SLICE: u64 = CYCLES_PER_MS / 2;
/// Bytes of the host wait outside while more than this is on the line, cycles.
const AHEAD: u64 = 10 * CYCLES_PER_MS;
/// The line is quiet once nothing has been on it for so long, cycles: an answer may take a while.
const QUIET: u64 = 20 * CYCLES_PER_MS;

/// How the board at a port goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// When simulated time is held back.
    pub pace: Pace,
    /// Each time the port is opened the board is reset, as the real one is by DTR. The second for which its boot loader
    /// waits is left out.
    pub reset_on_open: bool,
}

/// What is done with the board, between two instructions.
type Job = Box<dyn FnOnce(&mut Uno) + Send>;

/// Why there is no board behind the port.
#[derive(Debug, thiserror::Error)]
pub enum PortError {
    /// The simulation could not be set up.
    #[error(transparent)]
    Setup(#[from] Error),
    /// The pseudo-terminal failed.
    #[error("the pseudo-terminal of the board failed: {0}")]
    Terminal(#[from] std::io::Error),
    /// The program has come to an end of its own.
    #[error("{0}")]
    Halt(#[from] Halt),
    /// The board has ended before, or a job on it has panicked.
    #[error("the board runs no longer; closing the port tells why")]
    Ended,
}

/// A board that runs in a thread of its own, with its serial port on a pseudo-terminal. It ends when it is dropped.
pub struct Port {
    path: PathBuf,
    jobs: Option<Sender<Job>>,
    thread: Option<JoinHandle<Result<(), PortError>>>,
}

impl Port {
    /// Powers a board with this program and slot.
    ///
    /// # Errors
    /// Where the simulation or the pseudo-terminal cannot be set up.
    pub fn open(program: Program, slot: Slot, options: Options) -> Result<Port, PortError> {
        let pty = Pty::new()?;
        let path = pty.path().to_owned();
        let (jobs, to_do) = mpsc::channel();
        let thread = thread::Builder::new().name("board".to_owned());
        // The board is made in its thread: simavr's chip may not move to another.
        let thread = thread.spawn(move || {
            let uno = Uno::with_program(program, slot)?;
            Board::new(uno, pty, options, to_do).run()
        })?;
        let port = Port {
            path,
            jobs: Some(jobs),
            thread: Some(thread),
        };
        // It is there once it does something, and runs only then.
        match port.with(|_| ()) {
            Ok(()) => Ok(port),
            Err(ended) => Err(port.close().err().unwrap_or(ended)),
        }
    }

    /// The serial port to open, like `/dev/pts/5`.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Does something with the board, and waits for that. The board stands meanwhile, unless `act` runs it, which it may
    /// do faster than real time.
    ///
    /// # Errors
    /// [`PortError::Ended`] where the board runs no longer.
    pub fn with<T: Send + 'static>(
        &self,
        act: impl FnOnce(&mut Uno) -> T + Send + 'static,
    ) -> Result<T, PortError> {
        let (result, done) = mpsc::channel();
        // Nobody may wait for the result any more.
        let job = move |uno: &mut Uno| drop(result.send(act(uno)));
        let jobs = self.jobs.as_ref().ok_or(PortError::Ended)?;
        jobs.send(Box::new(job)).map_err(|_| PortError::Ended)?;
        done.recv().map_err(|_| PortError::Ended)
    }

    /// True until the board has ended by itself.
    pub fn is_running(&self) -> bool {
        let thread = self.thread.as_ref();
        thread.is_some_and(|thread| !thread.is_finished())
    }

    /// Ends the board, and the port with it.
    ///
    /// # Errors
    /// Where it has ended by itself, and why.
    pub fn close(mut self) -> Result<(), PortError> {
        self.end()
    }

    fn end(&mut self) -> Result<(), PortError> {
        self.jobs = None;
        match self.thread.take() {
            Some(thread) => thread.join().unwrap_or(Err(PortError::Ended)),
            None => Ok(()),
        }
    }
}

impl Drop for Port {
    fn drop(&mut self) {
        // Whoever wants to know closes it.
        let _ = self.end();
    }
}

/// What the thread has.
struct Board {
    uno: Uno,
    pty: Pty,
    options: Options,
    jobs: Receiver<Job>,
    /// When what has been sent to the board is over.
    line_free: u64,
    /// When the line was last in use.
    in_use: u64,
}

impl Board {
    fn new(uno: Uno, pty: Pty, options: Options, jobs: Receiver<Job>) -> Board {
        Board {
            uno,
            pty,
            options,
            jobs,
            line_free: 0,
            in_use: 0,
        }
    }

    /// Runs until nobody can want anything more of it.
    fn run(mut self) -> Result<(), PortError> {
        match self.jobs.recv() {
            Ok(job) => job(&mut self.uno),
            Err(_) => return Ok(()),
        }
        let mut pacer = Pacer::new(Instant::now(), self.uno.cycles());
        loop {
            match self.jobs.try_recv() {
                Ok(job) => {
                    job(&mut self.uno);
                    // What the job has run is not held back.
                    pacer = Pacer::new(Instant::now(), self.uno.cycles());
                }
                Err(TryRecvError::Empty) => {}
                Err(TryRecvError::Disconnected) => return Ok(()),
            }
            self.exchange()?;
            self.uno.run_cycles(SLICE)?;
            let now = self.uno.cycles();
            if self.options.pace == Pace::Quiet && now < self.in_use + QUIET {
                pacer = Pacer::new(Instant::now(), now);
            }
            thread::sleep(pacer.wait(Instant::now(), now));
        }
    }

    /// Carries bytes both ways.
    fn exchange(&mut self) -> Result<(), PortError> {
        let now = self.uno.cycles();
        if self.line_free < now + AHEAD {
            let was_in_use = self.pty.is_in_use();
            let bytes = self.pty.receive()?;
            if self.options.reset_on_open && self.pty.is_in_use() && !was_in_use {
                self.uno.reset();
            }
            if !bytes.is_empty() {
                self.line_free = self.uno.send_serial(&bytes);
            }
        }
        let sent = self.uno.take_serial_log();
        let last = sent.last().map_or(0, |sent| sent.end);
        self.in_use = self.in_use.max(self.line_free).max(last);
        let bytes: Vec<u8> = sent.into_iter().map(|sent| sent.byte).collect();
        Ok(self.pty.send(&bytes)?)
    }
}
