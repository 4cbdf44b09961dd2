//! Requests to a board, and their answers.
//!
//! Frames and check sums are those of the crate `rmodbus`; of an answer only address, function and length are
//! looked at here, which it leaves open.

use crate::identity::{self, Identity};
use crate::port::{self, Line, NotOpened};
use rmodbus::client::ModbusRequest;
use rmodbus::{ErrorKind, ModbusProto, guess_response_frame_len};
use serialport::{ClearBuffer, SerialPort};
use std::io::{self, Read, Write};
use std::thread;
use std::time::{Duration, Instant};
use unoclp_modbus::{Crc, Exception};

/// How long to wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// For an answer, besides the time that its bytes take on the line.
    pub answer: Duration,
    /// How often a request is sent until it is answered.
    pub attempts: u32,
    /// For a board from its reset on: boot loader, card and program memory take their time.
    pub start: Duration,
    /// For the answer to the end of an upload, while which the program is stored.
    pub store: Duration,
}

impl Default for Patience {
    fn default() -> Patience {
        Patience {
            answer: Duration::from_secs(1),
            attempts: 3,
            start: Duration::from_secs(8),
            store: Duration::from_secs(8),
        }
    }
}

/// Why a request has no result.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// Nothing came back.
    #[error("no answer")]
    Silent,
    /// What came back was no answer to it.
    #[error("what comes back is no Modbus; is the rate right?")]
    Garbled,
    /// The board refuses it.
    #[error("refused: {}", refusal(*.0))]
    Refused(Exception),
    /// The port is gone.
    #[error("the port is gone: {0}")]
    Lost(#[from] io::Error),
}

fn refusal(exception: Exception) -> &'static str {
    match exception {
        Exception::IllegalFunction => "no such function (01)",
        Exception::IllegalDataAddress => "no such address (02)",
        Exception::IllegalDataValue => "not that value (03)",
        Exception::ServerDeviceFailure => "not now (04)",
        Exception::ServerDeviceBusy => "busy (06)",
    }
}

/// A table that requests are about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Table {
    /// Coils.
    Coils,
    /// Discrete inputs.
    DiscreteInputs,
    /// Holding registers.
    HoldingRegisters,
    /// Input registers.
    InputRegisters,
}

/// The client of one board.
pub struct Client {
    port: Box<dyn SerialPort>,
    address: u8,
    /// Silence between frames.
    gap: Duration,
    /// The longest request and the longest answer, on the line.
    transit: Duration,
    patience: Patience,
}

impl Client {
    /// Opens the port. Also tells whether that has probably reset an UNO.
    ///
    /// # Errors
    /// Where the port is not there or may not be used.
    pub fn open(line: &Line, patience: Patience) -> Result<(Client, bool), NotOpened> {
        let (port, may_reset) = port::open(line)?;
        let character = Duration::from_secs(11) / line.rate.max(1);
        let client = Client {
            port,
            address: line.address,
            gap: (character * 4).max(Duration::from_millis(2)),
            transit: character * 512,
            patience,
        };
        Ok((client, may_reset))
    }

    /// How long it waits.
    pub fn patience(&self) -> Patience {
        self.patience
    }

    /// Reads bits.
    ///
    /// # Errors
    /// As for every request: [`Failure`].
    pub fn bits(&mut self, table: Table, first: u16, count: u16) -> Result<Vec<bool>, Failure> {
        let (mut modbus, mut request) = self.request();
        let generated = match table {
            Table::Coils => modbus.generate_get_coils(first, count, &mut request),
            _ => modbus.generate_get_discretes(first, count, &mut request),
        };
        generated.map_err(own)?;
        let reply = self.exchange(&request, Some(count.div_ceil(8)))?;
        let mut bits = Vec::new();
        modbus.parse_bool(&reply, &mut bits).map_err(own)?;
        Ok(bits)
    }

