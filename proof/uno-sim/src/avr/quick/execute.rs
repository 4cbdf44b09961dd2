//! One quick instruction.

use super::kind::{Kind, is_long};
use crate::avr::reg;
use crate::chip::RAM_END;

const X: usize = 26;
const Y: usize = 28;
const Z: usize = 30;
const SPMCSR: usize = reg::SPMCSR as usize;
const SP: usize = reg::SP as usize;
/// Bytes of the data space.
pub const DATA: usize = RAM_END as usize + 1;
/// First address of the RAM: what lies below may be more than memory.
const RAM: u16 = 0x100;

/// Flags, by their place in SREG.
mod flag {
    pub const C: usize = 0;
    pub const Z: usize = 1;
    pub const N: usize = 2;
    pub const V: usize = 3;
    pub const S: usize = 4;
    pub const H: usize = 5;
    pub const T: usize = 6;
}

/// What these instructions work on.
pub struct Machine<'a> {
    pub data: &'a mut [u8; DATA],
    /// A byte for each flag, as simavr has them.
    pub sreg: &'a mut [u8; 8],
    pub flash: &'a [u8],
    pub code_end: u32,
    /// The lowest stack pointer.
    pub low: u16,
}

/// What an instruction leaves: the byte address of the next, and cycles.
pub type Place = (u32, u64);

