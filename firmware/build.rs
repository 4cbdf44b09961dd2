//! Learns the code that the firmware's texts stand in: which pairs of bytes are worth a byte.
//!
//! A code from 0x80 on stands for two codes, each of them a character or a pair learnt before. The
//! pairs are learnt from the fault texts and from the literals in `flash_text!`; what is missed
//! there is not coded wrong, only less densely.

use std::collections::BTreeMap;
use std::path::Path;
use std::{env, fs};

use unoclp_core::Cause;

/// The first code that stands for a pair.
const FIRST: u8 = 0x80;
/// How many pairs there may be.
const PAIRS: usize = 0x80;
/// How deep pairs may stand in pairs: the firmware follows them by recursion.
const DEPTH: u8 = 4;
/// A pair has to occur more often than the bytes that it takes itself.
const COST: usize = 2;

fn main() {
    println!("cargo::rerun-if-changed=src");
    board();
    let mut texts: Vec<Vec<u8>> = Cause::ALL.iter().map(|cause| cause.text().into()).collect();
    literals(Path::new("src"), &mut texts);
    let pairs = learn(texts);
    let folder = env::var("OUT_DIR").expect("cargo names the folder");
    let table = format!("{pairs:?}");
    fs::write(Path::new(&folder).join("pairs.rs"), table).expect("the folder is there");
    second_port(Path::new(&folder));
}

/// What the second serial port of a Mega is called by where the first is this: names, registers by name, and registers by
/// address in `port.s`.
const SECOND_PORT: &[(&str, &str)] = &[
    ("PORT_", "BUS_"),
    (" port_", " bus_"),
    ("\nport_", "\nbus_"),
    ("interrupt", "bus_interrupt"),
    ("direction_low", "bus_direction_low"),
    (
        "include_str!(\"port.s\")",
        "include_str!(concat!(env!(\"OUT_DIR\"), \"/bus.s\"))",
    ),
    ("IS_BUS: bool = false", "IS_BUS: bool = true"),
    ("USART0", "USART1"),
    ("TC2", "TC0"),
    ("ocr2", "ocr0"),
    ("tccr2", "tccr0"),
    ("cs2", "cs0"),
    ("tifr2", "tifr0"),
    ("ubrr0", "ubrr1"),
    ("ucsr0", "ucsr1"),
    ("udr0", "udr1"),
    ("udre0", "udre1"),
    ("0xC0", "0xC8"),
    ("0xC1", "0xC9"),
    ("0xC6", "0xCE"),
    ("0xB2", "0x46"),
    ("0xB4", "0x48"),
    ("0x17,", "0x15,"),
];

/// The sources of the second port from those of the first, since they differ in nothing else. A [`Line`] is the same.
fn second_port(folder: &Path) {
    for (first, second) in [("serial.rs", "bus.rs"), ("port.s", "bus.s")] {
        let source = fs::read_to_string(Path::new("src/board").join(first)).expect("a source");
        let lines = source.lines().filter(|line| !line.starts_with("//!"));
        let mut text = lines.collect::<Vec<_>>().join("\n");
        if let Some((before, rest)) = text.split_once("/// What the line is like.")
            && let Some((_, behind)) = rest.split_once("/// The serial port.")
        {
            text = format!("{before}pub use super::serial::Line;\n\n/// The serial port.{behind}");
        }
        for (name, other) in SECOND_PORT {
            text = text.replace(name, other);
        }
        fs::write(folder.join(second), text + "\n").expect("the folder is there");
    }
}

/// Compiles for the board that `cargo xtask firmware` names; for the UNO where none is named. A feature of cargo's would
/// become part of the names of all functions, and so of their order: another firmware for the UNO.
fn board() {
    const BOARD: &str = "UNOCLP_BOARD";
    println!("cargo::rustc-check-cfg=cfg(nano)");
    println!("cargo::rerun-if-env-changed={BOARD}");
    match env::var(BOARD).as_deref() {
        Ok("nano") => println!("cargo::rustc-cfg=nano"),
        // `cfg(mega)` comes from whoever names it: the crates below the firmware are compiled for the board too.
        Ok("uno" | "mega") | Err(_) => {}
        Ok(other) => panic!("{BOARD} is uno, nano or mega, not {other}"),
    }
}

/// The first literal of each `flash_text!` in the sources of this folder.
fn literals(folder: &Path, texts: &mut Vec<Vec<u8>>) {
    let mut paths: Vec<_> = fs::read_dir(folder)
        .expect("a folder of sources")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            literals(&path, texts);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let source = fs::read_to_string(path).expect("a source");
            let uses = source.split("flash_text!(").skip(1);
            texts.extend(uses.filter_map(|rest| {
                let literal = rest.split('"').nth(1)?;
                Some(literal.replace("\\r", "\r").replace("\\n", "\n").into())
            }));
        }
    }
}

/// The pairs, the most frequent first.
fn learn(mut texts: Vec<Vec<u8>>) -> Vec<[u8; 2]> {
    let mut pairs = Vec::new();
    let mut depths = [0; 256];
    while pairs.len() < PAIRS {
        let mut counts = BTreeMap::new();
        for pair in texts.iter().flat_map(|text| text.array_windows()) {
            *counts.entry(*pair).or_insert(0) += 1;
        }
        let depth = |pair: [u8; 2]| {
            1 + pair
                .map(|code| depths[usize::from(code)])
                .into_iter()
                .max()
                .unwrap_or(0)
        };
        let best = counts
            .into_iter()
            .filter(|(pair, _)| depth(*pair) <= DEPTH)
            .max_by_key(|(_, count)| *count);
        let Some((pair, count)) = best else { break };
        if count <= COST {
            break;
        }
        let code = FIRST + pairs.len() as u8;
        depths[usize::from(code)] = depth(pair);
        pairs.push(pair);
        for text in &mut texts {
            replace(text, pair, code);
        }
    }
    pairs
}

fn replace(text: &mut Vec<u8>, pair: [u8; 2], code: u8) {
    let mut at = 0;
    while at + 1 < text.len() {
        if text[at..at + 2] == pair {
            text.splice(at..at + 2, [code]);
        }
        at += 1;
    }
}
