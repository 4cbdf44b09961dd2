//! `cargo xtask wiring`: the wiring of the Mega 2560 as a picture, from the table of its pins in `docs/numeric-code.md`.
//!
//! Owns that picture. Must not know which pin is which. The UNO's picture is drawn by hand, part by part on a breadboard.

use std::fmt::Write;
use std::fs;

use anyhow::{Context, Result, ensure};

use crate::shell::{root, say};

/// The picture that it writes.
pub const PICTURE: &str = "docs/wiring-mega.svg";
/// Where the pins stand, and below which heading.
const PAGE: &str = "docs/numeric-code.md";
const HEADING: &str = "## Pins of the Mega 2560";

/// From one pin to the next; where the board begins, and where its edges are.
const STEP: usize = 30;
const TOP: usize = 92;
const LEFT: usize = 360;
const RIGHT: usize = 560;
/// The rails of GND on both sides.
const RAILS: [usize; 2] = [170, 800];

/// A pin, and what is wired to it.
#[derive(Debug, PartialEq, Eq)]
pub struct Wired {
    /// The pin, as the board is printed.
    pub pin: String,
    /// The point or the signal there.
    pub name: String,
    /// The part.
    pub part: Part,
}

/// What is wired to a pin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// A button to GND.
    Button,
    /// An LED with its resistor to GND.
    Led,
    /// The wiper of a potentiometer.
    Wiper,
    /// A module, named by its signal.
    Module,
}

/// The pins of the table that something is wired to, row by row.
///
/// # Errors
/// If the table is missing, or a row has not as many pins as points.
pub fn wired() -> Result<Vec<Wired>> {
    let text = fs::read_to_string(root().join(PAGE)).context(PAGE)?;
    let (_, table) = text.split_once(HEADING).context(HEADING)?;
    let table = table.split_once("\n## ").map_or(table, |(table, _)| table);
    let mut all = Vec::new();
    for row in table.lines().filter(|line| line.starts_with("| ")) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [point, pins, ..] = cells[..] else {
            continue;
        };
        let (letter, part, numbers) = match point.split_once(' ') {
            Some(("inputs", numbers)) => ("I", Part::Button, numbers),
            Some(("outputs", numbers)) => ("Q", Part::Led, numbers),
            Some(("analogue", numbers)) => ("A", Part::Wiper, numbers.trim_start_matches("A ")),
            _ if point == "STOP" => {
                all.push(one(pins, "STOP", Part::Button));
                continue;
            }
            _ if point == "direction pin" => {
                all.push(one(pins, "RS-485 DE, RE", Part::Module));
                continue;
            }
            _ if point == "card" || point.starts_with("second") => {
                let what = if point == "card" { "card" } else { "RS-485" };
                for (pin, signal) in pins.split(", ").filter_map(|pin| pin.split_once(' ')) {
                    all.push(one(pin, &format!("{what} {signal}"), Part::Module));
                }
                continue;
            }
            _ => continue,
        };
        let [numbers, pins] = [
            range(numbers)?,
            range(pins.trim_end_matches(", descending"))?,
        ];
        ensure!(numbers.len() == pins.len(), "{row}");
        let named = numbers.iter().zip(&pins);
        all.extend(named.map(|((_, number), (port, pin))| {
            one(&format!("{port}{pin}"), &format!("{letter}{number}"), part)
        }));
    }
    Ok(all)
}

fn one(pin: &str, name: &str, part: Part) -> Wired {
    let (pin, name) = (pin.to_owned(), name.to_owned());
    Wired { pin, name, part }
}

/// What `D37–D30` or `01–08` says: letters and number of each, up or down.
fn range(text: &str) -> Result<Vec<(String, u32)>> {
    let end = |end: &str| -> Result<(String, u32)> {
        let digits = end.trim_start_matches(|sign: char| sign.is_ascii_alphabetic());
        let letters = end[..end.len() - digits.len()].to_owned();
        Ok((letters, digits.parse().with_context(|| text.to_owned())?))
    };
    let (first, last) = text.split_once('–').unwrap_or((text, text));
    let ((letters, first), (_, last)) = (end(first)?, end(last)?);
    let numbers: Vec<u32> = match first <= last {
        true => (first..=last).collect(),
        false => (last..=first).rev().collect(),
    };
    let named = numbers.into_iter().map(|number| (letters.clone(), number));
    Ok(named.collect())
}

