//! A Mega behind `unoclp serve`: its firmware on simavr, in the program `unoclp-uno-sim`.

use crate::{Server, http, site, unoclp_site};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// Input 24 is output 16, and marker 01 is output 15.
const FAR: &str = "0\n827324\n877916\n787600\n827701\n877915\n";

/// A simulated Mega.
struct Mega(Child);

impl Drop for Mega {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A Mega that runs the program, and its port.
fn mega() -> (Mega, String) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("far.txt");
    std::fs::write(&program, FAR).unwrap();
    let mut child = Command::new(root.join("target/debug/unoclp-uno-sim"))
        .args(["serve", "--elf"])
        .args([root.join("firmware/unoclp-mega.hex"), program])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("`cargo build -p unoclp-uno-sim` makes it");
    let mut port = String::new();
    let mut says = BufReader::new(child.stdout.take().unwrap());
    says.read_line(&mut port).unwrap();
    (Mega(child), port.trim_end().to_owned())
}

/// Asks again until the gateway tells all of this of its boards.
fn tells(address: &str, all: &[&str]) {
    let mut told = String::new();
    for _ in 0..100_000 {
        told = http(address, "/api/boards");
        if all.iter().all(|part| told.contains(part)) {
            return;
        }
        std::thread::yield_now();
    }
    panic!("{all:?}: {told}");
}

/// The answer to a request over Modbus TCP.
fn ask(client: &mut TcpStream, request: &[u8]) -> Vec<u8> {
    let mut frame = vec![0, 1, 0, 0, 0, request.len() as u8 + 1, 1];
    frame.extend(request);
    client.write_all(&frame).unwrap();
    let mut head = [0; 7];
    client.read_exact(&mut head).unwrap();
    let mut answer = vec![0; usize::from(head[5]) - 1];
    client.read_exact(&mut answer).unwrap();
    answer
}

#[test]
fn all_points_of_a_mega_are_read_and_written_through_a_gateway() {
    let (_mega, port) = mega();
    let lines = format!(
        "write = [\"far.M1\"]\n[[line]]\nport = {port:?}\n[[line.board]]\nname = \"far\"\nkind = \"mega\"\nevery = \"50ms\"\n"
    );
    let mut server = Server::of(&mut unoclp_site(&site("mega", &lines)));
    let modbus = server.line().replace("Modbus TCP: ", "");
    let address = server.address.clone();
    let begun = ["\"doing\":\"RUN\"", "\"I24\":0.0", "\"Q16\":0.0", "\"A7\":"];
    tells(&address, &begun);
    let mut client = TcpStream::connect(modbus).unwrap();
    assert_eq!(ask(&mut client, &[2, 0, 0, 0, 24]), [2, 3, 0, 0, 0]);
    assert_eq!(ask(&mut client, &[5, 0, 16, 0xFF, 0]), [5, 0, 16, 0xFF, 0]);
    tells(&address, &["\"Q15\":1.0"]);
    // What the site does not grant, and forcing.
    assert_eq!(ask(&mut client, &[5, 0, 15, 0, 0]), [0x85, 1]);
    assert_eq!(ask(&mut client, &[6, 1, 0x97, 0, 1]), [0x86, 1]);
}
