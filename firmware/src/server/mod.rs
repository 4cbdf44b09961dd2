//! The Modbus server: a slice of a request between two scans, and what it may see and change.
//!
//! Owns the way of a request from the serial port and back (`docs/modbus.md`); must not know how bytes are
//! moved, or what a program is. [`map`] says what an address stands for, [`upload`] takes a program.

mod map;
pub mod upload;

use crate::board::{Board, clock};
use crate::engine::memory::Memory;
use crate::scan::ScanTimes;
use crate::settings::Settings;
use crate::state::Images;
use map::Map;
use unoclp_core::{Fault, Image, Millis};
use unoclp_modbus::{Answer, Exception, Exchange, Frame, begin, refuse};
use upload::Upload;

/// Words, or bytes of 8 bits, that are done between two scans: under 0.3 ms.
pub const SLICE: u8 = 4;
/// Where no scan waits, a request is done at once.
pub const AT_ONCE: u8 = u8::MAX;

/// What the board is doing; the numbers are those of the map.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum State {
    Run = 1,
    Stop = 2,
    Fault = 3,
}

/// What is to be done once a request has been answered; the numbers are those of the map.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Command {
    Run = 1,
    Stop = 2,
    SingleScan = 3,
    Restart = 4,
    Upload = 5,
}

/// Points that are forced, and to what: inputs, values of inputs, outputs, values of outputs, as the map has
/// them; bit 0 is point 01.
#[derive(Clone, Copy, Default)]
pub struct Forces(pub [u8; 4]);

impl Forces {
    /// Whether there are any.
    #[inline(always)]
    pub fn any(self) -> bool {
        let [inputs, _, outputs, _] = self.0;
        inputs | outputs != 0
    }

    /// The input image with the forced inputs as they are forced.
    #[inline(always)]
    pub fn inputs(self, image: Image) -> Image {
        let [points, values, ..] = self.0;
        Image((image.0 as u8 & !points | values & points).into())
    }

    /// Which outputs are forced, bit 0 output 01.
    pub fn forced_outputs(self) -> u8 {
        let [.., outputs, _] = self.0;
        outputs
    }

    /// The same of the output image.
    #[inline(always)]
    pub fn outputs(self, image: Image) -> Image {
        let [.., points, values] = self.0;
        Image((image.0 as u8 & !points | values & points).into())
    }
}

/// What the server sees and changes of the board's operation.
pub struct Panel {
    /// What the board is doing.
    pub state: State,
    /// STOP by command.
    pub stopped: bool,
    /// An upload is under way.
    pub uploading: bool,
    /// What was commanded and has not been done.
    pub command: Option<Command>,
    /// The fault that there is, or that of the last upload.
    pub fault: Option<Fault>,
    /// The card has failed; the state is no longer kept.
    pub card_failed: bool,
    /// What is forced.
    pub forces: Forces,
    /// As the last scan left them.
    pub images: Images,
    /// How long scans take.
    pub times: ScanTimes,
    /// The settings that are kept.
    pub settings: Settings,
    /// When the request came that is being done, ms since start: two words of one time belong together.
    pub now: Millis,
}

impl Panel {
    /// Takes this command, if it is the one that was given.
    pub fn takes(&mut self, command: Command) -> bool {
        let given = self.command == Some(command);
        if given {
            self.command = None;
        }
        given
    }
}

/// The server.
pub struct Server {
    frame: &'static mut Frame,
    /// The request that is being done.
    exchange: Option<Exchange>,
    /// What it sees and changes.
    pub panel: Panel,
}

impl Server {
    /// A server with this memory for its frames, before the first scan.
    // Apart from who makes it, whose frame is large.
    #[inline(never)]
    pub fn new(frame: &'static mut Frame, settings: Settings) -> Server {
        Server {
            frame,
            exchange: None,
            panel: Panel {
                state: State::Stop,
                stopped: false,
                uploading: false,
                command: None,
                fault: None,
                card_failed: false,
                forces: Forces::default(),
                images: Images::default(),
                times: ScanTimes::default(),
                settings,
                now: 0,
            },
        }
    }

    /// From now on the serial port serves.
    pub fn start(&mut self, board: &Board) {
        board.serial.serve(&mut self.frame);
    }

    /// Answers the request that is being done by an exception.
    fn refuse(&mut self, board: &Board, exception: Exception) {
        self.exchange = None;
        board.serial.send(refuse(self.frame, exception));
    }

    /// Does at most one thing: takes a request that has come, or does a slice of it, or answers. `most`
    /// is the size of a slice. Where an upload is under way it comes along.
    #[inline(never)]
    pub fn step(
        &mut self,
        board: &Board,
        memory: Memory<'_>,
        upload: Option<&mut Upload<'_>>,
        most: u8,
    ) {
        let mut map = Map {
            board,
            panel: &mut self.panel,
            memory,
            upload,
        };
        let length = match &mut self.exchange {
            Some(exchange) => {
                let Some(length) = exchange.fill(self.frame, &mut map, most) else {
                    return;
                };
                self.exchange = None;
                length
            }
            None => {
                let Some(length) = board.serial.received(self.frame) else {
                    return;
                };
                map.panel.now = clock::now();
                match begin(self.frame, length, &mut map) {
                    Answer::Silence => 0,
                    Answer::Ready(length) => length,
                    Answer::Filling(exchange) => {
                        self.exchange = Some(exchange);
                        return;
                    }
                }
            }
        };
        board.serial.send(length);
        if self.panel.command == Some(Command::Restart) {
            board.restart();
        }
    }
}
