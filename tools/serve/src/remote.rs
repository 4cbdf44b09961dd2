//! A line that is a Modbus TCP server: a gateway of another maker, or another `unoclp serve`.
//!
//! Owns one connection, made again where it fails, and which answer belongs to which request. Must not know what is asked.

use crate::modbus::frame::{self, HEAD, Head};
use crate::owner::{Board, NoAnswer};
use std::io::{self, BufReader, ErrorKind, Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;
use unoclp_client::Failure;
use unoclp_client::identity::Identity;
use unoclp_client::start::{NotFound, judged};
use unoclp_modbus::Exception;
use unoclp_modbus::client::{NoReply, Request};

/// How long a connection or an answer is waited for,
const ANSWER: Duration = Duration::from_secs(2);
/// and the answer to what changes something: to store a program takes a board seconds.
const STORE: Duration = Duration::from_secs(8);

/// Boards behind a Modbus TCP server.
#[derive(Debug)]
pub struct Remote {
    server: String,
    stream: Option<BufReader<TcpStream>>,
    /// How long an answer is waited for at present.
    patience: Duration,
    transaction: u16,
    told: fn(&str, Absent) -> String,
}

/// Why a board is not behind a server.
#[derive(Debug)]
pub enum Absent {
    /// The server is not reached.
    Unreached(io::Error),
    /// There is no answer from the board.
    Silent(u8),
    /// Something else answers; with what it says that it is, if it says so.
    Foreign(Option<Identity>),
}

impl Remote {
    /// The boards behind the server at this host and port; `told` puts into words why one is not there.
    pub fn new(server: String, told: fn(&str, Absent) -> String) -> Remote {
        Remote {
            server,
            stream: None,
            patience: ANSWER,
            transaction: 0,
            told,
        }
    }

    fn seek(&mut self, address: u8) -> Result<(), Absent> {
        self.connect().map_err(Absent::Unreached)?;
        let request = Request::identify(address);
        let reply = match self.exchange(&request) {
            Ok(reply) => reply,
            Err(error) if error.kind() == ErrorKind::TimedOut => {
                return Err(Absent::Silent(address));
            }
            Err(error) => return Err(Absent::Unreached(error)),
        };
        let identity = match request.answer(&reply) {
            Some(Ok(reply)) => Identity::of(reply.texts()).ok_or(Failure::Garbled),
            Some(Err(NoReply::Refused(exception))) if is_silence(exception) => Err(Failure::Silent),
            Some(Err(NoReply::Refused(exception))) => Err(Failure::Refused(exception)),
            Some(Err(NoReply::Garbled)) | None => Err(Failure::Silent),
        };
        judged(identity).map(drop).map_err(|why| match why {
            NotFound::Silent => Absent::Silent(address),
            NotFound::Foreign(foreign) => Absent::Foreign(foreign),
            NotFound::Garbled | NotFound::Failed(_) => Absent::Foreign(None),
        })
    }

    fn connect(&mut self) -> io::Result<&mut BufReader<TcpStream>> {
        if self.stream.is_none() {
            let mut outcome = Err(ErrorKind::NotFound.into());
            for address in self.server.to_socket_addrs()? {
                outcome = TcpStream::connect_timeout(&address, ANSWER);
                if outcome.is_ok() {
                    break;
                }
            }
            let stream = outcome?;
            stream.set_nodelay(true)?;
            stream.set_write_timeout(Some(ANSWER))?;
            stream.set_read_timeout(Some(ANSWER))?;
            self.patience = ANSWER;
            self.stream = Some(BufReader::with_capacity(512, stream));
        }
        self.stream.as_mut().ok_or(ErrorKind::NotConnected.into())
    }

    /// The answer to a request. Where that fails the connection is given up: what is left of an answer would be taken for
    /// the next one.
    fn exchange(&mut self, request: &Request) -> io::Result<Vec<u8>> {
        let answered = self.on_this_connection(request);
        if answered.is_err() {
            self.stream = None;
        }
        answered.map_err(|error| match error.kind() {
            // As Unix calls it.
            ErrorKind::WouldBlock => ErrorKind::TimedOut.into(),
            _ => error,
        })
    }

    fn on_this_connection(&mut self, request: &Request) -> io::Result<Vec<u8>> {
        self.transaction = self.transaction.wrapping_add(1);
        let transaction = self.transaction;
        let patience = match request.only_reads() {
            true => ANSWER,
            false => STORE,
        };
        self.connect()?;
        let is_other = std::mem::replace(&mut self.patience, patience) != patience;
        let stream = self.connect()?;
        if is_other {
            stream.get_ref().set_read_timeout(Some(patience))?;
        }
        let sent = Head::new(transaction, request.server());
        stream
            .get_mut()
            .write_all(&sent.frame(&frame::from_board(request.bytes())))?;
        let mut head = [0; HEAD];
        stream.read_exact(&mut head)?;
        let head = Head::of(head).ok_or(ErrorKind::InvalidData)?;
        let mut answer = vec![0; head.length];
        stream.read_exact(&mut answer)?;
        if !head.answers(sent) {
            return Err(ErrorKind::InvalidData.into());
        }
        Ok(frame::of_board(request.server(), &answer))
    }
}

impl Board for Remote {
    fn find(&mut self, address: u8) -> Result<(), String> {
        self.seek(address)
            .map_err(|why| (self.told)(&self.server, why))
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        match self.exchange(request) {
            Ok(reply) => match request.answer(&reply) {
                Some(Err(NoReply::Refused(exception))) if is_silence(exception) => {
                    Err(NoAnswer::Silent)
                }
                _ => Ok(reply),
            },
            Err(error) if error.kind() == ErrorKind::TimedOut => Err(NoAnswer::Silent),
            Err(error) => {
                let why = (self.told)(&self.server, Absent::Unreached(error));
                Err(NoAnswer::Gone(why))
            }
        }
    }
}

/// Whether a gateway says by this that nobody answers behind it.
fn is_silence(exception: Exception) -> bool {
    matches!(
        exception,
        Exception::GatewayTargetSilent | Exception::GatewayPathUnavailable
    )
}
