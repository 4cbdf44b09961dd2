//! Boards over Modbus TCP: frames that lie, and rights.

use crate::common::Visitor;
use crate::simulated::{Simulated, kept};
use crate::site::{Site, ask, frame, register};
use std::io::{Read, Write};
use unoclp_modbus::client::Request;
use unoclp_modbus::map;
use unoclp_serve::{Line, News, Tell};

#[test]
fn every_span_of_the_map_is_read_of_each_unit() {
    let site = Site::new(Vec::new());
    for (unit, at) in [(1, 3), (2, 4)] {
        site.boards.board(at).outputs = unit.into();
        site.boards.board(at).inputs = 0x80 | u16::from(unit);
        let mut client = site.client();
        for span in map::ALL.iter().filter(|span| span.rights.has_addresses()) {
            let [[a, b], [c, d]] = [span.first, span.addresses().min(100)].map(u16::to_be_bytes);
            let answer = ask(&mut client, unit, &[span.table as u8, a, b, c, d]);
            assert_eq!(answer[0], span.table as u8, "{}: {answer:?}", span.name);
        }
        assert_eq!(ask(&mut client, unit, &[1, 0, 0, 0, 4]), [1, 1, unit]);
        assert_eq!(
            ask(&mut client, unit, &[2, 0, 0, 0, 8]),
            [2, 1, 0x80 | unit]
        );
    }
    assert_eq!(site.ask(3, &[3, 0, 0, 0, 1]), [0x83, 0x0A], "no such unit");
    assert_eq!(
        site.ask(1, &[3, 0xFF, 0xFF, 0, 1]),
        [0x83, 2],
        "the board's own answer"
    );
}

#[test]
fn a_frame_that_lies_ends_its_connection_and_no_other() {
    let site = Site::new(Vec::new());
    let mut other = site.client();
    for head in [
        [0, 1, 0, 0, 0, 0, 1],
        [0, 1, 0, 0, 0, 1, 1],
        [0, 1, 0, 0, 0, 255, 1],
        [0, 1, 0, 0, 0xFF, 0xFF, 1],
        [0, 1, 0, 1, 0, 6, 1],
        *b"GET / H",
    ] {
        let mut client = site.client();
        client.write_all(&head).unwrap();
        let mut rest = Vec::new();
        assert_eq!(client.read_to_end(&mut rest).unwrap(), 0, "{head:?}");
        assert_eq!(ask(&mut other, 2, &[3, 0, 0, 0, 1]), [3, 2, 0, 0]);
    }
    // One that promises more than it sends is not waited for.
    let mut client = site.client();
    client.write_all(&[0, 1, 0, 0, 0, 6, 1, 3]).unwrap();
    assert_eq!(client.read_to_end(&mut Vec::new()).unwrap(), 0);
    // Several requests at once are answered one by one.
    let twice = [frame(1, &[3, 0, 0, 0, 1]), frame(2, &[3, 0, 0, 0, 1])].concat();
    other.write_all(&twice).unwrap();
    let mut answers = [0; 22];
    other.read_exact(&mut answers).unwrap();
    assert_eq!((answers[6], answers[17]), (1, 2));
}

#[test]
fn nothing_is_written_unless_the_site_names_it() {
    let site = Site::new(vec![register(0, None)]);
    let refused = |request: &[u8]| {
        assert_eq!(site.ask(1, request), [request[0] | 0x80, 1], "{request:?}");
    };
    refused(&[6, 0x01, 0x90, 0, 2]); // STOP
    refused(&[6, 0x01, 0x92, 0, 1]); // forcing
    refused(&[6, 0x01, 0x9A, 0, 9]); // settings
    refused(&[16, 0x03, 0xE8, 0, 1, 2, 0, 0]); // upload
    refused(&[5, 0, 0, 0xFF, 0]);
    refused(&[6, 0, 2, 0, 5]);
    assert_eq!(
        site.ask(1, &[16, 0, 0, 0, 2, 4, 0, 1, 0, 5]),
        [16, 0, 0, 0, 2]
    );
    assert_eq!(
        site.ask(1, &[3, 0, 0, 0, 4]),
        [3, 8, 0, 1, 0, 5, 0, 0, 0, 0]
    );
    assert_eq!(site.ask(2, &[6, 0, 0, 0, 5]), [0x86, 1], "another unit");
    assert_eq!(site.boards.board(3).state, map::State::Run as u16);
}

