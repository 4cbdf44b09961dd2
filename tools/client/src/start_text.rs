//! What a board says as it starts: where that ends, and how long it may pause.

use std::time::Duration;

/// Silence after which a board is taken for one that has no start text to say.
pub(crate) const QUIET: Duration = Duration::from_millis(2500);

/// Whether this is all that a board says when it starts: it ends with `RUN`, `STOP` or a fault.
pub(crate) fn is_start_text(said: &[u8]) -> bool {
    let Some(lines) = said.strip_suffix(b"\r\n") else {
        return false;
    };
    let last = lines.rsplit(|&byte| byte == b'\n').next();
    last.is_some_and(|last| last == b"RUN" || last == b"STOP" || last.starts_with(b"fault "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_start_text_ends_with_what_the_board_does() {
        for all in [
            "\r\nunoclp 0.1.0\r\n4 codes\r\nRUN\r\n",
            "STOP\r\n",
            "x\r\nfault 51: no card\r\n",
        ] {
            assert!(is_start_text(all.as_bytes()), "{all:?}");
            let part = &all.as_bytes()[..all.len() - 1];
            assert!(!is_start_text(part), "{all:?}");
        }
        for part in ["", "\r\n", "RUN", "RUN\r\nx\r\n", "unoclp 0.1.0\r\n"] {
            assert!(!is_start_text(part.as_bytes()), "{part:?}");
        }
    }
}
