//! A machine that runs one function of the compiler's: registers, flags, memory, the stack.
//!
//! What is outside of the function is an [`Oracle`]: what memory and I/O hold, what other functions do. What
//! can be seen from outside is the [`trace`](Run::trace) and, at the end, what the convention of calls keeps.
//! Nothing is known of time and of interrupts, but how far timed writes stand apart.

pub mod decode;
pub mod oracle;
mod program;
mod state;

use std::collections::{BTreeMap, BTreeSet};

use decode::{Logic, One, Op, Place, flag};
use oracle::{Oracle, Question};
pub use program::{Program, Unknown};

/// Something that can be seen from outside.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A read of an I/O register, which may do something.
    Read(u16),
    /// A write to memory or to an I/O register.
    Write(u16, u8),
    /// Interrupts go on or off.
    Interrupts(bool),
    /// A call of another function, with the registers that it may look at.
    Call(String, Vec<u8>),
    /// `wdr`, `sleep`.
    Signal(&'static str),
}

/// How a run has ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// By a return to the caller.
    Returned,
    /// By a return from an interrupt.
    ReturnedFromInterrupt,
    /// After the last instruction, which called something that does not return.
    RanOff,
    /// Nowhere yet.
    TooLong,
    /// A pointer has led to the registers, the stack pointer, or saved registers and return addresses: with
    /// the values of this run the function means nothing.
    Void,
    /// At an address that is none of the code.
    Lost,
}

/// What a run has done.
#[derive(Debug)]
pub struct Run {
    /// How it has ended.
    pub end: End,
    /// What could be seen, in order.
    pub trace: Vec<Event>,
    /// The registers at the end.
    pub registers: [u8; 32],
    /// The flags at the end.
    pub flags: u8,
    /// How far the stack pointer has moved from the entry to the end.
    pub popped: u16,
    /// What the stack pointer was set to first.
    pub frame: Option<u16>,
    /// How many instructions stand between one timed write and the next.
    pub gaps: Vec<u32>,
}

/// A function and its surroundings.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// The code.
    pub program: &'a Program,
    /// The code as the compiler made it: what is a function there is outside.
    pub original: &'a Program,
    /// The surroundings.
    pub oracle: &'a Oracle,
    /// Which version this is: what nobody may look at differs between versions.
    pub version: u8,
    /// Whether the code may look at all registers at the entry, so that they are equal there.
    pub fragment: bool,
    /// What the stack pointer is moved by at the entry, so that frames of both versions begin alike.
    pub moved: u16,
    /// How far below the stack wild pointers must keep away from.
    pub below: u16,
    /// How far above the stack, where the other version's may begin, pointers but for Y must keep away from.
    pub above: u16,
    /// The instructions after which a run is too long.
    pub limit: u32,
}

/// The return address that ends the run.
const CALLER: u16 = 0xFFFF;
/// The address of the first instruction.
const CODE: u16 = 0x100;
/// The places of the stack pointer and the flags in data space.
const SPL: u16 = 0x5D;
const SPH: u16 = 0x5E;
const SREG: u16 = 0x5F;
/// Below are the registers.
const IO: u16 = 0x20;
/// Below is I/O.
const RAM: u16 = 0x100;

struct Machine<'a> {
    setting: Setting<'a>,
    registers: [u8; 32],
    flags: u8,
    stack: u16,
    entry: u16,
    lowest: u16,
    /// What was written, and before which call.
    memory: BTreeMap<u16, (u8, u32)>,
    /// The bytes of the stack that were pushed.
    saved: BTreeSet<u16>,
    calls: u32,
    reads: u32,
    trace: Vec<Event>,
    frame: Option<u16>,
    gaps: Vec<u32>,
    timed: Option<u32>,
    /// Whether the instruction is one of the pass's routines, or of an `asm!` block: these may look below the
    /// stack, and at what was pushed.
    trusted: bool,
}

/// Where control goes.
enum Next {
    Step,
    Skip,
    Go(usize),
    /// To an address from a register or from the stack.
    Address(u16),
    /// To another function, which returns for this one.
    Leave(String, bool),
    End(End),
}

