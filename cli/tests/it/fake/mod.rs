//! A board in memory behind a pseudo-terminal: the server's protocol is that of the firmware.
#![allow(dead_code, reason = "each test uses its part")]

mod device;

pub use device::{Board, FAULT, RUN, STOP};

use serialport::{SerialPort, TTYPort};
use std::io::{self, Read, Write};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use unoclp_board::{Line, Parity, Patience};
use unoclp_modbus::{Answer, Crc, FRAME_BYTES, begin};

/// What becomes of a request, before the board or behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It is answered.
    Answered,
    /// It is lost on its way.
    Lost,
    /// It is done, but the answer is lost.
    AnswerLost,
    /// It is done, but something else comes back.
    Garbled,
    /// Another function is answered.
    Mistaken,
    /// The port goes, and does not come back.
    Unplugged,
}

type Trick = Box<dyn FnMut(&mut Board, &[u8]) -> Fate + Send>;

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

    /// A board whose requests, each without its check sum, meet the fate that the trick says.
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

    /// How to speak to it.
    pub fn line(&self) -> Line {
        Line {
            port: self.path.clone(),
            address: 1,
            rate: 115_200,
            parity: Parity::None,
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
                assert_eq!(Crc::of(&request).value(), 0, "{request:02x?}");
                if self.answer(&request[..length - 2]) == Fate::Unplugged {
                    return;
                }
            }
        }
    }

    fn answer(&mut self, request: &[u8]) -> Fate {
        let mut board = self.board.lock().unwrap();
        let fate = (self.trick)(&mut board, request);
        // The address in use is that of the last start, which is 1 here as long as nobody asks for another.
        let ours = request[0] == board.settings[0] as u8 || request[0] == 1;
        if matches!(fate, Fate::Lost | Fate::Unplugged) || !ours {
            return fate;
        }
        let mut reply = handle(&mut board, request);
        match fate {
            Fate::AnswerLost => return fate,
            Fate::Garbled => *reply.last_mut().unwrap() ^= 1,
            Fate::Mistaken => {
                reply.truncate(reply.len() - 2);
                reply[1] ^= 7;
                reply.extend(Crc::of(&reply).to_bytes());
            }
            _ => {}
        }
        self.port.write_all(&reply).unwrap();
        fate
    }
}

/// The board's answer, with its check sum.
fn handle(board: &mut Board, request: &[u8]) -> Vec<u8> {
    let mut frame = [0; FRAME_BYTES];
    frame[..request.len()].copy_from_slice(request);
    let length = if request[1] == 43 && !board.identifies {
        (frame[1], frame[2]) = (0xAB, 1);
        3
    } else {
        match begin(&mut frame, request.len() as u8, board) {
            Answer::Silence => 0,
            Answer::Ready(length) => length,
            Answer::Filling(mut exchange) => loop {
                if let Some(length) = exchange.fill(&mut frame, board, 16) {
                    break length;
                }
            },
        }
    };
    let mut reply = frame[..length.into()].to_vec();
    reply.extend(Crc::of(&reply).to_bytes());
    reply
}

/// How long a request that begins so is: there is no silence on a pseudo-terminal.
fn request_length(came: &[u8]) -> Option<usize> {
    Some(match *came.get(1)? {
        15 | 16 => 9 + usize::from(*came.get(6)?),
        43 => 7,
        _ => 8,
    })
}
