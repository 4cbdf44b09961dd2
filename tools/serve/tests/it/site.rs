//! A gateway of two boards, and what asks it over Modbus TCP.

use crate::common::pages;
use crate::simulated::{Simulated, kept};
use std::future::pending;
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::thread;
use unoclp_alarm::Alarms;
use unoclp_client::diagnostics::Kept;
use unoclp_history::{Failure, Query, Row};
use unoclp_modbus::Table;
use unoclp_modbus::map::Width;
use unoclp_record::Record;
use unoclp_serve::{
    Guard, Keep, Line, Metric, Metrics, Modbus, Orders, Past, Server, SharedBoard, Sharing, Tell,
    Watched,
};
use unoclp_site::{Grant, Kind, Panel, Place};

/// A gateway of two boards at one line, whose addresses are 3 and 4, and whose units are 1 and 2.
pub struct Site {
    pub boards: Simulated,
    pub page: SocketAddr,
    pub modbus: SocketAddr,
    pub orders: Orders,
    /// None where the site has none.
    pub alarms: Option<Arc<Alarms>>,
    pub record: Option<Arc<Record>>,
}

/// What a site has beside its boards.
#[derive(Default)]
pub struct More {
    pub guard: Option<Guard>,
    pub alarms: Option<Arc<Alarms>>,
    pub record: Option<Arc<Record>>,
    pub panels: Vec<Panel>,
}

pub const LISTEN: &str = "127.0.0.1:0";

impl Site {
    pub fn new(write: Vec<Grant>) -> Site {
        let boards = Simulated::at(&[3, 4]);
        let lines = Line::begin_shared(boards.clone(), &[3, 4]);
        Site::of(boards, lines, write, None, None)
    }

    /// The same with users, alarms and a record.
    pub fn with(write: Vec<Grant>, more: More) -> Site {
        let boards = Simulated::at(&[3, 4]);
        let lines = Line::begin_shared(boards.clone(), &[3, 4]);
        Site::all(boards, lines, write, None, None, more)
    }

    pub fn of(
        boards: Simulated,
        lines: Vec<Line>,
        write: Vec<Grant>,
        tell: Option<Tell>,
        keep: Option<(Watched, Keep)>,
    ) -> Site {
        Site::all(boards, lines, write, tell, keep, More::default())
    }

    fn all(
        boards: Simulated,
        lines: Vec<Line>,
        write: Vec<Grant>,
        tell: Option<Tell>,
        keep: Option<(Watched, Keep)>,
        more: More,
    ) -> Site {
        let More {
            guard,
            alarms,
            record,
            panels,
        } = more;
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
            guard: guard.unwrap_or(Guard::ThisPc),
            modbus: Some(bound),
            orders: Some(ordered),
            metrics: Some(numbers()),
            past: Some(Arc::new(Seconds)),
            alarms: alarms.clone(),
            panels,
            record: record.clone(),
            keep,
            tell,
        };
        thread::spawn(move || server.run(pages, Some(sharing), pending()).unwrap());
        let site = Site {
            boards,
            page,
            modbus,
            orders,
            alarms,
            record,
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

    /// The answer to a request, both as function and what is after it.
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

/// The numbers of what follows.
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

/// What was kept: a point that counts the seconds, from 1970 on; and one that nobody can read.
struct Seconds;

impl Past for Seconds {
    fn points(&self) -> Result<Vec<(String, String)>, Failure> {
        Ok(vec![
            ("one".into(), "count".into()),
            ("one".into(), "broken".into()),
        ])
    }

    fn rows(&self, query: &Query) -> Result<Vec<Row>, Failure> {
        if query.point == "broken" {
            return Err(Failure::Busy);
        }
        let step = query.step.max(1_000);
        let is_known = (&*query.board, &*query.point) == ("one", "count");
        let first = query.from.max(0).div_euclid(step) * step;
        let moments = (0..).map(|row| first + row * step);
        let rows = moments.take_while(|at| is_known && *at < query.to.min(100_000));
        let value = |at: i64| Some((at / 1_000) as f64);
        let row = |at| Row {
            at,
            least: value(at),
            most: value(at + step - 1_000),
            last: value(at + step - 1_000).filter(|last| *last != 5.0),
        };
        Ok(rows.map(row).take(query.most).collect())
    }
}
