//! What a gateway takes for many boards: `scale UNOCLP [BOARDS] [SECONDS]`, with the program `unoclp` as it is handed out. Says it as
//! JSON. The figures are in `docs/site-benchmarks.md`.
//!
//! The boards are simulated in this process, behind Modbus TCP, twenty on each line. Each has a program with 32 names, and is read every
//! 500 ms. One in eight of its points changes from reading to reading. A gateway has 200 of them, and keeps a history.

#[path = "../../client/tests/fake/mod.rs"]
#[allow(unused_imports, reason = "each program uses its part")]
mod fake;

use fake::{Board, Fate, Trick, answer};
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use unoclp_client::diagnostics::Kept;
use unoclp_modbus::map::input;
use unoclp_modbus::{Crc, Table};
use unoclp_site::Files;

/// Boards of a line, and of a gateway.
const OF_LINE: usize = 20;
const OF_GATEWAY: usize = 200;
const POINTS: u64 = 32;
/// Until all boards are found, at most.
const PATIENCE: Duration = Duration::from_secs(60);

/// Readings of whole boards that were answered.
static READINGS: AtomicU64 = AtomicU64::new(0);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let program = PathBuf::from(words.next().ok_or("which program `unoclp`?")?);
    let boards: usize = words.next().map_or(Ok(1_000), |word| word.parse())?;
    let seconds: u64 = words.next().map_or(Ok(20), |word| word.parse())?;
    let folder = std::env::temp_dir().join(format!("unoclp-scale-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    fs::write(folder.join("p.st"), text())?;
    let kept = kept()?;
    let mut gateways = Vec::new();
    for first in (0..boards).step_by(OF_GATEWAY) {
        let count = OF_GATEWAY.min(boards - first);
        gateways.push(gateway(&program, &folder, first, count, kept)?);
    }
    let outcome = measured(&gateways, boards, seconds);
    for mut gateway in gateways {
        gateway.child.kill()?;
        gateway.child.wait()?;
    }
    fs::remove_dir_all(&folder)?;
    println!("{}", outcome?);
    Ok(())
}

/// A gateway that runs, and where its page is.
struct Gateway {
    child: Child,
    page: SocketAddr,
}

fn measured(gateways: &[Gateway], boards: usize, seconds: u64) -> io::Result<String> {
    let begun = Instant::now();
    while begun.elapsed() < PATIENCE && up(gateways)? < boards {
        thread::sleep(Duration::from_millis(200));
    }
    let (up, before) = (up(gateways)?, spent(gateways)?);
    let (readings, begun) = (READINGS.load(Ordering::Relaxed), Instant::now());
    thread::sleep(Duration::from_secs(seconds));
    let wall = begun.elapsed().as_secs_f64();
    let readings = (READINGS.load(Ordering::Relaxed) - readings) * POINTS;
    let processor = spent(gateways)? - before;
    let memory: u64 = gateways.iter().map(memory).sum::<io::Result<u64>>()?;
    Ok(format!(
        "{{\"boards\":{boards},\"up\":{up},\"gateways\":{},\"points\":{POINTS},\"readings\":{:.0},\"core\":{:.3},\"perProcessorSecond\":{:.0},\"megabytes\":{:.0}}}",
        gateways.len(),
        readings as f64 / wall,
        processor / wall,
        readings as f64 / processor,
        memory as f64 / 1_024.0,
    ))
}

/// The text of a program with 32 names.
fn text() -> String {
    let mut text = "PROGRAM p VAR\n".to_owned();
    let mut body = String::new();
    for n in 1..=4 {
        let _ = writeln!(text, "q{n} AT %QX0.{} : BOOL;", n - 1);
        let _ = writeln!(body, "q{n} := v1 > {n};");
    }
    for n in 1..=28 {
        let _ = writeln!(text, "v{n} : DINT;");
        let _ = writeln!(body, "v{n} := v{n} + 1;");
    }
    format!("{text}END_VAR\n{body}END_PROGRAM\n")
}

/// The folder of the site file, which has this program alone.
struct Folder;

impl Files for Folder {
    fn bytes(&self, _: &str) -> Result<Vec<u8>, String> {
        Ok(text().into())
    }
}

/// How a board keeps the program.
fn kept() -> Result<Kept, String> {
    let site = "[[line]]\nport = \"a\"\n[[line.board]]\nname = \"b\"\nprogram = \"p.st\"\n";
    let site = unoclp_site::read(site, &Folder).map_err(|wrong| format!("{wrong:?}"))?;
    let board = site.boards().next().ok_or("no board")?;
    let names = board.points.recorded(true).len();
    if names as u64 != POINTS {
        return Err(format!("the program has {names} names"));
    }
    board.points.program.ok_or("no program".to_owned())
}

/// Begins a gateway of so many boards.
fn gateway(
    program: &Path,
    folder: &Path,
    first: usize,
    boards: usize,
    kept: Kept,
) -> io::Result<Gateway> {
    // A port that is free, until the gateway takes it.
    let page = TcpListener::bind("127.0.0.1:0")?.local_addr()?;
    let mut site = format!(
        "[http]\nlisten = \"{page}\"\n[history]\nstore = \"{first}.db\"\n[journal]\nstore = \"{first}.journal\"\nevery = \"1s\"\n"
    );
    for line in (0..boards).step_by(OF_LINE) {
        let count = OF_LINE.min(boards - line);
        let server = serve(count, kept)?;
        let _ = writeln!(site, "[[line]]\ntcp = \"{server}\"");
        for n in 0..count {
            let (unit, name) = (line + n + 1, first + line + n);
            let _ = writeln!(
                site,
                "[[line.board]]\nname = \"b{name}\"\naddress = {}\nunit = {unit}\nprogram = \"p.st\"\nevery = \"500ms\"",
                n + 1
            );
        }
    }
    let file = folder.join(format!("{first}.toml"));
    fs::write(&file, site)?;
    let mut command = Command::new(program);
    command.args(["serve", "--site"]).arg(file);
    let child = command.stdout(Stdio::null()).spawn()?;
    Ok(Gateway { child, page })
}

/// Serves so many boards at a port of this PC, for ever.
fn serve(boards: usize, kept: Kept) -> io::Result<SocketAddr> {
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let address = listener.local_addr()?;
    let mut boards: Vec<Board> = (1..=boards)
        .map(|number| {
            let mut board = Board {
                kept,
                ..Board::default()
            };
            board.settings[0] = number as u16;
            board
        })
        .collect();
    thread::Builder::new()
        .stack_size(256 << 10)
        .spawn(move || {
            for stream in listener.incoming().flatten() {
                // Its end is nobody's concern: the gateway comes again.
                let _ = speak(stream, &mut boards);
            }
        })?;
    Ok(address)
}

/// Answers a gateway until it leaves.
fn speak(mut stream: TcpStream, boards: &mut [Board]) -> io::Result<()> {
    stream.set_nodelay(true)?;
    let mut trick: Trick = Box::new(|_, _| Fate::Answered);
    loop {
        let mut head = [0; 7];
        stream.read_exact(&mut head)?;
        let length = usize::from(u16::from_be_bytes([head[4], head[5]]));
        let mut request = vec![head[6]; length];
        stream.read_exact(request.get_mut(1..).unwrap_or_default())?;
        let board = usize::from(head[6]).checked_sub(1);
        let Some(board) = board.and_then(|at| boards.get_mut(at)) else {
            continue;
        };
        if request.get(1) == Some(&4)
            && request.get(2..4) == Some(&input::STATE.first.to_be_bytes())
        {
            READINGS.fetch_add(1, Ordering::Relaxed);
            step(board);
        }
        request.extend(Crc::of(&request).to_bytes());
        let (_, mut reply) = answer(board, &mut trick, &request);
        reply.truncate(reply.len().saturating_sub(2));
        let [high, low] = (reply.len() as u16).to_be_bytes();
        let mut frame = vec![head[0], head[1], 0, 0, high, low];
        frame.append(&mut reply);
        stream.write_all(&frame)?;
    }
}

/// One in eight of its values changes.
fn step(board: &mut Board) {
    for value in 0..4 {
        let low = board
            .words
            .entry((Table::HoldingRegisters as u16, 2001 + 14 * value))
            .or_default();
        *low = low.wrapping_add(1);
    }
}

/// How many boards the gateways have.
fn up(gateways: &[Gateway]) -> io::Result<usize> {
    let mut all = 0;
    for Gateway { page, .. } in gateways {
        let Ok(mut stream) = TcpStream::connect(page) else {
            continue;
        };
        write!(
            stream,
            "GET /health HTTP/1.1\r\nHost: {page}\r\nConnection: close\r\n\r\n"
        )?;
        let mut answer = String::new();
        stream.read_to_string(&mut answer)?;
        let up = answer.split("\"up\":").nth(1).unwrap_or_default();
        let up: String = up.chars().take_while(char::is_ascii_digit).collect();
        all += up.parse::<usize>().unwrap_or_default();
    }
    Ok(all)
}

/// Processor time of the gateways, s.
fn spent(gateways: &[Gateway]) -> io::Result<f64> {
    let mut ticks = 0;
    for Gateway { child, .. } in gateways {
        let stat = fs::read_to_string(format!("/proc/{}/stat", child.id()))?;
        let after = stat.rsplit(')').next().unwrap_or_default();
        let fields = after.split_whitespace().skip(11).take(2);
        ticks += fields
            .filter_map(|field| field.parse::<u64>().ok())
            .sum::<u64>();
    }
    // As Linux counts them.
    Ok(ticks as f64 / 100.0)
}

/// What a gateway has in memory, KB.
fn memory(Gateway { child, .. }: &Gateway) -> io::Result<u64> {
    let status = fs::read_to_string(format!("/proc/{}/status", child.id()))?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let number = line.and_then(|line| line.split_whitespace().next());
    Ok(number.and_then(|number| number.parse().ok()).unwrap_or(0))
}
