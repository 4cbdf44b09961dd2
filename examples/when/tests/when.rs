//! WHEN in every command, and what is told of its mistakes.

use std::path::{Path, PathBuf};
use std::process::Command;
use unoclp_core::Board;
use unoclp_exercise::scenario::{Scenario, check};
use unoclp_host_sim::engine::HostEngine;
use unoclp_lang::{Colour, Lang, TextLanguage, colours, compile_text, register};
use unoclp_when::WHEN;

const MOTOR: &str = include_str!("../motor.when");
/// Texts with what is told of each: `WHEN-2 9..12`, and the message in English.
const MISTAKES: &str = include_str!("mistakes.txt");

fn when() -> TextLanguage {
    register(&WHEN);
    TextLanguage::named("when").expect("it is registered")
}

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// What a command of the program says.
fn said(arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp-when"));
    let output = command.args(arguments).env("LC_ALL", "C").output();
    let output = output.expect("it runs");
    let text = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8_lossy(&text).into())
}

#[test]
fn the_motor_runs_on_the_core() {
    when();
    let scenario = Scenario::load(&file("motor.toml"), Board::UNO).expect("a scenario");
    let report = check(&scenario, &mut HostEngine::new(Board::UNO));
    assert!(report.passed(), "{report}");
}

#[test]
fn its_words_have_colours() {
    let colours = colours("fan when motor for 5 s // late", when());
    let shown = colours.iter().map(|(span, colour)| (span.start, *colour));
    let shown: Vec<_> = shown.collect();
    let (word, number, comment) = (Colour::Word, Colour::Number, Colour::Comment);
    let wanted = [
        (4, word),
        (15, word),
        (19, number),
        (21, word),
        (23, comment),
    ];
    assert_eq!(shown, wanted);
}

#[test]
fn every_command_takes_it() {
    let program = file("motor.when");
    let program = program.to_str().expect("a plain name");
    let scenario = file("motor.toml");
    let commands: [(&[&str], &str); 5] = [
        (&["check", program], "WHEN"),
        (&["compile", program], "0 "),
        (&["list", program], "Rung 1"),
        (
            &[
                "sim",
                "--scenario",
                scenario.to_str().expect("a plain name"),
            ],
            "PASS",
        ),
        (&["check", "--language", "basic", program], "lce, when, il"),
    ];
    for (arguments, wanted) in commands {
        let (code, text) = said(arguments);
        assert!(text.contains(wanted), "{arguments:?}: {code:?} {text}");
    }
}

#[test]
fn its_first_words_tell_it() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let program = folder.join("motor.txt");
    std::fs::write(&program, MOTOR).expect("it can be written");
    let (code, text) = said(&["check", program.to_str().expect("a plain name")]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("WHEN"), "{text}");
}

#[test]
fn what_is_wrong_is_told_at_its_place() {
    for case in MISTAKES.split("\n====\n") {
        let (text, wanted) = case
            .split_once("\n----\n")
            .expect("a text and what is told");
        let found = compile_text(text, when(), Board::UNO).diagnostics;
        let told: Vec<String> = found
            .iter()
            .map(|d| {
                format!(
                    "{} {}..{} {}",
                    d.code,
                    d.span.start,
                    d.span.end,
                    d.message(Lang::En)
                )
            })
            .collect();
        assert_eq!(told.join("\n"), wanted.trim_end(), "{text}");
        assert!(found.iter().all(|d| !d.message(Lang::Pt).contains('{')));
    }
}

#[test]
fn a_hundred_thousand_of_anything_is_one_error() {
    let head = "a is input 1\nq is output 1\nq when ";
    for (open, close) in [
        ("(", ""),
        ("not ", "a"),
        ("a and ", "a"),
        ("a or ", "a"),
        ("?", ""),
        ("", ""),
    ] {
        let text = format!("{head}{}{close}", open.repeat(100_000));
        let errors = compile_text(&text, when(), Board::UNO).diagnostics.len();
        assert_eq!(errors, 1, "{open}");
    }
}
