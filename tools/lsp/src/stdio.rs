//! The frames of the protocol at standard input and output.

use crate::serve;
use lsp_server::{Connection, Message};
use std::io::{self, BufRead, Read};
use std::sync::mpsc;
use std::thread;
use unoclp_core::Board;
use unoclp_lang::Lang;

/// The longest message that is taken, bytes: no text that is looked at is a sixteenth of it.
const LONGEST: usize = 16 << 20;

/// Speaks with the editor at standard input and output until it says goodbye.
///
/// # Errors
/// If what comes there are no messages of the protocol, or the editor is gone before it says goodbye.
pub fn stdio(board: Board, lang: Option<Lang>) -> io::Result<()> {
    let (own, editor) = Connection::memory();
    let Connection { sender, receiver } = editor;
    let (tell, told) = mpsc::channel();
    // It waits for the editor, and ends with the program.
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        loop {
            match read(&mut input) {
                Ok(Some(message)) => {
                    if sender.send(message).is_err() {
                        return;
                    }
                }
                Ok(None) => return,
                // Nobody may listen any longer.
                Err(error) => return drop(tell.send(error)),
            }
        }
    });
    let writer = thread::spawn(move || {
        let mut output = io::stdout().lock();
        receiver
            .iter()
            .try_for_each(|message| message.write(&mut output))
    });
    let served = serve(&own, board, lang).map_err(io::Error::other);
    drop(own);
    let written = writer.join().unwrap_or(Ok(()));
    match told.try_recv() {
        Ok(error) => Err(error),
        Err(_) => served.and(written),
    }
}

/// The next message; none at the end of the input.
fn read(input: &mut impl BufRead) -> io::Result<Option<Message>> {
    let wrong = |what: &str| io::Error::new(io::ErrorKind::InvalidData, what.to_owned());
    let mut length = None;
    loop {
        let mut line = Vec::new();
        input.by_ref().take(1024).read_until(b'\n', &mut line)?;
        if line.is_empty() {
            return Ok(None);
        }
        let line = String::from_utf8_lossy(&line);
        let line = line.trim();
        if line.is_empty() {
            break;
        }
        let (name, value) = line.split_once(':').ok_or_else(|| wrong("no header"))?;
        if name.eq_ignore_ascii_case("Content-Length") {
            length = value.trim().parse::<usize>().ok();
        }
    }
    let length = length.filter(|length| *length <= LONGEST);
    let length = length.ok_or_else(|| wrong("no length"))?;
    let mut body = vec![0; length];
    input.read_exact(&mut body)?;
    let message = serde_json::from_slice(&body).map_err(|error| wrong(&error.to_string()))?;
    Ok(Some(message))
}