    /// Reads words.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn words(&mut self, table: Table, first: u16, count: u16) -> Result<Vec<u16>, Failure> {
        let (mut modbus, mut request) = self.request();
        let generated = match table {
            Table::InputRegisters => modbus.generate_get_inputs(first, count, &mut request),
            _ => modbus.generate_get_holdings(first, count, &mut request),
        };
        generated.map_err(own)?;
        let reply = self.exchange(&request, Some(2 * count))?;
        let mut words = Vec::new();
        modbus.parse_u16(&reply, &mut words).map_err(own)?;
        Ok(words)
    }

    /// Writes a holding register.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn set_word(&mut self, address: u16, value: u16) -> Result<(), Failure> {
        let (mut modbus, mut request) = self.request();
        modbus
            .generate_set_holding(address, value, &mut request)
            .map_err(own)?;
        self.exchange(&request, None).map(drop)
    }

    /// Writes several holding registers, at most 123.
    ///
    /// # Errors
    /// [`Failure`].
    pub fn set_words(&mut self, first: u16, values: &[u16]) -> Result<(), Failure> {
        let (mut modbus, mut request) = self.request();
        modbus
            .generate_set_holdings_bulk(first, values, &mut request)
            .map_err(own)?;
        self.exchange(&request, None).map(drop)
    }

    /// Likewise, where the answer may take longer.
    pub(crate) fn set_words_within(
        &mut self,
        answer: Duration,
        first: u16,
        values: &[u16],
    ) -> Result<(), Failure> {
        let usual = std::mem::replace(&mut self.patience.answer, answer);
        let outcome = self.set_words(first, values);
        self.patience.answer = usual;
        outcome
    }

    /// Asks what the board is.
    ///
    /// # Errors
    /// [`Failure`]; [`Failure::Garbled`] too for an identification without vendor, product and version.
    pub fn identify(&mut self) -> Result<Identity, Failure> {
        let request = identity::request(self.address);
        let reply = self.exchange(&request, None)?;
        Identity::of(&reply).ok_or(Failure::Garbled)
    }

    /// What the board says of its own accord, until it has been quiet for so long or has said it all.
    pub(crate) fn listen(
        &mut self,
        quiet: Duration,
        is_all: impl Fn(&[u8]) -> bool,
    ) -> Result<Vec<u8>, Failure> {
        let mut said = Vec::new();
        while !is_all(&said) && self.receive(&mut said, Instant::now() + quiet)? {}
        Ok(said)
    }

    fn request(&self) -> (ModbusRequest, Vec<u8>) {
        let modbus = ModbusRequest::new(self.address, ModbusProto::Rtu);
        (modbus, Vec::new())
    }

    /// Sends a request until it is answered; gives the answer, which holds so many bytes of data where that
    /// is known.
    fn exchange(&mut self, request: &[u8], data: Option<u16>) -> Result<Vec<u8>, Failure> {
        let mut failure = Failure::Silent;
        for _ in 0..self.patience.attempts {
            match self.attempt(request, data) {
                Err(Failure::Silent) => {}
                Err(Failure::Garbled) => failure = Failure::Garbled,
                other => return other,
            }
        }
        Err(failure)
    }

    fn attempt(&mut self, request: &[u8], data: Option<u16>) -> Result<Vec<u8>, Failure> {
        thread::sleep(self.gap);
        // What is late, or was never meant for us.
        self.port
            .clear(ClearBuffer::Input)
            .map_err(io::Error::from)?;
        self.port.write_all(request)?;
        let until = Instant::now() + self.transit + self.patience.answer;
        let mut reply = Vec::new();
        let length = loop {
            match length(&reply) {
                Some(length) if reply.len() >= length => break length,
                _ => {}
            }
            if !self.receive(&mut reply, until)? {
                let nothing = reply.is_empty();
                return Err(if nothing {
                    Failure::Silent
                } else {
                    Failure::Garbled
                });
            }
        };
        let refused = [request[0], request[1] | 0x80];
        let data = data.is_none_or(|data| u16::from(reply[2]) == data);
        let sound = reply.len() == length && Crc::of(&reply).value() == 0;
        if sound && reply[..2] == refused {
            return Err(exception(reply[2]).map_or(Failure::Garbled, Failure::Refused));
        }
        if sound && data && reply[..2] == request[..2] {
            return Ok(reply);
        }
        // The rest of what is no answer is over before the next attempt.
        while self.receive(&mut reply, Instant::now() + self.gap * 8)? {}
        Err(Failure::Garbled)
    }

    /// Takes what has come in; false where nothing comes until then.
    fn receive(&mut self, bytes: &mut Vec<u8>, until: Instant) -> Result<bool, Failure> {
        loop {
            let mut chunk = [0; 256];
            let left = until.saturating_duration_since(Instant::now());
            self.port.set_timeout(left).map_err(io::Error::from)?;
            match self.port.read(&mut chunk) {
                Ok(0) => return Err(io::Error::from(io::ErrorKind::UnexpectedEof).into()),
                Ok(count) => {
                    bytes.extend(&chunk[..count]);
                    return Ok(true);
                }
                Err(error) if error.kind() == io::ErrorKind::TimedOut => return Ok(false),
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error.into()),
            }
        }
    }
}

/// How many bytes an answer that begins so has; none where that is not yet told.
fn length(reply: &[u8]) -> Option<usize> {
    if reply.get(1) == Some(&identity::FUNCTION) {
        return identity::length(reply);
    }
    match guess_response_frame_len(reply, ModbusProto::Rtu) {
        Ok(length) => Some(length.into()),
        // Too little is known; all else is no answer, and as long as it is.
        Err(ErrorKind::OOB) => None,
        Err(_) => Some(reply.len().max(5)),
    }
}

fn exception(code: u8) -> Option<Exception> {
    use Exception::*;
    [
        IllegalFunction,
        IllegalDataAddress,
        IllegalDataValue,
        ServerDeviceFailure,
        ServerDeviceBusy,
    ]
    .into_iter()
    .find(|exception| *exception as u8 == code)
}

/// Of a request within its bounds, and of an answer whose frame has been checked, `rmodbus` has nothing to say.
fn own(_: ErrorKind) -> Failure {
    Failure::Garbled
}
