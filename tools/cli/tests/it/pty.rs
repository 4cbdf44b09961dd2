//! A board in memory behind a pseudo-terminal.
#![allow(dead_code, reason = "each test uses its part")]

#[path = "../../../client/tests/fake/mod.rs"]
mod fake;

pub use fake::{Board, FAULT, Fate, RUN, STOP, kept};

use fake::{Trick, answer, request_length};
use serialport::{SerialPort, TTYPort};
use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use unoclp_cli::port::Place;
use unoclp_client::{Line, Patience};

/// The board, and the port that it is at.
pub struct Fake {
    board: Arc<Mutex<Board>>,
    path: String,
    /// What the board says of its own accord.
    say: Arc<Mutex<Vec<u8>>>,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Fake {
    /// A board that answers.
    pub fn new(board: Board) -> Fake {
        Fake::with(board, |_, _| Fate::Answered)
    }

    /// A board whose requests, each without its checksum, meet the fate that the trick says.
    pub fn with(
        board: Board,
        trick: impl FnMut(&mut Board, &[u8]) -> Fate + Send + 'static,
    ) -> Fake {
        let (port, user) = TTYPort::pair().unwrap();
        let path = user.name().unwrap();
        let say = Arc::new(Mutex::new(Vec::new()));
        let board = Arc::new(Mutex::new(board));
        let end = Arc::new(AtomicBool::new(false));
        let server = Server {
            board: board.clone(),
            say: say.clone(),
            port,
            _user: user,
            end: end.clone(),
            trick: Box::new(trick),
        };
        Fake {
            board,
            path,
            say,
            end,
            thread: Some(thread::spawn(|| server.run())),
        }
    }

    /// The board, to look at; it answers nothing meanwhile.
    pub fn board(&self) -> MutexGuard<'_, Board> {
        self.board.lock().unwrap()
    }

    /// The board says something that nobody has asked for.
    pub fn say(&self, text: &str) {
        self.say.lock().unwrap().extend(text.as_bytes());
    }

    /// The name of its port.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Where it is.
    pub fn place(&self) -> Place {
        Place {
            port: self.path.clone(),
            line: Line::default(),
        }
    }
}

impl Drop for Fake {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Relaxed);
        if let Some(thread) = self.thread.take() {
            let ended = thread.join();
            // A failure of the test itself says more.
            assert!(ended.is_ok() || thread::panicking(), "the board has failed");
        }
    }
}

/// So much that no machine is too slow for it.
pub const PATIENT: Patience = Patience {
    answer: Duration::from_secs(60),
    attempts: 3,
    start: Duration::from_secs(60),
    store: Duration::from_secs(60),
};

/// For boards that shall be waited for in vain.
pub const IMPATIENT: Patience = Patience {
    answer: Duration::from_millis(20),
    attempts: 2,
    start: Duration::from_millis(20),
    store: Duration::from_millis(20),
};

struct Server {
    board: Arc<Mutex<Board>>,
    say: Arc<Mutex<Vec<u8>>>,
    port: TTYPort,
    /// Kept open, so that the port outlives its users.
    _user: TTYPort,
    end: Arc<AtomicBool>,
    trick: Trick,
}

impl Server {
    fn run(mut self) {
        let mut came = Vec::new();
        self.port.set_timeout(Duration::from_millis(5)).unwrap();
        while !self.end.load(Ordering::Relaxed) {
            let says = std::mem::take(&mut *self.say.lock().unwrap());
            self.port.write_all(&says).unwrap();
            let mut bytes = [0; 512];
            match self.port.read(&mut bytes) {
                Ok(count) => came.extend(&bytes[..count]),
                Err(error) if error.kind() == io::ErrorKind::TimedOut => {}
                Err(error) => panic!("{error}"),
            }
            while let Some(length) = request_length(&came)
                && came.len() >= length
            {
                let request: Vec<u8> = came.drain(..length).collect();
                let mut board = self.board.lock().unwrap();
                let (fate, reply) = answer(&mut board, &mut self.trick, &request);
                if fate == Fate::Unplugged {
                    return;
                }
                self.port.write_all(&reply).unwrap();
            }
        }
    }
}