/// Runs a function, and notes which steps it has taken.
pub fn run(setting: Setting<'_>, function: &str, visited: &mut [bool]) -> Run {
    let mut machine = Machine::new(setting);
    let mut at = setting.program.begin(function);
    let mut steps = 0;
    let end = loop {
        let Some((n, step)) = at.and_then(|n| Some((n, setting.program.steps.get(n)?))) else {
            break End::Lost;
        };
        let Some(op) = &step.op else {
            break End::RanOff;
        };
        if steps == setting.limit {
            break End::TooLong;
        }
        if let Some(visited) = visited.get_mut(n) {
            *visited = true;
        }
        steps += 1;
        machine.trusted = step.routine || step.by_hand;
        if step.timed {
            let last = machine.timed.replace(steps);
            machine.gaps.extend(last.map(|last| steps - last));
        }
        let next = match machine.step(op, step, n) {
            Ok(next) => next,
            Err(Wild) => break End::Void,
        };
        let address = match next {
            Next::Step => {
                at = Some(n + 1);
                continue;
            }
            Next::Skip => {
                at = Some(n + 2);
                continue;
            }
            Next::Go(target) => {
                at = Some(target);
                continue;
            }
            Next::End(end) => break end,
            Next::Address(address) => address,
            Next::Leave(name, by_hand) => {
                machine.call(&name, by_hand);
                machine.pop_address()
            }
        };
        if address == CALLER {
            break End::Returned;
        }
        at = address.checked_sub(CODE).map(usize::from);
    };
    machine.finish(end)
}

/// A pointer that leads where none may.
struct Wild;

