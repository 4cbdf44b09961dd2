//! A program file as instructions: the letters that its codes spell, and their numbers.

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
}

/// The codes that end in no XX.
const PLAIN: &[&str] = &[
    "(", ")", "TON", "TOF", "TOR", "TP", "NOT", "EU", "ED", "A(", "X(", "RET", "NEG", "SQR", "SCL",
];

/// Operations that take a register or, with XX = 00, a constant.
pub const OPERATIONS: &[&str] = &[
    "LD", "ADD", "SUB", "MUL", "DIV", "MOD", "AND", "OR", "XOR", "GT", "GE", "EQ", "NE", "LE", "LT",
];

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
        let (letters, xx) = decode(code);
        let mut next = || codes.next().unwrap().1;
        let mut lines = Vec::new();
        let name = letters.trim_start_matches('-');
        let count = match name {
            "TON" | "TOF" | "TOR" | "TP" | "MOV" => 2,
            "CTU" | "CTD" | "FLT" => 1,
            "SCL" => 4,
            "DRM" => {
                lines.push(next());
                lines[0]
            }
            _ if OPERATIONS.contains(&name) && xx == 0 => 1,
            _ => 0,
        };
        lines.extend((0..count).map(|_| next()));
        let bytes = match name {
            "NL" | "(" | ")" | "A(" | "X(" | "NOT" | "EU" | "ED" | "RET" | "NEG" | "SQR"
            | "LDI" | "LDO" | "LDB" | "STO" | "RI" | "RO" | "SWO" | "RWO" | "()" => 1,
            "WO" if letters == "WO" => 1,
            "TON" | "TOF" | "TOR" | "TP" | "CTU" | "CTD" => 6,
            "MOV" | "FLT" | "JMP" => 4,
            "SCL" => 9,
            "DRM" => 3 + lines[0],
            _ if OPERATIONS.contains(&name) && xx == 0 => 6,
            _ => 2,
        };
        steps.push(Step {
            letters,
            xx,
            lines,
            line,
            bytes,
        });
    }
    steps
}

/// Each pair of digits is a letter, and the last two are the number of a point.
fn decode(code: i64) -> (String, usize) {
    let minus = if code < 0 { "-" } else { "" };
    let plain = letters(code.abs());
    if PLAIN.contains(&plain.as_str()) {
        return (format!("{minus}{plain}"), 0);
    }
    let spelt = letters(code.abs() / 100);
    (format!("{minus}{spelt}"), (code.abs() % 100) as usize)
}

fn letters(mut code: i64) -> String {
    let mut letters = Vec::new();
    while code > 0 {
        letters.push((code % 100) as u8 as char);
        code /= 100;
    }
    letters.iter().rev().collect()
}