#[test]
fn a_name_holds_while_the_board_keeps_the_program_of_the_file() {
    let site = Site::new(vec![register(0, Some(kept(3)))]);
    let write = [16, 0, 0, 0, 2, 4, 0, 0, 0, 5];
    assert_eq!(site.ask(1, &write), [16, 0, 0, 0, 2]);
    site.boards.board(3).kept.sum += 1;
    assert_eq!(site.ask(1, &write), [0x90, 4], "another program");
    site.boards.board(3).kept.sum -= 1;
    site.boards.board(3).version -= 1;
    assert_eq!(site.ask(1, &write), [0x90, 4], "in another form");
}

#[test]
fn a_person_goes_before_a_machine() {
    let site = Site::new(vec![register(0, None)]);
    let mut person = Visitor::at(site.page, "/line/one", "");
    let write = [16, 0, 0, 0, 2, 4, 0, 0, 0, 5];
    assert_eq!(site.ask(1, &write)[0], 16);
    // The machine has not taken the control.
    assert_eq!(person.ask(&Request::write_word(3, 400, 2))[1], 6);
    assert_eq!(site.ask(1, &write), [0x90, 6]);
    person.0.close(None).unwrap();
    while person.0.read().is_ok() {}
    // The server knows a moment later that nobody controls.
    while site.ask(1, &write)[0] != 16 {}
}

#[test]
fn each_board_has_its_page_and_the_first_is_that_of_no_name() {
    let site = Site::new(Vec::new());
    for (path, address, name) in [
        ("/line", 3, "one"),
        ("/line/one", 3, "one"),
        ("/line/two", 4, "two"),
    ] {
        let (_, told) = Visitor::new_at(site.page, path, "");
        assert_eq!(
            told,
            format!(r#"{{"address":{address},"name":"{name}","role":"control"}}"#)
        );
    }
    let mut two = Visitor::at(site.page, "/line/two", "");
    assert_eq!(two.ask(&Request::write_word(4, 400, 2))[1], 6);
    assert_eq!(
        two.ask(&Request::write_word(3, 400, 2))[2],
        10,
        "another board"
    );
    assert_eq!(site.boards.board(3).state, map::State::Run as u16);
    assert_eq!(site.boards.board(4).state, map::State::Stop as u16);
    let missing = crate::common::http(
        site.page,
        "/line/three",
        &format!("Host: {}\r\n", site.page),
    );
    assert!(missing.starts_with("HTTP/1.1 4"), "{missing}");
}

#[test]
fn a_board_that_is_gone_is_told_by_an_exception() {
    let site = Site::new(Vec::new());
    site.boards.unplug(true);
    while site.ask(1, &[3, 0, 0, 0, 1]) != [0x83, 0x0B] {}
    site.boards.unplug(false);
    while site.ask(1, &[3, 0, 0, 0, 1])[0] != 3 {}
}

#[test]
fn whoever_operates_it_is_told_what_becomes_of_the_boards() {
    let (send, told) = std::sync::mpsc::channel();
    let send = std::sync::Mutex::new(send);
    let tell: Tell = std::sync::Arc::new(move |board: &str, news| {
        if board == "one" {
            // After the end of the test nobody listens.
            let _ = send.lock().unwrap().send(news);
        }
    });
    let boards = Simulated::at(&[3, 4]);
    let lines = Line::begin_shared(boards.clone(), &[3, 4]);
    let site = Site::of(boards, lines, Vec::new(), Some(tell), None);
    assert_eq!(told.recv().unwrap(), News::Found);
    assert_eq!(told.recv().unwrap(), News::Program);
    site.boards.unplug(true);
    site.boards.board(3).kept.sum += 1;
    while site.ask(1, &[3, 0, 0, 0, 1]) != [0x83, 0x0B] {}
    assert_eq!(told.recv().unwrap(), News::Away("unplugged".into()));
    site.boards.unplug(false);
    assert_eq!(told.recv().unwrap(), News::Found);
    assert_eq!(told.recv().unwrap(), News::OtherProgram);
}
