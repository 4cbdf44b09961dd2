//! The commands that speak to a board: exit codes, messages and what the board gets.

use crate::pty::{Board, FAULT, Fake, Fate, RUN, STOP, kept};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

const FOLLOW: &str = "0\n787600\n827301\n877901\n";

/// A file for one test.
fn file(name: &str, content: &str) -> String {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, content).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Runs `unoclp` without a terminal: exit code, standard output and standard error.
fn unoclp(arguments: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    let output = command
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let code = output.status.code().unwrap();
    (code, text(output.stdout), text(output.stderr))
}

/// The command on this board.
fn on(fake: &Fake, arguments: &[&str]) -> (i32, String, String) {
    let port = ["--port", fake.path()];
    unoclp(&[arguments, &port].concat())
}

#[test]
fn an_upload_says_what_it_does() {
    let program = file("follow.txt", FOLLOW);
    let crc = kept(FOLLOW).sum;
    let fake = Fake::new(Board::default());
    let (code, out, err) = on(&fake, &["upload", &program]);
    let path = fake.path();
    let expected = format!(
        "unoclp UNO 0.1.0 at {path}, address 1\nSTOP\nstored: 3 bytes, check sum {crc:04X}\nRUN\n"
    );
    assert!(out.starts_with(&format!("{program}: 4 codes, ")), "{out}");
    assert!(out.ends_with(&expected), "{out}");
    assert_eq!((code, err.as_str()), (0, ""));
    assert_eq!(fake.board().text, FOLLOW.as_bytes());
    assert_eq!(fake.board().state, RUN);
}

#[test]
fn an_upload_to_a_board_with_another_stored_form_is_no_failure() {
    let program = file("form.txt", FOLLOW);
    for state in [STOP, FAULT] {
        let fake = Fake::new(Board::of_version(2, Board::in_state(state)));
        let (code, out, err) = on(&fake, &["upload", &program]);
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        let told = fake.board().kept.sum;
        assert_ne!(told, kept(FOLLOW).sum);
        let says = format!("stored: 3 bytes, check sum {told:04X}\nRUN\n");
        assert!(out.ends_with(&says), "{out}");
    }
}

#[test]
fn an_upload_ends_as_the_board_lets_it() {
    let program = file("ends.txt", FOLLOW);
    let switched = Board {
        switch: true,
        ..Board::in_state(STOP)
    };
    let faulty = Board {
        fault: 62,
        ..Board::in_state(FAULT)
    };
    for (board, more, says, state) in [
        (Board::default(), &["--stop"][..], "\nin STOP\n", STOP),
        (
            switched,
            &[],
            "A5 is closed: in STOP, until A5 is opened\n",
            STOP,
        ),
        (faulty, &[], "RUN\n", RUN),
    ] {
        let fake = Fake::new(board);
        let (code, out, err) = on(&fake, &[&["upload", &program], more].concat());
        assert_eq!((code, err.as_str()), (0, ""), "{out}");
        assert!(out.ends_with(says), "{out}");
        assert_eq!(fake.board().state, state);
    }
}

