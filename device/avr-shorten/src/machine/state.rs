//! What the machine holds: registers, flags, memory, stack, and what other functions do to them.

use std::collections::{BTreeMap, BTreeSet};

use super::decode::{Place, Value, flag};
use super::oracle::Question;
use super::{CALLER, End, Event, IO, Machine, RAM, Run, SPH, SPL, SREG, Setting, Wild};

/// The registers that a function may look at: its arguments, and r1, which is 0.
const ARGUMENTS: [u8; 19] = [
    1, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25,
];
/// The low register of the pointer to the frame.
const FRAME: u8 = 28;
/// The registers that nobody may look at, at an entry and after a call.
const JUNK: [u8; 5] = [0, 26, 27, 30, 31];

impl<'a> Machine<'a> {
    pub(super) fn new(setting: Setting<'a>) -> Self {
        let oracle = setting.oracle;
        // Above all data, so that few pointers hit the stack.
        let random = 0x900 + oracle.answer(Question::Stack) as u16 % 0x200;
        let entry = random.wrapping_add(setting.moved);
        let mut machine = Machine {
            setting,
            registers: std::array::from_fn(|n| oracle.byte(Question::Register(n as u8))),
            flags: oracle.answer(Question::Flags) as u8,
            stack: entry.wrapping_add(2),
            entry,
            lowest: entry,
            memory: BTreeMap::new(),
            saved: BTreeSet::new(),
            calls: 0,
            reads: 0,
            trace: Vec::new(),
            frame: None,
            gaps: Vec::new(),
            timed: None,
            trusted: false,
        };
        machine.registers[1] = 0;
        machine.junk();
        machine.push_address(CALLER);
        machine
    }

    pub(super) fn finish(self, end: End) -> Run {
        Run {
            end,
            trace: self.trace,
            registers: self.registers,
            flags: self.flags,
            popped: self.stack.wrapping_sub(self.entry),
            frame: self.frame,
            gaps: self.gaps,
        }
    }

    /// What other code leaves in registers that nobody may look at.
    fn junk(&mut self) {
        let call = self.calls;
        let version = match self.setting.fragment && call == 0 {
            true => 0,
            false => self.setting.version,
        };
        for register in JUNK {
            let question = Question::Junk {
                register,
                call,
                version,
            };
            self.set(register, self.setting.oracle.byte(question));
        }
    }

    /// Has another function do what it does.
    pub(super) fn call(&mut self, name: &str, by_hand: bool) {
        // What an `asm!` block calls may look at all registers, and change those that are not kept for all.
        let given: Vec<u8> = match by_hand {
            true => (1..=25).chain(28..=29).collect(),
            false => ARGUMENTS.to_vec(),
        };
        let given = given.into_iter().map(|n| self.get(n)).collect();
        self.trace.push(Event::Call(name.to_owned(), given));
        self.calls += 1;
        let call = self.calls;
        let oracle = self.setting.oracle;
        for register in if by_hand { 2..=25 } else { 18..=25 } {
            self.set(register, oracle.byte(Question::Result { register, call }));
        }
        self.junk();
        let flags = Question::Result { register: 32, call };
        let kept = self.flags & 1 << flag::I;
        self.flags = oracle.answer(flags) as u8 & !(1 << flag::I) | kept;
    }

    pub(super) fn get(&self, register: u8) -> u8 {
        self.registers[usize::from(register)]
    }

    pub(super) fn set(&mut self, register: u8, value: u8) {
        self.registers[usize::from(register)] = value;
    }

    pub(super) fn pair(&self, low: u8) -> u16 {
        u16::from_le_bytes([self.get(low), self.get(low + 1)])
    }

    pub(super) fn set_pair(&mut self, low: u8, value: u16) {
        let [l, h] = value.to_le_bytes();
        self.set(low, l);
        self.set(low + 1, h);
    }

    pub(super) fn value(&self, value: Value) -> u8 {
        match value {
            Value::Register(n) => self.get(n),
            Value::Constant(n) => n,
        }
    }

    pub(super) fn is(&self, bit: u8) -> bool {
        self.flags >> bit & 1 == 1
    }

    pub(super) fn flag(&mut self, bit: u8, set: bool) {
        self.flags = self.flags & !(1 << bit) | u8::from(set) << bit;
    }

    /// Z, N and S of a result; V is set already.
    pub(super) fn result(&mut self, result: u8) {
        self.flag(flag::Z, result == 0);
        self.flag(flag::N, result >> 7 == 1);
        self.flag(flag::S, self.is(flag::N) != self.is(flag::V));
    }

