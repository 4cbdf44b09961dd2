//! What the compiler makes of random texts does what the course says they do.
//!
//! The course says it in section 6: one accumulator, and a stack on which `(` puts the accumulator and the
//! operation. The evaluator here follows it line by line, and knows nothing of the compiler.

use crate::common::{LARGE, Random, inputs, large, plc};
use std::collections::HashMap;
use unoclp_testing::{held, rounds};

/// What the accumulator holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Value {
    Bit(bool),
    Number(i32),
}

/// The course's machine.
#[derive(Default)]
struct Evaluator {
    bits: HashMap<String, bool>,
    numbers: HashMap<String, i32>,
}

impl Evaluator {
    fn read(&self, operand: &str) -> Value {
        if let Ok(number) = operand.parse() {
            return Value::Number(number);
        }
        match operand.as_bytes()[0] {
            b'D' => Value::Number(self.numbers.get(operand).copied().unwrap_or(0)),
            b'I' if operand.starts_with("IW") => Value::Number(self.numbers[operand]),
            _ => Value::Bit(self.bits.get(operand).copied().unwrap_or(false)),
        }
    }

    fn scan(&mut self, text: &str) {
        let lines: Vec<&str> = text.lines().collect();
        let mut stack: Vec<(Value, String)> = Vec::new();
        let mut acc = Value::Bit(false);
        let mut at = 0;
        while at < lines.len() {
            let line = lines[at];
            at += 1;
            if line.ends_with(':') || line.is_empty() {
                continue;
            }
            let (operator, operand) = line.split_once(' ').unwrap_or((line, ""));
            if line == ")" {
                let (left, operator) = stack.pop().unwrap();
                acc = apply(&operator, left, acc);
                continue;
            }
            if let Some(deferred) = operator.strip_suffix('(') {
                stack.push((acc, deferred.to_owned()));
                match operand.strip_prefix("N ") {
                    _ if operand.is_empty() => {}
                    Some(operand) => acc = inverse(self.read(operand)),
                    None => acc = self.read(operand),
                }
                continue;
            }
            match operator {
                "LD" => acc = self.read(operand),
                "LDN" => acc = inverse(self.read(operand)),
                "NOT" => acc = inverse(acc),
                "ST" => self.write(operand, acc),
                "STN" => self.write(operand, inverse(acc)),
                "S" if acc == Value::Bit(true) => self.write(operand, acc),
                "R" if acc == Value::Bit(true) => self.write(operand, Value::Bit(false)),
                "S" | "R" => {}
                "JMP" => {
                    at = lines
                        .iter()
                        .position(|line| *line == format!("{operand}:"))
                        .unwrap()
                }
                "JMPC" | "JMPCN" => {
                    let holds = acc != Value::Bit(false) && acc != Value::Number(0);
                    if holds == (operator == "JMPC") {
                        at = lines
                            .iter()
                            .position(|line| *line == format!("{operand}:"))
                            .unwrap();
                    }
                }
                "RETC" if acc == Value::Bit(true) => return,
                "RETC" => {}
                _ => acc = apply(operator, acc, self.read(operand)),
            }
        }
    }

    fn write(&mut self, operand: &str, value: Value) {
        match value {
            Value::Bit(bit) => drop(self.bits.insert(operand.to_owned(), bit)),
            Value::Number(number) => drop(self.numbers.insert(operand.to_owned(), number)),
        }
    }
}

fn inverse(value: Value) -> Value {
    match value {
        Value::Bit(bit) => Value::Bit(!bit),
        Value::Number(number) => Value::Number(!number),
    }
}

fn apply(operator: &str, left: Value, right: Value) -> Value {
    let (operator, right) = match operator {
        "ANDN" | "ORN" | "XORN" => (&operator[..operator.len() - 1], inverse(right)),
        _ => (operator, right),
    };
    match (left, right) {
        (Value::Bit(left), Value::Bit(right)) => Value::Bit(match operator {
            "AND" | "&" => left && right,
            "OR" => left || right,
            "XOR" | "NE" => left != right,
            "EQ" => left == right,
            _ => panic!("{operator}"),
        }),
        (Value::Number(left), Value::Number(right)) => match operator {
            "ADD" => Value::Number(left.wrapping_add(right)),
            "SUB" => Value::Number(left.wrapping_sub(right)),
            "MUL" => Value::Number(left.wrapping_mul(right)),
            "DIV" if right == 0 => Value::Number(0),
            "DIV" => Value::Number(left.wrapping_div(right)),
            "MOD" if right == 0 => Value::Number(0),
            "MOD" => Value::Number(left.wrapping_rem(right)),
            "AND" => Value::Number(left & right),
            "OR" => Value::Number(left | right),
            "XOR" => Value::Number(left ^ right),
            "GT" => Value::Bit(left > right),
            "GE" => Value::Bit(left >= right),
            "EQ" => Value::Bit(left == right),
            "NE" => Value::Bit(left != right),
            "LE" => Value::Bit(left <= right),
            "LT" => Value::Bit(left < right),
            _ => panic!("{operator}"),
        },
        mixed => panic!("{operator} {mixed:?}"),
    }
}

