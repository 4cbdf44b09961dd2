//! A server on a free port of this PC, and what visits it.

use std::borrow::Cow;
use std::future::pending;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;
use tungstenite::client::IntoClientRequest;
use tungstenite::protocol::CloseFrame;
use tungstenite::{Error, Message, WebSocket};
use unoclp_modbus::client::Request;
use unoclp_modbus::{Crc, Table};
use unoclp_serve::{Board, Guard, Line, NoAnswer, Server, SharedBoard, Sharing, Tokens};

/// A board in memory: its holding registers, and whether it is there.
#[derive(Clone)]
pub struct Memory(pub Arc<Mutex<State>>);

/// What it holds.
pub struct State {
    /// 7 where nothing was written, and 0 from the commands on.
    pub words: Vec<u16>,
    /// Where was written, and what.
    pub writes: Vec<(u16, Vec<u16>)>,
    pub is_there: bool,
    pub answers: bool,
}

impl Memory {
    pub fn new() -> Memory {
        Memory(Arc::new(Mutex::new(State {
            words: (0..1200).map(|at| if at < 400 { 7 } else { 0 }).collect(),
            writes: Vec::new(),
            is_there: true,
            answers: true,
        })))
    }
}

impl Board for Memory {
    fn find(&mut self, _: u8) -> Result<(), String> {
        match self.0.lock().unwrap().is_there {
            true => Ok(()),
            false => Err("unplugged".into()),
        }
    }

    fn ask(&mut self, request: &Request) -> Result<Vec<u8>, NoAnswer> {
        let mut state = self.0.lock().unwrap();
        if !state.is_there {
            return Err(NoAnswer::Gone("unplugged".into()));
        }
        if !state.answers {
            return Err(NoAnswer::Silent);
        }
        let frame = request.bytes();
        let word = |at: usize| u16::from_be_bytes([frame[at], frame[at + 1]]);
        let (first, second) = (usize::from(word(2)), word(4));
        let mut reply = frame[..2].to_vec();
        if matches!(frame[1], 6 | 16) {
            let written: Vec<u16> = match frame[1] {
                6 => vec![second],
                _ => (0..second.into()).map(|at| word(7 + 2 * at)).collect(),
            };
            state.words[first..][..written.len()].copy_from_slice(&written);
            state.writes.push((word(2), written));
            reply.extend(&frame[2..6]);
        } else {
            let words = &state.words[first..][..second.into()];
            reply.push(2 * second as u8);
            reply.extend(words.iter().flat_map(|word| word.to_be_bytes()));
        }
        reply.extend(Crc::of(&reply).to_bytes());
        Ok(reply)
    }
}

/// A page of two files.
pub fn pages(path: &str) -> Option<Cow<'static, [u8]>> {
    match path {
        "index.html" => Some(b"<!doctype html><html><head><title>x</title></head></html>".into()),
        "app.js" => Some(b"1".into()),
        "unoclp.wasm" => Some(b"\0asm".into()),
        "large.wasm" => Some((&[0; 1 << 20]).into()),
        _ => None,
    }
}

/// The tokens of a server that asks for some.
pub fn tokens() -> Tokens {
    Tokens {
        watch: "w".repeat(32),
        control: "c".repeat(32),
    }
}

/// Begins a server, which ends with the tests.
pub fn serve(board: Option<Memory>, tokens: Option<Tokens>) -> SocketAddr {
    let server = Server::bind("127.0.0.1:0".parse().unwrap()).unwrap();
    let address = server.address();
    let sharing = board.map(|board| Sharing {
        boards: vec![SharedBoard {
            line: Line::begin(board, 1),
            name: "tty0".into(),
            unit: 1,
            program: None,
            watched: None,
        }],
        guard: tokens.map_or(Guard::ThisPc, Guard::Tokens),
        modbus: None,
        orders: None,
        metrics: None,
        past: None,
        alarms: None,
        panels: Vec::new(),
        record: None,
        keep: None,
        tell: None,
    });
    thread::spawn(move || server.run(pages, sharing, pending()).unwrap());
    address
}