impl Machine<'_> {
    /// The word of flash at a byte address.
    #[inline(always)]
    pub fn word(&self, at: u32) -> Option<u16> {
        let bytes = self.flash.get(at as usize..)?.first_chunk()?;
        Some(u16::from_le_bytes(*bytes))
    }

    /// Executes an instruction; `None`, and nothing has changed, where simavr is to do it.
    #[inline(always)]
    pub fn execute(&mut self, kind: Kind, opcode: u16, pc: u32) -> Option<Place> {
        let d = usize::from(opcode >> 4) & 31;
        let r = usize::from(opcode) & 15 | usize::from(opcode >> 5) & 16;
        let high = d & 15 | 16;
        let constant = (opcode & 15 | opcode >> 4 & 0xF0) as u8;
        let bit = usize::from(opcode) & 7;
        let next = pc + 2;
        let mut cycles = 1;
        match kind {
            Kind::Slow => return None,
            Kind::Nop => {}
            Kind::Ldi => self.data[high] = constant,
            Kind::Mov => self.data[d] = self.data[r],
            Kind::Movw => {
                let (to, from) = (2 * (d & 15), 2 * (usize::from(opcode) & 15));
                self.set_pair(to, self.pair(from));
            }
            Kind::Swap => self.data[d] = self.data[d].rotate_left(4),

            Kind::Add => self.data[d] = self.add(self.data[d], self.data[r], 0),
            Kind::Adc => self.data[d] = self.add(self.data[d], self.data[r], self.sreg[flag::C]),
            Kind::Sub => self.data[d] = self.subtract(self.data[d], self.data[r]),
            Kind::Cp => _ = self.subtract(self.data[d], self.data[r]),
            Kind::Subi => self.data[high] = self.subtract(self.data[high], constant),
            Kind::Cpi => _ = self.subtract(self.data[high], constant),
            Kind::Neg => self.data[d] = self.subtract(0, self.data[d]),
            Kind::Sbc => self.data[d] = self.subtract_on(self.data[d], self.data[r]),
            Kind::Cpc => _ = self.subtract_on(self.data[d], self.data[r]),
            Kind::Sbci => self.data[high] = self.subtract_on(self.data[high], constant),
            Kind::Inc => {
                self.data[d] = self.data[d].wrapping_add(1);
                self.signs(self.data[d], self.data[d] == 0x80);
            }
            Kind::Dec => {
                self.data[d] = self.data[d].wrapping_sub(1);
                self.signs(self.data[d], self.data[d] == 0x7F);
            }
            Kind::Adiw | Kind::Sbiw => {
                let low = 24 + 2 * (d & 3);
                let k = opcode & 15 | opcode >> 2 & 0x30;
                let before = self.pair(low);
                let (after, from, to) = if kind == Kind::Adiw {
                    let after = before.wrapping_add(k);
                    (after, before, after)
                } else {
                    let after = before.wrapping_sub(k);
                    (after, after, before)
                };
                self.set_pair(low, after);
                self.sreg[flag::C] = ((from & !to) >> 15) as u8;
                self.signs((after >> 8) as u8, (to & !from) >> 15 == 1);
                self.sreg[flag::Z] = (after == 0).into();
                cycles = 2;
            }

            Kind::And => self.data[d] = self.logic(self.data[d] & self.data[r]),
            Kind::Or => self.data[d] = self.logic(self.data[d] | self.data[r]),
            Kind::Eor => self.data[d] = self.logic(self.data[d] ^ self.data[r]),
            Kind::Andi => self.data[high] = self.logic(self.data[high] & constant),
            Kind::Ori => self.data[high] = self.logic(self.data[high] | constant),
            Kind::Com => {
                self.data[d] = self.logic(!self.data[d]);
                self.sreg[flag::C] = 1;
            }
            Kind::Lsr => self.data[d] = self.shift(self.data[d], 0),
            Kind::Asr => self.data[d] = self.shift(self.data[d], self.data[d] & 0x80),
            Kind::Ror => self.data[d] = self.shift(self.data[d], self.sreg[flag::C] << 7),
            Kind::Bst => self.sreg[flag::T] = self.data[d] >> bit & 1,
            Kind::Bld => self.data[d] = self.data[d] & !(1 << bit) | self.sreg[flag::T] << bit,
            Kind::Bset => self.sreg[d & 7] = 1,
            Kind::Bclr => self.sreg[d & 7] = 0,

            Kind::LddY => return self.load(d, self.pair(Y).wrapping_add(displacement(opcode)), pc),
            Kind::LddZ => return self.load(d, self.pair(Z).wrapping_add(displacement(opcode)), pc),
            Kind::LdX => return self.load(d, self.pair(X), pc),
            Kind::LdXInc => return self.load_and_move(d, X, pc),
            Kind::LdYInc => return self.load_and_move(d, Y, pc),
            Kind::LdZInc => return self.load_and_move(d, Z, pc),
            Kind::StdY => {
                return self.store(d, self.pair(Y).wrapping_add(displacement(opcode)), pc);
            }
            Kind::StdZ => {
                return self.store(d, self.pair(Z).wrapping_add(displacement(opcode)), pc);
            }
            Kind::StX => return self.store(d, self.pair(X), pc),
            Kind::StXInc => return self.store_and_move(d, X, pc),
            Kind::StYInc => return self.store_and_move(d, Y, pc),
            Kind::StZInc => return self.store_and_move(d, Z, pc),
            Kind::Lds => {
                let at = self.word(next)?;
                self.load(d, at, pc)?;
                return Some((pc + 4, 2));
            }
            Kind::Sts => {
                let at = self.word(next)?;
                self.store(d, at, pc)?;
                return Some((pc + 4, 2));
            }
            Kind::Lpm | Kind::LpmInc => {
                // Fuses are read where the flash is prepared for that.
                if self.data[SPMCSR] != 0 {
                    return None;
                }
                let at = self.pair(Z);
                self.data[d] = *self.flash.get(usize::from(at))?;
                if kind == Kind::LpmInc {
                    self.set_pair(Z, at.wrapping_add(1));
                }
                cycles = 3;
            }
            Kind::Push => {
                let sp = self.pair(SP);
                self.store(d, sp, pc)?;
                self.set_stack(sp - 1);
                cycles = 2;
            }
            Kind::Pop => {
                let sp = self.pair(SP).wrapping_add(1);
                self.load(d, sp, pc)?;
                self.set_pair(SP, sp);
                cycles = 2;
            }

            Kind::Rjmp => return Some((jump(next, opcode), 2)),
            Kind::Ijmp => return Some((u32::from(self.pair(Z)) << 1, 2)),
            Kind::Jmp => return Some((u32::from(self.word(next)?) << 1, 3)),
            Kind::Rcall => return self.call(jump(next, opcode), next, 3, pc),
            Kind::Icall => return self.call(u32::from(self.pair(Z)) << 1, next, 3, pc),
            Kind::Call => return self.call(u32::from(self.word(next)?) << 1, pc + 4, 4, pc),
            Kind::Ret => {
                let sp = self.pair(SP).wrapping_add(2);
                if !(RAM + 1..DATA as u16).contains(&sp) {
                    return None;
                }
                let [high, low] = [sp - 1, sp].map(|at| self.data[usize::from(at)]);
                let to = u32::from(u16::from_le_bytes([low, high])) << 1;
                self.accept(to, pc)?;
                self.set_pair(SP, sp);
                return Some((to, 4));
            }
            Kind::Brbs | Kind::Brbc => {
                if (self.sreg[bit] != 0) == (kind == Kind::Brbs) {
                    // 7 bits with a sign, of words.
                    let words = i32::from((opcode << 6) as i16 >> 9);
                    return Some((next.wrapping_add_signed(2 * words), 2));
                }
            }
            Kind::Sbrc => return self.skip_if(self.data[d] >> bit & 1 == 0, next),
            Kind::Sbrs => return self.skip_if(self.data[d] >> bit & 1 == 1, next),
            Kind::Cpse => return self.skip_if(self.data[d] == self.data[r], next),
        }
        Some((next, cycles))
    }

    #[inline(always)]
    fn pair(&self, low: usize) -> u16 {
        u16::from_le_bytes([self.data[low], self.data[low + 1]])
    }

    #[inline(always)]
    fn set_pair(&mut self, low: usize, value: u16) {
        [self.data[low], self.data[low + 1]] = value.to_le_bytes();
    }

    #[inline(always)]
    fn load(&mut self, d: usize, at: u16, pc: u32) -> Option<Place> {
        if at < RAM {
            return None;
        }
        self.data[d] = *self.data.get(usize::from(at))?;
        Some((pc + 2, 2))
    }

    #[inline(always)]
    fn store(&mut self, d: usize, at: u16, pc: u32) -> Option<Place> {
        if at < RAM {
            return None;
        }
        let value = self.data[d];
        *self.data.get_mut(usize::from(at))? = value;
        Some((pc + 2, 2))
    }

    #[inline(always)]
    fn load_and_move(&mut self, d: usize, pointer: usize, pc: u32) -> Option<Place> {
        let at = self.pair(pointer);
        // What becomes of a pointer that is loaded itself, simavr may say.
        if d & !1 == pointer {
            return None;
        }
        let place = self.load(d, at, pc)?;
        self.set_pair(pointer, at.wrapping_add(1));
        Some(place)
    }

    #[inline(always)]
    fn store_and_move(&mut self, d: usize, pointer: usize, pc: u32) -> Option<Place> {
        let at = self.pair(pointer);
        if d & !1 == pointer {
            return None;
        }
        let place = self.store(d, at, pc)?;
        self.set_pair(pointer, at.wrapping_add(1));
        Some(place)
    }

    /// Nothing for a jump to itself or out of the program, which somebody looks at closely.
    #[inline(always)]
    pub fn accept(&self, to: u32, pc: u32) -> Option<()> {
        (to != pc && to < self.code_end).then_some(())
    }

    #[inline(always)]
    fn call(&mut self, to: u32, back: u32, cycles: u64, pc: u32) -> Option<Place> {
        self.accept(to, pc)?;
        let sp = self.pair(SP);
        if !(RAM + 1..DATA as u16).contains(&sp) {
            return None;
        }
        let [low, high] = ((back >> 1) as u16).to_le_bytes();
        self.data[usize::from(sp)] = low;
        self.data[usize::from(sp) - 1] = high;
        self.set_stack(sp - 2);
        Some((to, cycles))
    }

    #[inline(always)]
    fn set_stack(&mut self, sp: u16) {
        self.set_pair(SP, sp);
        self.low = self.low.min(sp);
    }

    #[inline(always)]
    fn skip_if(&self, skips: bool, next: u32) -> Option<Place> {
        Some(match skips {
            false => (next, 1),
            true if is_long(self.word(next)?) => (next + 4, 3),
            true => (next + 2, 2),
        })
    }

    /// Z, N, V and S of a result of 8 bits.
    #[inline(always)]
    fn signs(&mut self, result: u8, overflows: bool) {
        self.sreg[flag::Z] = (result == 0).into();
        self.sreg[flag::N] = result >> 7;
        self.sreg[flag::V] = overflows.into();
        self.sreg[flag::S] = result >> 7 ^ u8::from(overflows);
    }

    #[inline(always)]
    fn logic(&mut self, result: u8) -> u8 {
        self.signs(result, false);
        result
    }

    #[inline(always)]
    fn add(&mut self, a: u8, b: u8, carry: u8) -> u8 {
        let result = a.wrapping_add(b).wrapping_add(carry);
        let carries = a & b | (a | b) & !result;
        self.sreg[flag::C] = carries >> 7;
        self.sreg[flag::H] = carries >> 3 & 1;
        self.signs(result, (a ^ result) & (b ^ result) & 0x80 != 0);
        result
    }

    #[inline(always)]
    fn subtract(&mut self, a: u8, b: u8) -> u8 {
        self.borrow(a, b, a.wrapping_sub(b))
    }

    /// With the carry; Z stays only where it was.
    #[inline(always)]
    fn subtract_on(&mut self, a: u8, b: u8) -> u8 {
        let before = self.sreg[flag::Z];
        let result = a.wrapping_sub(b).wrapping_sub(self.sreg[flag::C]);
        self.borrow(a, b, result);
        self.sreg[flag::Z] &= before;
        result
    }

    #[inline(always)]
    fn borrow(&mut self, a: u8, b: u8, result: u8) -> u8 {
        let borrows = !a & b | (!a | b) & result;
        self.sreg[flag::C] = borrows >> 7;
        self.sreg[flag::H] = borrows >> 3 & 1;
        self.signs(result, (a ^ b) & (a ^ result) & 0x80 != 0);
        result
    }

    /// To the right, with this bit 7.
    #[inline(always)]
    fn shift(&mut self, value: u8, top: u8) -> u8 {
        let result = value >> 1 | top;
        let carry = value & 1;
        self.sreg[flag::C] = carry;
        self.signs(result, result >> 7 != carry);
        result
    }
}

/// q of `ldd` and `std`.
#[inline(always)]
fn displacement(opcode: u16) -> u16 {
    opcode & 7 | opcode >> 7 & 0x18 | opcode >> 8 & 0x20
}

/// Where `rjmp` and `rcall` go: 12 bits with a sign, of words.
#[inline(always)]
fn jump(next: u32, opcode: u16) -> u32 {
    let words = i32::from((opcode << 4) as i16 >> 4);
    next.wrapping_add_signed(2 * words)
}
