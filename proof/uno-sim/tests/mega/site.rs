//! A Mega behind `unoclp serve`: all its points are read, written and forced through the gateway, and an UNO is told from it.

use crate::common::card;
use std::fs;
use std::io::{BufRead, BufReader, Lines, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use unoclp_uno_sim::port::{Options, Pace, Port};
use unoclp_uno_sim::{Program, Slot, firmware_file, mega_file};

/// Input 24 is output 16, and marker 01 is output 15.
const FAR: &str = "0\n827324\n877916\n787600\n827701\n877915\n";

/// A gateway, and what it has not said yet.
struct Gateway {
    child: Child,
    says: Lines<BufReader<ChildStdout>>,
}

impl Gateway {
    /// That of a site with a Mega at this port.
    fn of(name: &str, port: &Path) -> Gateway {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.toml"));
        let port = port.display();
        let text = format!(
            "[http]\nlisten = \"127.0.0.1:0\"\n[modbus]\nlisten = \"127.0.0.1:0\"\nwrite = [\"far.M1\"]\n\
             [[line]]\nport = \"{port}\"\n[[line.board]]\nname = \"far\"\nkind = \"mega\"\nevery = \"50ms\"\n"
        );
        fs::write(&file, text).unwrap();
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut child = Command::new(root.join("target/debug/unoclp"))
            .args(["serve", "--site"])
            .arg(file)
            .env("LC_ALL", "C")
            .stdout(Stdio::piped())
            .spawn()
            .expect("`cargo build -p unoclp-cli` makes it");
        let says = BufReader::new(child.stdout.take().unwrap()).lines();
        Gateway { child, says }
    }

    /// What comes after this in the line that has it.
    fn after(&mut self, mark: &str) -> String {
        let says = self.says.by_ref().map(Result::unwrap);
        let mut said = says.filter_map(|line| {
            line.split_once(mark)
                .map(|(_, rest)| rest.trim_end().to_owned())
        });
        said.next().expect("the gateway says it")
    }
}

impl Drop for Gateway {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// What the gateway tells of its boards.
fn boards(address: &str) -> String {
    let mut stream = TcpStream::connect(address).unwrap();
    let head = format!("GET /api/boards HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n");
    stream.write_all(head.as_bytes()).unwrap();
    let mut answer = String::new();
    stream.read_to_string(&mut answer).unwrap();
    answer
}

/// Asks again until it tells all of this.
fn tells(address: &str, all: &[&str]) {
    let mut told = String::new();
    for _ in 0..2_000 {
        told = boards(address);
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

fn board(firmware: &Path, slot: Slot) -> Port {
    let options = Options {
        pace: Pace::Quiet,
        reset_on_open: false,
    };
    Port::open(Program::read(firmware).unwrap(), slot, options).unwrap()
}

#[test]
fn all_points_of_a_mega_are_read_and_written_through_a_gateway() {
    let mega = board(&mega_file().unwrap(), Slot::Card(card(FAR)));
    let mut gateway = Gateway::of("mega", mega.path());
    let address = gateway.after("http://").replace("/#board", "");
    let modbus = gateway.after("Modbus TCP: ");
    tells(
        &address,
        &["\"doing\":\"RUN\"", "\"I24\":0.0", "\"Q16\":0.0", "\"A7\":"],
    );
    mega.with(|mega| mega.set_all_inputs(1 << 23)).unwrap();
    tells(&address, &["\"I24\":1.0", "\"Q16\":1.0", "\"I23\":0.0"]);
    let mut client = TcpStream::connect(modbus).unwrap();
    assert_eq!(ask(&mut client, &[2, 0, 0, 0, 24]), [2, 3, 0, 0, 0x80]);
    assert_eq!(ask(&mut client, &[5, 0, 16, 0xFF, 0]), [5, 0, 16, 0xFF, 0]);
    tells(&address, &["\"Q15\":1.0"]);
    // What the site does not grant, and forcing, is the page's alone.
    assert_eq!(ask(&mut client, &[5, 0, 15, 0, 0]), [0x85, 1]);
    assert_eq!(ask(&mut client, &[6, 1, 0x97, 0, 1]), [0x86, 1]);
    drop(gateway);
    mega.close().unwrap();
}

#[test]
fn an_uno_in_the_place_of_a_mega_is_told() {
    let uno = board(&firmware_file().unwrap(), Slot::Empty);
    let mut gateway = Gateway::of("uno-for-mega", uno.path());
    let why = gateway.after("far: not reachable: ");
    assert!(why.contains("unoclp UNO"), "{why}");
    assert!(why.contains("fewer points than a Mega"), "{why}");
    drop(gateway);
    uno.close().unwrap();
}