    pub(super) fn interrupts(&mut self, on: bool) {
        if self.is(flag::I) != on {
            self.trace.push(Event::Interrupts(on));
        }
        self.flag(flag::I, on);
    }

    /// The address of a place, and moves its pointer.
    pub(super) fn address(&mut self, place: Place) -> u16 {
        match place {
            Place::Fixed(address) => address,
            Place::Pointer { low, offset } => self.pair(low).wrapping_add(offset),
            Place::Raised { low } => {
                let address = self.pair(low);
                self.set_pair(low, address.wrapping_add(1));
                address
            }
            Place::Lowered { low } => {
                let address = self.pair(low).wrapping_sub(1);
                self.set_pair(low, address);
                address
            }
        }
    }

    pub(super) fn read(&mut self, address: u16, place: Place) -> Result<u8, Wild> {
        self.check(address, place)?;
        Ok(match address {
            SPL => self.stack as u8,
            SPH => (self.stack >> 8) as u8,
            SREG => self.flags,
            ..RAM => {
                self.trace.push(Event::Read(address));
                self.reads += 1;
                let nth = self.reads;
                self.setting.oracle.byte(Question::Io { address, nth })
            }
            _ => self.remembered(address),
        })
    }

    pub(super) fn write(&mut self, address: u16, value: u8, place: Place) -> Result<(), Wild> {
        self.check(address, place)?;
        match address {
            SPL => {
                self.stack = self.stack & 0xFF00 | u16::from(value);
                self.lowest = self.lowest.min(self.stack);
                self.frame.get_or_insert(self.stack);
            }
            SPH => self.stack = u16::from_be_bytes([value, self.stack as u8]),
            SREG => {
                self.interrupts(value >> flag::I & 1 == 1);
                self.flags = value;
            }
            _ => {
                self.trace.push(Event::Write(address, value));
                self.memory.insert(address, (value, self.calls));
            }
        }
        Ok(())
    }

    /// Pointers keep away from the registers, and from all of the stack but frames and arguments.
    fn check(&self, address: u16, place: Place) -> Result<(), Wild> {
        let by_pointer = !matches!(place, Place::Fixed(_));
        let special = address < IO || (SPL..=SREG).contains(&address);
        let near = self.lowest.wrapping_sub(self.setting.below)..=self.entry.wrapping_add(2);
        let private = !self.trusted && (address <= self.stack || self.saved.contains(&address));
        let arguments = self.entry.wrapping_add(3);
        let above = arguments..arguments.wrapping_add(self.setting.above);
        let own = matches!(place, Place::Pointer { low: FRAME, .. });
        if by_pointer && (special || near.contains(&address) && private)
            || by_pointer && !own && above.contains(&address)
        {
            return Err(Wild);
        }
        Ok(())
    }

    /// A byte of RAM: what was written there last, here or by another function.
    fn remembered(&self, address: u16) -> u8 {
        let oracle = self.setting.oracle;
        let (value, since) = match self.memory.get(&address) {
            Some(&(value, since)) => (Some(value), since),
            None => (None, 0),
        };
        if self.saved.contains(&address) {
            return value.unwrap_or_default();
        }
        // Another function writes to the frame less often: only by pointers that it was given.
        let framed = (self.stack..=self.entry).contains(&address);
        let one_in = if framed { 4 } else { 2 };
        let writes = |call: &u32| {
            let call = *call;
            let answer = oracle.answer(Question::Writes { address, call });
            answer.is_multiple_of(one_in)
        };
        match (since + 1..=self.calls).rev().find(writes) {
            Some(call) => oracle.byte(Question::Memory { address, call }),
            None => value.unwrap_or_else(|| oracle.byte(Question::Memory { address, call: 0 })),
        }
    }

    pub(super) fn push(&mut self, value: u8) {
        self.memory.insert(self.stack, (value, self.calls));
        self.saved.insert(self.stack);
        self.stack = self.stack.wrapping_sub(1);
        self.lowest = self.lowest.min(self.stack);
    }

    pub(super) fn pop(&mut self) -> u8 {
        self.stack = self.stack.wrapping_add(1);
        let value = self.remembered(self.stack);
        self.saved.remove(&self.stack);
        value
    }

    /// The low byte is pushed first.
    pub(super) fn push_address(&mut self, address: u16) {
        let [low, high] = address.to_le_bytes();
        self.push(low);
        self.push(high);
    }

    pub(super) fn pop_address(&mut self) -> u16 {
        let high = self.pop();
        let low = self.pop();
        u16::from_le_bytes([low, high])
    }
}