/// The answer to a request over HTTP, whose head ends with these lines.
pub fn http(address: SocketAddr, path: &str, head: &str) -> String {
    said(
        address,
        &format!("GET {path} HTTP/1.1\r\n{head}Connection: close\r\n\r\n"),
    )
}

/// The same of one that brings something.
pub fn post(address: SocketAddr, path: &str, head: &str, body: &str) -> String {
    let length = body.len();
    let head = format!("{head}Content-Length: {length}\r\nConnection: close\r\n\r\n");
    said(address, &format!("POST {path} HTTP/1.1\r\n{head}{body}"))
}

fn said(address: SocketAddr, request: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.write_all(request.as_bytes()).unwrap();
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).unwrap();
    String::from_utf8_lossy(&answer).into_owned()
}

/// A visitor of the board.
pub struct Visitor(pub WebSocket<TcpStream>);

impl Visitor {
    /// One that has said nothing yet.
    pub fn silent(address: SocketAddr) -> Visitor {
        Visitor::silent_at(address, "/line")
    }

    /// The same at this path.
    fn silent_at(address: SocketAddr, path: &str) -> Visitor {
        let request = format!("ws://{address}{path}")
            .into_client_request()
            .unwrap();
        let stream = TcpStream::connect(address).unwrap();
        Visitor(tungstenite::client(request, stream).unwrap().0)
    }

    /// One with this token, and what it is told.
    pub fn new(address: SocketAddr, token: &str) -> (Visitor, String) {
        Visitor::new_at(address, "/line", token)
    }

    /// The same at this path.
    pub fn new_at(address: SocketAddr, path: &str, token: &str) -> (Visitor, String) {
        let mut visitor = Visitor::silent_at(address, path);
        visitor.send(token);
        let told = visitor.text();
        (visitor, told)
    }

    /// One whose board is there.
    pub fn at_board(address: SocketAddr, token: &str) -> Visitor {
        Visitor::at(address, "/line", token)
    }

    /// The same at this path.
    pub fn at(address: SocketAddr, path: &str, token: &str) -> Visitor {
        let (mut visitor, _) = Visitor::new_at(address, path, token);
        while visitor.text() != r#"{"board":true}"# {}
        visitor
    }

    /// Sends a text.
    pub fn send(&mut self, text: &str) {
        self.0.send(Message::text(text)).unwrap();
    }

    /// The next text.
    pub fn text(&mut self) -> String {
        loop {
            match self.0.read().unwrap() {
                Message::Text(text) => return text.to_string(),
                Message::Ping(_) | Message::Pong(_) => {}
                other => panic!("{other:?}"),
            }
        }
    }

    /// Sends a request; gives the answer without its checksum.
    pub fn ask(&mut self, request: &Request) -> Vec<u8> {
        let frame = request.bytes().to_vec();
        self.0.send(Message::binary(frame)).unwrap();
        loop {
            match self.0.read().unwrap() {
                Message::Binary(answer) => {
                    assert_eq!(Crc::of(&answer).value(), 0);
                    return answer[..answer.len() - 2].to_vec();
                }
                Message::Text(_) | Message::Ping(_) => {}
                other => panic!("{other:?}"),
            }
        }
    }

    /// Why it was sent away.
    pub fn farewell(mut self) -> String {
        loop {
            match self.0.read() {
                Ok(Message::Close(Some(CloseFrame { reason, .. }))) => return reason.to_string(),
                Ok(_) => {}
                Err(Error::ConnectionClosed | Error::Io(_) | Error::Protocol(_)) => {
                    return "closed".into();
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
}

/// Reads so many holding registers from 0 on.
pub fn read(count: u16) -> Request {
    Request::read(1, Table::HoldingRegisters, 0, count)
}