impl Machine<'_> {
    fn step(&mut self, op: &Op, step: &program::Step, n: usize) -> Result<Next, Wild> {
        let target = || step.target;
        match *op {
            Op::Move { to, from } => {
                let value = self.value(from);
                self.set(to, value);
            }
            Op::MovePair { to, from } => {
                let value = self.pair(from);
                self.set_pair(to, value);
            }
            Op::Add { to, from, carry } => self.add(to, from, carry),
            Op::Subtract {
                to,
                value,
                carry,
                keep,
            } => {
                let value = self.value(value);
                let result = self.subtract(self.get(to), value, carry);
                if keep {
                    self.set(to, result);
                }
            }
            Op::Logic { how, to, value } => {
                let (a, b) = (self.get(to), self.value(value));
                let result = match how {
                    Logic::And => a & b,
                    Logic::Or => a | b,
                    Logic::Xor => a ^ b,
                };
                self.flag(flag::V, false);
                self.result(result);
                self.set(to, result);
            }
            Op::One { how, register } => self.one(how, register),
            Op::AddWord { to, by } => self.add_word(to, by),
            Op::Flag { bit: flag::I, set } => self.interrupts(set),
            Op::Flag { bit, set } => self.flag(bit, set),
            Op::StoreBit { from, bit } => self.flag(flag::T, self.get(from) >> bit & 1 == 1),
            Op::LoadBit { to, bit } => {
                let value = self.get(to) & !(1 << bit) | u8::from(self.is(flag::T)) << bit;
                self.set(to, value);
            }
            Op::Load { to, from } => {
                let address = self.address(from);
                let value = self.read(address, from)?;
                self.set(to, value);
            }
            Op::Store { to, from } => {
                let value = self.get(from);
                let address = self.address(to);
                self.write(address, value, to)?;
            }
            Op::Bit { address, bit, set } => {
                let place = Place::Fixed(address);
                let value = self.read(address, place)?;
                let value = value & !(1 << bit) | u8::from(set) << bit;
                self.write(address, value, place)?;
            }
            Op::LoadProgram { to, moves } => {
                let address = self.pair(30);
                let value = self.setting.oracle.byte(Question::Program(address));
                if moves {
                    self.set_pair(30, address.wrapping_add(1));
                }
                self.set(to, value);
            }
            Op::Push(register) => self.push(self.get(register)),
            Op::Pop(register) => {
                let value = self.pop();
                self.set(register, value);
            }
            Op::SkipBit { register, bit, set } => {
                return Ok(skip(self.get(register) >> bit & 1 == u8::from(set)));
            }
            Op::SkipIo { address, bit, set } => {
                let value = self.read(address, Place::Fixed(address))?;
                return Ok(skip(value >> bit & 1 == u8::from(set)));
            }
            Op::SkipEqual(a, b) => return Ok(skip(self.get(a) == self.get(b))),
            Op::Branch { bit, set, .. } if self.is(bit) == set => {
                return Ok(target().map_or(Next::End(End::Lost), Next::Go));
            }
            Op::Jump(ref name) => {
                return Ok(match target().filter(|_| !self.is_outside(name)) {
                    Some(target) => Next::Go(target),
                    None => Next::Leave(name.clone(), step.by_hand),
                });
            }
            Op::Call(ref name) => match target().filter(|_| !self.is_outside(name)) {
                Some(target) => {
                    self.push_address(CODE.wrapping_add(n as u16 + 1));
                    return Ok(Next::Go(target));
                }
                None => self.call(name, step.by_hand),
            },
            Op::CallPointer => {
                let name = format!("{:#06x}", self.pair(30));
                self.call(&name, step.by_hand);
            }
            Op::JumpPointer => return Ok(Next::Address(self.pair(30))),
            Op::Return => return Ok(Next::Address(self.pop_address())),
            Op::ReturnFromInterrupt => {
                let back = self.pop_address() == CALLER;
                self.interrupts(true);
                let end = if back {
                    End::ReturnedFromInterrupt
                } else {
                    End::Lost
                };
                return Ok(Next::End(end));
            }
            Op::Signal(name) => self.trace.push(Event::Signal(name)),
            Op::Branch { .. } | Op::Nop => {}
        }
        Ok(Next::Step)
    }

    /// Whether a name is that of a function of the compiler's. What else has a label was shared by the pass.
    fn is_outside(&self, name: &str) -> bool {
        self.setting.original.begin(name).is_some()
    }

    fn add(&mut self, to: u8, from: u8, carry: bool) {
        let (a, b) = (self.get(to), self.get(from));
        let carry = u8::from(carry && self.is(flag::C));
        let sum = a.wrapping_add(b).wrapping_add(carry);
        let carries = a & b | (a | b) & !sum;
        self.flag(flag::H, carries >> 3 & 1 == 1);
        self.flag(flag::C, carries >> 7 == 1);
        self.flag(flag::V, (a ^ sum) & (b ^ sum) & 0x80 != 0);
        self.result(sum);
        self.set(to, sum);
    }

    fn subtract(&mut self, a: u8, b: u8, carry: bool) -> u8 {
        let zero = !carry || self.is(flag::Z);
        let borrow = u8::from(carry && self.is(flag::C));
        let difference = a.wrapping_sub(b).wrapping_sub(borrow);
        let borrows = !a & b | (!a | b) & difference;
        self.flag(flag::H, borrows >> 3 & 1 == 1);
        self.flag(flag::C, borrows >> 7 == 1);
        self.flag(flag::V, (a ^ b) & (a ^ difference) & 0x80 != 0);
        self.result(difference);
        self.flag(flag::Z, difference == 0 && zero);
        difference
    }

    fn one(&mut self, how: One, register: u8) {
        let a = self.get(register);
        let carry = self.is(flag::C);
        let result = match how {
            One::Com => !a,
            One::Neg => a.wrapping_neg(),
            One::Inc => a.wrapping_add(1),
            One::Dec => a.wrapping_sub(1),
            One::Swap => a.rotate_left(4),
            One::Lsr => a >> 1,
            One::Asr => a >> 1 | a & 0x80,
            One::Ror => a >> 1 | u8::from(carry) << 7,
        };
        self.set(register, result);
        match how {
            One::Swap => return,
            One::Com => {
                self.flag(flag::C, true);
                self.flag(flag::V, false);
            }
            One::Neg => {
                self.flag(flag::C, result != 0);
                self.flag(flag::H, (result | a) >> 3 & 1 == 1);
                self.flag(flag::V, result == 0x80);
            }
            One::Inc => self.flag(flag::V, result == 0x80),
            One::Dec => self.flag(flag::V, result == 0x7F),
            One::Lsr | One::Asr | One::Ror => {
                self.flag(flag::C, a & 1 == 1);
                self.flag(flag::V, (result >> 7 == 1) != (a & 1 == 1));
            }
        }
        self.result(result);
    }

    fn add_word(&mut self, to: u8, by: i16) {
        let a = self.pair(to);
        let sum = a.wrapping_add_signed(by);
        let (was, is) = (a >> 15 == 1, sum >> 15 == 1);
        if by < 0 {
            self.flag(flag::V, was && !is);
            self.flag(flag::C, is && !was);
        } else {
            self.flag(flag::V, !was && is);
            self.flag(flag::C, !is && was);
        }
        self.result((sum >> 8) as u8);
        self.flag(flag::Z, sum == 0);
        self.set_pair(to, sum);
    }
}

fn skip(skips: bool) -> Next {
    if skips { Next::Skip } else { Next::Step }
}
