//! A gateway of two boards, and what asks it over Modbus TCP.

use crate::common::pages;
use crate::simulated::{Simulated, kept};
use std::future::pending;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread;
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::Table;
use unoclp_modbus::map::Width;
use unoclp_serve::{
    Keep, Line, Metric, Metrics, Modbus, Orders, Server, SharedBoard, Sharing, Tell, Watched,
};
use unoclp_site::{Grant, Kind, Place};

/// A gateway of two boards at one line, whose addresses are 3 and 4, and whose units are 1 and 2.
pub struct Site {
    pub boards: Simulated,
    pub page: SocketAddr,
    pub modbus: SocketAddr,
    pub orders: Orders,
}

pub const LISTEN: &str = "127.0.0.1:0";

impl Site {
    pub fn new(write: Vec<Grant>) -> Site {
        let boards = Simulated::at(&[3, 4]);
        let lines = Line::begin_shared(boards.clone(), &[3, 4]);
        Site::of(boards, lines, write, None, None)
    }

    pub fn of(
        boards: Simulated,
        lines: Vec<Line>,
        write: Vec<Grant>,
        tell: Option<Tell>,
        keep: Option<(Watched, Keep)>,
    ) -> Site {
        let (watched, keep) = keep.unzip();
        let (orders, ordered) = Orders::new();
        let server = Server::bind(LISTEN.parse().unwrap()).unwrap();
        let bound = Modbus::bind(LISTEN.parse().unwrap(), write).unwrap();
        let (page, modbus) = (server.address(), bound.address());
        let named = lines.into_iter().zip([("one", 1), ("two", 2)]);
        let shared = named.map(|(line, (name, unit))| SharedBoard {
            line,
            name: name.into(),
            unit,
            program: Some(kept(3)),
            watched: watched.clone().filter(|_| unit == 1),
        });
        let sharing = Sharing {
            boards: shared.collect(),
            tokens: None,
            modbus: Some(bound),
            orders: Some(ordered),
            metrics: Some(numbers()),
            keep,
            tell,
        };
        thread::spawn(move || server.run(pages, Some(sharing), pending()).unwrap());
        let site = Site {
            boards,
            page,
            modbus,
            orders,
        };
        // All of them have been found.
        for unit in [1, 2] {
            while site.ask(unit, &[3, 0, 0, 0, 1])[0] != 3 {}
        }
        site
    }

    pub fn client(&self) -> TcpStream {
        TcpStream::connect(self.modbus).unwrap()
    }

    /// The answer to a request, both as function and what is behind it.
    pub fn ask(&self, unit: u8, request: &[u8]) -> Vec<u8> {
        ask(&mut self.client(), unit, request)
    }
}

pub fn ask(client: &mut TcpStream, unit: u8, request: &[u8]) -> Vec<u8> {
    client.write_all(&frame(unit, request)).unwrap();
    let mut head = [0; 7];
    client.read_exact(&mut head).unwrap();
    let length = u16::from_be_bytes([head[4], head[5]]);
    assert_eq!(head, [9, 7, 0, 0, 0, length as u8, unit]);
    let mut answer = vec![0; usize::from(length) - 1];
    client.read_exact(&mut answer).unwrap();
    answer
}

pub fn frame(unit: u8, request: &[u8]) -> Vec<u8> {
    let mut frame = vec![9, 7, 0, 0, 0, request.len() as u8 + 1, unit];
    frame.extend(request);
    frame
}

/// A grant of unit 1: the register at this address of the rows of D.
pub fn register(first: u16, while_kept: Option<Kept>) -> Grant {
    Grant {
        unit: 1,
        name: "one.x".into(),
        point: "x".into(),
        kind: Kind::Signed,
        places: vec![Place {
            table: Table::HoldingRegisters,
            first,
            width: Width::Long,
        }],
        while_kept,
    }
}

/// The numbers of what stands behind.
fn numbers() -> Metrics {
    std::sync::Arc::new(|| {
        vec![Metric {
            name: "rows_total",
            help: "Rows",
            is_counter: true,
            value: 7,
        }]
    })
}
