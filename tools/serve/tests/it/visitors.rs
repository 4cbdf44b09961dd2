//! Visitors of the board.

use crate::common::{Memory, Visitor, read, serve, tokens};
use tungstenite::Message;
use unoclp_modbus::Table;
use unoclp_modbus::client::Request;

#[test]
fn on_this_pc_everybody_may_do_all() {
    let address = serve(Some(Memory::new()), None);
    let (mut visitor, told) = Visitor::new(address, "");
    assert_eq!(told, r#"{"address":1,"name":"tty0","role":"control"}"#);
    while visitor.text() != r#"{"board":true}"# {}
    assert_eq!(
        visitor.ask(&Request::write_word(1, 2, 0x1234)),
        [1, 6, 0, 2, 0x12, 0x34]
    );
    assert_eq!(visitor.ask(&read(3)), [1, 3, 6, 0, 7, 0, 7, 0x12, 0x34]);
    let elsewhere = Request::write_word(9, 2, 1);
    assert_eq!(
        visitor.ask(&elsewhere),
        [9, 0x86, 10],
        "no way to this address"
    );
}

#[test]
fn whoever_watches_changes_nothing() {
    let board = Memory::new();
    let address = serve(Some(board.clone()), Some(tokens()));
    let (mut watcher, told) = Visitor::new(address, &tokens().watch);
    assert_eq!(told, r#"{"address":1,"name":"tty0","role":"watch"}"#);
    while watcher.text() != r#"{"board":true}"# {}
    assert_eq!(watcher.ask(&read(1)), [1, 3, 2, 0, 7]);
    assert_eq!(watcher.ask(&Request::write_word(1, 0, 1)), [1, 0x86, 1]);
    assert_eq!(board.0.lock().unwrap().words[0], 7);
}

#[test]
fn one_controls_at_a_time() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    let mut one = Visitor::at_board(address, &tokens().control);
    let mut other = Visitor::at_board(address, &tokens().control);
    let write = Request::write_word(1, 0, 1);
    assert_eq!(one.ask(&write)[1], 6);
    assert_eq!(other.ask(&write), [1, 0x86, 6]);
    assert_eq!(other.ask(&read(1)), [1, 3, 2, 0, 1]);
    one.0.close(None).unwrap();
    while one.0.read().is_ok() {}
    // The server knows of it a moment later.
    while other.ask(&write)[1] != 6 {}
}

#[test]
fn what_is_forced_is_let_go_once_who_forced_it_is_gone() {
    let board = Memory::new();
    let address = serve(Some(board.clone()), Some(tokens()));
    let mut one = Visitor::at_board(address, &tokens().control);
    let force = Request::write_words(1, 402, &[2, 2, 5, 4, 1]).unwrap();
    assert_eq!(one.ask(&force)[1], 16);
    one.0.close(None).unwrap();
    // Others go on to read, and to write what is not forced.
    let mut watcher = Visitor::at_board(address, &tokens().watch);
    let mut other = Visitor::at_board(address, &tokens().control);
    while other.ask(&Request::write_word(1, 0, 1))[1] != 6 {}
    let forced = Request::read(1, Table::HoldingRegisters, 402, 5);
    while watcher.ask(&forced) != [1, 3, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1] {}
    let writes = board.0.lock().unwrap().writes.clone();
    let [.., off, none] = &writes[..] else {
        panic!("{writes:?}");
    };
    assert_eq!(off, &(402, vec![2, 2, 5, 0]), "forced outputs are off");
    assert_eq!(none, &(402, vec![0; 4]), "and then let go");
}

#[test]
fn an_upload_whose_visitor_is_gone_is_begun_again() {
    let board = Memory::new();
    let address = serve(Some(board.clone()), Some(tokens()));
    let begin = Request::write_word(1, 400, 5);
    let blocks = [[0x0001, 0x3100], [0x0101, 0x3200]]
        .map(|words| Request::write_words(1, 1000, &words).unwrap());
    let mut one = Visitor::at_board(address, &tokens().control);
    assert_eq!(one.ask(&begin)[1], 6);
    assert_eq!(one.ask(&blocks[0])[1], 16);
    one.0.close(None).unwrap();
    while one.0.read().is_ok() {}
    let mut other = Visitor::at_board(address, &tokens().control);
    // The server knows a moment later that nobody else controls.
    while other.ask(&Request::write_word(1, 0, 1))[1] != 6 {}
    assert_eq!(other.ask(&blocks[1]), [1, 0x90, 6]);
    assert_eq!(other.ask(&begin)[1], 6);
    assert_eq!(other.ask(&blocks[0])[1], 16);
    let writes: Vec<u16> = board
        .0
        .lock()
        .unwrap()
        .writes
        .iter()
        .map(|(first, _)| *first)
        .collect();
    assert_eq!(writes, [400, 1000, 0, 400, 1000]);
}

#[test]
fn a_wrong_token_lets_nobody_in() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    for token in ["", "w", &"W".repeat(32), &"c".repeat(33)] {
        let mut visitor = Visitor::silent(address);
        visitor.send(token);
        assert_eq!(visitor.farewell(), "not allowed", "{token}");
    }
    let mut visitor = Visitor::silent(address);
    visitor
        .0
        .send(Message::binary(tokens().control.into_bytes()))
        .unwrap();
    assert_eq!(visitor.farewell(), "not allowed");
}

