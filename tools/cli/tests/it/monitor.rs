//! `unoclp monitor` in a terminal, which a pseudo-terminal is.

use crate::pty::{Board, Fake};
use rustix::termios::{Winsize, tcsetwinsize};
use serialport::{SerialPort, TTYPort};
use std::fs::File;
use std::io::{ErrorKind, Read, Write};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A monitor, and the terminal that it is in.
struct Monitor {
    child: Child,
    terminal: TTYPort,
    /// Kept open, so that what is shown at the end is not lost.
    _user: TTYPort,
    shown: Vec<u8>,
}

impl Monitor {
    fn new(fake: &Fake, more: &[&str]) -> Monitor {
        let (mut terminal, user) = TTYPort::pair().unwrap();
        terminal.set_timeout(Duration::from_millis(5)).unwrap();
        let path = user.name().unwrap();
        let side = || File::options().read(true).write(true).open(&path).unwrap();
        let size = Winsize {
            ws_row: 24,
            ws_col: 80,
            ws_xpixel: 0,
            ws_ypixel: 0,
        };
        tcsetwinsize(side(), size).unwrap();
        let child = Command::new(env!("CARGO_BIN_EXE_unoclp"))
            .args(["monitor", "--port", fake.path()])
            .args(more)
            .env("LC_ALL", "C")
            .stdin(Stdio::from(side()))
            .stdout(Stdio::from(side()))
            .stderr(Stdio::inherit())
            .spawn()
            .unwrap();
        Monitor {
            child,
            terminal,
            _user: user,
            shown: Vec::new(),
        }
    }

    /// Takes what is shown; says whether there was anything.
    fn look(&mut self) -> bool {
        let mut bytes = [0; 4096];
        match self.terminal.read(&mut bytes) {
            Ok(count) => self.shown.extend(&bytes[..count]),
            Err(error) if error.kind() == ErrorKind::TimedOut => return false,
            Err(error) => panic!("{error}"),
        }
        true
    }

    /// What is shown so far.
    fn shown(&self) -> String {
        String::from_utf8_lossy(&self.shown).into_owned()
    }

    fn has_ended(&mut self) -> bool {
        self.child.try_wait().unwrap().is_some()
    }

    /// Waits until it is so.
    fn until(&mut self, is_so: impl Fn(&Monitor) -> bool) {
        while !is_so(self) {
            assert!(!self.has_ended(), "{:?}", self.shown());
            self.look();
        }
    }

    fn press(&mut self, key: u8) {
        self.terminal.write_all(&[key]).unwrap();
    }

    /// Leaves; gives all that was shown.
    fn quit(mut self) -> String {
        self.press(b'q');
        loop {
            let has_ended = self.has_ended();
            while self.look() {}
            if has_ended {
                return self.shown();
            }
        }
    }
}

impl Drop for Monitor {
    fn drop(&mut self) {
        // One that has ended is left alone; another must not outlive a test that has failed.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn whoever_leaves_is_told_what_stays_forced_and_how_long() {
    for (more, ends, says) in [
        (
            &["--end-forcing", "10"][..],
            10,
            "; the board releases them 10 s after",
        ),
        (&[], 0, "; to release them, press x in the monitor"),
    ] {
        let fake = Fake::new(Board::default());
        let mut monitor = Monitor::new(&fake, more);
        monitor.until(|monitor| monitor.shown().contains("I1"));
        monitor.press(b'1');
        monitor.until(|_| fake.board().forces[0] != 0);
        assert_eq!(fake.board().forces, [1, 1, 0, 0, ends]);
        let shown = monitor.quit();
        let stays = shown.find("still forced: I1=");
        let stays = stays.map(|at| &shown[at..]).unwrap_or_default();
        assert!(stays.contains(says), "{shown:?}");
    }
}

#[test]
fn a_program_in_any_language_is_shown_by_its_names() {
    for (name, text, shows) in [
        (
            "shown.st",
            "VAR level : REAL; p : STRUCT n : DINT; END_STRUCT; END_VAR\nlevel := level + 0.5; p.n := p.n + 1;\n",
            &["level", "p.n"][..],
        ),
        (
            "shown.iscl",
            "BLOCO INT n; n := n + 1; PRINT(n); END_BLOCK\n",
            &["Watched"],
        ),
        (
            "shown.lce",
            "var V0 = nivel;\nnivel := nivel + 1;\n",
            &["nivel"],
        ),
    ] {
        let program = crate::common::file(name, text);
        let written =
            unoclp_program::Written::new(name.to_owned(), text.into(), unoclp_core::Board::UNO);
        let source = written.check(None).unwrap();
        let kept = unoclp_client::diagnostics::Kept::of(source.program());
        let fake = Fake::new(Board {
            kept,
            ..Board::default()
        });
        let mut monitor = Monitor::new(&fake, &[&program]);
        monitor.until(|monitor| shows.iter().all(|name| monitor.shown().contains(name)));
        monitor.quit();
    }
}