#[test]
fn a_fault_that_the_board_finds_is_shown_as_check_does() {
    let program = file("differs.txt", FOLLOW);
    let fake = Fake::new(Board {
        second_differs: true,
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert_eq!((code, err.as_str()), (1, ""));
    let says = "the board refuses the program, and keeps the one that it had:\nerror[57]: ";
    assert!(out.contains(says), "{out}");
    assert_eq!(fake.board().state, STOP, "it does not run");
}

#[test]
fn a_program_with_a_fault_does_not_reach_the_board() {
    let program = file("faulty-upload.txt", "0\n827309\n");
    for command in ["upload", "monitor"] {
        let (code, out, err) = unoclp(&[command, &program, "--port", "/dev/no-such-port"]);
        assert_eq!((code, err.as_str()), (1, ""));
        assert!(
            out.starts_with("error[25]: this board has no such input\n"),
            "{out}"
        );
    }
}

#[test]
fn a_card_with_another_program_has_the_last_word() {
    let program = file("card.txt", FOLLOW);
    let fake = Fake::new(Board {
        card: Some(b"0\n877901\n".to_vec()),
        ..Board::in_state(FAULT)
    });
    let (code, _, err) = on(&fake, &["upload", &program]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the board's card has another PROGRAM.TXT"),
        "{err}"
    );
}

#[test]
fn settings_are_shown_and_set() {
    let fake = Fake::new(Board::default());
    let (code, out, _) = on(&fake, &["settings"]);
    let shown = "\naddress 1, 115200 baud, no parity, direction pin off\n";
    assert_eq!(code, 0);
    assert!(out.ends_with(shown), "{out}");
    let board = fake.board();
    assert_eq!((board.restarts, board.state), (0, RUN));
}

#[test]
fn new_settings_are_kept_and_used() {
    let fake = Fake::new(Board::default());
    let set = ["settings", "--set-address", "7", "--set-rate", "9600"];
    let more = ["--set-parity", "even", "--set-direction", "on"];
    let (code, out, err) = on(&fake, &[&set[..], &more].concat());
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let says = "address 7, 9600 baud, even parity, direction pin on; restarting\n\
        it answers from address 7 at 9600 baud, even parity\n";
    assert!(out.ends_with(says), "{out}");
    let board = fake.board();
    assert_eq!(board.settings, [7, 96, 1, 1]);
    assert_eq!((board.restarts, board.state), (1, RUN));
}

#[test]
fn settings_that_are_not_kept_are_no_success() {
    let fake = Fake::new(Board {
        eeprom_fails: true,
        ..Board::default()
    });
    let (code, _, err) = on(&fake, &["settings", "--set-address", "7"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the board does not keep the settings"),
        "{err}"
    );
    assert_eq!(fake.board().restarts, 0);
}

#[test]
fn what_cannot_be_done_is_exit_code_2_and_says_what_to_do() {
    let program = file("nobody.txt", FOLLOW);
    let port = ["--port", "/dev/no-such-port"];
    let missing = "error: there is no port /dev/no-such-port; this PC has ";
    #[rustfmt::skip]
    let cases: &[(&[&str], &str)] = &[
        (&["upload"], "error: the following required arguments were not provided:"),
        (&["monitor"], "error: the following required arguments were not provided:"),
        (&["settings"], "error: the following required arguments were not provided:"),
        (&["upload", &program], "error: the following required arguments were not provided:"),
        (&["upload", "no-such.txt", port[0], port[1]], "error: no-such.txt cannot be read ("),
        (&["monitor", "no-such.txt", port[0], port[1]], "error: no-such.txt cannot be read ("),
        (&["upload", &program, port[0], port[1]], missing),
        (&["settings", port[0], port[1]], missing),
        (&["monitor", port[0], port[1]], "error: the monitor needs a terminal"),
        (&["settings", port[0], port[1], "--set-rate", "1234"], "error: a board has no rate of 1234 baud; it has 2400, "),
        (&["settings", port[0], port[1], "--address", "0"], "error: invalid value '0' for '--address"),
        (&["settings", port[0], port[1], "--set-address", "248"], "error: invalid value '248' for '--set-address"),
    ];
    for (arguments, message) in cases {
        let (code, _, err) = unoclp(arguments);
        assert_eq!(code, 2, "{arguments:?}");
        assert!(err.starts_with(message), "{arguments:?}: {err}");
    }
}

#[test]
fn a_board_that_fails_in_its_first_second_is_not_said_to_run() {
    let program = file("fails.il", "(* waits *)\nagain:\nLD I1\nST Q1\nJMP again\n");
    let (_, code, _) = unoclp(&["compile", &program]);
    let jump = code.lines().position(|line| line.contains("JMP")).unwrap();
    let fake = Fake::new(Board {
        fault_in_run: Some((75, jump as u32 + 1)),
        ..Board::default()
    });
    let (code, out, err) = on(&fake, &["upload", &program]);
    assert_eq!((code, err.as_str()), (1, ""), "{out}");
    let says = format!(
        "in FAULT, within the first 1000 ms of its scans:\n\
         {program}:5: fault 75: too many jumps back in one scan (NC-19)\n  JMP again\n"
    );
    assert!(out.ends_with(&says), "{out}");
    assert!(!out.contains("\nRUN\n"), "{out}");
}

#[test]
fn an_upload_lets_go_what_is_forced_unless_it_is_told_not_to() {
    let program = file("forced.txt", FOLLOW);
    let forced = || Board {
        forces: [0b1, 0b1, 0b10, 0],
        ..Board::default()
    };
    let fake = Fake::new(forced());
    let (code, out, _) = on(&fake, &["upload", &program]);
    assert_eq!(code, 0, "{out}");
    assert!(out.contains("\nforced: I1=1 Q2=0\n"), "{out}");
    assert!(
        out.ends_with("\nno longer forced: I1=1 Q2=0\nRUN\n"),
        "{out}"
    );
    assert_eq!(fake.board().forces, [0; 4]);

    let fake = Fake::new(forced());
    let (_, out, _) = on(&fake, &["upload", &program, "--keep-forces"]);
    assert!(out.contains("RUN\nstill forced: I1=1 Q2=0; "), "{out}");
    assert_eq!(fake.board().forces, forced().forces);

    // What is refused changes nothing, and says so.
    let fake = Fake::new(Board {
        second_differs: true,
        ..forced()
    });
    let (_, out, _) = on(&fake, &["upload", &program]);
    assert!(out.contains("\nstill forced: I1=1 Q2=0; "), "{out}");
}

#[test]
fn an_upload_that_is_interrupted_ends_in_order() {
    let program = file(
        "interrupted.txt",
        &format!("{FOLLOW}/{}\n", "x".repeat(4_000)),
    );
    let begun = Arc::new(AtomicBool::new(false));
    let seen = begun.clone();
    // The board holds the second block until Ctrl-C has come.
    let fake = Fake::with(Board::default(), move |board, _| {
        match board.is_uploading() && !seen.swap(true, Ordering::SeqCst) {
            true => Fate::Lost,
            false => Fate::Answered,
        }
    });
    let child = Command::new(env!("CARGO_BIN_EXE_unoclp"))
        .args(["upload", &program, "--port", fake.path()])
        .env("LC_ALL", "C")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !begun.load(Ordering::SeqCst) {
        std::thread::yield_now();
    }
    let pid = rustix::process::Pid::from_child(&child);
    rustix::process::kill_process(pid, rustix::process::Signal::INT).unwrap();
    let output = child.wait_with_output().unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{err}");
    let says = "error: interrupted; the board is in STOP, and keeps the program that it had\n";
    assert_eq!(err, says);
    let board = fake.board();
    assert!(!board.is_uploading() && board.state == STOP);
}
