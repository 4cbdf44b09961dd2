//! The files of the page.

use crate::common::{Memory, http, serve};

#[test]
fn files_come_with_their_kind_and_nothing_else_does() {
    let address = serve(None, None);
    let host = format!("Host: {address}\r\n");
    for (path, status, kind, end) in [
        ("/", "200 OK", "text/html; charset=utf-8", "</html>"),
        (
            "/index.html",
            "200 OK",
            "text/html; charset=utf-8",
            "</html>",
        ),
        (
            "/app.js?x=1",
            "200 OK",
            "text/javascript; charset=utf-8",
            "1",
        ),
        ("/unoclp.wasm", "200 OK", "application/wasm", "\0asm"),
        (
            "/../../Cargo.toml",
            "404 Not Found",
            "text/plain; charset=utf-8",
            "404\n",
        ),
        (
            "/%2e%2e/Cargo.toml",
            "404 Not Found",
            "text/plain; charset=utf-8",
            "404\n",
        ),
        (
            "//etc/passwd",
            "404 Not Found",
            "text/plain; charset=utf-8",
            "404\n",
        ),
    ] {
        let answer = http(address, path, &host);
        assert!(
            answer.starts_with(&format!("HTTP/1.1 {status}\r\n")),
            "{path}: {answer}"
        );
        assert!(
            answer.contains(&format!("content-type: {kind}\r\n")),
            "{path}: {answer}"
        );
        assert!(answer.contains("content-security-policy: default-src 'self';"));
        assert!(answer.ends_with(end), "{path}: {answer}");
    }
}

#[test]
fn a_foreign_page_gets_nothing() {
    let address = serve(Some(Memory::new()), None);
    for head in [
        "Host: evil.example\r\n".to_owned(),
        format!("Host: {address}\r\nOrigin: http://evil.example\r\n"),
        format!("Host: {address}\r\nHost: {address}\r\n"),
    ] {
        let answer = http(address, "/", &head);
        assert!(answer.starts_with("HTTP/1.1 4"), "{answer}");
        let upgrade = "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
        let answer = http(address, "/line", &format!("{head}{upgrade}"));
        assert!(answer.starts_with("HTTP/1.1 4"), "{answer}");
    }
}

#[test]
fn a_head_without_end_is_refused() {
    let address = serve(None, None);
    let head = format!("Host: {address}\r\nX: {}\r\n", "x".repeat(20 << 10));
    let answer = http(address, "/", &head);
    assert!(answer.starts_with("HTTP/1.1 431"), "{answer}");
}
