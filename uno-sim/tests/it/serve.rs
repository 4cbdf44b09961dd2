//! The command `unoclp-uno-sim serve`: the firmware behind a pseudo-terminal.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use unoclp_uno_sim::firmware_elf;

#[test]
fn the_firmware_speaks_over_a_pseudo_terminal_until_the_input_ends() {
    let elf = firmware_elf().unwrap();
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../programs/motor.txt");
    let mut serve = Command::new(env!("CARGO_BIN_EXE_unoclp-uno-sim"))
        .args(["serve", "--reset", "--elf"])
        .args([&elf, &program])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut path = String::new();
    let mut out = BufReader::new(serve.stdout.take().unwrap());
    out.read_line(&mut path).unwrap();
    let mut port = File::open(path.trim_end()).unwrap();
    let mut said = Vec::new();
    while !said.ends_with(b"RUN\r\n") {
        let mut byte = [0];
        port.read_exact(&mut byte).unwrap();
        said.push(byte[0]);
    }
    let said = String::from_utf8(said).unwrap();
    // What it said before the reset may come first.
    assert!(said.contains("\r\nunoclp "), "{said:?}");

    drop(serve.stdin.take());
    assert!(serve.wait().unwrap().success());
    assert!(!Path::new(path.trim_end()).exists(), "the port is gone");
    assert_eq!(out.read_line(&mut path).unwrap(), 0, "it says no more");
}

#[test]
fn what_is_missing_is_said() {
    for (arguments, said) in [
        (&["serve"][..], "<PROGRAM>"),
        (&["serve", "no.txt"], "the program no.txt cannot be read"),
        (
            &["serve", "--card", "no.img"],
            "the card image no.img cannot be read",
        ),
        (&["serve", "no.txt", "--elf", "no.elf"], "no.txt"),
    ] {
        let command = env!("CARGO_BIN_EXE_unoclp-uno-sim");
        let output = Command::new(command).args(arguments).output().unwrap();
        assert!(!output.status.success());
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains(said), "{arguments:?}: {error}");
        assert!(output.stdout.is_empty());
    }
}
