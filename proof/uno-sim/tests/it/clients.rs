//! Modbus clients that others have written, on the pseudo-terminal of `unoclp-uno-sim serve`.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use unoclp_uno_sim::firmware_file;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Output 01 follows input 01, which starts a TON and counts C 01 up.
const PROGRAM: &str = "0\n827301\n877901\n67848501\n5\n787600\n827301\n847978\n70000\n7702\n";

/// The firmware with a program behind a pseudo-terminal, in RUN, and the path of that.
struct Serve {
    child: Child,
    path: String,
    // Open all the time: it keeps what the port is set to.
    _port: File,
}

impl Serve {
    fn start(name: &str) -> Serve {
        let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        std::fs::write(&program, PROGRAM).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_unoclp-uno-sim"))
            .args(["serve", "--elf"])
            .arg(firmware_file().unwrap())
            .arg(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut path = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut path)
            .unwrap();
        let path = path.trim_end().to_owned();
        let mut port = File::open(&path).unwrap();
        let mut said = Vec::new();
        while !said.ends_with(b"RUN\r\n") {
            let mut byte = [0];
            port.read_exact(&mut byte).unwrap();
            said.push(byte[0]);
        }
        Serve {
            child,
            path,
            _port: port,
        }
    }
}

impl Drop for Serve {
    fn drop(&mut self) {
        drop(self.child.stdin.take());
        let _ = self.child.wait();
    }
}

#[test]
fn pymodbus_calls_every_function() {
    let serve = Serve::start("pymodbus.txt");
    let output = Command::new(root().join("target/python/bin/python3"))
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/clients.py"))
        .arg(&serve.path)
        .output()
        .expect("`cargo xtask setup` brings it");
    let said = String::from_utf8_lossy(&output.stdout);
    let error = String::from_utf8_lossy(&output.stderr);
    println!("pymodbus: {said}");
    assert!(output.status.success(), "{said}{error}");
    assert!(said.ends_with("exceptions 1 to 4\n"), "{said}");
}

/// What mbpoll says, which asks once; it counts addresses from 0 here.
fn mbpoll(serve: &Serve, options: &str, values: &str) -> String {
    let output = Command::new("mbpoll")
        .args("-m rtu -a 1 -b 115200 -P none -0 -1 -o 5".split(' '))
        .args(options.split(' '))
        .arg(&serve.path)
        .args(values.split_whitespace())
        .output()
        .expect("`cargo xtask setup` brings it");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        output.status.success(),
        "{options}: {said}{}",
        String::from_utf8_lossy(&output.stderr)
    );
    said
}

/// The values of lines such as `[402]: 1`, with a tab in place of the blank.
fn values(said: &str) -> Vec<u16> {
    let line = |line: &str| {
        line.strip_prefix('[')?
            .split_once("]:")?
            .1
            .trim()
            .parse()
            .ok()
    };
    said.lines().filter_map(line).collect()
}

#[test]
fn mbpoll_calls_every_function() {
    let serve = Serve::start("mbpoll.txt");
    // 6, 16 and 3
    mbpoll(&serve, "-t 4 -r 402", "1");
    mbpoll(&serve, "-t 4 -r 402", "1 1 2 2");
    assert_eq!(
        values(&mbpoll(&serve, "-t 4 -r 402 -c 4", "")),
        [1, 1, 2, 2]
    );
    // 2
    assert_eq!(values(&mbpoll(&serve, "-t 1 -r 0 -c 4", "")), [1, 0, 0, 0]);
    // 5, 15 and 1
    mbpoll(&serve, "-t 0 -r 2", "1");
    mbpoll(&serve, "-t 0 -r 2", "0 1");
    assert_eq!(values(&mbpoll(&serve, "-t 0 -r 1 -c 3", "")), [1, 0, 1]);
    // 4
    assert_eq!(values(&mbpoll(&serve, "-t 3 -r 16 -c 2", "")), [1, 0x104]);
    // Markers, registers, a timer's preset, a counter.
    mbpoll(&serve, "-t 0 -r 77", "1 0 1");
    assert_eq!(values(&mbpoll(&serve, "-t 0 -r 77 -c 3", "")), [1, 0, 1]);
    mbpoll(&serve, "-t 4 -r 62", "4660 22136");
    assert_eq!(
        values(&mbpoll(&serve, "-t 4 -r 62 -c 2", "")),
        [4660, 22136]
    );
    assert_eq!(values(&mbpoll(&serve, "-t 4 -r 128 -c 2", "")), [1, 4464]);
    mbpoll(&serve, "-t 4 -r 128", "2 0");
    assert_eq!(values(&mbpoll(&serve, "-t 4 -r 128 -c 2", "")), [2, 0]);
    assert_eq!(values(&mbpoll(&serve, "-t 3 -r 320 -c 2", "")), [0, 1]);
}
