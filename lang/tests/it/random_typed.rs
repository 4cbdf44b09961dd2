//! Random typed programs: the board's core does what the interpreter does, scan by scan.
//!
//! `UNOCLP_TYPED_PROGRAMS` sets how many, `UNOCLP_TYPED_SEED` the first seed.

use crate::board::{Twins, compiled, errors, with_plc};
use crate::common::Random;
use std::fmt::Write;
use unoclp_lang::TextLanguage;
use unoclp_lang::typed::{Base, Value};

const SCANS: u32 = 20;

const NUMBERS: [(&str, &str); 9] = [
    ("SINT", "si"),
    ("INT", "i"),
    ("DINT", "d"),
    ("USINT", "us"),
    ("UINT", "u"),
    ("UDINT", "ud"),
    ("BYTE", "by"),
    ("WORD", "w"),
    ("DWORD", "dw"),
];

/// Writes a text.
struct Author {
    random: Random,
    loops: usize,
    text: String,
    depth: usize,
    /// Blocks that are still to be called.
    blocks: Vec<(&'static str, String)>,
    in_loop: bool,
}

impl Author {
    fn number(&mut self, ty: &str) -> String {
        let (low, high): (i64, i64) = match ty {
            "SINT" => (-128, 127),
            "INT" => (-32768, 32767),
            "DINT" => (i32::MIN.into(), i32::MAX.into()),
            "USINT" | "BYTE" => (0, 255),
            "UINT" | "WORD" => (0, 65535),
            _ => (0, u32::MAX.into()),
        };
        let number = match self.random.below(4) {
            0 => low,
            1 => high,
            2 => (self.random.below(12) as i64).min(high),
            _ => low + (self.random.bits() % (high - low + 1) as u64) as i64,
        };
        match ty {
            "BYTE" | "WORD" | "DWORD" => format!("{ty}#16#{number:X}"),
            _ => format!("{ty}#{number}"),
        }
    }

    fn name(&mut self, ty: &str) -> String {
        let prefix = NUMBERS
            .iter()
            .find(|(known, _)| *known == ty)
            .map_or("i", |(_, p)| p);
        match self.random.below(6) {
            0 if ty == "INT" => format!("a[{}]", self.subscript()),
            1 if ty == "INT" => format!("m[{}, {}]", self.subscript(), self.subscript()),
            2 if ty == "DINT" => format!("p[{}].x", self.subscript()),
            _ => format!("{prefix}{}", self.random.below(2)),
        }
    }

    fn subscript(&mut self) -> String {
        match self.random.below(4) {
            0 => self.random.below(3).to_string(),
            1 => "i0 MOD 3".to_owned(),
            2 => format!("k{}", self.random.below(2)),
            _ => "d1 + 1".to_owned(),
        }
    }

