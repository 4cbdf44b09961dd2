//! Copies and constants: what a register holds already is not put there again, a copy is taken from the
//! register that had the value first, and what nothing needs any more is not put anywhere.

use std::collections::BTreeMap;

use super::assembly::{Code, Function, Line, Unit};
use super::effects::{ALL, CLOBBERED, Flow, Set, effects, flow, register};
use super::liveness::needed_behind;

/// Drops copies and constants in all functions. The functions must still be as the compiler made them:
/// its convention of calls tells what a call changes.
pub fn drop_superfluous(unit: &mut Unit) -> bool {
    let mut changed = false;
    for function in unit.functions_mut() {
        while drop_known(function) | drop_unneeded(function) {
            changed = true;
        }
    }
    changed
}

/// Something that a register may hold; equal numbers are equal values.
type Value = u32;

/// What is known of the registers at a place.
#[derive(Default)]
struct Registers {
    values: [Value; 32],
    next: Value,
    constants: BTreeMap<String, Value>,
}

impl Registers {
    fn forget(&mut self, set: Set) {
        for (n, value) in self.values.iter_mut().enumerate() {
            if set >> n & 1 == 1 {
                self.next += 1;
                *value = self.next;
            }
        }
    }

    fn constant(&mut self, text: &str) -> Value {
        if let Some(&value) = self.constants.get(text) {
            return value;
        }
        self.next += 1;
        self.constants.insert(text.to_owned(), self.next);
        self.next
    }

    fn get(&self, n: u32) -> Value {
        self.values[n as usize]
    }

    fn set(&mut self, n: u32, value: Value) {
        self.values[n as usize] = value;
    }

    /// The registers that are written by a copy, each with its value; `None` if it is none.
    fn copied(&mut self, code: &Code) -> Option<Vec<(u32, Value)>> {
        let to = register(code.operand(0))?;
        match code.name.as_str() {
            "mov" => Some(vec![(to, self.get(register(code.operand(1))?))]),
            "movw" => {
                let from = register(code.operand(1))?;
                Some(vec![(to, self.get(from)), (to + 1, self.get(from + 1))])
            }
            "ldi" => {
                let text = code.operand(1);
                let number = text.parse::<i32>().ok();
                let text = number.map_or(text.to_owned(), |n| (n & 0xff).to_string());
                Some(vec![(to, self.constant(&text))])
            }
            _ => None,
        }
    }

    /// Another register, or pair, that had the value of this one first and can take its place in a copy.
    fn first(&self, code: &Code) -> Option<u32> {
        let from = register(code.operand(1))?;
        let wide = code.name == "movw";
        let same = |&n: &u32| {
            self.get(n) == self.get(from)
                && (!wide || n % 2 == 0 && self.get(n + 1) == self.get(from + 1))
        };
        // Those that calls leave alone hold a value longest.
        let lasting = (2..18).chain([28]);
        lasting.filter(same).next().filter(|&n| n != from)
    }
}

/// Goes through the code forward, from label to label.
fn drop_known(function: &mut Function) -> bool {
    let mut registers = Registers::default();
    let start = |registers: &mut Registers| {
        registers.forget(ALL);
        // r1 is 0 in all code of the compiler, which makes no products.
        let zero = registers.constant("0");
        registers.set(1, zero);
    };
    start(&mut registers);
    let mut changed = false;
    let mut after_skip = false;
    let mut kept = Vec::new();
    for line in &function.body {
        let (Line::Code(code) | Line::Fixed(code)) = line else {
            if matches!(line, Line::Label(_)) {
                start(&mut registers);
            }
            kept.push(line.clone());
            continue;
        };
        let mut code = code.clone();
        let own = matches!(line, Line::Code(_)) && !after_skip;
        let certain = !after_skip;
        after_skip = flow(&code) == Flow::Skip;
        if let Some(copied) = registers.copied(&code).filter(|_| certain) {
            if own && copied.iter().all(|&(to, value)| registers.get(to) == value) {
                changed = true;
                continue;
            }
            if own && let Some(first) = registers.first(&code) {
                code.operands[1] = format!("r{first}");
                changed = true;
            }
            for (to, value) in copied {
                registers.set(to, value);
            }
        } else {
            let by_hand = matches!(line, Line::Fixed(_));
            match flow(&code) {
                Flow::Call(_) | Flow::CallPointer if by_hand => start(&mut registers),
                Flow::Call(_) | Flow::CallPointer => registers.forget(CLOBBERED & !2),
                _ => registers.forget(effects(&code).writes),
            }
            let clears = code.name == "clr"
                || code.name == "eor" && code.operand(0) == code.operand(1);
            if let (true, true, Some(n)) = (clears, certain, register(code.operand(0))) {
                let zero = registers.constant("0");
                registers.set(n, zero);
            }
        }
        kept.push(match line {
            Line::Fixed(_) => line.clone(),
            _ => Line::Code(code),
        });
    }
    function.body = kept;
    changed
}

/// Goes through the code backward.
fn drop_unneeded(function: &mut Function) -> bool {
    let needed = needed_behind(function);
    let mut changed = false;
    let mut after_skip = false;
    let mut kept = Vec::new();
    for (line, needed) in function.body.iter().zip(needed) {
        let drop = match line {
            Line::Code(code) if !after_skip && is_only_a_value(code) => {
                effects(code).writes & needed == 0
            }
            _ => false,
        };
        if let Some(code) = line.instruction() {
            after_skip = flow(code) == Flow::Skip;
        }
        if drop {
            changed = true;
        } else {
            kept.push(line.clone());
        }
    }
    function.body = kept;
    changed
}

/// Whether an instruction does nothing but to put a value into registers and flags.
fn is_only_a_value(code: &Code) -> bool {
    const NAMES: [&str; 21] = [
        "mov", "movw", "ldi", "clr", "eor", "andi", "ori", "and", "or", "com", "lsr", "lsl", "ror",
        "rol", "swap", "add", "sub", "subi", "cp", "cpi", "cpc",
    ];
    // A slot of the stack is plain memory.
    let slot = code.name == "ldd" && code.operand(1).starts_with("Y+");
    let y = matches!(code.operand(0), "r28" | "r29" | "r0" | "r1");
    !y && (slot || NAMES.contains(&code.name.as_str()))
}
