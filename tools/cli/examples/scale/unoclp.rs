//! Gateways of unoclp, each with a history in SQLite.

use crate::boards::{Lines, OF_LINE, text};
use crate::process::Process;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::net::TcpListener;
use std::path::Path;
use std::process::{Command, Stdio};

/// Lines of a gateway: it has at most 247 boards, one a unit.
const LINES: usize = 200 / OF_LINE;

/// Begins as many gateways as these lines need.
pub fn begin(program: &Path, folder: &Path, lines: &Lines) -> io::Result<Vec<Process>> {
    fs::write(folder.join("p.st"), text())?;
    let all: Vec<usize> = (0..lines.servers.len()).collect();
    let gateways = all.chunks(LINES).enumerate();
    gateways
        .map(|(number, of)| gateway(program, folder, number, of, lines))
        .collect()
}

fn gateway(
    program: &Path,
    folder: &Path,
    number: usize,
    of: &[usize],
    lines: &Lines,
) -> io::Result<Process> {
    // A port that is free, until the gateway takes it.
    let page = TcpListener::bind("127.0.0.1:0")?.local_addr()?;
    let mut site = format!(
        "[http]\nlisten = \"{page}\"\n[history]\nstore = \"{number}.db\"\n[journal]\nstore = \"{number}.journal\"\nevery = \"1s\"\n"
    );
    let mut unit = 0;
    for &line in of {
        let server = lines.servers.get(line).ok_or(io::ErrorKind::NotFound)?;
        // To a string nothing fails.
        let _ = writeln!(site, "[[line]]\ntcp = \"{server}\"");
        for address in 1..=lines.count(line) {
            unit += 1;
            let _ = writeln!(
                site,
                "[[line.board]]\nname = \"b{number}-{unit}\"\naddress = {address}\nunit = {unit}\nprogram = \"p.st\"\nevery = \"500ms\""
            );
        }
    }
    let file = folder.join(format!("{number}.toml"));
    fs::write(&file, site)?;
    let mut command = Command::new(program);
    command.args(["serve", "--site"]).arg(file);
    command.stdout(Stdio::null()).spawn().map(Process)
}