/// A random text, of which the type of the accumulator is always known.
struct Writer {
    random: Random,
    text: String,
    /// Whether the accumulator is a bit.
    bit: bool,
    /// For each open parenthesis: whether the accumulator must be a bit at its end, and is one after it.
    open: Vec<(bool, bool)>,
    labels: usize,
    /// The label of the jump that is open, and the instructions to it.
    /// The type of the accumulator at the jump.
    ahead: Option<(usize, bool)>,
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn bit_operand(&mut self) -> String {
        let (letter, count) = self.random.pick(&[("I", 8), ("Q", 4), ("M", 6)]);
        format!("{letter}{}", self.random.below(count) + 1)
    }

    fn number_operand(&mut self) -> String {
        match self.random.below(4) {
            0 => format!("IW{}", self.random.below(1) + 4),
            1 => (self.random.below(40) as i32 + 2).to_string(),
            _ => format!("D{}", self.random.below(5) + 1),
        }
    }

    fn operand(&mut self, bit: bool) -> String {
        if bit {
            self.bit_operand()
        } else {
            self.number_operand()
        }
    }

    fn load(&mut self) {
        self.bit = self.random.percent(70);
        let operand = self.operand(self.bit);
        let operator = if self.random.percent(30) { "LDN" } else { "LD" };
        self.line(&format!("{operator} {operand}"));
    }

    /// An operation on the accumulator: its operator, the type of its operand and of its result.
    fn operation(&mut self) -> (&'static str, bool) {
        let logic = ["AND", "OR", "XOR", "ANDN", "ORN", "XORN"];
        if self.bit {
            let operator = match self.random.percent(8) {
                true => self.random.pick(&["EQ", "NE"]),
                false => self.random.pick(&logic),
            };
            return (operator, true);
        }
        match self.random.below(3) {
            0 => (
                self.random.pick(&["GT", "GE", "EQ", "NE", "LE", "LT"]),
                true,
            ),
            1 => (self.random.pick(&logic[..3]), false),
            _ => (
                self.random.pick(&["ADD", "SUB", "MUL", "DIV", "MOD"]),
                false,
            ),
        }
    }

    fn step(&mut self) {
        match self.random.below(100) {
            0..35 => {
                let (operator, result) = self.operation();
                let operand = self.operand(self.bit);
                self.line(&format!("{operator} {operand}"));
                self.bit = result;
            }
            35..55 if self.open.len() < 6 => {
                let (operator, result) = self.operation();
                self.open.push((self.bit, result));
                match self.random.below(4) {
                    0 => {
                        self.line(&format!("{operator}("));
                        self.load();
                    }
                    1 if self.bit => self.line(&format!("{operator}(")),
                    2 if self.bit => {
                        let operand = self.operand(true);
                        self.line(&format!("{operator}( N {operand}"));
                    }
                    _ => {
                        let operand = self.operand(self.bit);
                        self.line(&format!("{operator}( {operand}"));
                    }
                }
            }
            55..72 if !self.open.is_empty() => self.close(),
            72..80 => self.line("NOT"),
            80..92 => self.store(),
            92..95 if self.open.is_empty() && self.bit => {
                let operator = self.random.pick(&["S", "R"]);
                let operand = format!(
                    "{}{}",
                    self.random.pick(&["Q", "M"]),
                    self.random.below(4) + 1
                );
                self.line(&format!("{operator} {operand}"));
            }
            95..98 if self.open.is_empty() && self.ahead.is_none() => {
                self.labels += 1;
                self.ahead = Some((self.labels, self.bit));
                let operator = self.random.pick(&["JMP", "JMPC", "JMPCN"]);
                self.line(&format!("{operator} L{}", self.labels));
                self.load();
            }
            98 if self.open.is_empty() && self.bit && self.random.percent(30) => {
                self.line("RETC");
            }
            _ if self.open.is_empty() => self.label_or_load(),
            _ => {}
        }
    }

