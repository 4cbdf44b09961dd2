//! Boards behind Modbus TCP servers of this PC.

#[path = "../../../client/tests/fake/mod.rs"]
#[allow(unused_imports, reason = "each program uses its part")]
pub mod fake;

use fake::{Board, Fate, Trick, answer};
use std::fmt::Write as _;
use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::thread;
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::{Crc, Table};
use unoclp_site::Files;

/// Boards of a line.
pub const OF_LINE: usize = 20;
/// Points of a board: so many outputs, and so many values of 32 bits.
pub const POINTS: u64 = 32;
pub const OUTPUTS: u16 = 4;
pub const VALUES: u16 = 28;
/// The first register of the values.
pub const FIRST: u16 = 2000;

/// Lines of boards.
pub struct Lines {
    pub boards: usize,
    /// Where the lines are.
    pub servers: Vec<SocketAddr>,
    /// How many readings of the values of a board were answered,
    readings: Arc<AtomicU64>,
    /// and of how many boards.
    read: Arc<AtomicUsize>,
}

impl Lines {
    /// So many boards.
    pub fn of(boards: usize) -> Result<Lines, Box<dyn std::error::Error>> {
        let kept = kept()?;
        let mut lines = Lines {
            boards,
            servers: Vec::new(),
            readings: Arc::default(),
            read: Arc::default(),
        };
        for first in (0..boards).step_by(OF_LINE) {
            let count = OF_LINE.min(boards - first);
            let server = serve(count, kept, lines.readings.clone(), lines.read.clone())?;
            lines.servers.push(server);
        }
        Ok(lines)
    }

    /// How many boards are at this line.
    pub fn count(&self, line: usize) -> usize {
        OF_LINE.min(self.boards - line * OF_LINE)
    }

    /// How many readings of all values of a board were answered.
    pub fn readings(&self) -> u64 {
        self.readings.load(Ordering::Relaxed)
    }

    /// How many boards have been read.
    pub fn read(&self) -> usize {
        self.read.load(Ordering::Relaxed)
    }
}

/// The text of a program with 32 names.
pub fn text() -> String {
    let mut text = "PROGRAM p VAR\n".to_owned();
    let mut body = String::new();
    // To a string nothing fails.
    for n in 1..=OUTPUTS {
        let _ = writeln!(text, "q{n} AT %QX0.{} : BOOL;", n - 1);
        let _ = writeln!(body, "q{n} := v1 > {n};");
    }
    for n in 1..=VALUES {
        let _ = writeln!(text, "v{n} : DINT;");
        let _ = writeln!(body, "v{n} := v{n} + 1;");
    }
    format!("{text}END_VAR\n{body}END_PROGRAM\n")
}

/// The folder of the site file, which has this program alone.
struct Folder;

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Ok(text().into())
    }
}

/// How a board keeps the program.
pub fn kept() -> Result<Kept, String> {
    let site = "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"b\"\nprogram = \"p.st\"\n";
    let site = unoclp_site::read(site, &Folder).map_err(|wrong| format!("{wrong:?}"))?;
    let board = site.boards().next().ok_or("no board")?;
    let names = board.points.recorded(true).len();
    if names as u64 != POINTS {
        return Err(format!("the program has {names} names"));
    }
    board.points.program.ok_or("no program".to_owned())
}

/// Serves so many boards at a port of this PC, forever.
fn serve(
    count: usize,
    kept: Kept,
    readings: Arc<AtomicU64>,
    read: Arc<AtomicUsize>,
) -> io::Result<SocketAddr> {
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let address = listener.local_addr()?;
    let board = |number: usize| {
        let mut board = Board {
            kept,
            ..Board::default()
        };
        board.settings[0] = number as u16;
        board
    };
    let mut line = Line {
        boards: (1..=count).map(board).collect(),
        were_read: vec![false; count],
        readings,
        read,
    };
    let small = thread::Builder::new().stack_size(256 << 10);
    small.spawn(move || {
        for stream in listener.incoming().flatten() {
            // Its end is nobody's concern: the gateway comes again.
            let _ = line.speak(stream);
        }
    })?;
    Ok(address)
}

struct Line {
    boards: Vec<Board>,
    were_read: Vec<bool>,
    readings: Arc<AtomicU64>,
    read: Arc<AtomicUsize>,
}

impl Line {
    /// Answers a gateway until it leaves.
    fn speak(&mut self, mut stream: TcpStream) -> io::Result<()> {
        stream.set_nodelay(true)?;
        let mut trick: Trick = Box::new(|_, _| Fate::Answered);
        loop {
            let mut head = [0; 7];
            stream.read_exact(&mut head)?;
            let length = usize::from(u16::from_be_bytes([head[4], head[5]]));
            let mut request = vec![head[6]; length];
            stream.read_exact(request.get_mut(1..).unwrap_or_default())?;
            let at = usize::from(head[6]).wrapping_sub(1);
            let Some(board) = self.boards.get_mut(at) else {
                continue;
            };
            let is_reading =
                request.get(1) == Some(&3) && request.get(2..4) == Some(&FIRST.to_be_bytes());
            request.extend(Crc::of(&request).to_bytes());
            let (_, mut reply) = answer(board, &mut trick, &request);
            if is_reading {
                step(board);
                self.readings.fetch_add(1, Ordering::Relaxed);
                if let Some(was @ false) = self.were_read.get_mut(at) {
                    *was = true;
                    self.read.fetch_add(1, Ordering::Relaxed);
                }
            }
            reply.truncate(reply.len().saturating_sub(2));
            let [high, low] = (reply.len() as u16).to_be_bytes();
            let mut frame = vec![head[0], head[1], 0, 0, high, low];
            frame.append(&mut reply);
            stream.write_all(&frame)?;
        }
    }
}

/// One in eight of its values changes.
fn step(board: &mut Board) {
    for value in 0..4 {
        let address = FIRST + 1 + 14 * value;
        let low = board
            .words
            .entry((Table::HoldingRegisters as u16, address))
            .or_default();
        *low = low.wrapping_add(1);
    }
}
