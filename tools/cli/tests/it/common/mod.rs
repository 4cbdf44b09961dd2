//! What the tests of the program `unoclp` share: its files, and running it.
#![allow(dead_code)]

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// Where the files of the tests stand.
pub fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// A new and empty folder for one test.
pub fn empty_folder(name: &str) -> PathBuf {
    let path = folder().join(name);
    if path.exists() {
        fs::remove_dir_all(&path).unwrap();
    }
    fs::create_dir(&path).unwrap();
    path
}

/// A file for one test.
pub fn file(name: &str, content: &str) -> String {
    let path = folder().join(name);
    fs::write(&path, content).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Runs `unoclp` without a terminal, in an environment of this language.
pub fn unoclp(arguments: &[&str], lang: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_unoclp"));
    command
        .args(arguments)
        .env_remove("LC_MESSAGES")
        .env_remove("LANG")
        .env("LC_ALL", lang)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

/// Exit code, standard output and standard error.
pub fn outcome_in(arguments: &[&str], lang: &str) -> (i32, String, String) {
    let Output {
        status,
        stdout,
        stderr,
    } = unoclp(arguments, lang);
    let text = |bytes| String::from_utf8(bytes).unwrap().replace("\r\n", "\n");
    (status.code().unwrap(), text(stdout), text(stderr))
}

/// Likewise in English.
pub fn outcome(arguments: &[&str]) -> (i32, String, String) {
    outcome_in(arguments, "C")
}
