//! How much of an RS-485 line a gateway uses.
//!
//! The line is a pseudo-terminal, on which each byte takes the time that it takes on wires at that rate: 8 bits, a start, a stop. A board
//! answers once the line has been silent for 3.5 characters, or 1.75 ms above 19,200 bits a second, as Modbus wants it, and at once then.
//! Each board is to be read every 10 ms: so the line is never without somebody who waits for it.

use crate::boards::fake::{Board, Fate, Trick, answer, request_length};
use crate::boards::{FIRST, kept, text};
use crate::process::Process;
use serialport::{SerialPort, TTYPort};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, ErrorKind, Read, Write};
use std::net::TcpListener;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Until all boards have been read, at most.
const PATIENCE: Duration = Duration::from_secs(120);

/// Measures a gateway of so many boards at a line of this rate; says it as JSON.
pub fn measured(
    program: &Path,
    folder: &Path,
    boards: u8,
    rate: u32,
    time: Duration,
) -> Result<String, Box<dyn std::error::Error>> {
    let (port, user) = TTYPort::pair()?;
    let mut wires = Wires::new(port, boards, rate)?;
    let path = user.name().ok_or("a port without a name")?;
    let gateway = gateway(program, folder, &path, boards, rate)?;
    let begun = Instant::now();
    let mut outcome =
        wires.until(|wires| wires.read.len() == usize::from(boards) || begun.elapsed() > PATIENCE);
    let up = wires.read.len();
    (wires.bytes, wires.silent, wires.readings) = (0, Duration::ZERO, 0);
    let begun = Instant::now();
    outcome = outcome.and_then(|()| wires.until(|_| begun.elapsed() > time));
    let wall = begun.elapsed().as_secs_f64();
    drop(gateway);
    outcome?;
    let bytes = wires.character.as_secs_f64() * wires.bytes as f64;
    Ok(format!(
        "{{\"boards\":{boards},\"up\":{up},\"rate\":{rate},\"readings\":{:.1},\"bytes\":{:.4},\"used\":{:.4}}}",
        wires.readings as f64 / wall,
        bytes / wall,
        (bytes + wires.silent.as_secs_f64()) / wall,
    ))
}

/// A line, and the boards at it.
struct Wires {
    port: TTYPort,
    boards: Vec<Board>,
    /// The time of a byte,
    character: Duration,
    /// and the silence that ends a frame.
    silence: Duration,
    /// What was on the wires: bytes, the silences before answers and before the next requests, readings of boards,
    bytes: usize,
    silent: Duration,
    readings: u64,
    /// and which boards have been read.
    read: BTreeSet<u8>,
    came: Vec<u8>,
}

impl Wires {
    fn new(mut port: TTYPort, boards: u8, rate: u32) -> Result<Wires, Box<dyn std::error::Error>> {
        let kept = kept()?;
        port.set_timeout(Duration::from_millis(100))?;
        let character = Duration::from_secs(10) / rate;
        let board = |address: u8| {
            let mut board = Board {
                kept,
                ..Board::default()
            };
            board.settings[0] = address.into();
            board
        };
        Ok(Wires {
            port,
            boards: (1..=boards).map(board).collect(),
            character,
            silence: match rate {
                ..=19_200 => character * 7 / 2,
                _ => Duration::from_micros(1_750),
            },
            bytes: 0,
            silent: Duration::ZERO,
            readings: 0,
            read: BTreeSet::new(),
            came: Vec::new(),
        })
    }

    /// Carries requests and answers until this is so.
    fn until(&mut self, is_so: impl Fn(&Wires) -> bool) -> io::Result<()> {
        while !is_so(self) {
            let mut chunk = [0; 512];
            match self.port.read(&mut chunk) {
                Ok(count) => self.came.extend(chunk.iter().take(count)),
                Err(error) if error.kind() == ErrorKind::TimedOut => continue,
                Err(error) => return Err(error),
            }
            let begun = Instant::now();
            while let Some(length) = request_length(&self.came)
                && self.came.len() >= length
            {
                let request: Vec<u8> = self.came.drain(..length).collect();
                self.answer(&request, begun)?;
            }
        }
        Ok(())
    }

    /// Answers a request whose first byte was sent at this moment.
    fn answer(&mut self, request: &[u8], begun: Instant) -> io::Result<()> {
        let mut trick: Trick = Box::new(|_, _| Fate::Answered);
        let address = request.first().copied().unwrap_or_default();
        let board = usize::from(address).wrapping_sub(1);
        let Some(board) = self.boards.get_mut(board) else {
            return Ok(());
        };
        let (_, reply) = answer(board, &mut trick, request);
        let bytes = request.len() + reply.len();
        let on_wires = self.character * bytes as u32 + self.silence;
        thread::sleep((begun + on_wires).saturating_duration_since(Instant::now()));
        self.port.write_all(&reply)?;
        self.bytes += bytes;
        // After the answer the line must be silent as long again.
        self.silent += 2 * self.silence;
        if request.get(1) == Some(&3) && request.get(2..4) == Some(&FIRST.to_be_bytes()) {
            self.readings += 1;
            self.read.insert(address);
        }
        Ok(())
    }
}

/// Begins a gateway of these boards.
fn gateway(
    program: &Path,
    folder: &Path,
    port: &str,
    boards: u8,
    rate: u32,
) -> io::Result<Process> {
    fs::write(folder.join("p.st"), text())?;
    // A port that is free, until the gateway takes it.
    let page = TcpListener::bind("127.0.0.1:0")?.local_addr()?;
    let mut site = format!(
        "[http]\nlisten = \"{page}\"\n[history]\nstore = \"h.db\"\n[[line]]\nport = \"{port}\"\nrate = {rate}\n"
    );
    for address in 1..=boards {
        // To a string nothing fails.
        let _ = writeln!(
            site,
            "[[line.board]]\nname = \"b{address}\"\naddress = {address}\nunit = {address}\nprogram = \"p.st\"\nevery = \"10ms\""
        );
    }
    let file = folder.join("site.toml");
    fs::write(&file, site)?;
    let mut command = Command::new(program);
    command.args(["serve", "--site"]).arg(file);
    command.stdout(Stdio::null()).spawn().map(Process)
}
