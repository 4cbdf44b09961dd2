//! The firmware on avr8js, which the page runs it on: the simulated board of `page/uno/`, in a process of Node.
//!
//! The process obeys requests in order and answers each run with all that can be asked for after it: registers and RAM,
//! what was sent, where the program is (`page/uno/src/engine/main.ts` has the form of both). So a scan takes one answer.
//! A write to the EEPROM takes 4 µs there, not 3.4 ms: keeping a program would take seconds of each start.

use crate::chip::Chip;
use crate::engine::{EngineError, Simulated};
use crate::pins::Levels;
use crate::{Error, Halt, Program, Pwm};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Cycles of a write to the EEPROM.
const EEPROM_WRITE: u32 = 64;
/// No place to run to.
const NOWHERE: u32 = u32::MAX;
/// Bytes of a card's block.
const BLOCK: usize = 512;
/// Register of timer 1's interrupts.
const TIMSK1: u16 = 0x6F;

mod request {
    pub const FIRMWARE: u8 = 0;
    pub const START: u8 = 1;
    pub const POWER: u8 = 2;
    pub const WRITE: u8 = 3;
    pub const INPUTS: u8 = 4;
    pub const ANALOGUE: u8 = 5;
    pub const SEND: u8 = 6;
    pub const RUN: u8 = 7;
    pub const SLOW: u8 = 8;
    pub const TRAIL: u8 = 9;
}

/// How a run ended.
mod ended {
    pub const TIME_OVER: u8 = 0;
    pub const THERE: u8 = 1;
}

/// The symbols by which a scan goes in slow motion: `Places` in `page/uno/src/slow/linked.ts`.
const PLACES: [&str; 7] = [
    "engine_link",
    "link_one",
    "link_flush",
    "link_put",
    "engine_end",
    "scan_begin",
    "ENGINE_MORE_INPUTS",
];

/// The last of them, which a board without outputs in bytes of their own lacks.
const OUTPUT_CELLS: &str = "OUTPUT_CELLS";

/// How the engine stood between two instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seam {
    /// The instruction that comes next, from 0.
    pub step: usize,
    /// The result of the rung so far (NC-6).
    pub acc: bool,
    /// How many values are pushed (NC-22).
    pub pushed: u8,
    /// The value accumulator (NC-16).
    pub value: i32,
}

/// A board in a process of Node, which ends with it.
pub struct Avr8js {
    process: Child,
    requests: BufWriter<ChildStdin>,
    answers: ChildStdout,
    program: Program,
    /// The first request that could not be sent: the next run tells it.
    broken: Option<io::Error>,
    data: Vec<u8>,
    serial: Vec<u8>,
    moved: u32,
    cycles: u64,
}

/// Where `cargo xtask test` has built it.
fn script() -> Result<PathBuf, Error> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/uno/engine/main.mjs");
    if path.is_file() {
        Ok(path)
    } else {
        Err(Error::NoAvr8js(path))
    }
}

