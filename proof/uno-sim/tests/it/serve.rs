//! The command `unoclp-uno-sim serve`: the firmware behind a pseudo-terminal.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use unoclp_uno_sim::firmware_file;

#[test]
fn the_firmware_speaks_over_a_pseudo_terminal_until_the_input_ends() {
    let elf = firmware_file().unwrap();
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../programs/motor.txt");
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
        (
            &["serve", "no.txt"][..],
            "the program no.txt cannot be read",
        ),
        (
            &["serve", "--card", "no.img"],
            "the card image no.img cannot be read",
        ),
        (&["serve", "no.txt", "--elf", "no.elf"], "no.elf"),
    ] {
        let command = env!("CARGO_BIN_EXE_unoclp-uno-sim");
        let output = Command::new(command).args(arguments).output().unwrap();
        assert!(!output.status.success());
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(error.contains(said), "{arguments:?}: {error}");
        assert!(output.stdout.is_empty());
    }
}

/// What the firmware says until it is in RUN, served so; the input ends after that.
fn served(firmware: &Path, arguments: &[&str]) -> String {
    let mut serve = Command::new(env!("CARGO_BIN_EXE_unoclp-uno-sim"))
        .args(["serve", "--reset", "--elf"])
        .arg(firmware)
        .args(arguments)
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
    drop(serve.stdin.take());
    assert!(serve.wait().unwrap().success());
    String::from_utf8(said).unwrap()
}

fn path(name: &str) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    path.to_str().unwrap().to_owned()
}

#[test]
fn instruction_list_is_compiled_and_the_eeprom_kept() {
    let (lamp, eeprom) = (path("served.il"), path("served.eep"));
    // The Mega as it is handed out, where its symbols say which board it is.
    let mega = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../firmware/unoclp-mega.hex");
    for (firmware, text, length) in [
        (firmware_file().unwrap(), "LD I1\nST Q1\n", 1024),
        (mega, "LD I24\nST Q16\n", 4096),
    ] {
        std::fs::write(&lamp, text).unwrap();
        let _ = std::fs::remove_file(&eeprom);
        let said = served(&firmware, &[&lamp, "--eeprom", &eeprom]);
        assert!(said.contains("program: 3 codes"), "{said}");
        let kept = std::fs::read(&eeprom).unwrap();
        assert_eq!(kept.len(), length);
        assert!(kept.iter().any(|&byte| byte != 0xFF));
        // Without a program and without a card the board runs what it has kept.
        let said = served(&firmware, &["--eeprom", &eeprom]);
        assert!(said.contains("RUN"), "{said}");
        assert!(!said.contains("fault 65"), "{said}");
    }
}

#[test]
fn what_is_no_eeprom_and_no_program_is_left_alone() {
    let (notes, wrong) = (path("notes.eep"), path("served-wrong.il"));
    std::fs::write(&notes, "not an EEPROM").unwrap();
    std::fs::write(&wrong, "LD I9\nST Q1\n").unwrap();
    let elf = firmware_file().unwrap();
    for (arguments, said) in [
        (
            ["serve", "--eeprom", &notes],
            "has 13 bytes and is no EEPROM",
        ),
        (["serve", "--baud=9600", &wrong], "has errors\nerror[IL-"),
    ] {
        let command = env!("CARGO_BIN_EXE_unoclp-uno-sim");
        let mut command = Command::new(command);
        let output = command
            .args(arguments)
            .arg("--elf")
            .arg(&elf)
            .output()
            .unwrap();
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && error.contains(said), "{error}");
    }
    assert_eq!(std::fs::read(&notes).unwrap(), b"not an EEPROM");
}

#[test]
fn a_closed_pipe_ends_it_quietly() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = Command::new(env!("CARGO_BIN_EXE_unoclp-uno-sim"))
        .args(["serve", "--elf"])
        .arg(firmware_file().unwrap())
        .stdin(Stdio::piped())
        .stdout(writer)
        .output()
        .unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}
