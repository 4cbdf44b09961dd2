//! Boards that are read again and again.

use crate::common::{Memory, http, serve, tokens};
use crate::simulated::{Simulated, kept};
use crate::site::Site;
use std::sync::mpsc::{self, Receiver};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use unoclp_modbus::Table;
use unoclp_modbus::map::Width;
use unoclp_serve::{Change, Keep, Line, Watched};
use unoclp_site::{Kind, Place, Point, Points};

fn point(name: &str, kind: Kind, table: Table, first: u16, width: Width) -> Point {
    Point {
        name: name.into(),
        kind,
        read: Place {
            table,
            first,
            width,
        },
        write: Vec::new(),
    }
}

/// The program of board one, and what it names.
fn points() -> Points {
    let registers = Table::HoldingRegisters;
    Points {
        board: unoclp_core::Board::UNO,
        program: Some(kept(3)),
        named: vec![
            point(
                "start",
                Kind::Unsigned,
                Table::DiscreteInputs,
                1,
                Width::Bit,
            ),
            point("count", Kind::Signed, registers, 2000, Width::Long),
            point("level", Kind::Real, registers, 2194, Width::Long),
        ],
    }
}

/// A site whose board one is watched, and its changes.
fn watched() -> (Site, Receiver<Change>) {
    let (send, changes) = mpsc::channel();
    let send = Mutex::new(send);
    let keep: Keep = Arc::new(move |changes| {
        for change in changes {
            // After the end of the test nobody listens.
            let _ = send.lock().unwrap().send(change);
        }
    });
    let boards = Simulated::at(&[3, 4]);
    let lines = Line::begin_shared(boards.clone(), &[3, 4]);
    let watched = Watched {
        points: points(),
        every: Duration::from_millis(10),
    };
    let site = Site::of(boards, lines, Vec::new(), None, Some((watched, keep)));
    (site, changes)
}

/// The value of the next change, which is one of this point.
fn next(changes: &Receiver<Change>, point: &str) -> Option<f64> {
    let change = changes.recv().unwrap();
    assert_eq!((&*change.board, &*change.point), ("one", point));
    change.value
}

#[test]
fn changes_are_told_by_name_and_in_their_type() {
    let (site, changes) = watched();
    for name in ["count", "level", "start"] {
        assert_eq!(next(&changes, name), Some(0.0));
    }
    site.boards.board(3).inputs = 2;
    assert_eq!(next(&changes, "start"), Some(1.0));
    let set = |first: u16, bits: u32| {
        let mut board = site.boards.board(3);
        let table = Table::HoldingRegisters as u16;
        board.words.insert((table, first), (bits >> 16) as u16);
        board.words.insert((table, first + 1), bits as u16);
    };
    set(2000, (-5_i32).cast_unsigned());
    assert_eq!(next(&changes, "count"), Some(-5.0));
    set(2194, 12.5_f32.to_bits());
    assert_eq!(next(&changes, "level"), Some(12.5));
}

#[test]
fn other_programs_read_boards_and_points() {
    let (site, changes) = watched();
    for name in ["count", "level", "start"] {
        assert_eq!(next(&changes, name), Some(0.0));
    }
    let host = format!("Host: {}\r\n", site.page);
    let get = |path: &str| {
        let answer = http(site.page, path, &host);
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        (head.to_owned(), body.to_owned())
    };
    let (head, body) = get("/health");
    assert!(
        head.starts_with("HTTP/1.1 200 OK") && head.contains("application/json"),
        "{head}"
    );
    assert_eq!(body, r#"{"boards":2,"up":2}"#);
    let (_, body) = get("/api/boards");
    let one = r#"{"name":"one","up":true,"doing":"RUN","forced":false,"points":{"count":0.0,"level":0.0,"start":0.0}}"#;
    assert_eq!(
        body,
        format!(r#"[{one},{{"name":"two","up":true,"forced":false,"points":{{}}}}]"#)
    );
    site.boards.board(3).inputs = 2;
    assert_eq!(next(&changes, "start"), Some(1.0));
    let (head, body) = get("/metrics");
    assert!(head.contains("text/plain; version=0.0.4"), "{head}");
    for line in [
        "# TYPE unoclp_board_up gauge",
        "unoclp_board_up{board=\"one\"} 1",
        "unoclp_point{board=\"one\",point=\"start\"} 1",
        "# HELP unoclp_rows_total Rows",
        "# TYPE unoclp_rows_total counter",
        "unoclp_rows_total 7",
    ] {
        assert!(body.lines().any(|of| of == line), "{line}\n{body}");
    }
    site.boards.unplug(true);
    for name in ["count", "level", "start"] {
        assert_eq!(next(&changes, name), None);
    }
    let (_, body) = get("/api/boards");
    assert!(
        body.contains(
            r#""up":false,"why":"unplugged","forced":false,"points":{"count":null,"level":null,"start":null}"#
        ),
        "{body}"
    );
    assert!(!get("/metrics").1.contains("unoclp_point{"));
}

#[test]
fn in_a_network_other_programs_show_a_token() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    let get = |path: &str, more: &str| {
        let answer = http(address, path, &format!("Host: {address}\r\n{more}"));
        answer.split(' ').nth(1).unwrap().to_owned()
    };
    let with = |token: &str| format!("Authorization: Bearer {token}\r\n");
    for path in [
        "/health",
        "/metrics",
        "/api/boards",
        "/api/history?board=one&point=count",
        "/api/history.csv?board=one&point=count",
        "/api/openapi.json",
    ] {
        assert_eq!(get(path, ""), "401", "{path}");
        assert_eq!(get(path, &with("x")), "401");
        // This site keeps no history.
        let there = if path.contains("history") {
            "404"
        } else {
            "200"
        };
        assert_eq!(get(path, &with(&tokens().watch)), there);
        assert_eq!(get(path, &with(&tokens().control)), there);
        assert_eq!(get(path, "Origin: http://evil.example\r\n"), "403");
    }
    let alone = serve(None, None);
    let answer = http(alone, "/metrics", &format!("Host: {alone}\r\n"));
    assert!(
        answer.starts_with("HTTP/1.1 404"),
        "nothing is shared: {answer}"
    );
}

#[test]
fn what_is_away_is_not_known_until_it_is_back() {
    let (site, changes) = watched();
    let names = ["count", "level", "start"];
    for name in names {
        assert_eq!(next(&changes, name), Some(0.0));
    }
    site.boards.unplug(true);
    for name in names {
        assert_eq!(next(&changes, name), None);
    }
    site.boards.unplug(false);
    for name in names {
        assert_eq!(next(&changes, name), Some(0.0));
    }
}

#[test]
fn names_of_a_program_that_the_board_no_longer_keeps_are_not_known() {
    let (site, changes) = watched();
    let names = ["count", "level", "start"];
    for name in names {
        assert_eq!(next(&changes, name), Some(0.0));
    }
    site.boards.board(3).kept.sum += 1;
    for name in names {
        assert_eq!(next(&changes, name), None);
    }
    // Points have their own names now.
    let own: Vec<Change> = (0..17).map(|_| changes.recv().unwrap()).collect();
    assert_eq!(own[0].point, "A0");
    assert_eq!(own[16].point, "Q4");
    site.boards.board(3).kept.sum -= 1;
    let mut back = Vec::new();
    while back.len() < 3 {
        let change = changes.recv().unwrap();
        if change.value.is_some() {
            back.push(change.point);
        }
    }
    assert_eq!(back, names);
}