impl Avr8js {
    fn new(program: &Program) -> Result<Avr8js, Error> {
        let mut node = Command::new("node");
        node.arg(script()?)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped());
        let mut process = node.spawn().map_err(Error::NoNode)?;
        let no_pipe = || Error::NoNode(io::Error::other("it has no pipes"));
        let requests = process.stdin.take().ok_or_else(no_pipe)?;
        let answers = process.stdout.take().ok_or_else(no_pipe)?;
        let mut board = Avr8js {
            process,
            requests: BufWriter::new(requests),
            answers,
            program: program.clone(),
            broken: None,
            data: vec![0; program.chip().ram_end() as usize + 1],
            serial: Vec::new(),
            moved: 0,
            cycles: 0,
        };
        let mut flash = program.flash.clone();
        flash.resize(program.chip().flash_len(), 0xFF);
        let kind = match program.chip() {
            Chip::Atmega328p => 0,
            Chip::Atmega2560 => 1,
        };
        board.request(request::FIRMWARE, &[&[kind], &flash]);
        Ok(board)
    }

    fn insert_and_start(&mut self, image: &[u8]) {
        let written: Vec<(u32, &[u8])> = (0..)
            .zip(image.chunks_exact(BLOCK))
            .filter(|(_, block)| block.iter().any(|&byte| byte != 0))
            .collect();
        let head = [EEPROM_WRITE, image.len() as u32, written.len() as u32];
        self.request(request::START, &[&head.map(u32::to_le_bytes).concat()]);
        for (number, block) in written {
            self.send(&number.to_le_bytes());
            self.send(block);
        }
        self.forget();
    }

    fn forget(&mut self) {
        self.serial.clear();
        self.moved = 0;
    }

    fn request(&mut self, kind: u8, parts: &[&[u8]]) {
        self.send(&[kind]);
        for part in parts {
            self.send(part);
        }
    }

    fn send(&mut self, bytes: &[u8]) {
        if self.broken.is_none() {
            self.broken = self.requests.write_all(bytes).err();
        }
    }

    fn write(&mut self, address: u16, bytes: &[u8]) {
        let head = [address, bytes.len() as u16].map(u16::to_le_bytes).concat();
        self.request(request::WRITE, &[&head, bytes]);
    }

    /// From now on each scan goes from one seam of its program to the next.
    ///
    /// # Errors
    /// Where the firmware lacks a symbol, or the board keeps no program.
    pub fn go_slowly(&mut self) -> Result<(), EngineError> {
        let mut places = Vec::new();
        for name in PLACES {
            let symbol = self.program.symbol(name);
            let address = symbol.ok_or(EngineError::NoSymbol(name))?.address & 0xFFFF;
            places.extend(address.to_le_bytes());
        }
        let cells = self.program.symbol(OUTPUT_CELLS);
        let cells = cells.map_or(NOWHERE, |symbol| symbol.address & 0xFFFF);
        places.extend(cells.to_le_bytes());
        self.request(request::SLOW, &[&places]);
        match self.answer::<1>()? {
            [0] => Err(EngineError::NoProgram),
            _ => Ok(()),
        }
    }

    /// How the engine stood at each seam since this was asked last.
    ///
    /// # Errors
    /// Where the process is gone.
    pub fn trail(&mut self) -> Result<Vec<Seam>, EngineError> {
        self.request(request::TRAIL, &[]);
        let count = u16::from_le_bytes(self.answer()?);
        let seams = (0..count).map(|_| {
            let [low, high, acc, pushed, value @ ..] = self.answer::<8>()?;
            Ok(Seam {
                step: u16::from_le_bytes([low, high]).into(),
                acc: acc != 0,
                pushed,
                value: i32::from_le_bytes(value),
            })
        });
        seams.collect()
    }

    fn answer<const N: usize>(&mut self) -> Result<[u8; N], EngineError> {
        let read = self.requests.flush().and_then(|()| self.read());
        read.map_err(|error| {
            let reason = error.to_string();
            EngineError::Halt(Halt::Simulator { reason }, String::new())
        })
    }

    /// Runs, and says whether it came to the address.
    fn run(&mut self, address: u32, cycles: u64) -> Result<bool, Halt> {
        let cycles = u32::try_from(cycles).unwrap_or(u32::MAX);
        self.request(
            request::RUN,
            &[&address.to_le_bytes(), &cycles.to_le_bytes()],
        );
        let lost = |error: io::Error| Halt::Simulator {
            reason: error.to_string(),
        };
        if let Some(error) = self.broken.take() {
            return Err(lost(error));
        }
        self.requests.flush().map_err(lost)?;
        let (how, said, place) = self.read_answer().map_err(lost)?;
        match how {
            ended::THERE => Ok(true),
            ended::TIME_OVER if address == NOWHERE => Ok(true),
            ended::TIME_OVER => Err(Halt::Timeout {
                cycles: cycles.into(),
                place: self.program.place(place),
            }),
            _ => Err(Halt::Simulator {
                reason: String::from_utf8_lossy(&said).into_owned(),
            }),
        }
    }

    /// How it ended, what was said, and where the program is.
    fn read_answer(&mut self) -> io::Result<(u8, Vec<u8>, u32)> {
        let [how] = self.read()?;
        let moved = u32::from_le_bytes(self.read()?);
        let place = u32::from_le_bytes(self.read()?);
        let cycles = f64::from_le_bytes(self.read()?);
        let mut said = vec![0; u32::from_le_bytes(self.read()?) as usize];
        self.answers.read_exact(&mut said)?;
        self.answers.read_exact(&mut self.data)?;
        self.moved = moved;
        self.cycles = cycles as u64;
        self.serial.extend(&said);
        Ok((how, said, place))
    }

    fn read<const N: usize>(&mut self) -> io::Result<[u8; N]> {
        let mut bytes = [0; N];
        self.answers.read_exact(&mut bytes)?;
        Ok(bytes)
    }
}