#[test]
fn what_is_no_request_ends_the_visit() {
    let address = serve(Some(Memory::new()), None);
    let mut wrong_sum = read(1).bytes().to_vec();
    *wrong_sum.last_mut().unwrap() ^= 1;
    for message in [
        Message::binary(wrong_sum),
        Message::binary(Vec::new()),
        Message::binary(vec![0; 256]),
        Message::text("read"),
    ] {
        let mut visitor = Visitor::at_board(address, "");
        visitor.0.send(message.clone()).unwrap();
        assert_eq!(visitor.farewell(), "not allowed", "{message:?}");
    }
    let mut visitor = Visitor::at_board(address, "");
    visitor.0.send(Message::binary(vec![0; 257])).unwrap();
    assert_eq!(visitor.farewell(), "closed");
}

#[test]
fn a_board_that_goes_away_and_comes_back_is_found_again() {
    let board = Memory::new();
    let address = serve(Some(board.clone()), None);
    let mut visitor = Visitor::at_board(address, "");
    board.0.lock().unwrap().is_there = false;
    assert_eq!(visitor.ask(&read(1)), [1, 0x83, 11]);
    // The text may have come before the answer.
    let (mut late, _) = Visitor::new(address, "");
    while late.text() != r#"{"board":false,"why":"unplugged"}"# {}
    assert_eq!(late.ask(&read(1)), [1, 0x83, 11]);
    board.0.lock().unwrap().is_there = true;
    while late.text() != r#"{"board":true}"# {}
    assert_eq!(late.ask(&read(1)), [1, 3, 2, 0, 7]);
}

#[test]
fn a_board_without_an_answer_is_told_of_at_once() {
    let board = Memory::new();
    let address = serve(Some(board.clone()), None);
    let mut visitor = Visitor::at_board(address, "");
    board.0.lock().unwrap().answers = false;
    assert_eq!(visitor.ask(&read(1)), [1, 0x83, 11]);
    board.0.lock().unwrap().answers = true;
    assert_eq!(visitor.ask(&read(1)), [1, 3, 2, 0, 7]);
}

#[test]
fn who_says_nothing_is_dropped() {
    let address = serve(Some(Memory::new()), None);
    assert_eq!(Visitor::silent(address).farewell(), "too slow");
}

#[test]
fn who_takes_no_answers_is_dropped_and_nobody_waits_for_it() {
    let address = serve(Some(Memory::new()), None);
    let slow = Visitor::at_board(address, "");
    let mut stream = slow.0.get_ref().try_clone().unwrap();
    let flood = std::thread::spawn(move || {
        // Requests as frames of their own, with a mask of zeros, until the server takes no more of them.
        let request = read(125);
        let mut frame = vec![0x82, 0x80 | request.bytes().len() as u8, 0, 0, 0, 0];
        frame.extend(request.bytes());
        let frames = frame.repeat(1000);
        while std::io::Write::write_all(&mut stream, &frames).is_ok() {}
    });
    let mut other = Visitor::at_board(address, "");
    while !flood.is_finished() {
        assert_eq!(other.ask(&read(1)), [1, 3, 2, 0, 7]);
    }
    flood.join().unwrap();
    drop(slow);
    assert_eq!(other.ask(&read(1)), [1, 3, 2, 0, 7]);
}
