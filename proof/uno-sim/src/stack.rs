//! The deepest point of the stack, exactly: the stack pointer is looked at after every instruction that moves it.

use crate::avr::{Avr, reg};

/// Lowest stack pointer seen.
pub(crate) struct StackWatch {
    min: u16,
    /// SPH has been written, SPL not yet.
    half_written: bool,
}

/// I/O addresses of the two halves of the stack pointer, as `out` names them.
const SPL_IO: u16 = 0x3D;
const SPH_IO: u16 = 0x3E;

impl StackWatch {
    pub fn new(avr: &Avr) -> StackWatch {
        StackWatch {
            min: sp(avr),
            half_written: false,
        }
    }

    /// Forgets the past.
    pub fn restart(&mut self, avr: &Avr) {
        self.min = sp(avr);
        self.half_written = false;
    }

    pub fn min(&self) -> u16 {
        self.min
    }

    /// To be called after the instruction at `pc`.
    ///
    /// A function with a frame sets SP in two instructions, SPH first (gcc and LLVM alike), and with interrupts off. In
    /// between SP may be too low by up to 255 bytes; nothing is pushed there, so it does not count.
    #[inline]
    pub fn watch(&mut self, avr: &Avr, pc: u32) {
        let sp = sp(avr);
        if sp >= self.min {
            self.half_written = false;
        } else {
            self.deeper(avr, pc, sp);
        }
    }

    /// Whether SP is set in part: then each instruction has to be told.
    #[inline]
    pub fn is_between(&self) -> bool {
        self.half_written
    }

    /// To be called after instructions that leave SP alone, or push, pop, call and return: they reached this.
    #[inline]
    pub fn reached(&mut self, low: u16) {
        self.min = self.min.min(low);
    }

    #[cold]
    fn deeper(&mut self, avr: &Avr, pc: u32, sp: u16) {
        let opcode = avr.flash_word(pc);
        // out A, Rr is 1011 1AAr rrrr AAAA.
        let out_to = (opcode & 0xF800 == 0xB800).then_some(opcode >> 5 & 0x30 | opcode & 0x0F);
        match out_to {
            Some(SPH_IO) => self.half_written = true,
            Some(SPL_IO) => {
                self.half_written = false;
                self.min = sp;
            }
            _ if self.half_written => {}
            _ => self.min = sp,
        }
    }
}

/// Byte by byte, as simavr writes it: a processor waits where two bytes are read that were written one by one.
#[inline]
pub(crate) fn sp(avr: &Avr) -> u16 {
    u16::from_le_bytes([avr.register(reg::SP), avr.register(reg::SP + 1)])
}
