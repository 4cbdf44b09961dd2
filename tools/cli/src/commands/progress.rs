//! A line that changes, if somebody sees it.

use anstream::eprint;
use std::io::{IsTerminal, stderr};

/// Back to the beginning of an empty line.
const ANEW: &str = "\r\x1b[K";

/// Shows this in place of what the line showed before.
pub fn show(text: impl FnOnce() -> String) {
    if stderr().is_terminal() {
        eprint!("{ANEW}{}", text());
    }
}

/// Takes the line back.
pub fn hide() {
    show(String::new);
}