    fn label_or_load(&mut self) {
        if let Some((label, bit)) = self.ahead.take() {
            self.line(&format!("L{label}:"));
            // What comes over a jump is of the same type as what comes from above.
            if bit == self.bit && self.random.percent(60) {
                return;
            }
        }
        self.load();
    }

    fn store(&mut self) {
        let operator = if self.random.percent(20) { "STN" } else { "ST" };
        let operand = match self.bit {
            true => format!(
                "{}{}",
                self.random.pick(&["Q", "M"]),
                self.random.below(4) + 1
            ),
            false => format!("D{}", self.random.below(5) + 1),
        };
        self.line(&format!("{operator} {operand}"));
    }

    fn close(&mut self) {
        let Some((needs, result)) = self.open.pop() else {
            return;
        };
        if self.bit != needs {
            match needs {
                // A number becomes a bit by a comparison; a bit a number only by a load.
                true => self.line("GT 5"),
                false => {
                    let operand = self.number_operand();
                    self.line(&format!("LD {operand}"));
                }
            }
        }
        self.line(")");
        self.bit = result;
    }
}

fn random_text(seed: u64) -> String {
    let mut writer = Writer {
        random: Random(seed),
        text: String::new(),
        bit: true,
        open: Vec::new(),
        labels: 0,
        ahead: None,
    };
    writer.load();
    for _ in 0..writer.random.below(40) + 3 {
        writer.step();
    }
    while !writer.open.is_empty() {
        writer.close();
    }
    writer.store();
    if let Some((label, _)) = writer.ahead {
        writer.line(&format!("L{label}:"));
    }
    writer.text
}

#[test]
fn random_programs_do_what_the_course_says() {
    let mut memory = vec![0; 8000];
    let mut refused = 0;
    let programs = rounds(10_000);
    let mut run = |seed: u64| {
        let text = random_text(seed);
        let compiled = unoclp_lang::compile(&text, unoclp_lang::TextLanguage::Il, &large());
        // What goes too deep for the board is told, and nothing else is.
        if compiled.has_errors() {
            refused += 1;
            let deep = |d: &unoclp_lang::Diagnostic| {
                d.severity() == unoclp_lang::Severity::Warning
                    || d.code == unoclp_lang::Code::TooDeep
            };
            assert!(
                compiled.diagnostics.iter().all(deep),
                "{seed}:\n{text}{:#?}",
                compiled.diagnostics
            );
            return;
        }
        let file = compiled.file().unwrap();
        let mut plc = plc(&file, &mut memory, LARGE);
        let mut evaluator = Evaluator::default();
        let mut random = Random(!seed);
        for scan in 0..8 {
            let points = random.bits() as u8;
            let reading = random.below(60) as u16;
            for n in 0..8 {
                evaluator
                    .bits
                    .insert(format!("I{}", n + 1), points >> n & 1 != 0);
            }
            evaluator.numbers.insert("IW4".into(), reading.into());
            evaluator.scan(&text);
            let outputs = plc.scan(inputs(points, [reading; 5]), scan).unwrap();
            for n in 0..4 {
                let name = format!("Q{}", n + 1);
                let expected = evaluator.bits.get(&name).copied().unwrap_or(false);
                assert_eq!(
                    outputs.0 >> n & 1 != 0,
                    expected,
                    "seed {seed}, scan {scan}, {name}\n{text}\n{file}"
                );
            }
            // What the text does not name may hold what is put aside.
            let named = |n: &usize, kind| text.contains(&format!("{kind}{}", n + 1));
            for n in (0..6).filter(|n| named(n, 'M')) {
                let expected = evaluator
                    .bits
                    .get(&format!("M{}", n + 1))
                    .copied()
                    .unwrap_or(false);
                assert_eq!(
                    plc.markers() >> n & 1 != 0,
                    expected,
                    "seed {seed}, scan {scan}, M{}\n{text}\n{file}",
                    n + 1
                );
            }
            for n in (0..5).filter(|n| named(n, 'D')) {
                let expected = evaluator
                    .numbers
                    .get(&format!("D{}", n + 1))
                    .copied()
                    .unwrap_or(0);
                assert_eq!(
                    plc.registers()[n],
                    expected,
                    "seed {seed}, scan {scan}, D{}\n{text}\n{file}",
                    n + 1
                );
            }
        }
    };
    (0..u64::from(programs)).for_each(|seed| held(|| run(seed)));
    assert!(refused < programs / 100, "{refused}");
}
