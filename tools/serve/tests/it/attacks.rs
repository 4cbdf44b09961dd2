//! Whoever has no token, or never reads, shuts nobody out.

use crate::common::{Memory, Visitor, http, read, serve, tokens};
use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};

/// The right token gets in, is answered, and the page comes.
fn is_served(address: SocketAddr) {
    let mut visitor = Visitor::at_board(address, &tokens().control);
    assert_eq!(visitor.ask(&read(1)), [1, 3, 2, 0, 7]);
    let page = http(address, "/", &format!("Host: {address}\r\n"));
    assert!(page.starts_with("HTTP/1.1 200 OK"), "{page}");
}

#[test]
fn visitors_without_a_token_hold_no_places() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    let silent: Vec<Visitor> = (0..64).map(|_| Visitor::silent(address)).collect();
    for _ in 0..95 {
        is_served(address);
    }
    drop(silent);
}

#[test]
fn connections_that_never_read_hold_no_places() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    let requests = format!("GET /large.wasm HTTP/1.1\r\nHost: {address}\r\n\r\n").repeat(64);
    let mut greedy: Vec<TcpStream> = (0..130)
        .map(|_| {
            let mut stream = TcpStream::connect(address).unwrap();
            // Its place may be another's already.
            let _ = stream.write_all(requests.as_bytes());
            stream
        })
        .collect();
    for _ in 0..20 {
        is_served(address);
    }
    // Those that were left are dropped.
    let mut last = greedy.pop().unwrap();
    while last.write_all(requests.as_bytes()).is_ok() {}
}

#[test]
fn half_a_head_is_not_waited_for() {
    let address = serve(None, None);
    let mut stream = TcpStream::connect(address).unwrap();
    stream.write_all(b"GET / HTTP/1.1\r\nHost:").unwrap();
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).unwrap();
    assert_eq!(answer, b"");
}

#[test]
fn who_watches_leaves_room_for_who_controls() {
    let address = serve(Some(Memory::new()), Some(tokens()));
    let watch = |_| Visitor::at_board(address, &tokens().watch);
    let watchers: Vec<Visitor> = (0..64).map(watch).collect();
    let (mut late, mut one) = (Visitor::silent(address), Visitor::silent(address));
    late.send(&tokens().watch);
    assert_eq!(late.farewell(), "too many visitors");
    one.send(&tokens().control);
    assert_eq!(
        one.text(),
        r#"{"address":1,"name":"tty0","role":"control"}"#
    );
    is_served(address);
    drop(watchers);
}