impl Drop for Avr8js {
    fn drop(&mut self) {
        // It may have ended already, and then there is nothing to do.
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Simulated for Avr8js {
    fn powered(
        program: &Program,
        image: Vec<u8>,
        before: Option<Avr8js>,
    ) -> Result<Avr8js, EngineError> {
        let mut board = match before {
            Some(board) => board,
            None => Avr8js::new(program)?,
        };
        board.insert_and_start(&image);
        Ok(board)
    }

    fn cut_power(&mut self) {
        self.request(request::POWER, &[]);
        self.forget();
    }

    fn cycles(&self) -> u64 {
        self.cycles
    }

    fn run_cycles(&mut self, cycles: u64) -> Result<(), Halt> {
        self.run(NOWHERE, cycles).map(drop)
    }

    fn run_until(&mut self, address: u32, max_cycles: u64) -> Result<(), Halt> {
        self.run(address, max_cycles).map(drop)
    }

    fn stop_clock(&mut self) {
        self.write(TIMSK1, &[0]);
    }

    fn read_ram(&self, address: u32, len: usize) -> Result<&[u8], Error> {
        let at = address as usize;
        self.data.get(at..at + len).ok_or(Error::OutOfRange {
            memory: "RAM",
            address,
            len,
        })
    }

    fn write_ram(&mut self, address: u32, bytes: &[u8]) -> Result<(), Error> {
        let (at, len) = (address as usize, bytes.len());
        let ram = self.program.chip().ram_start();
        let cells = self.data.get_mut(at..at + len).filter(|_| address >= ram);
        let cells = cells.ok_or(Error::OutOfRange {
            memory: "RAM",
            address,
            len,
        })?;
        cells.copy_from_slice(bytes);
        self.write(address as u16, bytes);
        Ok(())
    }

    fn set_inputs(&mut self, closed: u32) {
        self.request(request::INPUTS, &[&closed.to_le_bytes()]);
    }

    fn set_reading(&mut self, index: usize, reading: u16) {
        self.request(request::ANALOGUE, &[&[index as u8], &reading.to_le_bytes()]);
    }

    fn send_serial(&mut self, bytes: &[u8]) {
        self.request(request::SEND, &[&(bytes.len() as u16).to_le_bytes(), bytes]);
    }

    fn serial(&self) -> &[u8] {
        &self.serial
    }

    fn take_serial(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.serial)
    }

    fn outputs(&self) -> u32 {
        Levels::of_data(self.program.chip(), &self.data).outputs
    }

    fn moved_output(&self) -> Option<u8> {
        (self.moved != 0).then(|| self.moved.trailing_zeros() as u8)
    }

    fn pwm(&self, index: usize) -> Option<Pwm> {
        let pwm = match (self.program.chip(), index) {
            (Chip::Atmega2560, _) => Pwm::of_mega(&self.data, index),
            (Chip::Atmega328p, 0) => Pwm::of_timer_0(&self.data),
            (Chip::Atmega328p, 3) => Pwm::of_timer_1(&self.data),
            _ => None,
        };
        let driven = Levels::of_data(self.program.chip(), &self.data).is_output;
        pwm.filter(|_| driven >> index & 1 == 1)
    }
}