    fn value(&mut self, ty: &str, deep: usize) -> String {
        let bits = matches!(ty, "BYTE" | "WORD" | "DWORD");
        if deep == 0 {
            return match self.random.below(3) {
                0 => self.number(ty),
                _ => self.name(ty),
            };
        }
        let next = deep - 1;
        if bits {
            return match self.random.below(6) {
                0 => format!("NOT {}", self.atom(ty, next)),
                1 => format!("SHL({}, {})", self.value(ty, next), self.random.below(34)),
                2 => format!("SHR({}, {})", self.value(ty, next), self.random.below(34)),
                3 => format!("ROL({}, {})", self.value(ty, next), self.random.below(34)),
                4 => self.value(ty, 0),
                _ => {
                    let op = self.random.pick(&["AND", "OR", "XOR"]);
                    format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
                }
            };
        }
        match self.random.below(12) {
            0 if !ty.starts_with('U') => format!("-{}", self.atom(ty, next)),
            1 => format!("ABS({})", self.value(ty, next)),
            2 => format!("MAX({}, {})", self.value(ty, next), self.value(ty, next)),
            3 => format!("MIN({}, {})", self.value(ty, next), self.value(ty, next)),
            4 => format!(
                "SEL({}, {}, {})",
                self.truth(next),
                self.value(ty, next),
                self.value(ty, next)
            ),
            5 => {
                let (from, _) = self.random.pick(&NUMBERS);
                match from == ty {
                    true => self.value(ty, next),
                    false => format!("{from}_TO_{ty}({})", self.value(from, next)),
                }
            }
            6 => format!("BOOL_TO_{ty}({})", self.truth(next)),
            7 if !ty.starts_with("U") => format!("REAL_TO_{ty}({})", self.real(next)),
            8 => format!(
                "LIMIT({}, {}, {})",
                self.value(ty, 0),
                self.value(ty, next),
                self.value(ty, 0)
            ),
            9 if ty == "INT" => format!("Twice({})", self.value(ty, next)),
            10 => format!(
                "MUX({}, {}, {}, {})",
                self.value("DINT", 0),
                self.value(ty, next),
                self.value(ty, 0),
                self.value(ty, 0)
            ),
            _ => {
                let op = self.random.pick(&["+", "-", "*", "/", "MOD", "+", "-"]);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
        }
    }

    fn atom(&mut self, ty: &str, deep: usize) -> String {
        format!("({})", self.value(ty, deep))
    }

    fn real(&mut self, deep: usize) -> String {
        if deep == 0 {
            return match self.random.below(3) {
                0 => self
                    .random
                    .pick(&["0.5", "-2.25", "1.0E10", "3.1415", "0.0"])
                    .to_owned(),
                _ => format!("r{}", self.random.below(2)),
            };
        }
        let next = deep - 1;
        match self.random.below(8) {
            0 => format!("INT_TO_REAL({})", self.value("INT", next)),
            1 => format!("DINT_TO_REAL({})", self.value("DINT", next)),
            2 => format!("ABS({})", self.real(next)),
            3 => format!("SQRT({})", self.real(next)),
            4 => format!("MAX({}, {})", self.real(next), self.real(next)),
            5 => format!("EXPT({}, {})", self.real(next), self.random.below(5)),
            _ => {
                let op = self.random.pick(&["+", "-", "*", "/"]);
                format!("({} {op} {})", self.real(next), self.real(next))
            }
        }
    }

    fn bit(&mut self) -> String {
        match self.random.below(8) {
            0 => format!("%IX{}", 1 + self.random.below(4)),
            1 => format!("f[{}]", self.subscript()),
            2 => "p[1].on".to_owned(),
            3 => "lamp".to_owned(),
            _ => format!("b{}", self.random.below(4)),
        }
    }

    fn truth(&mut self, deep: usize) -> String {
        if deep == 0 {
            return self.bit();
        }
        let next = deep - 1;
        match self.random.below(9) {
            0 => format!("NOT {}", self.bit()),
            1 => format!("NOT ({})", self.truth(next)),
            2 | 3 => {
                let (ty, _) = self.random.pick(&NUMBERS);
                let op = self.random.pick(&["<", "<=", ">", ">=", "=", "<>"]);
                format!("({} {op} {})", self.value(ty, next), self.value(ty, next))
            }
            4 => {
                let op = self.random.pick(&["<", "<=", ">", ">=", "=", "<>"]);
                format!("({} {op} {})", self.real(next), self.real(next))
            }
            5 => format!("DINT_TO_BOOL({})", self.value("DINT", next)),
            6 => format!(
                "SEL({}, {}, {})",
                self.bit(),
                self.truth(next),
                self.truth(next)
            ),
            _ => {
                let op = self.random.pick(&["AND", "OR", "XOR", "AND", "OR", "="]);
                format!("({} {op} {})", self.truth(next), self.truth(next))
            }
        }
    }

    fn line(&mut self, line: &str) {
        for _ in 0..self.depth {
            self.text.push_str("  ");
        }
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn statements(&mut self, count: usize) {
        for _ in 0..count {
            self.statement();
        }
    }

    fn body(&mut self, count: usize) {
        self.depth += 1;
        self.statements(count);
        self.depth -= 1;
    }

    fn statement(&mut self) {
        let deep = 1 + self.random.below(3);
        match self.random.below(20) {
            0..=5 => {
                let (ty, _) = self.random.pick(&NUMBERS);
                let to = self.name(ty);
                let value = self.value(ty, deep);
                self.line(&format!("{to} := {value};"));
            }
            6..=8 => {
                let value = self.truth(deep);
                let to = match self.random.below(4) {
                    0 => "lamp".to_owned(),
                    1 => format!("f[{}]", self.subscript()),
                    _ => format!("b{}", self.random.below(4)),
                };
                self.line(&format!("{to} := {value};"));
            }
            9 => {
                let (to, value) = (self.random.below(2), self.real(deep));
                self.line(&format!("r{to} := {value};"));
            }
            10 => {
                let value = self.value("INT", deep);
                self.line(&format!("narrow := {value};"));
            }
            11..=13 if self.depth < 4 => {
                let condition = self.truth(deep.min(2));
                self.line(&format!("IF {condition} THEN"));
                let count = 1 + self.random.below(2);
                self.body(count);
                if self.random.percent(40) {
                    let condition = self.truth(1);
                    self.line(&format!("ELSIF {condition} THEN"));
                    self.body(1);
                }
                if self.random.percent(50) {
                    self.line("ELSE");
                    self.body(1);
                }
                self.line("END_IF;");
            }
            14 if self.depth < 3 => {
                let value = self.value("INT", 1);
                self.line(&format!("CASE {value} OF"));
                self.line("1, 3:");
                self.body(1);
                self.line("-5..0, 7..90:");
                self.body(1);
                if self.random.percent(60) {
                    self.line("ELSE");
                    self.body(1);
                }
                self.line("END_CASE;");
            }
            15 if self.loops < 2 && self.depth < 3 => {
                let number = self.loops;
                self.loops += 1;
                let (from, to) = (self.random.below(4), self.random.below(5));
                let to = match self.random.percent(50) {
                    true => to.to_string(),
                    false => format!("MIN({to}, {})", self.value("INT", 1)),
                };
                let down = self.random.percent(25);
                let by = if down { " BY -1" } else { "" };
                let to = if down { "0".to_owned() } else { to };
                self.line(&format!("FOR k{number} := {from} TO {to}{by} DO"));
                let was = std::mem::replace(&mut self.in_loop, true);
                self.body(1);
                if self.random.percent(40) {
                    let condition = self.truth(1);
                    let word = self.random.pick(&["EXIT", "CONTINUE"]);
                    self.depth += 1;
                    self.line(&format!("IF {condition} THEN {word}; END_IF;"));
                    self.depth -= 1;
                }
                self.body(1);
                self.in_loop = was;
                self.line("END_FOR;");
            }
            16 if self.loops < 2 && self.depth < 3 => {
                self.loops += 1;
                self.line("c := 0;");
                let condition = self.truth(1);
                let repeat = self.random.percent(50);
                match repeat {
                    true => self.line("REPEAT"),
                    false => self.line(&format!("WHILE c < 4 AND {condition} DO")),
                }
                let was = std::mem::replace(&mut self.in_loop, true);
                self.body(1);
                self.in_loop = was;
                self.line("  c := c + 1;");
                match repeat {
                    true => self.line(&format!("UNTIL c >= 3 OR {condition} END_REPEAT;")),
                    false => self.line("END_WHILE;"),
                }
            }
            17 | 18 if !self.in_loop => {
                let Some((block, name)) = self.blocks.pop() else {
                    return;
                };
                let call = match block {
                    "TON" | "TOF" | "TP" => {
                        format!(
                            "{name}(IN := {}, PT := T#{}ms);",
                            self.truth(1),
                            10 * self.random.below(9)
                        )
                    }
                    "CTU" => format!(
                        "{name}(CU := {}, R := {}, PV := {});",
                        self.truth(1),
                        self.bit(),
                        self.random.below(5)
                    ),
                    "CTD" => format!(
                        "{name}(CD := {}, LD := {}, PV := {});",
                        self.truth(1),
                        self.bit(),
                        self.random.below(5)
                    ),
                    "CTUD" => format!(
                        "{name}(CU := {}, CD := {}, R := {}, LD := {}, PV := {});",
                        self.truth(1),
                        self.bit(),
                        self.bit(),
                        self.bit(),
                        self.random.below(5)
                    ),
                    "SR" => format!("{name}(S1 := {}, R := {});", self.truth(1), self.truth(1)),
                    "RS" => format!("{name}(S := {}, R1 := {});", self.truth(1), self.truth(1)),
                    "Own" => format!(
                        "{name}(up := {}, step := {});",
                        self.truth(1),
                        self.value("INT", 1)
                    ),
                    _ => format!("{name}(CLK := {});", self.truth(1)),
                };
                self.line(&call);
                let after = match block {
                    "TON" | "TP" | "TOF" => {
                        format!("b0 := {name}.Q; d0 := TIME_TO_DINT({name}.ET);")
                    }
                    "CTU" | "CTD" => format!("b1 := {name}.Q; i1 := {name}.CV;"),
                    "CTUD" => format!("b1 := {name}.QU; b2 := {name}.QD; i1 := {name}.CV;"),
                    "SR" | "RS" => format!("b2 := {name}.Q1;"),
                    "Own" => format!("i0 := {name}.sum;"),
                    _ => format!("b3 := {name}.Q;"),
                };
                if self.random.percent(70) {
                    self.line(&after);
                }
            }
            _ => {
                let (to, from) = (self.name("DINT"), self.name("DINT"));
                self.line(&format!("{to} := {from} + 1;"));
            }
        }
    }
}

/// A program by its seed.
fn program(seed: u64) -> String {
    let mut author = Author {
        random: Random(seed),
        loops: 0,
        text: String::new(),
        depth: 0,
        blocks: [
            "TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS", "R_TRIG", "F_TRIG", "Own",
        ]
        .iter()
        .map(|block| (*block, format!("x{}", block.to_lowercase())))
        .collect(),
        in_loop: false,
    };
    for at in (1..author.blocks.len()).rev() {
        let other = author.random.below(at + 1);
        author.blocks.swap(at, other);
    }
    let mut head = String::from(
        "FUNCTION Twice : INT\nVAR_INPUT x : INT; END_VAR\nVAR n : INT := 2; END_VAR\nIF x > 1000 THEN Twice := 7; RETURN; END_IF;\nTwice := x * n;\nEND_FUNCTION\n\
         FUNCTION_BLOCK Own\nVAR_INPUT up : BOOL; step : INT; END_VAR\nVAR_OUTPUT sum : INT; END_VAR\nVAR edge : R_TRIG; END_VAR\nedge(CLK := up);\nIF edge.Q THEN sum := sum + step; END_IF;\nEND_FUNCTION_BLOCK\n\
         TYPE Pair : STRUCT x : DINT; on : BOOL; END_STRUCT; END_TYPE\nPROGRAM main\nVAR\n",
    );
    for (ty, prefix) in NUMBERS {
        let first = author.number(ty);
        let _ = writeln!(head, "  {prefix}0 : {ty} := {first}; {prefix}1 : {ty};");
    }
    head.push_str("  r0 : REAL := 1.5; r1 : REAL; b0, b1 : BOOL; b2 : BOOL := TRUE; b3 : BOOL;\n");
    head.push_str("  a : ARRAY[0..2] OF INT := [1, 2, 3]; m : ARRAY[-1..2, 0..2] OF INT; f : ARRAY[0..3] OF BOOL;\n");
    head.push_str(
        "  p : ARRAY[0..2] OF Pair; narrow : INT(-5..100); k0, k1, c : INT; lamp AT %QX1 : BOOL;\n",
    );
    for (block, name) in &author.blocks {
        let _ = writeln!(head, "  {name} : {block};");
    }
    head.push_str("END_VAR\n");
    let count = 4 + author.random.below(8);
    author.statements(count);
    format!("{head}{}END_PROGRAM\n", author.text)
}

/// What differs; whether it ran at all.
fn compared(seed: u64) -> Result<bool, String> {
    let text = program(seed);
    let made = compiled(&text, TextLanguage::St);
    // Constants that do not fit are told, and so is what the board lacks.
    if let Some(errors) = errors(&made) {
        return match errors.contains("IL-") {
            true => Err(format!("does not compile: {errors}\n{text}")),
            false => Ok(false),
        };
    }
    let (Some(tree), Some((mut checked, _))) = (made.tree, made.program) else {
        return Ok(false);
    };
    let listing = || -> String {
        let lines = made.lines.iter();
        lines
            .map(|l| format!("{} {} {}\n", l.code, l.letters, l.symbol))
            .collect()
    };
    with_plc(&mut checked, |plc| {
        let mut twins = Twins::new(&tree, &made.places);
        let mut random = Random(seed ^ 0x5EED);
        let mut now = 0;
        for scan in 0..SCANS {
            for (at, symbol) in tree.symbols.iter().enumerate() {
                let input = symbol.name.starts_with("%I");
                if scan > 0
                    && (input || random.percent(3))
                    && symbol.type_name == "BOOL"
                    && !symbol.name.contains('.')
                {
                    let on = random.percent(50);
                    if input || symbol.name.starts_with('b') {
                        twins.set(plc, at, &Value::Int(on.into()));
                    }
                }
                if scan > 0
                    && symbol.type_name == Base::Int.name()
                    && symbol.name == "i0"
                    && random.percent(30)
                {
                    twins.set(plc, at, &Value::Int(random.below(9) as i128 - 2));
                }
            }
            match twins.scan(plc, now) {
                Ok(()) => {}
                Err(why) if why == "stopped" => return Ok(scan > 0),
                Err(why) => {
                    return Err(format!(
                        "seed {seed}, scan {scan}: {why}\n{text}\n{}",
                        listing()
                    ));
                }
            }
            now += random.below(40) as u32;
        }
        Ok(true)
    })
}

fn from_environment(name: &str, or: u64) -> u64 {
    std::env::var(name)
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(or)
}

#[test]
fn board_and_interpreter_agree() {
    let first = from_environment("UNOCLP_TYPED_SEED", 1);
    let count = from_environment("UNOCLP_TYPED_PROGRAMS", 500);
    let (mut ran, mut wrong) = (0, Vec::new());
    for seed in first..first + count {
        match compared(seed) {
            Ok(did) => ran += u64::from(did),
            Err(why) => wrong.push(why),
        }
    }
    wrong.sort_by_key(String::len);
    println!("{ran} of {count} ran, {} differ", wrong.len());
    let first: Vec<&str> = wrong
        .iter()
        .filter_map(|w| w.lines().next())
        .take(30)
        .collect();
    let all: Vec<&str> = wrong.iter().map(String::as_str).take(3).collect();
    assert!(
        wrong.is_empty(),
        "{} differ:\n{}\nthe shortest:\n{}",
        wrong.len(),
        first.join("\n"),
        all.join("\n\n")
    );
    assert!(ran * 2 > count, "only {ran} of {count} ran");
}
