//! Clients of Modbus TCP that others have written.

use crate::site::{Site, register};
use std::path::Path;
use std::process::Command;
use unoclp_modbus::Table;
use unoclp_modbus::map::Width;
use unoclp_site::{Grant, Place};

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn said(command: &mut Command) -> String {
    let output = command.output().expect("`cargo xtask setup` brings it");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}{error}");
    said
}

#[test]
fn pymodbus_calls_every_function() {
    let marker = Grant {
        places: vec![Place {
            table: Table::Coils,
            first: 16,
            width: Width::Bit,
        }],
        ..register(0, None)
    };
    let site = Site::new(vec![register(0, None), marker]);
    let said = said(
        Command::new(root().join("target/python/bin/python3"))
            .arg(root().join("tools/serve/tests/tcp.py"))
            .arg(site.modbus.port().to_string()),
    );
    assert!(said.ends_with("refused: what is not named\n"), "{said}");
}

#[test]
fn mbpoll_reads_and_writes() {
    let site = Site::new(vec![register(0, None)]);
    let mbpoll = |options: &str, values: &str| {
        let port = site.modbus.port();
        let common = format!("-m tcp -p {port} -0 -1 -o 5 {options} 127.0.0.1 {values}");
        said(Command::new("mbpoll").args(common.split_whitespace()))
    };
    mbpoll("-a 1 -t 4:int -B -r 0", "70000");
    assert!(mbpoll("-a 1 -t 4:int -B -r 0 -c 1", "").contains("[0]: \t70000"));
    site.boards.board(4).inputs = 0b100;
    assert!(mbpoll("-a 2 -t 1 -r 0 -c 8", "").contains("[2]: \t1"));
}
