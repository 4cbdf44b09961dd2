//! Random programs of all types: each is right, its tree is settled, and each value stays within its type.

use crate::common::Random;
use crate::typed_tree::faults;
use std::fmt::Write;
use unoclp_lang::run::Machine;
use unoclp_lang::typed::{Base, Value};
use unoclp_lang::{Code, TextLanguage, check};
use unoclp_testing::held;

const TYPES: [(&str, Base); 15] = [
    ("BOOL", Base::Bool),
    ("SINT", Base::Sint),
    ("INT", Base::Int),
    ("DINT", Base::Dint),
    ("LINT", Base::Lint),
    ("USINT", Base::Usint),
    ("UINT", Base::Uint),
    ("UDINT", Base::Udint),
    ("ULINT", Base::Ulint),
    ("BYTE", Base::Byte),
    ("WORD", Base::Word),
    ("DWORD", Base::Dword),
    ("REAL", Base::Real),
    ("LREAL", Base::Lreal),
    ("TIME", Base::Time),
];

struct Writer {
    random: Random,
    text: String,
    /// Loops are counted by variables of their own.
    loops: usize,
}

impl Writer {
    fn ty(&mut self) -> (&'static str, Base) {
        self.random.pick(&TYPES)
    }

    fn literal(&mut self, base: Base) -> String {
        let small = self.random.below(100);
        match base {
            Base::Bool => ["TRUE", "FALSE"][small % 2].to_owned(),
            Base::Real | Base::Lreal => format!("{small}.{}", self.random.below(100)),
            Base::Time => format!("T#{small}ms"),
            _ if base.is_bits() => format!("{base}#16#{small:X}"),
            _ if base.is_signed() && small.is_multiple_of(3) => format!("{base}#-{small}"),
            _ => format!("{base}#{small}"),
        }
    }

    /// A variable, an element, a member or a value that a block gives.
    fn place(&mut self, base: Base, depth: u32) -> String {
        let name = base.name().to_lowercase();
        match self.random.below(4) {
            0 if depth > 0 => {
                let subscript = self.expr(Base::Int, depth - 1);
                format!("a_{name}[{subscript}]")
            }
            1 => format!("s.m_{name}"),
            2 => format!("a_{name}[{}]", self.random.below(4)),
            _ => format!("v_{name}{}", self.random.below(2)),
        }
    }

    fn expr(&mut self, base: Base, depth: u32) -> String {
        if depth == 0 || self.random.percent(20) {
            return match self.random.percent(40) {
                true => self.literal(base),
                false => self.place(base, 0),
            };
        }
        let deeper = depth - 1;
        match self.random.below(9) {
            0 => {
                let (name, from) = self.ty();
                // No number becomes a time but a whole one.
                if from == Base::Time && base.is_real()
                    || base == Base::Time && from == Base::Bool
                    || from == base
                {
                    return self.place(base, deeper);
                }
                let inner = self.expr(from, deeper);
                format!("{name}_TO_{base}({inner})")
            }
            1 => self.place(base, deeper),
            2 => {
                let condition = self.expr(Base::Bool, deeper);
                let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                format!("SEL({condition}, {a}, {b})")
            }
            3 if base != Base::Bool => {
                let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                let name = ["MIN", "MAX"][self.random.below(2)];
                format!("{name}({a}, {b})")
            }
            4 if base.is_bits() => {
                let name = self.random.pick(&["SHL", "SHR", "ROL", "ROR"]);
                format!(
                    "{name}({}, {})",
                    self.expr(base, deeper),
                    self.random.below(40)
                )
            }
            5 if base.is_int() => format!(
                "F_{}({}, {})",
                base.name(),
                self.expr(base, deeper),
                self.expr(Base::Int, deeper)
            ),
            _ if base == Base::Bool => {
                let (_, of) = self.ty();
                let (a, b) = (self.expr(of, deeper), self.expr(of, deeper));
                match self.random.percent(60) {
                    true => format!(
                        "({a} {} {b})",
                        self.random.pick(&["=", "<>", "<", "<=", ">", ">="])
                    ),
                    false => {
                        let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                        format!("({a} {} NOT {b})", self.random.pick(&["AND", "OR", "XOR"]))
                    }
                }
            }
            _ if base.is_bits() => {
                let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                format!("({a} {} NOT {b})", self.random.pick(&["AND", "OR", "XOR"]))
            }
            _ if base == Base::Time => {
                let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                format!("({a} {} {b})", self.random.pick(&["+", "-"]))
            }
            _ => {
                let (a, b) = (self.expr(base, deeper), self.expr(base, deeper));
                let signs: &[&str] = match base.is_int() {
                    true => &["+", "-", "*", "/", "MOD"],
                    false => &["+", "-", "*", "/"],
                };
                // A divisor that is known to be 0 is told.
                let b = match b.parse::<f64>() == Ok(0.0) || b.ends_with("#0") || b.ends_with("#-0")
                {
                    true => self.place(base, 0),
                    false => b,
                };
                format!("({a} {} {b})", self.random.pick(signs))
            }
        }
    }

    fn statements(&mut self, depth: u32) {
        for _ in 0..=self.random.below(4) {
            self.statement(depth);
        }
    }

