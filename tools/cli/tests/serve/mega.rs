//! A Mega at a port and behind `unoclp serve`: its firmware on simavr, in the program `unoclp-uno-sim`; and a UNO in its place.

use crate::pty::{PATIENT, kept};
use crate::{Server, http, site, unoclp_site};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use unoclp_cli::port::{Place, find};
use unoclp_client::Line;
use unoclp_client::diagnostics::Diagnostics;
use unoclp_client::map::State;

/// Input 24 is output 16, and marker 01 is output 15.
const FAR: &str = "0\n827324\n877916\n787600\n827701\n877915\n";

/// Input 01 is output 01.
const NEAR: &str = "0\n827301\n877901\n";

/// A simulated board.
struct Simulated(Child);

impl Drop for Simulated {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// A file for these tests.
fn file(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// A board with this firmware that runs the program in this file, and its port.
fn simulated(firmware: &str, program: &Path) -> (Simulated, String) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut child = Command::new(root.join("target/debug/unoclp-uno-sim"))
        .args(["serve", "--elf"])
        .args([&root.join("firmware").join(firmware), program])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("`cargo build -p unoclp-uno-sim` makes it");
    let mut port = String::new();
    let mut says = BufReader::new(child.stdout.take().unwrap());
    says.read_line(&mut port).unwrap();
    (Simulated(child), port.trim_end().to_owned())
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
    let (_mega, port) = simulated("unoclp-mega.hex", &file("served-far.txt", FAR));
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

/// Whether `unoclp upload` has done it, and what it says.
fn upload(program: &Path, port: &str, more: &[&str], lang: &str) -> (bool, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    command.arg("upload").arg(program).args(["--port", port]);
    let output = command.args(more).env("LC_ALL", lang).output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8(said).unwrap())
}

/// How the board at this port does.
fn board(port: &str) -> Diagnostics {
    let place = Place {
        port: port.to_owned(),
        line: Line::default(),
    };
    let mut found = find(&place, PATIENT).unwrap();
    found.port.talk(Diagnostics::read).unwrap()
}

#[test]
fn an_uno_keeps_its_program_where_one_for_a_mega_is_sent_and_a_mega_takes_both() {
    let (near, far) = (file("sent-near.txt", NEAR), file("sent-far.txt", FAR));
    let (_uno, port) = simulated("unoclp-uno.hex", &near);
    for (lang, has, lacks) in [
        (
            "C",
            "the Mega has",
            "the UNO at the port lacks something that the program needs; nothing was sent",
        ),
        (
            "pt_BR.UTF-8",
            "a placa Mega tem",
            "a placa UNO na porta não tem tudo o que o programa usa; nada foi enviado",
        ),
    ] {
        let (done, said) = upload(&far, &port, &[], lang);
        assert!(!done && said.contains(has), "{said}");
        let (done, said) = upload(&far, &port, &["--board", "mega"], lang);
        assert!(
            !done && said.contains(has) && said.contains(lacks),
            "{said}"
        );
    }
    let uno = board(&port);
    assert_eq!((uno.state, uno.program), (Some(State::Run), kept(NEAR)));

    let (_mega, port) = simulated("unoclp-mega.hex", &far);
    for more in [&[][..], &["--board", "uno"]] {
        let (done, said) = upload(&near, &port, more, "C");
        assert!(done && said.ends_with("RUN\n"), "{said}");
    }
    assert_eq!(board(&port).program, kept(NEAR));
    let (done, said) = upload(&far, &port, &[], "C");
    assert!(done && said.ends_with("RUN\n"), "{said}");
}

#[test]
fn a_board_of_a_site_that_has_fewer_points_than_its_kind_is_told() {
    let (_uno, port) = simulated("unoclp-uno.hex", &file("site-near.txt", NEAR));
    // It has begun.
    assert_eq!(board(&port).state, Some(State::Run));
    let lines = format!(
        "[[line]]\nport = {port:?}\n[[line.board]]\nname = \"far\"\nkind = \"mega\"\nevery = \"50ms\"\n"
    );
    let file = site("less", &lines);
    for (lang, begins, lacks, remedy) in [
        (
            "C",
            "far: not reachable: the board identifies itself as unoclp UNO ",
            ", which has fewer points than a Mega; ",
            "change the board, or `kind` in the site file",
        ),
        (
            "pt_BR.UTF-8",
            "far: fora do ar: a placa se identifica como unoclp UNO ",
            ", que tem menos pontos que um Mega; ",
            "mude a placa, ou `kind` no arquivo de instalação",
        ),
    ] {
        let mut server = Server::of(unoclp_site(&file).env("LC_ALL", lang));
        let said = loop {
            let line = server.line();
            if line.starts_with("far: ") {
                break line;
            }
        };
        for part in [begins, lacks, remedy] {
            assert!(said.contains(part), "{said}");
        }
        tells(&server.address, &["UNO", "Mega"]);
    }
}