/// The picture.
///
/// # Errors
/// As [`wired`].
pub fn picture() -> Result<String> {
    let all = wired()?;
    let [left, right]: [Vec<&Wired>; 2] = [true, false].map(|left| {
        all.iter()
            .filter(|one| (one.part == Part::Button) == left)
            .collect()
    });
    let rows = left.len().max(right.len());
    let bottom = TOP + STEP * rows;
    let height = bottom + 96;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 {height}\" width=\"960\" height=\"{height}\" role=\"img\" \
         aria-labelledby=\"title\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"14\" fill=\"#222222\">\n\
         <title id=\"title\">unoclp: wiring of the Arduino Mega 2560 / ligações do Arduino Mega 2560</title>\n\
         <rect width=\"960\" height=\"{height}\" fill=\"#ffffff\"/>\n\
         <text x=\"30\" y=\"42\" font-size=\"26\" font-weight=\"bold\">unoclp</text>\n\
         <text x=\"142\" y=\"42\" font-size=\"20\">wiring of the Arduino Mega 2560 / ligações do Arduino Mega 2560</text>\n\
         <rect x=\"{LEFT}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"12\" fill=\"#00797d\" stroke=\"#004f52\" stroke-width=\"2\"/>\n",
        TOP - 24,
        RIGHT - LEFT,
        bottom - TOP + 32,
    );
    for (side, rail) in [&left, &right].into_iter().zip(RAILS) {
        let is_grounded = |one: &&Wired| matches!(one.part, Part::Button | Part::Led);
        let first = TOP + STEP * side.iter().position(is_grounded).unwrap_or(0);
        let last = TOP + STEP * side.iter().rposition(is_grounded).unwrap_or(0);
        writeln!(
            svg,
            "<path d=\"M{rail},{} V{last}\" stroke=\"#222222\" stroke-width=\"4\"/>\n<text x=\"{rail}\" y=\"{}\" \
             text-anchor=\"middle\" font-weight=\"bold\">GND</text>",
            first - 12,
            first - 18,
        )?;
        for (row, one) in side.iter().enumerate() {
            draw(&mut svg, one, TOP + STEP * row)?;
        }
    }
    for (line, text) in [
        "Potentiometers of 10 kΩ: ends to 5V and GND. LEDs: 330 Ω each. Card module, RS-485 driver: VCC to 5V, GND to GND.",
        "Potenciômetros de 10 kΩ: pontas em 5V e GND. LEDs: 330 Ω cada. Cartão, driver RS-485: VCC em 5V, GND em GND.",
    ]
    .into_iter()
    .enumerate()
    {
        writeln!(svg, "<text x=\"30\" y=\"{}\">{text}</text>", bottom + 44 + 24 * line)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// A pin with what is wired to it, at this height: buttons to the left of the board, the rest to its right.
fn draw(svg: &mut String, one: &Wired, y: usize) -> Result<()> {
    let Wired { pin, name, part } = one;
    let wire = "stroke=\"#0b6b63\" stroke-width=\"2.5\" fill=\"none\"";
    let outline = "stroke=\"#222222\" stroke-width=\"1.5\"";
    let [ground, rail] = RAILS;
    let (x, anchor) = match part {
        Part::Button => (LEFT + 10, "start"),
        _ => (RIGHT - 10, "end"),
    };
    writeln!(
        svg,
        "<text x=\"{x}\" y=\"{}\" text-anchor=\"{anchor}\" fill=\"#ffffff\" font-weight=\"bold\">{pin}</text>",
        y + 5
    )?;
    let (x, anchor) = match part {
        Part::Button => {
            writeln!(
                svg,
                "<path d=\"M{LEFT},{y} H{ground}\" {wire}/>\n<rect x=\"250\" y=\"{}\" width=\"40\" height=\"22\" rx=\"4\" fill=\"#d8dbe0\" \
                 {outline}/>\n<circle cx=\"270\" cy=\"{y}\" r=\"7\" fill=\"#3a3f47\"/>",
                y - 11
            )?;
            (ground - 14, "end")
        }
        Part::Led => {
            writeln!(
                svg,
                "<path d=\"M{RIGHT},{y} H{rail}\" {wire}/>\n<rect x=\"610\" y=\"{}\" width=\"46\" height=\"14\" rx=\"4\" fill=\"#e9d8a6\" \
                 {outline}/>\n<path d=\"M696,{} L722,{y} L696,{} Z M722,{} V{}\" fill=\"#c1121f\" {outline}/>",
                y - 7,
                y - 10,
                y + 10,
                y - 10,
                y + 10
            )?;
            (rail + 14, "start")
        }
        Part::Wiper => {
            writeln!(
                svg,
                "<path d=\"M{RIGHT},{y} H620\" {wire}/>\n<circle cx=\"632\" cy=\"{y}\" r=\"11\" fill=\"#2f6fb5\" {outline}/>\n\
                 <path d=\"M632,{y} l7,-7\" stroke=\"#ffffff\" stroke-width=\"3\"/>",
            )?;
            (656, "start")
        }
        Part::Module => {
            writeln!(svg, "<path d=\"M{RIGHT},{y} H640\" {wire}/>")?;
            (656, "start")
        }
    };
    writeln!(
        svg,
        "<text x=\"{x}\" y=\"{}\" text-anchor=\"{anchor}\" font-weight=\"bold\">{name}</text>",
        y + 5
    )?;
    Ok(())
}

/// Writes it.
///
/// # Errors
/// As [`wired`], or if it cannot be written.
pub fn run() -> Result<()> {
    fs::write(root().join(PICTURE), picture()?).context(PICTURE)?;
    say(&format!("wrote {PICTURE}"));
    Ok(())
}
