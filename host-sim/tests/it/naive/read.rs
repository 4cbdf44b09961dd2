//! A program file as instructions, by the table of docs/numeric-code.md: the letters of its codes, and their
//! numbers.

use std::sync::LazyLock;

/// An instruction with all that stands with it.
pub struct Step {
    /// The letters of its code, `NL` or `RI`; a minus is part of them.
    pub letters: String,
    /// XX of its code; 0 where it has none.
    pub xx: usize,
    /// The numbers on the lines that follow.
    pub lines: Vec<i64>,
    /// The line of its code, from 1.
    pub line: u32,
    /// Bytes of program memory that it takes, from the table of the page.
    pub bytes: i64,
    /// Whether it works with a register, or with XX = 00 a constant, or with XX = 99 what was pushed.
    pub takes_number: bool,
}

impl Step {
    /// Whether it is a timer of its own; another with `84XX` calls that again (NC-30).
    pub fn is_own_timer(&self) -> bool {
        let is_timer = matches!(self.letters.as_str(), "TON" | "TOF" | "TOR" | "TP");
        is_timer && self.lines[1] / 100 != 84
    }
}

/// A row of the page's table of codes.
struct Row {
    /// The digits of the code, without XX.
    digits: i64,
    has_xx: bool,
    letters: String,
    /// How many bytes store it: `2`, `2, constant 6`, `3, plus 1 per step`.
    bytes: String,
}

/// The table of codes, as the page has it.
fn page() -> &'static [Row] {
    static PAGE: LazyLock<Vec<Row>> = LazyLock::new(|| {
        let text = include_str!("../../../../docs/numeric-code.md");
        let (_, rest) = text.split_once("<!-- isa:begin -->").unwrap();
        let (table, _) = rest.split_once("<!-- isa:end -->").unwrap();
        let rows = table.lines().filter(|line| line.starts_with('|')).skip(2);
        rows.map(row).collect()
    });
    &PAGE
}

fn row(line: &str) -> Row {
    let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
    let code = cells[0].trim_matches('`');
    let digits = code.strip_suffix("XX");
    Row {
        digits: digits.unwrap_or(code).parse().unwrap(),
        has_xx: digits.is_some(),
        letters: cells[1].strip_suffix(" XX").unwrap_or(cells[1]).to_owned(),
        bytes: cells[4].to_owned(),
    }
}

/// The instructions of a valid program, program start left out.
pub fn read(text: &str) -> Vec<Step> {
    let text = text.strip_prefix('\u{FEFF}').unwrap_or(text);
    let mut codes = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        let code = content.split('/').next().unwrap().trim();
        if !code.is_empty() {
            codes.push((line, code.parse::<i64>().unwrap()));
        }
    }
    let mut codes = codes.into_iter().skip(1);
    let mut steps = Vec::new();
    while let Some((line, code)) = codes.next() {
        let (row, xx) = decode(code);
        let letters = row.letters.clone();
        let takes_number = row.bytes.contains("constant");
        let mut next = || codes.next().unwrap().1;
        let mut lines = Vec::new();
        let name = letters.trim_start_matches('-');
        let count = match name {
            "TON" | "TOF" | "TOR" | "TP" | "MOV" => 2,
            "CTU" | "CTD" | "FLT" | "LDX" | "STX" => 1,
            "SCL" => 4,
            "DRM" => {
                lines.push(next());
                lines[0]
            }
            _ if takes_number && xx == 0 => 1,
            _ => 0,
        };
        lines.extend((0..count).map(|_| next()));
        let bytes = match row.bytes.as_str() {
            _ if takes_number && lines.is_empty() => 2,
            // As a jump back counts it.
            _ if takes_number => 6,
            "3, plus 1 per step" => 3 + lines[0],
            // A point above 16 stands in a byte of its own.
            "1" if xx > 16 => 2,
            bytes => bytes.parse().unwrap(),
        };
        steps.push(Step {
            letters,
            xx,
            lines,
            line,
            bytes,
            takes_number,
        });
    }
    steps
}

/// The row of a code, and the number of its point.
fn decode(code: i64) -> (&'static Row, usize) {
    let fits = |row: &&Row| row.digits == if row.has_xx { code / 100 } else { code };
    let row = page().iter().find(fits);
    let row = row.unwrap_or_else(|| panic!("{code} is no code of the page"));
    let xx = if row.has_xx { code.abs() % 100 } else { 0 };
    (row, xx as usize)
}
