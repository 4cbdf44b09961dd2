//! What the registers of a function are known to hold: which of them are equal, and which are constants.

use std::collections::BTreeMap;

use super::assembly::{Code, Function, Line};
use super::effects::{ALL, CLOBBERED, Flow, Set, effects, flow, register};

/// Something that a register may hold; equal numbers are equal values.
pub type Value = u32;

/// The values of all registers at a place.
#[derive(Clone, Default)]
pub struct Registers {
    values: [Value; 32],
}

/// Goes through a function from line to line, and knows the values before each.
pub struct Walk<'a> {
    /// What is known before the next line.
    pub registers: Registers,
    next: Value,
    constants: BTreeMap<String, Value>,
    /// What is known where the lines so far lead to, for labels to come.
    ahead: BTreeMap<&'a str, Vec<Registers>>,
    /// How many lines of the function lead to each label.
    uses: BTreeMap<&'a str, usize>,
    /// Whether the line before leads to the next.
    falls: bool,
    skips: bool,
}

impl<'a> Walk<'a> {
    /// At the entry of a function.
    pub fn of(function: &'a Function) -> Self {
        let mut uses = BTreeMap::new();
        for code in function.body.iter().filter_map(Line::instruction) {
            if let Flow::Jump(label) | Flow::Branch(label) = flow(code) {
                *uses.entry(label).or_default() += 1;
            }
        }
        let mut walk = Walk {
            registers: Registers::default(),
            next: 0,
            constants: BTreeMap::new(),
            ahead: BTreeMap::new(),
            uses,
            falls: true,
            skips: false,
        };
        walk.forget_all();
        walk
    }

    /// Whether the instruction that comes next may be skipped.
    pub fn may_be_skipped(&self) -> bool {
        self.skips
    }

    /// The value of a constant.
    pub fn constant(&mut self, text: &str) -> Value {
        let number = text.parse::<i32>().ok();
        let text = number.map_or(text.to_owned(), |n| (n & 0xff).to_string());
        let next = &mut self.next;
        *self.constants.entry(text).or_insert_with(|| {
            *next += 1;
            *next
        })
    }

    /// The registers that an instruction copies something into, each with its value; `None` if it does
    /// anything else.
    pub fn copied(&mut self, code: &Code) -> Option<Vec<(u32, Value)>> {
        let to = register(code.operand(0))?;
        match code.name.as_str() {
            "mov" => Some(vec![(to, self.registers.get(register(code.operand(1))?))]),
            "movw" => {
                let from = register(code.operand(1))?;
                let value = |n| self.registers.get(from + n);
                Some(vec![(to, value(0)), (to + 1, value(1))])
            }
            "ldi" => Some(vec![(to, self.constant(code.operand(1)))]),
            _ => None,
        }
    }

    /// Goes past a line.
    pub fn pass(&mut self, line: &'a Line) {
        match line {
            Line::Other(_) => {}
            Line::Label(name) => self.label(name),
            Line::Code(code) => self.code(code, false),
            Line::Fixed(code) => self.code(code, true),
        }
    }

    /// A label is reached from the lines that lead to it. If some of them are still to come, nothing is
    /// known; else what is the same on all ways.
    fn label(&mut self, name: &str) {
        let ways = self.ahead.remove(name).unwrap_or_default();
        let all = name.starts_with(".L") && self.uses.get(name).copied().unwrap_or(0) == ways.len();
        let before = std::mem::take(&mut self.registers);
        let mut ways = ways.into_iter().chain(self.falls.then_some(before));
        let first = ways.next().filter(|_| all);
        self.falls = true;
        self.skips = false;
        let Some(first) = first else {
            self.forget_all();
            return;
        };
        let others: Vec<Registers> = ways.collect();
        self.registers = first;
        for n in 0..32 {
            if others.iter().any(|way| way.get(n) != self.registers.get(n)) {
                self.forget(1 << n);
            }
        }
    }

    fn code(&mut self, code: &'a Code, by_hand: bool) {
        let certain = !self.skips;
        self.skips = flow(code) == Flow::Skip;
        self.falls = true;
        match flow(code) {
            // What an `asm!` block calls says only to the compiler what it changes.
            Flow::Call(_) | Flow::CallPointer if by_hand => self.forget_all(),
            Flow::Call(_) | Flow::CallPointer => self.forget(CLOBBERED),
            Flow::Jump(label) | Flow::Branch(label) => {
                let known = self.registers.clone();
                self.ahead.entry(label).or_default().push(known);
                self.falls = !certain || matches!(flow(code), Flow::Branch(_));
            }
            Flow::Leave => self.falls = !certain,
            Flow::Next | Flow::Skip => {
                let copied = self.copied(code).filter(|_| certain);
                self.forget(effects(code).writes);
                for (to, value) in copied.unwrap_or_default() {
                    self.registers.values[to as usize] = value;
                }
                if let Some(cleared) = cleared(code).filter(|_| certain) {
                    self.registers.values[cleared as usize] = self.constant("0");
                }
            }
        }
    }

    fn forget_all(&mut self) {
        self.forget(ALL);
        // All code of the compiler has 0 in r1, since it makes no products.
        self.registers.values[1] = self.constant("0");
    }

    fn forget(&mut self, set: Set) {
        for n in (0..32).filter(|n| set >> n & 1 == 1) {
            self.next += 1;
            self.registers.values[n] = self.next;
        }
    }
}

impl Registers {
    /// What a register holds.
    pub fn get(&self, n: u32) -> Value {
        self.values[n as usize]
    }
}

/// The register that an instruction sets to 0.
fn cleared(code: &Code) -> Option<u32> {
    let clears = code.name == "clr" || code.name == "eor" && code.operand(0) == code.operand(1);
    register(code.operand(0)).filter(|_| clears)
}