    fn statement(&mut self, depth: u32) {
        let (_, base) = self.ty();
        let kind = if depth == 0 { 0 } else { self.random.below(7) };
        let line = match kind {
            1 => {
                let condition = self.expr(Base::Bool, 2);
                let _ = writeln!(self.text, "IF {condition} THEN");
                self.statements(depth - 1);
                self.text.push_str("ELSE\n");
                self.statements(depth - 1);
                "END_IF;".to_owned()
            }
            2 if self.loops < 8 => {
                self.loops += 1;
                let count = self.loops;
                let end = self.random.below(6);
                let _ = writeln!(self.text, "FOR i{count} := 0 TO {end} DO");
                self.statements(depth - 1);
                "END_FOR;".to_owned()
            }
            3 => {
                let selector = self.expr(Base::Int, 2);
                let _ = writeln!(self.text, "CASE {selector} OF\n-5..5:");
                self.statements(depth - 1);
                self.text.push_str("7, 9:\n");
                self.statements(depth - 1);
                "END_CASE;".to_owned()
            }
            4 => {
                let (a, b) = (self.expr(Base::Int, 2), self.place(Base::Dint, 1));
                format!("fb1(x := {a}, total := {b}, y => v_int0);")
            }
            _ => {
                let place = self.place(base, 2);
                let value = self.expr(base, 3);
                format!("{place} := {value};")
            }
        };
        self.text.push_str(&line);
        self.text.push('\n');
    }
}

fn program(seed: u64) -> String {
    let mut writer = Writer {
        random: Random(seed),
        text: String::new(),
        loops: 0,
    };
    writer.statements(3);
    let mut text = String::from("TYPE S : STRUCT\n");
    for (name, _) in TYPES {
        let _ = writeln!(text, "m_{} : {name};", name.to_lowercase());
    }
    text.push_str("END_STRUCT; END_TYPE\n");
    for (name, _) in TYPES.iter().filter(|row| row.1.is_int()) {
        let _ = write!(
            text,
            "FUNCTION F_{name} : {name}\nVAR_INPUT a : {name}; n : INT; END_VAR\nVAR k : INT; END_VAR\n"
        );
        let _ = writeln!(
            text,
            "F_{name} := a;\nFOR k := 1 TO 3 DO F_{name} := F_{name} * a - {name}#1; IF k > n THEN RETURN; END_IF; END_FOR;\nEND_FUNCTION"
        );
    }
    text.push_str("FUNCTION_BLOCK FB\nVAR_INPUT x : INT; END_VAR\nVAR_OUTPUT y : INT; END_VAR\nVAR_IN_OUT total : DINT; END_VAR\n");
    text.push_str("VAR n : INT; END_VAR\nn := n + 1;\ntotal := total + x;\ny := n;\nEND_FUNCTION_BLOCK\nPROGRAM main\nVAR\n");
    for (name, _) in TYPES {
        let low = name.to_lowercase();
        let _ = writeln!(
            text,
            "v_{low}0, v_{low}1 : {name}; a_{low} : ARRAY[0..3] OF {name};"
        );
    }
    text.push_str("s : S; fb1 : FB; i1, i2, i3, i4, i5, i6, i7, i8 : SINT;\nEND_VAR\n");
    text + &writer.text + "END_PROGRAM\n"
}

#[test]
fn random_programs_stay_within_their_types() {
    let ran = (0..3_000)
        .filter(|seed| held(|| stays_within(*seed)))
        .count();
    assert!(ran > 1_000, "{ran}");
}

/// Whether the program of this seed ran.
fn stays_within(seed: u64) -> bool {
    let text = program(seed);
    let checked = check(&text, TextLanguage::St, unoclp_core::Board::UNO);
    let told: Vec<String> = checked
        .diagnostics
        .iter()
        .map(|d| format!("{:?} {}", d.span, d.message(unoclp_lang::Lang::En)))
        .collect();
    // What comes of constants alone may not fit, and that is told.
    let known = [
        Code::StOutOfRange,
        Code::StDivisionByZero,
        Code::StSubscript,
    ];
    let constant = checked.diagnostics.iter().all(|d| known.contains(&d.code));
    let Some(tree) = checked.tree else {
        assert!(constant, "{seed}: {told:#?}\n{text}");
        return false;
    };
    assert_eq!(faults(&tree), [""; 0], "{seed}:\n{text}");
    let mut machines = [(); 2].map(|()| Machine::new(&tree));
    for scan in 0..5 {
        for machine in &mut machines {
            machine.scan(scan * 10).unwrap();
        }
        let [a, b] = &machines;
        for symbol in &tree.symbols {
            let (value, base) = a.value(symbol);
            assert_eq!(
                (&value, base),
                (&b.value(symbol).0, base),
                "{seed}: {}",
                symbol.name
            );
            let within = match (&value, base.range()) {
                (Value::Int(number), Some((low, high))) => (low..=high).contains(number),
                (Value::Real(number), None) => {
                    number.is_finite()
                        && (base != Base::Real || f64::from(*number as f32) == *number)
                }
                _ => false,
            };
            assert!(within, "{seed}: {} is {value:?}\n{text}", symbol.name);
        }
    }
    true
}
